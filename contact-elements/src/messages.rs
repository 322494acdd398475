//! Texts of codes, statuses and arguments: static, zero-terminated for C; each says what to do.

use crate::codes::{argument, code};

/// What a return code means.
pub(crate) fn code_text(value: i32) -> &'static str {
    match value {
        code::SUCCESS => "success\0",
        code::CUT_BACK => {
            "a contact point cannot be evaluated in this state: redo the increment with a smaller step\0"
        }
        code::NULL => "a required pointer is null\0",
        code::STRUCT_SIZE => {
            "struct_size is not that of this version's struct: begin with the initialiser, as CTE_ARGUMENTS_INIT\0"
        }
        code::NODE_COUNT => "the number of nodes does not fit the element: see cte_element_info\0",
        code::PARAMETER => {
            "a parameter is missing or outside its range: see cte_element_parameter\0"
        }
        code::REQUEST => {
            "the request has an unknown bit, or one that the element does not offer: see cte_info.requests\0"
        }
        code::WORKSPACE => "the workspace is too small: see cte_info.workspace\0",
        code::NOT_FINITE => "a value is NaN, infinite or larger than 1e30\0",
        code::INDEX => "an index is out of range\0",
        code::NAME => "no element has this name: see cte_element_get\0",
        code::VERSION => "the library has another major version than the header\0",
        code::STRIDE => "strides are negative, let entries overlap or reach beyond any memory\0",
        code::HISTORY => {
            "the history could not come from this library (invalid status or regime, projection or anchor out of range, negative path, non-unit normal, positive multiplier), or does not belong to the output\0"
        }
        code::ELEMENT => {
            "the element does not fit the call: its history lacks the entries, or it is of another kind\0"
        }
        _ => "not a return code of this library\0",
    }
}

/// What a status means.
pub(crate) fn status_text(value: i32) -> &'static str {
    match value {
        0 => "open\0",
        1 => "closed\0",
        2 => "stick: in contact, held by its anchor\0",
        3 => "slip: in contact, sliding\0",
        4 => "outside: the projection lies beyond an edge or vertex of the master\0",
        5 => "not converged: the projection did not converge from its start\0",
        6 => "not unique: focal surface, axis or parallel tangents\0",
        7 => "degenerate: zero area or length, or zero distance in codimension 2 or 3\0",
        8 => "law: the gap is outside the normal law's domain\0",
        _ => "not a status of this library\0",
    }
}

/// Name of an argument as in the C structs.
pub(crate) fn argument_text(value: i32) -> &'static str {
    match value {
        argument::NONE => "none\0",
        argument::STRUCT_SIZE => "struct_size\0",
        argument::REQUEST => "request\0",
        argument::NNODE => "nnode\0",
        argument::NSLAVE => "nslave\0",
        argument::X => "x\0",
        argument::U => "u\0",
        argument::PARAMETERS => "parameters\0",
        argument::HISTORY_ACCEPTED => "history_accepted\0",
        argument::HISTORY_TRIAL => "history_trial\0",
        argument::SLAVE_ROW => "slave_row\0",
        argument::F => "f\0",
        argument::K => "k\0",
        argument::K_STRIDE => "k_row_stride, k_col_stride\0",
        argument::UNKNOWN_MAP => "unknown_map\0",
        argument::SCALE => "f_scale, k_scale\0",
        argument::OUTPUT => "output\0",
        argument::ENERGY => "energy\0",
        argument::WORKSPACE => "workspace\0",
        argument::ELEMENT => "element\0",
        argument::INFO => "info\0",
        argument::ELEMENT_NAME => "element_name\0",
        argument::BATCH => "batch\0",
        argument::CONNECTIVITY => "connectivity\0",
        argument::CSR => "csr_values, csr_map\0",
        argument::STATUS => "status\0",
        argument::FROM => "from\0",
        argument::FROM_OUTPUT => "from_output\0",
        argument::FROM_HISTORY => "from_history\0",
        argument::TO => "to\0",
        argument::TO_OUTPUT => "to_output\0",
        argument::TO_HISTORY => "to_history\0",
        argument::REACH => "reach\0",
        argument::RESULT => "result\0",
        argument::PATCH => "patch\0",
        argument::FACETS => "facets\0",
        argument::FACET => "facet\0",
        argument::EDGE => "edge\0",
        argument::VERTEX => "vertex\0",
        argument::THREADS => "threads\0",
        _ => "unknown\0",
    }
}

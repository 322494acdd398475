//! `cte_f77_csr_map_` and `cte_f77_csr_blocks_`.

use crate::element::Element;
use crate::harness::Harness;
use crate::ledger::function;
use crate::memory::Edge;
use crate::pattern::Pattern;

const MAPS: [usize; 2] = [
    function("cte_f77_csr_map_"),
    function("cte_f77_csr_blocks_"),
];
/// Before a call in the code.
const UNSET: i32 = 0x5a5a_5a5a;

/// Pattern and map as C has them.
#[derive(Clone, Copy)]
pub struct Arrays {
    /// Nodes of each element.
    pub connectivity: *const i32,
    /// Where each row begins.
    pub start: *const i64,
    /// Columns.
    pub column: *const i32,
    /// The map.
    pub map: *mut i64,
}

/// Makes one of both maps; its code, or `None` where Fortran cannot say the numbers.
pub fn make(
    harness: &mut Harness,
    (element, pattern): (&Element, &Pattern),
    which: usize,
    arrays: Arrays,
    edge: Edge,
) -> Result<Option<i32>, String> {
    let (Ok(n), Ok(rows)) = (i32::try_from(pattern.n), i32::try_from(pattern.rows)) else {
        return Ok(None);
    };
    let mut slots = harness.slots.integers.iter_mut();
    let [index, n, nslave, rows] = [element.index, n, pattern.nslave, rows].map(|value| {
        let slot = slots.next().expect("as many slots as integers");
        slot.input(&[value], edge)
    });
    let code = slots.next().expect("a slot for the code");
    let code = code.output(&[UNSET], edge);
    let fortran = &harness.interface.fortran;
    let make = [fortran.csr_map, fortran.csr_blocks][which];
    let Arrays {
        connectivity,
        start,
        column,
        map,
    } = arrays;
    // SAFETY: what the header demands, or what it says is refused.
    harness.call(MAPS[which], || unsafe {
        make(
            index,
            n,
            nslave,
            connectivity,
            rows,
            start,
            column,
            map,
            code.pointer,
        );
    });
    code.check_margins("code")?;
    harness.ledger.code(MAPS[which], code.values()[0]);
    Ok(Some(code.values()[0]))
}

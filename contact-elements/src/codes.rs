//! Numbers of the interface, as in `contact_elements.h`.

/// Return codes.
pub mod code {
    #![allow(missing_docs)]
    pub const SUCCESS: i32 = 0;
    pub const CUT_BACK: i32 = 1;
    pub const NULL: i32 = -1;
    pub const STRUCT_SIZE: i32 = -2;
    pub const NODE_COUNT: i32 = -3;
    pub const PARAMETER: i32 = -4;
    pub const REQUEST: i32 = -5;
    pub const WORKSPACE: i32 = -6;
    pub const NOT_FINITE: i32 = -7;
    pub const INDEX: i32 = -8;
    pub const NAME: i32 = -9;
    pub const VERSION: i32 = -10;
    pub const STRIDE: i32 = -11;
    pub const HISTORY: i32 = -12;
    pub const ELEMENT: i32 = -13;
}

/// Arguments named by errors.
pub mod argument {
    #![allow(missing_docs)]
    pub const NONE: i32 = 0;
    pub const STRUCT_SIZE: i32 = 1;
    pub const REQUEST: i32 = 2;
    pub const NNODE: i32 = 3;
    pub const NSLAVE: i32 = 4;
    pub const X: i32 = 5;
    pub const U: i32 = 6;
    pub const PARAMETERS: i32 = 7;
    pub const HISTORY_ACCEPTED: i32 = 8;
    pub const HISTORY_TRIAL: i32 = 9;
    pub const SLAVE_ROW: i32 = 10;
    pub const F: i32 = 11;
    pub const K: i32 = 12;
    pub const K_STRIDE: i32 = 13;
    pub const UNKNOWN_MAP: i32 = 14;
    pub const SCALE: i32 = 15;
    pub const OUTPUT: i32 = 16;
    pub const ENERGY: i32 = 17;
    pub const WORKSPACE: i32 = 18;
    pub const ELEMENT: i32 = 19;
    pub const INFO: i32 = 20;
    pub const ELEMENT_NAME: i32 = 21;
    pub const BATCH: i32 = 22;
    pub const CONNECTIVITY: i32 = 23;
    pub const CSR: i32 = 24;
    pub const STATUS: i32 = 25;
    pub const FROM: i32 = 26;
    pub const FROM_OUTPUT: i32 = 27;
    pub const FROM_HISTORY: i32 = 28;
    pub const TO: i32 = 29;
    pub const TO_OUTPUT: i32 = 30;
    pub const TO_HISTORY: i32 = 31;
    pub const REACH: i32 = 32;
    pub const RESULT: i32 = 33;
    pub const PATCH: i32 = 34;
    pub const FACETS: i32 = 35;
    pub const FACET: i32 = 36;
    pub const EDGE: i32 = 37;
    pub const VERTEX: i32 = 38;
    pub const THREADS: i32 = 39;
}

/// Request bits.
pub mod request {
    #![allow(missing_docs)]
    pub const RESIDUAL: u32 = 1;
    pub const TANGENT: u32 = 2;
    pub const HISTORY: u32 = 4;
    pub const OUTPUT: u32 = 8;
    pub const ENERGY: u32 = 16;
    pub const FREEZE_STATE: u32 = 32;
    pub const SYMMETRISE: u32 = 64;
    pub const PROJECTION_GIVEN: u32 = 128;
    pub const SCREEN: u32 = 256;
    /// Batches: `csr_map` has an entry for every pair of nodes and comes from `csr_blocks`.
    pub const CSR_BY_BLOCKS: u32 = 512;
}

/// Kinds of unknowns: displacement or tangent vector, plus the component 0, 1, 2; multiplier.
pub mod kind {
    #![allow(missing_docs)]
    pub const DISPLACEMENT: i32 = 1;
    pub const TANGENT_VECTOR: i32 = 4;
    pub const MULTIPLIER: i32 = 7;
}

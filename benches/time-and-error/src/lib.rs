//! Run time against error of the elements, and what skipping work saves.
//!
//! [`case`]: a state as an element is called with it; [`truth`]: its residual and tangent in octuple precision;
//! [`timing`]: contenders in turns; [`pairs`]: the same pairs by hand, for the other [`ways`] to a tangent. One module
//! per table, listed in [`SECTIONS`]; [`report`] writes them.

pub mod batch;
pub mod case;
pub mod growth;
pub mod instructions;
pub mod iterations;
pub mod library_size;
pub mod pairs;
pub mod pressure;
pub mod report;
pub mod skipping;
pub mod states;
pub mod timing;
pub mod trade;
pub mod truth;
pub mod ways;

use report::Section;
use timing::Effort;

/// Why a benchmark could not be made.
pub type Failure = Box<dyn std::error::Error>;

/// Makes the sections of a benchmark.
pub type Maker = fn(&Effort) -> Result<Vec<Section>, Failure>;

/// All benchmarks: name, what makes its sections.
pub const SECTIONS: [(&str, Maker); 7] = [
    ("time-against-error", trade::sections),
    ("newton-iterations", iterations::sections),
    ("integration-points", pressure::sections),
    ("growth", growth::sections),
    ("skipping", skipping::sections),
    ("batch", batch::sections),
    ("library-size", library_size::sections),
];

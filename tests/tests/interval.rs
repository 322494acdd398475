//! The tests of interval arithmetic [eq:interval]: it is private to the search, so its file is compiled here too.

use contact_elements::{arithmetic, table};

#[allow(dead_code)]
#[path = "../../contact-elements/src/search/interval.rs"]
mod interval;

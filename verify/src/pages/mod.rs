//! The certificate as pages: `certificate.html` with a table of all elements, and a page for each element. They need
//! no network and open from disk.

mod declaration;
mod element;
mod equations;
mod formula;
mod frame;
mod index;
mod plot;
mod quotes;

use std::error::Error;
use std::path::{Path, PathBuf};

use crate::certificate::Certificate;
pub use declaration::Declarations;
pub use equations::{Equation, Equations};
pub use quotes::Quotes;

/// Writes all pages to a folder and returns the path of the first one.
///
/// # Errors
/// Where a page cannot be written or a plot not drawn.
pub fn write(
    certificate: &Certificate,
    quotes: &Quotes,
    folder: &Path,
) -> Result<PathBuf, Box<dyn Error>> {
    let elements = folder.join(index::ELEMENTS);
    std::fs::create_dir_all(&elements)?;
    for element in &certificate.elements {
        let page = element::page(element, quotes)?;
        let file = elements.join(format!("{}.html", element.name));
        std::fs::write(file, page.into_string())?;
    }
    let index = folder.join("certificate.html");
    std::fs::write(&index, index::page(certificate)?.into_string())?;
    Ok(index)
}

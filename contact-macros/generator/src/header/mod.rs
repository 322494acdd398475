//! C headers and Fortran include file of a library of elements.

mod c;
mod fortran;

use std::path::{Path, PathBuf};

use crate::expand::parse;
use crate::model::Model;

pub use c::{C_HEADERS, header, symbols_header};
pub use fortran::{fortran_include, numbers, short_name};

/// The error of a build script that writes a header.
#[derive(Debug)]
pub enum HeaderError {
    /// A file could not be read or written.
    File(PathBuf, std::io::Error),
    /// The source is not Rust, or a declaration has mistakes (the compiler shows them in place).
    Declaration(syn::Error),
    /// No `contact_elements!` with an `export PREFIX;` line in the source.
    NothingExported,
}

impl std::fmt::Display for HeaderError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::File(path, error) => write!(f, "{}: {error}", path.display()),
            Self::Declaration(error) => write!(f, "{error}"),
            Self::NothingExported => {
                write!(
                    f,
                    "no contact_elements! with `export PREFIX;` as its first line"
                )
            }
        }
    }
}

impl std::error::Error for HeaderError {}

/// For a build script: finds the exported `contact_elements!` in the Rust file `source` and writes
/// `PREFIX.h` and `PREFIX.inc`, beside a copy of `contact_elements.h` and what it includes, into `directory`.
/// Returns the path of `PREFIX.h`.
///
/// # Errors
/// [`HeaderError`]: unreadable files, mistakes in the declaration, nothing exported.
pub fn write(source: &Path, directory: &Path) -> Result<PathBuf, HeaderError> {
    let file = |path: &Path| {
        let path = path.to_path_buf();
        move |error| HeaderError::File(path, error)
    };
    let text = std::fs::read_to_string(source).map_err(file(source))?;
    let rust = syn::parse_file(&text).map_err(HeaderError::Declaration)?;
    let library = Model::library();
    for item in rust.items {
        let syn::Item::Macro(item) = item else {
            continue;
        };
        if item
            .mac
            .path
            .segments
            .last()
            .is_none_or(|s| s.ident != "contact_elements")
        {
            continue;
        }
        let declaration = parse(item.mac.tokens).map_err(HeaderError::Declaration)?;
        let Some(prefix) = declaration.export else {
            continue;
        };
        let model =
            Model::build(&declaration.file, Some(&library)).map_err(HeaderError::Declaration)?;
        let prefix = prefix.to_string();
        std::fs::create_dir_all(directory).map_err(file(directory))?;
        let path = directory.join(format!("{prefix}.h"));
        let write = |path: &Path, text: &str| std::fs::write(path, text).map_err(file(path));
        write(&path, &header(&prefix, &model.elements))?;
        for (name, text) in C_HEADERS {
            write(&directory.join(name), text)?;
        }
        write(
            &directory.join(format!("{prefix}.inc")),
            &fortran_include(&prefix, &model.elements),
        )?;
        return Ok(path);
    }
    Err(HeaderError::NothingExported)
}

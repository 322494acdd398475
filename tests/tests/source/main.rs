//! The texts of the project: documentation and code agree, and the compiler says what a user should read.

mod circles;
mod doc_links;
mod ui;

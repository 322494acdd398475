//! A declaration of every feature of the language, built and run.

mod elements;
mod export;
mod foot;
mod fortran77;
mod geometries;
mod history;
mod laws;
mod project;
mod transfer;

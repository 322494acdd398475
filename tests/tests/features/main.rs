//! A declaration of every feature of the language, built and run.

mod elements;
mod export;
mod geometries;
mod laws;

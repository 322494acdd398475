//! Behaviour of friction with known answers: closed forms, exact constructions, published numbers.
//!
//! One file per behaviour; `pair`, `vector`, `linear`, `beams` and `surface` are what they share. The numbers that the tests
//! print with `--nocapture` are those of `docs/verification.md`.
#![allow(clippy::excessive_precision)] // exact answers, with the digits they were computed with

mod all_angle;
mod balance;
mod beams;
mod crossing;
mod cylinders;
mod dragging;
mod edge_sides;
mod edges;
mod elastic_rope;
mod exchange;
mod facets;
mod history;
mod incline;
mod linear;
mod loops;
mod multipliers;
mod orthotropic;
mod oscillator;
mod pair;
mod patch;
mod rolling;
mod rope;
mod rotation;
mod seam;
mod static_kinetic;
mod surface;
mod transition;
mod vector;
mod via_curve;

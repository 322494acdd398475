//! Tests across the workspace; see README.md beside this crate for which test lives where.

//! Quantities as engineers write them.

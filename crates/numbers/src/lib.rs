//! Numbers of the engine's kernels: several in one register of the processor, and in files.
//!
//! A part of the crate `wholestring`, whose rock, string and modes compute with it. Its names and
//! signatures change without notice.
//!
//! The registers of [`simd`] are sound only in code that runs on a processor which has them:
//! [`simd::dispatch`] chooses it.
#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod damage;
pub mod finite;
pub mod simd;

//! Parts of the kernels that the project's own tests and benchmarks need. Not part of the public
//! interface: names and signatures change without notice.

pub use crate::{
    dynamics::kernel_speed::{KernelAccess, instruction_sets},
    simd::counted::Flops,
    wall::{
        friction::{independent, vector},
        normal_force::{hertz, linear},
    },
};

/// Digest of the engine's sources, sixteen hexadecimal digits: two builds of one version that
/// compute otherwise have different ones.
pub const ENGINE_BUILD: &str = env!("WHOLESTRING_ENGINE_BUILD");

//! Number types of the mechanics, and the processor's registers that hold several of them.

pub mod counted;
pub mod dispatch;
pub mod lanes;
pub mod number;
pub mod peak;
pub mod vector;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod wasm;
pub mod wide;

//! The laws of the bit.

pub(super) mod custom;
pub(super) mod detournay;
pub(super) mod rate;
pub(super) mod regenerative;

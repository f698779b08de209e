//! Solid rock under the bit: elements that the face of the bit breaks.

mod cut;
mod law;
mod run_in;

pub(super) use self::cut::RockCut;
pub use self::{cut::RunIn, law::RockLaw, run_in::Standing};

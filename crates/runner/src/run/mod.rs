//! A run: a case with all of its operations and models, solved one after the other.

mod answers;
mod asked;
mod lift;
mod live;
pub(crate) mod pictures;
mod request;
mod solve;
mod stop;
mod way;

pub use answers::{Answers, Solved, answer};
pub use asked::{Asked, BitAnswer, BitReading, OwnLaws, ShakeReading};
pub use live::Live;
pub use request::{Outcome, Request, run};
pub(crate) use solve::solve;
pub use stop::Stop;
pub(crate) use way::{Way, checkpoint_every};

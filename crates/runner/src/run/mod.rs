//! A run: a case with all of its operations and models, solved one after the other.

mod answers;
mod asked;
mod held;
mod lift;
mod live;
mod own_laws;
pub(crate) mod pictures;
mod request;
mod solve;
mod stop;
mod way;

pub use answers::{Answers, Solved, answer};
pub use asked::{Answering, Asked, BitAnswer, BitReading, ShakeReading};
pub use live::Live;
pub use own_laws::OwnLaws;
pub use request::{Outcome, Request, run};
pub(crate) use solve::solve;
pub use stop::Stop;
pub(crate) use way::{Way, checkpoint_every};

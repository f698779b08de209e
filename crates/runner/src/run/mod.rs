//! A run: a case with all of its operations and models, solved one after the other.

mod answers;
mod buckled;
mod lift;
mod live;
mod own_laws;
pub(crate) mod pictures;
mod request;
mod sampled_law;
mod solve;
mod stop;
mod way;
mod zero_order_hold;

pub use answers::{Answers, Solved, answer};
pub use live::Live;
pub use own_laws::OwnLaws;
pub use request::{Outcome, Request, run};
pub use sampled_law::{Answering, BitAnswer, BitReading, SampledLaw, ShakeReading};
pub(crate) use solve::solve;
pub use stop::Stop;
pub(crate) use way::{Way, checkpoint_every};

//! Strings in motion: a thread for each, which takes it forward at the pace that its viewers choose.
//!
//! A [`LiveString`] is what viewers share: they leave what they want in `wanted`, and find the
//! latest frame, the samples of some minutes and the status there. Nothing is queued for them: who
//! reads slowly gets the newest frame, and what samples are still kept. Its `engine` owns the
//! simulation; [`EngineRoom`] holds all of them, few at a time.

mod begin;
mod channels;
mod checkpoints;
mod command;
mod engine;
mod engine_moments;
mod engine_set;
mod kept;
mod lamps;
mod layout;
mod live_string;
mod pace;
mod packet;
mod recording;
mod ring;
mod room;
mod schedule_text;
mod set_points;
mod status;
mod wanted;

pub(crate) use begin::{Beginning, Start};
pub(crate) use command::LiveError;
pub(crate) use kept::{KeptEntry, KeptString};
pub(crate) use layout::Layout;
pub(crate) use live_string::LiveString;
pub(crate) use pace::Pace;
pub(crate) use packet::{frame_packet, samples_packet};
pub(crate) use recording::RecordedEvent;
pub(crate) use room::EngineRoom;
pub(crate) use schedule_text::with_schedule;
pub(crate) use set_points::SetPoints;
pub(crate) use status::{LiveState, Status};

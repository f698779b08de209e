//! Live strings, advanced at the pace that their viewers choose.
//!
//! A [`LiveString`] is shared with viewers: they leave their requests there, and find the latest
//! frame, the samples of some minutes and the status. Nothing is queued for them: a slow reader
//! gets the newest frame, and the samples that are still kept. Its [`Engine`] owns the simulation,
//! and advances one [turn](Engine::turn) at a time. The messages between a page and the string are
//! in [`Viewing`].

mod begin;
mod channels;
mod checkpoints;
mod command;
mod engine;
mod engine_set;
mod kept;
mod lamp;
mod lamps;
mod layout;
mod live_string;
mod long_elements;
mod pace;
mod packet;
mod recording;
mod requests;
mod ring;
mod schedule_text;
mod set_points;
mod status;
mod viewing;
mod wanted;
mod watched;

pub use begin::{Beginning, Keeps, Start};
pub use command::LiveError;
pub use engine::{End, Engine};
pub use kept::{KeptEntry, KeptString};
pub use layout::Layout;
pub use live_string::{FrameNow, LiveString, Viewer};
pub use pace::Pace;
pub use packet::frame_packet;
pub use recording::RecordedEvent;
pub use requests::{At, Back, LiveEntry, LiveId, NewString, Scheduled, TextOfCase, schedule};
pub use set_points::SetPoints;
pub use status::{LiveState, Status};
pub use viewing::{Said, Told, Viewing};
pub use wanted::{Asked, Ending};

//! Logs of a rig: measurements at the surface against time or depth.
//!
//! LAS, the text of electronic drilling recorders and WITSML each provide columns and
//! [rows](record::Rows) of cells. The further steps are the same for all: [channels](channel) are
//! chosen by name and unit, the [clock] reads the time, and a [`Log`] returns one [`Record`] after
//! the other without holding more than a few rows.

mod channel;
mod clock;
mod contents;
pub(crate) mod csv;
mod kind;
mod las;
mod lines;
// The type of this module.
#[expect(clippy::module_inception)]
mod log;
mod mnemonics;
mod moment;
mod number;
pub(crate) mod picking;
mod quantity;
mod read;
mod record;
pub(crate) mod sheet;
mod watch;
mod witsml;

pub use channel::Channel;
pub(crate) use contents::contents;
pub use kind::Kind;
pub use log::Log;
pub use quantity::Quantity;
pub use read::log;
pub(crate) use read::read;
pub use record::Record;

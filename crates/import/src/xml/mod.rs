//! XML, read event by event and kept within limits.

mod capped;
mod reader;

pub(crate) use reader::root;
pub(crate) use reader::{Element, Event, Xml};

//! XML, read event by event and kept within limits.

mod capped;
mod reader;

pub(crate) use reader::root;
#[expect(unused_imports, reason = "for the readers of WITSML and EDM")]
pub(crate) use reader::{Element, Event, Xml};

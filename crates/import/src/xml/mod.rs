//! XML, read event by event and kept within limits.

mod capped;
mod reader;

#[expect(unused_imports, reason = "for the readers of WITSML and EDM")]
pub(crate) use reader::{Element, Event, Xml};
pub(crate) use reader::root;

//! XML, read event by event within limits.

mod capped;
mod decode;
mod reader;
#[cfg(test)]
mod tests;

pub(crate) use reader::{Element, Event, Xml, check, root};

//! Logs of WITSML: 1.3.1.1 and 1.4.1.1, 2.0 and 2.1.

mod json;
mod pick;
mod rows1;
mod series1;
mod series2;

use self::pick::missing;
use super::log::Opened;
use crate::{
    choices::Choices,
    error::ImportError,
    input::Input,
    xml::{Event, Xml},
};

/// Whether XML with this root is a log.
pub(crate) fn is_log(root: &str) -> bool {
    matches!(root, "logs" | "log" | "Log" | "ChannelSet")
}

/// Reads the head.
pub(super) fn open<'a>(input: Input<'a>, choices: &Choices) -> Result<Opened<'a>, ImportError> {
    let mut xml = Xml::new(input);
    loop {
        match xml.next()? {
            Event::Start(root) => {
                return match root.name.as_str() {
                    "logs" | "log" => series1::open(xml, &root, choices),
                    _ => series2::open(xml, &root, choices),
                };
            }
            Event::Eof => return Err(missing(&xml, "a log")),
            Event::Text(_) | Event::End => {}
        }
    }
}

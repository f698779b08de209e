//! The events of an XML file: elements by their local names, texts, ends.

use std::io::BufRead;

use quick_xml::{
    Reader, XmlVersion,
    events::{BytesStart, Event as XmlEvent},
};

use super::capped::{Capped, Taken};
use crate::{
    error::{ImportError, ImportErrorKind},
    input::Input,
};

/// Elements within elements.
const DEEPEST: usize = 64;

/// Attributes of an element. EDM has rows of a few hundred.
const ATTRIBUTES: usize = 2000;

/// Bytes of one tag or text.
const LONGEST_TOKEN: u64 = 64 << 20;

/// The beginning of an element.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Element {
    /// Its name without the prefix of its namespace.
    pub(crate) name: String,
    /// Its attributes by their local names, in their order.
    pub(crate) attributes: Vec<(String, String)>,
    /// Line in which it begins, from 1.
    pub(crate) line: u64,
}

impl Element {
    /// An attribute's text, trimmed.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(key, _)| key == name).map(|(_, value)| value.trim())
    }
}

/// What comes next in a file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Event {
    /// An element begins. One without content is followed by its end, too.
    Start(Element),
    /// Text, references resolved, blanks as they stand.
    Text(String),
    /// The innermost element ends.
    End,
    /// The file ends.
    Eof,
}

/// An XML file, read event by event.
pub(crate) struct Xml<'a> {
    reader: Reader<Capped<Box<dyn BufRead + 'a>>>,
    file: String,
    taken: Taken,
    buffer: Vec<u8>,
    depth: usize,
    /// The element that ends without having had content.
    empty: bool,
}

impl<'a> Xml<'a> {
    /// Reads a file from its beginning.
    pub(crate) fn new(input: Input<'a>) -> Self {
        let (file, bytes) = input.into_parts();
        let (capped, taken) = Capped::new(Box::new(bytes) as Box<dyn BufRead>, LONGEST_TOKEN);
        let mut reader = Reader::from_reader(capped);
        reader.config_mut().check_end_names = true;
        Self { reader, file, taken, buffer: Vec::new(), depth: 0, empty: false }
    }

    /// The file's name.
    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    /// The line that is read, from 1.
    pub(crate) fn line(&self) -> u64 {
        self.taken.line()
    }

    /// An error in the line that is read.
    pub(crate) fn error(&self, kind: ImportErrorKind) -> ImportError {
        ImportError::new(&self.file, Some(format!("line {}", self.taken.line())), kind)
    }

    /// The next event.
    pub(crate) fn next(&mut self) -> Result<Event, ImportError> {
        if std::mem::take(&mut self.empty) {
            self.depth -= 1;
            return Ok(Event::End);
        }
        loop {
            self.buffer.clear();
            self.taken.token();
            let line = self.taken.line();
            let mut buffer = std::mem::take(&mut self.buffer);
            let event = self.reader.read_event_into(&mut buffer);
            let found = match event {
                Err(error) => Err(self.not_xml(&error)),
                Ok(XmlEvent::Start(start)) => self.element(&start, line).map(Some),
                Ok(XmlEvent::Empty(start)) => {
                    self.empty = true;
                    self.element(&start, line).map(Some)
                }
                Ok(XmlEvent::End(_)) => {
                    self.depth = self.depth.saturating_sub(1);
                    Ok(Some(Event::End))
                }
                Ok(XmlEvent::Text(text)) => {
                    Ok(Some(Event::Text(text.xml10_content().into_owned())))
                }
                Ok(XmlEvent::CData(text)) => {
                    Ok(Some(Event::Text(text.xml10_content().into_owned())))
                }
                Ok(XmlEvent::GeneralRef(of)) => match reference(&of) {
                    Some(text) => Ok(Some(Event::Text(text))),
                    None => Err(self.error(ImportErrorKind::NotXml {
                        reason: "it uses an entity that XML does not have".to_owned(),
                    })),
                },
                Ok(XmlEvent::DocType(_)) => Err(self.error(ImportErrorKind::DocumentType)),
                Ok(XmlEvent::Comment(_) | XmlEvent::Decl(_) | XmlEvent::PI(_)) => Ok(None),
                Ok(XmlEvent::Eof) if self.depth > 0 => Err(self.error(ImportErrorKind::NotXml {
                    reason: "it ends before its elements do".to_owned(),
                })),
                Ok(XmlEvent::Eof) => Ok(Some(Event::Eof)),
            };
            self.buffer = buffer;
            if let Some(event) = found? {
                return Ok(event);
            }
        }
    }

    /// Passes over the rest of the element that began last.
    pub(crate) fn skip(&mut self) -> Result<(), ImportError> {
        let outside = self.depth - 1;
        while self.depth > outside {
            self.next()?;
        }
        Ok(())
    }

    /// The text of the element that began last, trimmed, and passes over what else it holds.
    pub(crate) fn text(&mut self) -> Result<String, ImportError> {
        let outside = self.depth - 1;
        let mut text = String::new();
        while self.depth > outside {
            if let Event::Text(more) = self.next()?
                && self.depth == outside + 1
            {
                text.push_str(&more);
            }
        }
        Ok(text.trim().to_owned())
    }

    fn element(&mut self, start: &BytesStart, line: u64) -> Result<Event, ImportError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.error(ImportErrorKind::TooMuch {
                found: format!("elements more than {DEEPEST} deep in each other"),
                most: DEEPEST.to_string(),
            }));
        }
        let name = start.local_name().as_ref().to_owned();
        let mut attributes = Vec::new();
        for attribute in start.attributes() {
            let attribute = attribute.map_err(|error| {
                self.error(ImportErrorKind::NotXml { reason: error.to_string() })
            })?;
            if attributes.len() == ATTRIBUTES {
                return Err(self.error(ImportErrorKind::TooMuch {
                    found: format!("an element of more than {ATTRIBUTES} attributes"),
                    most: ATTRIBUTES.to_string(),
                }));
            }
            let key = attribute.key.local_name().as_ref().to_owned();
            let value = attribute.normalized_value(XmlVersion::Implicit1_0);
            let value = value.map_err(|error| self.not_xml(&error))?;
            attributes.push((key, value.into_owned()));
        }
        Ok(Event::Start(Element { name, attributes, line }))
    }

    fn not_xml(&self, error: &quick_xml::Error) -> ImportError {
        let kind = match error {
            quick_xml::Error::Io(error) if error.kind() == std::io::ErrorKind::FileTooLarge => {
                ImportErrorKind::TooMuch {
                    found: error.to_string(),
                    most: format!("{} MB", LONGEST_TOKEN >> 20),
                }
            }
            quick_xml::Error::Io(error) => {
                ImportErrorKind::Unreadable { reason: error.to_string() }
            }
            error => ImportErrorKind::NotXml { reason: error.to_string() },
        };
        self.error(kind)
    }
}

/// What a reference stands for: a character by its number, or one of the five of XML.
fn reference(of: &quick_xml::events::BytesRef) -> Option<String> {
    if let Ok(Some(character)) = of.resolve_char_ref() {
        return Some(character.to_string());
    }
    quick_xml::escape::resolve_xml_entity(&of.xml10_content()).map(str::to_owned)
}

/// The first element of what begins as XML does; none of what does not.
pub(crate) fn root(head: &[u8]) -> Option<Element> {
    let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    let first = text.iter().position(|byte| !byte.is_ascii_whitespace())?;
    if text[first] != b'<' {
        return None;
    }
    let mut xml = Xml::new(Input::of_bytes("", head));
    loop {
        match xml.next() {
            Ok(Event::Start(element)) => return Some(element),
            Ok(Event::Eof) => return None,
            Ok(_) => {}
            // A document type, which the reader refuses with its line.
            Err(error) => {
                let is_xml = matches!(error.kind(), ImportErrorKind::DocumentType);
                return is_xml.then(|| Element {
                    name: "!DOCTYPE".to_owned(),
                    attributes: Vec::new(),
                    line: 1,
                });
            }
        }
    }
}

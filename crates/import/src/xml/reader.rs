//! Events of an XML file: elements by their local names, texts, ends.

use std::io::BufRead;

use quick_xml::{
    Reader, XmlVersion,
    events::{BytesStart, Event as XmlEvent},
};

use super::{Capped, Taken};
use crate::{
    error::{ImportError, ImportErrorKind},
    input::{Input, unreadable},
    xml,
};

/// Maximum nesting of elements.
const DEEPEST: usize = 64;

/// Maximum number of attributes of an element. EDM has rows of a few hundred.
const ATTRIBUTES: usize = 2000;

/// Maximum bytes of one tag, and of the text of one element; smaller in tests to save time.
const LONGEST_TOKEN: u64 = if cfg!(test) { 1 << 20 } else { 64 << 20 };

/// Maximum bytes quoted from a parser's message, which may include input of any length.
const LONGEST_REASON: usize = 200;

/// Start tag of an element.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Element {
    /// Its name without namespace prefix.
    pub(crate) name: String,
    /// Its attributes by local names, in order.
    pub(crate) attributes: Vec<(String, String)>,
    /// Line on which it begins, from 1.
    pub(crate) line: u64,
}

impl Element {
    /// An attribute's text, trimmed.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(key, _)| key == name).map(|(_, value)| value.trim())
    }
}

/// An event of the file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Event {
    /// An element begins. An empty element is followed by its end, too.
    Start(Element),
    /// Text with references resolved and whitespace unchanged.
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
    /// Whether an empty element is about to end.
    empty: bool,
    /// Whether the first element of the file has begun.
    rooted: bool,
    /// Reason why the file cannot be read.
    unreadable: Option<ImportError>,
    /// Names of elements whose attributes are read.
    has_attributes: fn(&str) -> bool,
}

impl<'a> Xml<'a> {
    /// Reads a file from its beginning.
    pub(crate) fn new(input: Input<'a>) -> Self {
        let (file, bytes) = input.into_parts();
        let (bytes, unreadable) = match xml::utf8(Box::new(bytes)) {
            Ok(Ok(bytes)) => (bytes, None),
            Ok(Err(encoding)) => {
                let encoding: String = encoding.chars().take(40).collect();
                let kind = ImportErrorKind::Refused(format!(
                    "its encoding is '{encoding}'; expected UTF-8, UTF-16, ISO-8859-1 or \
                     windows-1252: save it as UTF-8"
                ));
                (nothing(), Some(ImportError::new(&file, None, kind)))
            }
            Err(error) => (nothing(), Some(unreadable(&file, &error))),
        };
        let (capped, taken) = Capped::new(bytes, LONGEST_TOKEN);
        let mut reader = Reader::from_reader(capped);
        reader.config_mut().check_end_names = true;
        Self {
            reader,
            file,
            taken,
            buffer: Vec::new(),
            depth: 0,
            empty: false,
            rooted: false,
            unreadable,
            has_attributes: |_| true,
        }
    }

    /// Restricts attributes to elements with some names; others have none. This saves time in a
    /// file of which little is needed.
    pub(crate) fn only(&mut self, has_attributes: fn(&str) -> bool) {
        self.has_attributes = has_attributes;
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
        if let Some(error) = &self.unreadable {
            return Err(error.clone());
        }
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
                Ok(XmlEvent::Text(text)) if self.depth == 0 => {
                    match text.xml10_content().trim().is_empty() {
                        true => Ok(None),
                        false => Err(self.ill_formed("there is text outside its elements")),
                    }
                }
                Ok(XmlEvent::Text(text)) => {
                    Ok(Some(Event::Text(text.xml10_content().into_owned())))
                }
                Ok(XmlEvent::CData(text)) => {
                    Ok(Some(Event::Text(text.xml10_content().into_owned())))
                }
                Ok(XmlEvent::GeneralRef(entity)) => match reference(&entity) {
                    Some(text) => Ok(Some(Event::Text(text))),
                    None => Err(self.ill_formed("it uses an entity that XML does not have")),
                },
                Ok(XmlEvent::DocType(_)) => Err(self.error(ImportErrorKind::DocumentType)),
                Ok(XmlEvent::Comment(_) | XmlEvent::Decl(_) | XmlEvent::PI(_)) => Ok(None),
                Ok(XmlEvent::Eof) if self.depth > 0 => {
                    Err(self.ill_formed("it ends before its elements do"))
                }
                Ok(XmlEvent::Eof) => Ok(Some(Event::Eof)),
            };
            self.buffer = buffer;
            if let Some(event) = found? {
                return Ok(event);
            }
        }
    }

    /// Skips the rest of the element that began last.
    pub(crate) fn skip(&mut self) -> Result<(), ImportError> {
        let outside = self.depth.saturating_sub(1);
        while self.depth > outside {
            self.next()?;
        }
        Ok(())
    }

    /// Returns the trimmed text of the element that began last and skips its other content.
    pub(crate) fn text(&mut self) -> Result<String, ImportError> {
        let outside = self.depth.saturating_sub(1);
        let mut text = String::new();
        while self.depth > outside {
            if let Event::Text(more) = self.next()?
                && self.depth == outside + 1
            {
                if text.len() + more.len() > LONGEST_TOKEN as usize {
                    let most = format!("{} MB", LONGEST_TOKEN >> 20);
                    let found = format!("an element whose text has more than {most}");
                    return Err(self.error(ImportErrorKind::TooMuch { found, most }));
                }
                text.push_str(&more);
            }
        }
        Ok(text.trim().to_owned())
    }

    fn element(&mut self, start: &BytesStart, line: u64) -> Result<Event, ImportError> {
        if self.depth == 0 && std::mem::replace(&mut self.rooted, true) {
            return Err(self.ill_formed("a second root element follows the first"));
        }
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.error(ImportErrorKind::TooMuch {
                found: format!("elements nested more than {DEEPEST} deep"),
                most: DEEPEST.to_string(),
            }));
        }
        let name = start.local_name().as_ref().to_owned();
        let mut attributes = Vec::new();
        if !(self.has_attributes)(&name) {
            return Ok(Event::Start(Element { name, attributes, line }));
        }
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

    fn ill_formed(&self, reason: &str) -> ImportError {
        self.error(ImportErrorKind::NotXml { reason: reason.to_owned() })
    }

    fn not_xml(&self, error: &quick_xml::Error) -> ImportError {
        let io = match error {
            quick_xml::Error::Io(error) => error,
            quick_xml::Error::Encoding(_) => {
                return self.ill_formed("its text is not UTF-8 as declared, or is truncated");
            }
            // The library's words are about bytes; a reader knows lines and tags.
            quick_xml::Error::Escape(_) => {
                return self.ill_formed(
                    "an '&' does not begin the name of a character; '&amp;' was expected",
                );
            }
            quick_xml::Error::Syntax(_) => {
                return self
                    .ill_formed("it ends, or goes wrong, within a tag; is the file cut off?");
            }
            quick_xml::Error::InvalidAttr(_) => {
                return self.ill_formed("an attribute is not written as NAME=\"VALUE\"");
            }
            error => {
                let reason: String = error.to_string().chars().take(LONGEST_REASON).collect();
                return self.ill_formed(&reason);
            }
        };
        let kind = match io.kind() {
            std::io::ErrorKind::FileTooLarge => ImportErrorKind::TooMuch {
                found: io.to_string(),
                most: format!("{} MB", LONGEST_TOKEN >> 20),
            },
            std::io::ErrorKind::InvalidData => ImportErrorKind::NotXml { reason: io.to_string() },
            _ => ImportErrorKind::Unreadable { reason: io.to_string() },
        };
        self.error(kind)
    }
}

/// A reader without content, for a file that cannot be read.
fn nothing<'a>() -> Box<dyn BufRead + 'a> {
    Box::new(std::io::empty())
}

/// Resolves a reference: a character by its number, or one of the five of XML.
fn reference(entity: &quick_xml::events::BytesRef) -> Option<String> {
    if let Ok(Some(character)) = entity.resolve_char_ref() {
        return Some(character.to_string());
    }
    quick_xml::escape::resolve_xml_entity(&entity.xml10_content()).map(str::to_owned)
}

/// Whether a file begins as XML, in any encoding.
fn begins_as_xml(head: &[u8]) -> bool {
    let text = match head {
        [0xef, 0xbb, 0xbf, rest @ ..] => rest,
        [0xff, 0xfe, b'<', 0, ..] | [0xfe, 0xff, 0, b'<', ..] => return true,
        [b'<', 0, ..] | [0, b'<', ..] => return true,
        head => head,
    };
    let mut text = text.iter().skip_while(|byte| byte.is_ascii_whitespace());
    text.next() == Some(&b'<')
        && text.next().is_some_and(|byte| byte.is_ascii_alphabetic() || b"?!_".contains(byte))
}

/// The first element of a file that begins as XML; `None` otherwise.
pub(crate) fn root(head: &[u8]) -> Option<Element> {
    first(head)?.ok()
}

/// Refuses a file that begins as XML but is not well formed up to its first element, with the line.
pub(crate) fn check(name: &str, head: &[u8]) -> Result<(), ImportError> {
    match first(head) {
        Some(Err(error)) => {
            let place = error.place().map(str::to_owned);
            Err(ImportError::new(name, place, error.kind().clone()))
        }
        _ => Ok(()),
    }
}

fn first(head: &[u8]) -> Option<Result<Element, ImportError>> {
    if !begins_as_xml(head) {
        return None;
    }
    let mut xml = Xml::new(Input::of_bytes("", head));
    loop {
        match xml.next() {
            Ok(Event::Start(element)) => return Some(Ok(element)),
            Ok(Event::Eof) => return Some(Err(xml.ill_formed("it has no element"))),
            Ok(_) => {}
            Err(error) => return Some(Err(error)),
        }
    }
}

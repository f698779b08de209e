//! An object of a file as a tree, within a budget.

use crate::{
    error::{ImportError, ImportErrorKind},
    xml::{Element, Event, Xml},
};

/// Elements of a file that are kept: ten thousand stations have so many.
const ELEMENTS: usize = 400_000;

/// Bytes of their names, texts and attributes.
const BYTES: usize = 32 << 20;

/// What no case needs, and what makes most of a trajectory: not kept, whatever it holds.
const PASSED_OVER: &[&str] = &[
    "rawData",
    "corUsed",
    "valid",
    "matrixCov",
    "location",
    "nozzle",
    "nameTag",
    "documentInfo",
    "customData",
    "extensionAny",
    "extensionNameValue",
];

/// Attributes that are kept.
const ATTRIBUTES: &[&str] = &["uom", "uid", "uuid", "uidRef", "datum"];

/// An element with what it holds.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    /// Its name without a prefix.
    pub(crate) name: String,
    /// Line in which it begins.
    pub(crate) line: u64,
    /// Its own text, trimmed.
    pub(crate) text: String,
    attributes: Vec<(String, String)>,
    children: Vec<Node>,
}

/// How much of a file may still be kept.
#[derive(Debug)]
pub(crate) struct Budget {
    elements: usize,
    bytes: usize,
}

impl Default for Budget {
    fn default() -> Self {
        Self { elements: ELEMENTS, bytes: BYTES }
    }
}

impl Budget {
    fn take(&mut self, elements: usize, bytes: usize, xml: &Xml) -> Result<(), ImportError> {
        let (Some(elements), Some(bytes)) =
            (self.elements.checked_sub(elements), self.bytes.checked_sub(bytes))
        else {
            let most = format!("{ELEMENTS} elements and {} MB", BYTES >> 20);
            let found = format!("objects of more than {most}");
            return Err(xml.error(ImportErrorKind::TooMuch { found, most }));
        };
        *self = Self { elements, bytes };
        Ok(())
    }
}

impl Node {
    /// The element that began last, with all that it holds.
    pub(crate) fn read(
        element: Element,
        xml: &mut Xml,
        budget: &mut Budget,
    ) -> Result<Self, ImportError> {
        let mut attributes = element.attributes;
        attributes.retain(|(key, _)| ATTRIBUTES.contains(&key.as_str()));
        attributes.shrink_to_fit();
        let texts = attributes.iter().map(|(key, value)| key.len() + value.len());
        budget.take(1, element.name.len() + texts.sum::<usize>(), xml)?;
        let mut node = Self {
            name: element.name,
            line: element.line,
            text: String::new(),
            attributes,
            children: Vec::new(),
        };
        if PASSED_OVER.iter().any(|name| node.is(name)) {
            xml.skip()?;
            return Ok(node);
        }
        loop {
            match xml.next()? {
                Event::Start(element) => node.children.push(Self::read(element, xml, budget)?),
                Event::Text(text) => {
                    budget.take(0, text.trim().len(), xml)?;
                    // Blanks between elements are no text.
                    if !node.text.is_empty() || !text.trim().is_empty() {
                        node.text.push_str(&text);
                    }
                }
                Event::End | Event::Eof => break,
            }
        }
        node.text = node.text.trim().to_owned();
        Ok(node)
    }

    /// Whether it has one of these names, written `wbGeometrySection|WellboreGeometrySection`.
    ///
    /// Versions before and after 2.0 differ by a capital at most, but where names are given.
    pub(crate) fn is(&self, names: &str) -> bool {
        names.split('|').any(|name| name.eq_ignore_ascii_case(&self.name))
    }

    /// Those that it holds of these names.
    pub(crate) fn all<'a>(&'a self, names: &'a str) -> impl Iterator<Item = &'a Node> {
        self.children.iter().filter(move |child| child.is(names))
    }

    /// The first that it holds of these names.
    pub(crate) fn child(&self, names: &str) -> Option<&Node> {
        self.children.iter().find(|child| child.is(names))
    }

    /// All that it holds.
    pub(crate) fn children(&self) -> &[Node] {
        &self.children
    }

    /// The text of the first that it holds of these names, if it has one.
    pub(crate) fn text_of(&self, names: &str) -> Option<&str> {
        let texts = self.children.iter().filter(|child| child.is(names));
        texts.map(|child| child.text.as_str()).find(|text| !text.is_empty())
    }

    /// An attribute, if it says anything.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        let found = self.attributes.iter().find(|(key, _)| key == name);
        found.map(|(_, value)| value.trim()).filter(|value| !value.is_empty())
    }
}

//! An object of a file as a tree, within a memory budget.

use crate::{
    error::{ImportError, ImportErrorKind},
    xml::{Element, Event, Xml},
};

/// Maximum number of elements kept from a file: ten thousand stations have that many.
const ELEMENTS: usize = 400_000;

/// Maximum bytes of their names, texts and attributes.
const BYTES: usize = 32 << 20;

/// Elements that no case needs and that make up most of a trajectory; they are skipped with their
/// content.
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

/// An element with its content.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    /// Its name without namespace prefix.
    pub(crate) name: String,
    /// Line on which it begins.
    pub(crate) line: u64,
    /// Its own text, trimmed.
    pub(crate) text: String,
    attributes: Vec<(String, String)>,
    children: Vec<Node>,
}

/// Remaining budget for elements and bytes of the file.
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
    /// Reads the element that began last with all its content.
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
                    // Whitespace between elements is not text.
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
    /// Names before and after 2.0 differ at most by a capital, except where several are given.
    pub(crate) fn is(&self, names: &str) -> bool {
        names.split('|').any(|name| name.eq_ignore_ascii_case(&self.name))
    }

    /// Children with one of these names.
    pub(crate) fn all<'a>(&'a self, names: &'a str) -> impl Iterator<Item = &'a Node> {
        self.children.iter().filter(move |child| child.is(names))
    }

    /// First child with one of these names.
    pub(crate) fn child(&self, names: &str) -> Option<&Node> {
        self.children.iter().find(|child| child.is(names))
    }

    /// All children.
    pub(crate) fn children(&self) -> &[Node] {
        &self.children
    }

    /// Text of the first child with one of these names, if any.
    pub(crate) fn text_of(&self, names: &str) -> Option<&str> {
        let texts = self.children.iter().filter(|child| child.is(names));
        texts.map(|child| child.text.as_str()).find(|text| !text.is_empty())
    }

    /// An attribute, if it is not empty.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        let found = self.attributes.iter().find(|(key, _)| key == name);
        found.map(|(_, value)| value.trim()).filter(|value| !value.is_empty())
    }
}

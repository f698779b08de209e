//! Writing XML.

use std::io::{self, Write};

use quick_xml::{
    Writer,
    events::{BytesDecl, BytesEnd, BytesStart, BytesText, Event},
};

use super::Version;
use crate::look::{Look, Uom, number};

const SERIES_1: &str = "http://www.witsml.org/schemas/1series";
const SERIES_2: &str = "http://www.energistics.org/energyml/data/witsmlv2";
const COMMON_2: &str = "http://www.energistics.org/energyml/data/commonv2";

/// Maximum length of a uid made from a name, as WITSML 1.4.1.1 permits.
const LONGEST_UID: usize = 64;

/// An XML writer: indented, names and texts escaped.
pub(super) struct Xml(Writer<Vec<u8>>);

impl Xml {
    pub(super) fn new() -> io::Result<Self> {
        let mut writer = Writer::new_with_indent(Vec::new(), b' ', 2);
        writer.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
        Ok(Self(writer))
    }

    /// Begins the root of a file of WITSML 1.4.1.1: `logs`, `tubulars`.
    pub(super) fn open_series_1(&mut self, plural: &str) -> io::Result<()> {
        self.open(plural, &[("xmlns", SERIES_1), ("version", Version::V1411.number())])
    }

    /// Begins the root of a file of WITSML 2, which is the object, with its citation.
    pub(super) fn open_series_2(
        &mut self,
        object: &str,
        look: &Look,
        title: &str,
        version: Version,
    ) -> io::Result<()> {
        self.open(
            object,
            &[
                ("xmlns", SERIES_2),
                ("xmlns:eml", COMMON_2),
                ("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"),
                ("schemaVersion", version.number()),
                ("uuid", &uuid(&format!("{object} {title} {}", look.created))),
            ],
        )?;
        self.citation(look, title)
    }

    /// Title, program and time of creation of an object of WITSML 2.
    pub(super) fn citation(&mut self, look: &Look, title: &str) -> io::Result<()> {
        self.open("eml:Citation", &[])?;
        self.leaf("eml:Title", &[], title)?;
        self.leaf("eml:Originator", &[], &look.program)?;
        self.leaf("eml:Creation", &[], &look.created)?;
        self.leaf("eml:Format", &[], &look.program)?;
        self.close("eml:Citation")
    }

    /// The wellbore that an object of WITSML 2 belongs to.
    pub(super) fn wellbore(&mut self, look: &Look, version: Version) -> io::Result<()> {
        let (name, about) = ("Wellbore", look.name.as_str());
        if version == Version::V21 {
            return self.reference(name, "witsml21.Wellbore", about);
        }
        self.open(name, &[])?;
        self.leaf("eml:ContentType", &[], "application/x-witsml+xml;version=2.0;type=Wellbore")?;
        self.leaf("eml:Title", &[], about)?;
        self.leaf("eml:Uuid", &[], &uuid(&format!("{name} {about}")))?;
        self.close(name)
    }

    /// A reference of WITSML 2.1 to an object of a type.
    pub(super) fn reference(&mut self, name: &str, kind: &str, title: &str) -> io::Result<()> {
        self.open(name, &[])?;
        self.leaf("eml:Uuid", &[], &uuid(&format!("{name} {title}")))?;
        self.leaf("eml:QualifiedType", &[], kind)?;
        self.leaf("eml:Title", &[], title)?;
        self.close(name)
    }

    /// Marks an object of WITSML 2.1 as complete.
    pub(super) fn inactive(&mut self) -> io::Result<()> {
        self.leaf("eml:ActiveStatus", &[], "inactive")
    }

    pub(super) fn open(&mut self, name: &str, attributes: &[(&str, &str)]) -> io::Result<()> {
        self.0.write_event(Event::Start(start(name, attributes)))
    }

    pub(super) fn close(&mut self, name: &str) -> io::Result<()> {
        self.0.write_event(Event::End(BytesEnd::new(name)))
    }

    /// An element that contains a text.
    pub(super) fn leaf(
        &mut self,
        name: &str,
        attributes: &[(&str, &str)],
        text: &str,
    ) -> io::Result<()> {
        self.0.write_event(Event::Start(start(name, attributes)))?;
        self.0.write_event(Event::Text(BytesText::new(&allowed(text))))?;
        self.0.write_event(Event::End(BytesEnd::new(name)))
    }

    /// An element that contains a quantity; nothing if it is not finite.
    pub(super) fn quantity(&mut self, name: &str, uom: Uom, si: f64) -> io::Result<()> {
        self.quantity_with(name, uom, &[], si)
    }

    /// The same with additional attributes.
    pub(super) fn quantity_with(
        &mut self,
        name: &str,
        uom: Uom,
        more: &[(&str, &str)],
        si: f64,
    ) -> io::Result<()> {
        match number(uom.of(si)) {
            Some(text) => self.leaf(name, &[&[("uom", uom.symbol)], more].concat(), &text),
            None => Ok(()),
        }
    }

    /// The file.
    pub(super) fn finish(self) -> io::Result<String> {
        let mut bytes = self.0.into_inner();
        bytes.write_all(b"\n")?;
        String::from_utf8(bytes).map_err(io::Error::other)
    }
}

fn start<'a>(name: &'a str, attributes: &[(&str, &str)]) -> BytesStart<'a> {
    let mut start = BytesStart::new(name);
    for (key, value) in attributes {
        start.push_attribute((*key, allowed(value).as_str()));
    }
    start
}

/// A text reduced to the characters permitted in XML.
fn allowed(text: &str) -> String {
    let may = |c: char| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}');
    text.chars().map(|c| if may(c) { c } else { ' ' }).collect()
}

/// A uid from a name: its letters and digits, the others as dashes.
pub(super) fn uid(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    let uid: String = name.chars().map(plain).take(LONGEST_UID).collect();
    if uid.is_empty() { "-".to_owned() } else { uid }
}

/// A UUID of a text, equal for equal texts: two 64-bit FNV-1a sums, marked as custom (version 8,
/// whose contents are free).
pub(super) fn uuid(text: &str) -> String {
    let sum = |seed: u64| {
        let step = |sum: u64, byte: u8| (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        text.bytes().fold(seed, step)
    };
    let high = sum(0xcbf2_9ce4_8422_2325) & !0xf000 | 0x8000;
    let low = sum(0x9ae1_6a3b_2f90_404f) & !(0b11 << 62) | 0b10 << 62;
    format!(
        "{:08x}-{:04x}-{:04x}-{:04x}-{:012x}",
        high >> 32,
        high >> 16 & 0xffff,
        high & 0xffff,
        low >> 48,
        low & 0xffff_ffff_ffff
    )
}

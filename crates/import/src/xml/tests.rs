//! Events and errors of the XML reader.

use std::io::Read;

use super::{Event, Xml, check, root};
use crate::{
    error::{ImportError, ImportErrorKind},
    input::Input,
};

/// Every event of a file in short form: `<a x=1>`, `text`, `/`.
fn events(bytes: &[u8]) -> Result<String, ImportError> {
    let mut xml = Xml::new(Input::of_bytes("a.xml", bytes));
    let mut text = String::new();
    loop {
        match xml.next()? {
            Event::Start(element) => {
                let attributes: String = element
                    .attributes
                    .iter()
                    .map(|(key, value)| format!(" {key}={value}"))
                    .collect();
                text.push_str(&format!("<{}{attributes}>", element.name));
            }
            Event::Text(content) => text.push_str(&content),
            Event::End => text.push('/'),
            Event::Eof => return Ok(text),
        }
    }
}

fn refusal(bytes: &[u8]) -> String {
    events(bytes).unwrap_err().to_string()
}

#[test]
fn elements_have_local_names_and_texts_are_resolved() {
    let text = "<?xml version='1.0'?><!-- a --><w:a xmlns:w='u' w:x='1 &amp; 2'>&lt;&#x41;\
                <![CDATA[<b>]]><c/></w:a>\n";
    assert_eq!(events(text.as_bytes()).unwrap(), "<a w=u x=1 & 2><A<b><c>//");
}

#[test]
fn every_encoding_of_the_list_is_read() {
    let text = "<a>Ærøskøbing 9⅝</a>";
    let marked = [b"\xef\xbb\xbf", text.as_bytes()].concat();
    assert_eq!(events(&marked).unwrap(), "<a>Ærøskøbing 9⅝/");
    let units = |mark: &str| -> Vec<u16> { format!("{mark}{text}").encode_utf16().collect() };
    for mark in ["", "\u{feff}"] {
        let little: Vec<u8> = units(mark).iter().flat_map(|unit| unit.to_le_bytes()).collect();
        let big: Vec<u8> = units(mark).iter().flat_map(|unit| unit.to_be_bytes()).collect();
        for bytes in [little, big] {
            assert_eq!(events(&bytes).unwrap(), "<a>Ærøskøbing 9⅝/");
            assert_eq!(root(&bytes).unwrap().name, "a");
        }
    }
    for name in ["ISO-8859-1", "windows-1252", "Latin1"] {
        let head = format!("<?xml version=\"1.0\" encoding=\"{name}\"?>");
        let western = [head.as_bytes(), b"<a>\xd8 \x80</a>"].concat();
        assert_eq!(events(&western).unwrap(), "<a>Ø €/");
    }
    let unknown = b"<?xml version='1.0' encoding='Shift_JIS'?><a/>";
    assert_eq!(
        refusal(unknown),
        "a.xml: its encoding is 'Shift_JIS'; expected UTF-8, UTF-16, ISO-8859-1 or windows-1252: \
         save it as UTF-8"
    );
    assert!(check("a.xml", unknown).is_err());
    // The encoding differs from the declared one.
    assert_eq!(
        refusal(b"<a>\n\xd8</a>"),
        "a.xml, line 2: it is not well-formed XML: its text is not UTF-8 as declared, or is \
         truncated"
    );
    assert!(refusal(b"\xff\xfe<\0a\0>\0\0\xd8<\0/\0a\0>\0").contains("not UTF-16"));
}

#[test]
fn document_types_are_refused_before_anything_grows() {
    let laughs = "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [<!ENTITY lol \"lol\">\
                  <!ENTITY lol2 \"&lol;&lol;&lol;&lol;&lol;&lol;&lol;&lol;&lol;&lol;\">]>\
                  <lolz>&lol2;</lolz>";
    let sentence = "a.xml, line 2: it declares a document type (DTD), which is not read; remove \
         the line";
    assert_eq!(refusal(laughs.as_bytes()), sentence);
    assert_eq!(check("a.xml", laughs.as_bytes()).unwrap_err().to_string(), sentence);
    assert!(refusal(b"<a>&file;</a>").contains("an entity that XML does not have"));
    assert!(refusal(b"<a x='&file;'/>").contains("not well-formed"));
    assert!(refusal(b"<a>&#0;</a>").contains("not well-formed"));
}

#[test]
fn what_is_no_xml_is_refused_with_its_line() {
    for (text, reason) in [
        ("<a>\n<b></a>", "line 2"),
        ("<a>\n", "it ends before its elements do"),
        ("<a/>\n<a/>", "line 2: it is not well-formed XML: a second root element"),
        ("<a/>more", "there is text outside its elements"),
        ("<a x=1/>", "not well-formed"),
        ("<a x='1' x='2'/>", "not well-formed"),
        ("<a", "not well-formed"),
        ("<a><!-- </a>", "not well-formed"),
    ] {
        let message = refusal(text.as_bytes());
        assert!(
            message.contains(reason) && message.contains("not well-formed"),
            "{text}: {message}"
        );
    }
    // A name without end is not repeated in the message.
    let long = format!("<a></{}>", "b".repeat(1_000_000));
    assert!(refusal(long.as_bytes()).len() < 400);
}

#[test]
fn depth_and_attributes_are_limited() {
    let deep = "<a>".repeat(100_000);
    assert_eq!(
        refusal(deep.as_bytes()),
        "a.xml, line 1: it holds elements nested more than 64 deep; at most 64 are read"
    );
    let attributes: String = (0..100_000).map(|index| format!(" a{index}=''")).collect();
    assert!(
        refusal(format!("<a{attributes}/>").as_bytes())
            .contains("an element of more than 2000 attributes")
    );
}

/// Returns the same bytes repeatedly after a beginning.
struct Endless {
    head: &'static [u8],
    again: &'static [u8],
    at: usize,
}

impl Read for Endless {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        for byte in into.iter_mut() {
            *byte = match self.head {
                [first, rest @ ..] => {
                    self.head = rest;
                    *first
                }
                [] => {
                    self.at += 1;
                    self.again[(self.at - 1) % self.again.len()]
                }
            };
        }
        Ok(into.len())
    }
}

#[test]
fn a_token_without_an_end_does_not_fill_memory() {
    for (head, again) in [
        (&b"<a>"[..], &b"x"[..]),
        (b"<a ", b"x"),
        (b"<a x='", b"x"),
        (b"<!--", b"x"),
        (b"<a><![CDATA[", b"x"),
        (b"<?x ", b"x"),
        // Many short texts make a long one.
        (b"<a><b>", b"0123456789abcdef0123456789abcdef0123456789abcdef&amp;"),
    ] {
        let endless = Endless { head, again, at: 0 };
        let mut xml = Xml::new(Input::new("a.xml", endless));
        let error = loop {
            match xml.next() {
                Ok(Event::Start(element)) if element.name == "b" => break xml.text().unwrap_err(),
                Ok(_) => {}
                Err(error) => break error,
            }
        };
        assert!(
            matches!(error.kind(), ImportErrorKind::TooMuch { most, .. } if most == "1 MB"),
            "{error}"
        );
    }
}

#[test]
fn lines_are_counted_and_elements_passed_over() {
    let text = "<a>\n<b><c>1</c>\n2</b>\n<d\n x='1'> 3\n<e/>4 </d></a>";
    let mut xml = Xml::new(Input::of_bytes("a.xml", text.as_bytes()));
    let mut lines = Vec::new();
    loop {
        match xml.next().unwrap() {
            Event::Start(element) => {
                lines.push((element.name.clone(), element.line));
                match element.name.as_str() {
                    "b" => xml.skip().unwrap(),
                    "d" => assert_eq!(xml.text().unwrap(), "3\n4"),
                    _ => {}
                }
            }
            Event::Eof => break,
            _ => {}
        }
    }
    let found: Vec<(&str, u64)> = lines.iter().map(|(name, line)| (name.as_str(), *line)).collect();
    assert_eq!(found, [("a", 1), ("b", 2), ("d", 4)]);
}

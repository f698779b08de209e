//! Files of other programs, as `wholestring import` reads them.

use std::collections::BTreeMap;

use wholestring_case::Template;
use wholestring_import::{Choices, Input, contents, import};

use super::reader::{New, Reader};

/// The readers of this file.
pub(super) const READERS: &[(&str, New)] = &[
    ("import-tally", tally),
    ("import-witsml", witsml),
    ("import-edm", edm),
    ("import-las", las),
    ("import-log-csv", log_csv),
    ("import-log-witsml", log_witsml),
];

/// What stands in files of XML.
const XML: &[&str] = &[
    "<", ">", "/>", "</", "&lt;", "&#0;", "&#x10ffff;", "&x;", "<![CDATA[", "]]>", "<!--", "-->",
    "<!DOCTYPE x [<!ENTITY a \"b\">]>", "<?xml version=\"1.0\" encoding=\"UTF-16\"?>", "uom=\"ft\"",
    "uom=\"\"", "uid=\"a\"", "ft", "m", "klbf", "dega", "sequence", "NaN", "1e999", "-1",
];

/// What stands in logs.
const LOG: &[&str] = &[
    "~V", "~W", "~C", "~A", "~P", "\n", "\r\n", ":", ".", ".ft", ".klbs", "WRAP. YES :", "NULL. -9 :",
    "DLM. COMMA :", "#", "-999.25", "1,5", "1.2.3", "2026-11-21T06:00:00Z", "\t", "\u{feff}", "TIME",
    "DBTM", "HKLA", "TQA", "RPMA", "BPOS",
];

/// What holds of any file: it is read or refused with a sentence, with or without choices, and a case
/// that it gives is sound or has its mistakes told.
fn reads(choices: Choices) -> impl FnMut(&[u8]) -> bool {
    move |input| {
        let file = || Input::of_bytes("file", input);
        match contents(file()) {
            Ok(contents) => assert!(!contents.what.is_empty()),
            Err(error) => assert!(!error.to_string().is_empty()),
        }
        match import(vec![file()], &choices) {
            Ok(imported) => {
                let text = imported.text_as("file");
                let files = imported.beside.iter().map(|beside| {
                    (format!("file{}", beside.ending), beside.text.clone().into_bytes())
                });
                let files: BTreeMap<String, Vec<u8>> = files.collect();
                drop(Template::in_memory("file.toml", &text, files).case(&[]));
                true
            }
            Err(error) => {
                assert!(!error.to_string().is_empty());
                false
            }
        }
    }
}

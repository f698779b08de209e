//! From a file to its keys and values.

use std::{io, path::Path};

use crate::{
    diagnostic::{Diagnostic, Report},
    kind::Kind,
    names::short,
    node::{self, Entries},
    reader::Reader,
    source,
};

/// Name of the file in diagnostics, and its contents.
pub fn read_file(path: &Path, noun: &str) -> Result<(String, Vec<u8>), Report> {
    let name = path.display().to_string();
    with_reason(name, source::read_file(path), noun)
}

/// The same for a pipe.
pub fn read_pipe(path: &Path, noun: &str) -> Result<(String, Vec<u8>), Report> {
    with_reason(path.display().to_string(), source::read_pipe(path), noun)
}

fn with_reason(
    name: String,
    read: io::Result<Vec<u8>>,
    noun: &str,
) -> Result<(String, Vec<u8>), Report> {
    match read {
        Ok(text) => Ok((name, text)),
        Err(error) => {
            let why = match error.kind() {
                io::ErrorKind::NotFound => "there is no such file".to_owned(),
                _ => short(&error.to_string()),
            };
            let diagnostic = Diagnostic::error(format!("the {noun} cannot be read: {why}"));
            Err(Report::about_file(&name, diagnostic))
        }
    }
}

/// The keys and values of a file, and the reader with its text.
pub fn tree(name: &str, text: &[u8], kind: &'static Kind) -> Result<(Entries, Reader), Report> {
    let text = match as_text(text, kind) {
        Ok(text) => text,
        Err(diagnostic) => return Err(Report::about_file(name, diagnostic)),
    };
    let mut reader = Reader::of(kind);
    let source = reader.add_source(name, text);
    match node::parse_text(text, source) {
        Ok(root) => Ok((root, reader)),
        Err(mistakes) => {
            mistakes.into_iter().for_each(|mistake| reader.report(mistake));
            Err(reader.into_report())
        }
    }
}

/// The text of a file, or the reason why it is not text.
fn as_text<'a>(bytes: &'a [u8], kind: &Kind) -> Result<&'a str, Diagnostic> {
    let noun = kind.noun;
    const MAX_BYTES: usize = 8 << 20;
    if bytes.len() > MAX_BYTES {
        let message = format!("this file holds {} MB: it is no {noun} file", bytes.len() >> 20);
        return Err(Diagnostic::error(message)
            .help(format!("a {noun} file is a TOML text of some kilobytes")));
    }
    // Editors on Windows may put a byte order mark in front.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let help = format!("a {noun} file is a TOML text in UTF-8");
    match std::str::from_utf8(bytes) {
        Ok(text) if text.trim().is_empty() => {
            Err(Diagnostic::error(format!("the {noun} file is empty")).help(kind.needs))
        }
        Ok(text) if text.contains('\0') => {
            Err(Diagnostic::error("this file is not a text: it holds zero bytes").help(help))
        }
        Ok(text) => Ok(text),
        Err(error) => {
            let line = bytes[..error.valid_up_to()].iter().filter(|&&byte| byte == b'\n').count();
            let message = format!("this file is not a text: line {} is not UTF-8", line + 1);
            Err(Diagnostic::error(message).help(help))
        }
    }
}

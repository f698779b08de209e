//! Files that a case names, relative to the folder of the case.

use wholestring_config::prelude::*;
use wholestring_tabular::TableError;

/// Reads the content of the file. `noun` names its kind; a file that cannot be read is a mistake of
/// the case.
pub(crate) fn read_beside(
    file: &Spanned<String>,
    noun: &str,
    files: &dyn Files,
    reader: &mut Reader,
) -> Option<Vec<u8>> {
    let error = match files.read(&file.value) {
        Ok(bytes) => return Some(bytes),
        Err(error) => error,
    };
    let why = match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        _ => short(&error.to_string()),
    };
    let name = short(&file.value);
    Diagnostic::error(format!("the {noun} `{name}` cannot be read"))
        .at(file.place, why)
        .help("the name is relative to the folder of the case")
        .refuse(reader)
}

/// The mistake of a table in a file, underlined in the file if it is a text. `noun` names the
/// table.
pub(crate) fn unfit(
    error: &TableError,
    file: &Spanned<String>,
    noun: &str,
    reader: &mut Reader,
) -> Diagnostic {
    let sentence = error.sentence();
    let (message, expected) = sentence.split_once("; ").unwrap_or((&sentence, ""));
    let diagnostic = Diagnostic::error(message);
    match (error.text(), error.span(), error.place()) {
        (Some(text), Some(span), _) => {
            let source = reader.add_source(&file.value, text);
            let place = Span { source, start: span.start, end: span.end };
            diagnostic.at(place, expected).at(file.place, format!("the {noun}"))
        }
        (_, _, Some(place)) => {
            let diagnostic = diagnostic.at(file.place, format!("in {place}"));
            if expected.is_empty() { diagnostic } else { diagnostic.help(expected) }
        }
        _ => Diagnostic::error(format!("the {noun} cannot be read: {message}"))
            .at(file.place, expected),
    }
}

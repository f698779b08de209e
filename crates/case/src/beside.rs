//! Files that a case names, which stand beside it.

use wholestring_config::prelude::*;

/// What the file contains. `noun` says what it is; one that cannot be read is a mistake of the case.
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

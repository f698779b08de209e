//! Names of files.

use serde_json::json;
use wholestring_config::{Json, prelude::*};

/// The name of a file without its extension, valid on every system.
pub(crate) struct FileName;

impl Rule for FileName {
    type Value = String;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<String> {
        let name = Text.read(node, reader)?;
        let valid = |letter: char| letter.is_ascii_alphanumeric() || "-_ +=,()".contains(letter);
        if name.chars().all(valid) && name.len() <= 80 && name.trim() == name {
            return Some(name);
        }
        let message = format!("`{}` makes no file name on every system", short(&name));
        Diagnostic::error(message)
            .at(node.place, "expected letters, digits, blanks and - _ + = , ( ), 80 at most")
            .refuse(reader)
    }

    fn schema(&self) -> Json {
        json!({ "type": "string", "pattern": "^[A-Za-z0-9_+=,() -]{1,80}$" })
    }
}

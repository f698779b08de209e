//! The interface of an mdBook preprocessor.

use std::io::{self, Read};

use serde_json::Value;

use super::{equations::set_all, playground::shown};
use crate::{command::Failure, finding::Finding};

/// Reads a book from standard input in mdBook's format, and writes it with its equations converted
/// and the app on its page.
pub(crate) fn equations(arguments: &[&str]) -> Result<Finding, Failure> {
    // HTML can contain equations, and is the only output of the book.
    if let ["supports", format] = arguments {
        return match *format {
            "html" => Ok(Finding::Done),
            _ => Err(Failure::new(format!("equations are set for html, not for {format}"))),
        };
    }
    let mut text = String::new();
    let read = io::stdin().read_to_string(&mut text);
    read.map_err(|error| Failure::new(format!("standard input: {error}")))?;
    let handed: Value = serde_json::from_str(&text)
        .map_err(|error| Failure::new(format!("this is no book of mdBook: {error}")))?;
    let Value::Array(mut parts) = handed else {
        return Err(Failure::new("this is no book of mdBook"));
    };
    let Some(book) = parts.get_mut(1) else {
        return Err(Failure::new("mdBook handed over no book"));
    };
    set_in(book).map_err(Failure::new)?;
    println!("{book}");
    Ok(Finding::Done)
}

/// Converts chapters, which are in lists and nested; an object with a name and content is one.
fn set_in(value: &mut Value) -> Result<(), String> {
    match value {
        Value::Array(parts) => parts.iter_mut().try_for_each(set_in),
        Value::Object(parts) => {
            let name = parts.get("name").and_then(Value::as_str).unwrap_or_default().to_owned();
            if let Some(Value::String(content)) = parts.get_mut("content") {
                let set = set_all(content).and_then(|page| shown(&page));
                *content = set.map_err(|error| format!("{name}: {error}"))?;
            }
            parts.values_mut().try_for_each(set_in)
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn chapters_in_chapters_are_found() {
        let page = "$$\nx\n$$\n";
        let inner = json!({ "Chapter": { "name": "b", "content": page, "sub_items": [] } });
        let outer = json!({ "Chapter": { "name": "a", "content": "x", "sub_items": [inner] } });
        let mut book = json!({ "items": [outer, "Separator"] });
        set_in(&mut book).unwrap_or_else(|error| panic!("{error}"));
        assert!(book.to_string().contains("<math"), "{book}");
    }
}

//! Example cases.

use std::iter;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_cases::{ALL, ReadyCase};

use crate::refusal::Refusal;

/// The commented example, whose text is that of `wholestring new`: its name and title.
const COMMENTED: (&str, &str) =
    ("my-well", "A commented case to start with, in which every line is explained");

/// An example case in a list.
#[derive(Debug, Serialize, ToSchema)]
pub struct ExampleEntry {
    /// Its identifier, and a name for its file without the extension.
    name: &'static str,
    /// Description, in a sentence.
    title: &'static str,
}

/// An example case with its text.
#[derive(Debug, Serialize, ToSchema)]
pub struct Example {
    /// Its identifier.
    name: &'static str,
    /// Description, in a sentence.
    title: &'static str,
    /// Its text.
    text: String,
    /// Files that it names.
    beside: Vec<ExampleFile>,
}

/// A file that an example names.
#[derive(Debug, Serialize, ToSchema)]
pub struct ExampleFile {
    /// Its name.
    file_name: &'static str,
    /// Its contents.
    text: &'static str,
}

/// The example cases: the commented one, and wells.
pub fn list() -> Vec<ExampleEntry> {
    let wells = ALL.iter().map(|case| (case.name, case.title));
    iter::once(COMMENTED).chain(wells).map(|(name, title)| ExampleEntry { name, title }).collect()
}

/// An example case with its text.
///
/// # Errors
/// A name that none has.
pub fn example(name: &str) -> Result<Example, Refusal> {
    if name == COMMENTED.0 {
        let (name, title) = COMMENTED;
        let text = wholestring_case::new_case(name);
        return Ok(Example { name, title, text, beside: Vec::new() });
    }
    let found = ALL.iter().find(|one| one.name == name);
    let &ReadyCase { name, title, text, beside, .. } =
        found.ok_or_else(|| Refusal::not_found("there is no such example"))?;
    let beside = beside.iter().map(|(file_name, text)| ExampleFile { file_name, text });
    Ok(Example { name, title, text: text.to_owned(), beside: beside.collect() })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use wholestring_case::Template;

    use super::{example, list};

    #[test]
    fn every_example_is_sound_with_what_is_beside_it() {
        for entry in list() {
            let example = example(entry.name).unwrap();
            let beside = example.beside.iter();
            let beside: BTreeMap<String, Vec<u8>> = beside
                .map(|file| (file.file_name.to_owned(), file.text.as_bytes().to_owned()))
                .collect();
            let template = Template::in_memory(example.name, &example.text, beside.clone());
            let case = template.case(&[]);
            assert!(case.is_ok(), "{}", case.unwrap_err().render(false));
            for name in beside.keys() {
                assert!(example.text.contains(name.as_str()), "{name}");
            }
        }
    }
}

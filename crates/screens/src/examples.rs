//! Cases to begin with, embedded.

use serde::Serialize;
use utoipa::ToSchema;

use crate::refusal::Refusal;

/// A case to begin with, as it is embedded.
#[derive(Debug)]
struct Embedded {
    /// Its name, that of its file without the ending.
    name: &'static str,
    /// What it is, in a sentence.
    title: &'static str,
    /// Its text; of the commented one, nothing: that is the command's.
    text: Option<&'static str>,
    /// The files that it names.
    beside: &'static [(&'static str, &'static str)],
}

impl Embedded {
    /// Its text.
    fn text(&self) -> String {
        self.text.map_or_else(|| wholestring_case::new_case(self.name), str::to_owned)
    }
}

/// Names cases of `cases/`, each with its title and the files that it names.
macro_rules! examples {
    ($($name:literal: $title:literal $(with $beside:literal)*;)*) => {
        &[
            Embedded {
                name: "my-well",
                title: "A commented case to begin with, every line of which says what it means",
                text: None,
                beside: &[],
            },
            $(Embedded {
                name: $name,
                title: $title,
                text: Some(include_str!(concat!("../../../cases/", $name, ".toml"))),
                beside: &[$(($beside, include_str!(concat!("../../../cases/", $beside)))),*],
            }),*
        ]
    };
}

/// The cases to begin with.
const EXAMPLES: &[Embedded] = examples! {
    "vertical": "A vertical well of 1500 m: hook load is buoyed weight";
    "slant": "A slant well of 1200 m that builds to 42 deg";
    "horizontal": "A shallow horizontal well of 1100 m with heavy-weight pipe above the lateral";
    "lateral-that-cannot-be-drilled": "A lateral of 3100 m with nothing but light pipe in the hole";
    "bent-motor": "A bent motor that slides in a tangent: an assembly to look at";
    "np13-x1042": "A highly deviated well of 4305 m, from a published article"
        with "np13-x1042-survey.csv";
    "iscwsa-04": "ISCWSA standard wellpath 04: a horizontal well that turns twice"
        with "iscwsa-04-survey.csv";
    "forge-16a": "Utah FORGE 16A(78)-32, a geothermal well in granite, with what the rig has read"
        with "forge-16a-survey.csv" with "forge-16a-measured.csv";
    "well-b-2235": "A string that sticks and slips off bottom, from a published article";
    "rock-300": "A short string that drills solid rock, element by element";
};

/// A case to begin with, in a list.
#[derive(Debug, Serialize, ToSchema)]
pub struct ExampleEntry {
    /// What it is asked for by, and a name for its file without the ending.
    name: &'static str,
    /// What it is, in a sentence.
    title: &'static str,
}

/// A case to begin with, whole.
#[derive(Debug, Serialize, ToSchema)]
pub struct Example {
    /// What it is asked for by.
    name: &'static str,
    /// What it is, in a sentence.
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
    /// What it holds.
    text: &'static str,
}

/// The cases to begin with: the commented one, and wells.
pub fn list() -> Vec<ExampleEntry> {
    EXAMPLES.iter().map(|of| ExampleEntry { name: of.name, title: of.title }).collect()
}

/// A case to begin with, whole.
///
/// # Errors
/// A name that none has.
pub fn example(name: &str) -> Result<Example, Refusal> {
    let found = EXAMPLES.iter().find(|one| one.name == name);
    let found = found.ok_or_else(|| Refusal::not_found("there is no such example"))?;
    let beside = found.beside.iter().map(|(file_name, text)| ExampleFile { file_name, text });
    Ok(Example {
        name: found.name,
        title: found.title,
        text: found.text(),
        beside: beside.collect(),
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use wholestring_case::Template;

    use super::EXAMPLES;

    #[test]
    fn every_example_is_sound_with_what_is_beside_it() {
        for example in EXAMPLES {
            let beside = example.beside.iter();
            let beside: BTreeMap<String, Vec<u8>> = beside
                .map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_owned()))
                .collect();
            let template = Template::in_memory(example.name, &example.text(), beside.clone());
            let case = template.case(&[]);
            assert!(case.is_ok(), "{}", case.unwrap_err().render(false));
            for name in beside.keys() {
                assert!(example.text().contains(name.as_str()), "{name}");
            }
        }
    }
}

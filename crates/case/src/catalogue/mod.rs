//! A user's own tubulars: a file beside the case.

mod columns;
mod tubular;

use std::path::Path;

use wholestring::string::catalogue::{self, CatalogueEntry, CatalogueError};
use wholestring_config::{diagnostic::Report, file, kind::Kind, node, prelude::*};

use crate::beside::read_beside;
use tubular::TubularTable;

table! {
    /// Tubulars of one's own.
    OwnTable in "the catalogue" {
        /// A tubular.
        tubular: Vec<Spanned<TubularTable>> = required(List::tables::<TubularTable>(
            "tubulars ([[tubular]])", 5000,
        ));
    }
}

static CATALOGUE_FILE: Kind =
    Kind { noun: "catalogue", needs: "it needs a [[tubular]]", tables: || &SCHEMA };

static SCHEMA: std::sync::LazyLock<serde_json::Value> = std::sync::LazyLock::new(OwnTable::schema);

/// JSON schema of a user's own catalogue.
pub fn catalogue_schema() -> serde_json::Value {
    let mut schema = SCHEMA.clone();
    schema["title"] = serde_json::json!("a catalogue of one's own");
    schema
}

/// A user's own tubulars, which come before those that are built in.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct OwnCatalogue(Vec<CatalogueEntry>);

impl OwnCatalogue {
    /// The entries, in the order of the file.
    pub fn entries(&self) -> &[CatalogueEntry] {
        &self.0
    }

    /// The catalogue of a file: TOML, or CSV where its name ends so.
    ///
    /// # Errors
    /// A report of every mistake that was found, if there is one.
    pub fn load(path: &Path) -> Result<Self, Report> {
        let (name, bytes) = file::read_file(path, CATALOGUE_FILE.noun)?;
        let mut reader = Reader::of(&CATALOGUE_FILE);
        let own = Self::read(&name, &bytes, None, &mut reader);
        let failed = reader.has_errors();
        let report = reader.into_report();
        own.filter(|_| !failed).ok_or(report)
    }

    /// The catalogue that a case names.
    pub(crate) fn beside(
        file: &Spanned<String>,
        files: &dyn Files,
        reader: &mut Reader,
    ) -> Option<Self> {
        let bytes = read_beside(file, CATALOGUE_FILE.noun, files, reader)?;
        Self::read(&file.value, &bytes, Some(file.place), reader)
    }

    /// `place` is that of the file's name, where a case has it.
    fn read(name: &str, bytes: &[u8], place: Option<Span>, reader: &mut Reader) -> Option<Self> {
        let mistake = |message: String, expected: &str| {
            let diagnostic = Diagnostic::error(message);
            match place {
                Some(place) => diagnostic.at(place, expected),
                None => diagnostic.help(expected),
            }
        };
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let Ok(text) = std::str::from_utf8(bytes) else {
            return mistake(
                format!("the catalogue `{}` is not a text", short(name)),
                "expected TOML or CSV in UTF-8",
            )
            .refuse(reader);
        };
        if text.trim().is_empty() {
            let message = format!("the catalogue `{}` is empty", short(name));
            return mistake(message, CATALOGUE_FILE.needs).refuse(reader);
        }
        let source = reader.add_source(name, text);
        let is_csv =
            Path::new(name).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"));
        let parsed = match is_csv {
            true => columns::parse(text, source).map_err(|mistake| vec![mistake]),
            false => node::parse_text(text, source),
        };
        let root = match parsed {
            Ok(root) => root,
            Err(mistakes) => {
                mistakes.into_iter().for_each(|mistake| reader.report(mistake));
                return None;
            }
        };
        let whole = Span { source, start: 0, end: text.lines().next().map_or(0, str::len) };
        let table = OwnTable::read(&root, whole, reader);
        let mut entries: Vec<(CatalogueEntry, Span)> = Vec::new();
        let mut valid = true;
        for tubular in table.tubular.get()? {
            let Some(entry) = tubular.value.build(tubular.place, reader) else {
                valid = false;
                continue;
            };
            let named = tubular.value.name.at().map_or(tubular.place, |at| at.place);
            let same = |(other, _): &&(CatalogueEntry, Span)| {
                key(&other.designation) == key(&entry.designation)
            };
            if let Some((_, first)) = entries.iter().find(same) {
                let message = format!("there are two tubulars `{}`", short(&entry.designation));
                reader.report(
                    Diagnostic::error(message)
                        .at(named, "again here")
                        .at(*first, "first here")
                        .help("each needs a name of its own"),
                );
                valid = false;
            } else {
                entries.push((entry, named));
            }
        }
        valid.then(|| Self(entries.into_iter().map(|(entry, _)| entry).collect()))
    }

    /// The tubular of a name, without regard to capitals and blanks: of one's own, or built in.
    pub(crate) fn find(&self, designation: &str) -> Result<CatalogueEntry, CatalogueError> {
        let wanted = key(designation);
        match self.0.iter().find(|entry| key(&entry.designation) == wanted) {
            Some(entry) => Ok(entry.clone()),
            None => catalogue::find(designation),
        }
    }

    /// Names of one's own that are spelt nearly so.
    pub(crate) fn nearest(&self, designation: &str) -> Option<&str> {
        nearest(designation, self.0.iter().map(|entry| entry.designation.as_str()))
    }
}

/// What is compared of a name.
fn key(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase()
}

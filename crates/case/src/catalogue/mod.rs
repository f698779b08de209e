//! A user's own tubulars and casings, from a file that the case names.

mod casing;
mod columns;
mod tubular;

use std::path::Path;

use wholestring::{
    string::catalogue::{self, CatalogueEntry, CatalogueError},
    well::casing::{Casing, UnknownCasing, find as find_casing},
};
use wholestring_config::{diagnostic::Report, file, kind::Kind, node, prelude::*};

use crate::beside::read_beside;
use casing::OwnCasingTable;
use tubular::TubularTable;

table! {
    /// Tubulars and casings of the user's own.
    OwnTable in "the catalogue" {
        /// A tubular of a string.
        tubular: Vec<Spanned<TubularTable>> = optional(List::tables::<TubularTable>(
            "tubulars ([[tubular]])", 5000,
        ));
        /// A casing of a hole.
        casing: Vec<Spanned<OwnCasingTable>> = optional(List::tables::<OwnCasingTable>(
            "casings ([[casing]])", 5000,
        ));
    }
}

static CATALOGUE_FILE: Kind =
    Kind { noun: "catalogue", needs: "it needs a [[tubular]] or a [[casing]]", tables: || &SCHEMA };

static SCHEMA: std::sync::LazyLock<serde_json::Value> = std::sync::LazyLock::new(OwnTable::schema);

/// JSON schema of a user's own catalogue.
pub fn catalogue_schema() -> serde_json::Value {
    let mut schema = SCHEMA.clone();
    schema["title"] = serde_json::json!("a catalogue of one's own");
    schema
}

/// A user's own tubulars and casings, which take precedence over the built-in ones.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct OwnCatalogue {
    tubulars: Vec<CatalogueEntry>,
    casings: Vec<Casing>,
}

impl OwnCatalogue {
    /// The tubulars, in the order of the file.
    pub fn entries(&self) -> &[CatalogueEntry] {
        &self.tubulars
    }

    /// The casings, in the order of the file.
    pub fn casings(&self) -> &[Casing] {
        &self.casings
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

    /// Reads the catalogue that a case names.
    pub(crate) fn beside(
        file: &Spanned<String>,
        files: &dyn Files,
        reader: &mut Reader,
    ) -> Option<Self> {
        let bytes = read_beside(file, CATALOGUE_FILE.noun, files, reader)?;
        Self::read(&file.value, &bytes, Some(file.place), reader)
    }

    /// Reads a catalogue; `place` is that of the file's name, where a case has it.
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
        let (tubulars, casings) = (table.tubular.optional()?, table.casing.optional()?);
        if tubulars.is_none() && casings.is_none() {
            let message = format!("the catalogue `{}` is empty", short(name));
            return mistake(message, CATALOGUE_FILE.needs).refuse(reader);
        }
        let tubulars = tubulars.map_or(&[][..], |at| &at.value[..]);
        let tubulars = distinct("tubulars", tubulars, reader, |tubular, reader| {
            let entry = tubular.value.build(tubular.place, reader)?;
            Some((entry.designation.clone(), tubular.value.name.place(), entry))
        });
        let casings = casings.map_or(&[][..], |at| &at.value[..]);
        let casings = distinct("casings", casings, reader, |casing, reader| {
            let built = casing.value.build(reader)?;
            Some((built.designation.clone(), casing.value.name.place(), built))
        });
        Some(Self { tubulars: tubulars?, casings: casings? })
    }

    /// Finds the tubular of a name, without regard to capitals and blanks, in the user's own
    /// catalogue or among the built-in ones.
    pub(crate) fn find(&self, designation: &str) -> Result<CatalogueEntry, CatalogueError> {
        let sought = key(designation);
        match self.tubulars.iter().find(|entry| key(&entry.designation) == sought) {
            Some(entry) => Ok(entry.clone()),
            None => catalogue::find(designation),
        }
    }

    /// Returns the name of a tubular of the user's own with a similar spelling.
    pub(crate) fn nearest(&self, designation: &str) -> Option<&str> {
        nearest(designation, self.tubulars.iter().map(|entry| entry.designation.as_str()))
    }

    /// Finds the casing of a name, likewise.
    pub(crate) fn find_casing(&self, designation: &str) -> Result<Casing, UnknownCasing> {
        let sought = key(designation);
        match self.casings.iter().find(|casing| key(&casing.designation) == sought) {
            Some(casing) => Ok(casing.clone()),
            None => find_casing(designation),
        }
    }

    /// Returns the name of a casing of the user's own with a similar spelling.
    pub(crate) fn nearest_casing(&self, designation: &str) -> Option<&str> {
        nearest(designation, self.casings.iter().map(|casing| casing.designation.as_str()))
    }
}

/// Returns the items of tables, each with a distinct name; `None` after a mistake.
fn distinct<T, E>(
    noun: &str,
    tables: &[Spanned<T>],
    reader: &mut Reader,
    build: impl Fn(&Spanned<T>, &mut Reader) -> Option<(String, Option<Span>, E)>,
) -> Option<Vec<E>> {
    let mut found: Vec<(String, Span, E)> = Vec::new();
    let mut valid = true;
    for table in tables {
        let Some((name, place, one)) = build(table, reader) else {
            valid = false;
            continue;
        };
        let named = place.unwrap_or(table.place);
        if let Some((_, first, _)) = found.iter().find(|(other, ..)| key(other) == key(&name)) {
            reader.report(
                Diagnostic::error(format!("there are two {noun} `{}`", short(&name)))
                    .at(named, "again here")
                    .at(*first, "first here")
                    .help("each needs a name of its own"),
            );
            valid = false;
        } else {
            found.push((name, named, one));
        }
    }
    valid.then(|| found.into_iter().map(|(.., one)| one).collect())
}

/// The form of a name in which names are compared.
fn key(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase()
}

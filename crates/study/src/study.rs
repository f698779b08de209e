//! A study: its top level, and the conversion of a text into a [`Study`].

use std::{path::Path, sync::LazyLock};

use serde_json::json;
use wholestring_case::rules::UNIT_SETS;
use wholestring_config::{
    Json,
    diagnostic::Report,
    file::{read_file, tree},
    kind::Kind,
    prelude::*,
};
use wholestring_units::UnitSet;

use crate::{
    column::{ColumnName, Quantity, Source},
    figure::Figure,
    figure_table::FigureTable,
    numbers::NumberTable,
    numbers_table::NumbersTable,
    sweep::{self, Sweep, SweepTable},
};

table! {
    /// A set of cases, and the figures and tables of their results.
    StudyTable in "the study" {
        /// Name of the study on its page. Default: the name of the file.
        name: String = optional(Text);
        /// Purpose and method of the study, at the top of its page.
        description: String = optional(Prose);
        /// Units of figures and tables: "si" (m, kN, kN.m, mm, kg/m3), "metric" (m, t, kN.m, mm,
        /// sg) or "field" (ft, klbf, ft-lbf, in, ppg). Their data as CSV are always SI.
        units: UnitSet = default(UNIT_SETS, UnitSet::Si);
        /// The cases to solve.
        sweep: Vec<Spanned<SweepTable>> = required(List::tables::<SweepTable>(
            "sweeps ([[sweep]])", 100,
        ));
        /// The figures, in the order of the page.
        figure: Vec<Spanned<FigureTable>> = optional(List::tables::<FigureTable>(
            "figures ([[figure]])", 500,
        ));
        /// The tables, in the order of the page.
        table: Vec<Spanned<NumbersTable>> = optional(List::tables::<NumbersTable>(
            "tables ([[table]])", 100,
        ));
    }
}

/// A study in which everything but its cases has been checked.
#[derive(Debug, Clone)]
pub struct Study {
    /// Its name.
    pub name: String,
    /// Purpose and method; may be empty.
    pub description: String,
    /// Units of figures and tables.
    pub units: UnitSet,
    /// The cases.
    pub sweeps: Vec<Sweep>,
    /// The figures.
    pub figures: Vec<Figure>,
    /// The tables.
    pub tables: Vec<NumberTable>,
    /// Usable but probably unintended settings.
    pub warnings: Report,
}

impl Study {
    /// Whether a figure or a number uses tables of the cases of a sweep, by its index; otherwise
    /// only summaries.
    pub fn reads_tables_of(&self, sweep: usize) -> bool {
        let reads =
            |quantity: &Quantity| !matches!(quantity.column.source, Source::Summary | Source::Path);
        let figures = self.figures.iter().filter(|figure| figure.chosen.sweeps.contains(&sweep));
        let rows = self.tables.iter().flat_map(|table| &table.rows);
        let mut rows = rows.filter(|row| row.chosen.sweeps.contains(&sweep));
        figures.flat_map(Figure::quantities).any(reads)
            || rows.any(|row| reads(&row.number.quantity))
    }
}

static STUDY_FILE: Kind =
    Kind { noun: "study", needs: "it needs at least one [[sweep]]", tables: || &TABLES };

static TABLES: LazyLock<Json> = LazyLock::new(StudyTable::schema);

/// JSON schema (draft 2020-12) of the study file: every key with its meaning, units, range and
/// default.
pub fn schema() -> Json {
    let mut schema = TABLES.clone();
    schema["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    schema["title"] = json!("wholestring study");
    schema
}

/// Reads the study at `path`. `columns` are those available to its figures and tables.
///
/// # Errors
/// A report of every mistake, if there is one. The cases themselves are not read.
pub fn load(path: &Path, columns: &[ColumnName]) -> Result<Study, Report> {
    let (name, text) = read_file(path, "study")?;
    parse(&name, &text, columns)
}

/// Reads a study from its text; `name` is its name in diagnostics.
///
/// # Errors
/// As [`load`].
pub fn parse(name: &str, text: &[u8], columns: &[ColumnName]) -> Result<Study, Report> {
    let (root, mut reader) = tree(name, text, &STUDY_FILE)?;
    let table = StudyTable::read(&root, Span::default(), &mut reader);
    let study = build(name, &table, columns, &mut reader);
    let failed = reader.has_errors();
    let report = reader.into_report();
    match study {
        Some(study) if !failed => Ok(Study { warnings: report, ..study }),
        _ => Err(report),
    }
}

fn build(
    name: &str,
    table: &StudyTable,
    columns: &[ColumnName],
    reader: &mut Reader,
) -> Option<Study> {
    let sweeps = sweep::build(table.sweep.get()?, reader)?;
    let all = |tables: usize, built: usize| (tables == built).then_some(());
    let figure_tables = table.figure.optional()?.map_or(&[][..], |at| &at.value);
    let mut names = Names::default();
    let figures: Vec<Figure> = figure_tables
        .iter()
        .enumerate()
        .filter_map(|(index, at)| {
            let name = names.name(&at.value.name, "figure", index, reader)?;
            at.value.build(name, at.place, &sweeps, columns, reader)
        })
        .collect();
    let tables_given = table.table.optional()?.map_or(&[][..], |at| &at.value);
    let tables: Vec<NumberTable> = tables_given
        .iter()
        .enumerate()
        .filter_map(|(index, at)| {
            let name = names.name(&at.value.name, "table", index, reader)?;
            at.value.build(name, &sweeps, columns, reader)
        })
        .collect();
    all(figure_tables.len(), figures.len())?;
    all(tables_given.len(), tables.len())?;
    let stem = || {
        let stem = Path::new(name).file_stem();
        stem.map_or_else(|| "study".to_owned(), |stem| stem.to_string_lossy().into_owned())
    };
    Some(Study {
        name: table.name.optional()?.map_or_else(stem, |at| at.value.clone()),
        description: table.description.text()?,
        units: *table.units.get()?,
        sweeps,
        figures,
        tables,
        warnings: Report::default(),
    })
}

/// File names, each used once.
#[derive(Default)]
struct Names(Vec<String>);

impl Names {
    /// The given name, or one made of the kind and number.
    fn name(
        &mut self,
        field: &Field<String>,
        kind: &str,
        index: usize,
        reader: &mut Reader,
    ) -> Option<String> {
        let name = match field.optional()? {
            Some(at) => {
                let name = at.value.to_lowercase();
                if self.0.contains(&name) {
                    let message = format!("two are named `{}`", short(&at.value));
                    return Diagnostic::error(message)
                        .at(at.place, "expected another file name")
                        .refuse(reader);
                }
                at.value.clone()
            }
            None => format!("{kind}-{:02}", index + 1),
        };
        self.0.push(name.to_lowercase());
        Some(name)
    }
}

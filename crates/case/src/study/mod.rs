//! Study files: sweeps of cases, and the figures and tables to make of them.

mod column;
mod figure;
mod numbers;
mod selection;
mod sweep;

use std::path::Path;

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_units::UnitSet;

pub use self::{
    column::{ColumnName, Quantity, Source, Statistic},
    figure::{Abscissa, Figure, FigureData, Level, Pointing},
    numbers::{Number, NumberTable, Row, Shape, Wanted},
    selection::Selection,
    sweep::{Exception, Sweep},
};
use self::{figure::FigureTable, numbers::NumbersTable, sweep::SweepTable};
use wholestring_config::{
    diagnostic::{Diagnostic, Report},
    file::{read_file, tree},
    kind::Kind,
    names::{nearest, short},
    reader::Reader,
    rule::{At, List, Prose, Section, Table, Text},
    source::Place,
    table::{Field, default, optional, required, table},
};

use crate::{model_rule::ModelRule, unit_set::UNIT_SETS};

table! {
    /// A set of cases, and the figures and tables to make of what they leave.
    StudyTable in "the study" {
        /// What the study is called on its page. Default: the name of the file.
        name: String = optional(Text);
        /// What it asks and how, on top of its page.
        description: String = optional(Prose);
        /// Units of figures and tables: "si" (m, kN, kN.m, mm, kg/m3), "metric" (m, t, kN.m, mm, sg) or
        /// "field" (ft, klbf, ft-lbf, in, ppg). Their data as CSV are SI always.
        units: UnitSet = default(UNIT_SETS, UnitSet::Si);
        /// The cases to solve.
        sweep: Vec<At<SweepTable>> = required(List {
            item: Section::<SweepTable>::RULE,
            or_one: false,
            noun: "sweeps ([[sweep]])",
            most: 100,
        });
        /// The figures, in the order of the page.
        figure: Vec<At<FigureTable>> = optional(List {
            item: Section::<FigureTable>::RULE,
            or_one: false,
            noun: "figures ([[figure]])",
            most: 500,
        });
        /// The tables, in the order of the page.
        table: Vec<At<NumbersTable>> = optional(List {
            item: Section::<NumbersTable>::RULE,
            or_one: false,
            noun: "tables ([[table]])",
            most: 100,
        });
    }
}

/// A study in which everything has been checked but its cases.
#[derive(Debug, Clone)]
pub struct Study {
    /// What it is called.
    pub name: String,
    /// What it asks and how; may be empty.
    pub description: String,
    /// Units of figures and tables.
    pub units: UnitSet,
    /// The cases.
    pub sweeps: Vec<Sweep>,
    /// The figures.
    pub figures: Vec<Figure>,
    /// The tables.
    pub tables: Vec<NumberTable>,
    /// What is probably not meant, but can be done.
    pub warnings: Report,
}

/// Whose answers a figure or a number shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Chosen {
    /// Sweeps, as indices into [`Study::sweeps`].
    pub sweeps: Vec<usize>,
    /// Models; all where it is empty.
    pub models: Vec<ModelKind>,
    /// Operations; all where it is empty.
    pub operations: Vec<OperationKind>,
    /// Cases.
    pub only: Selection,
}

impl Study {
    /// Whether a figure or a number is made from tables that the cases of a sweep leave, by its index; from their
    /// summaries otherwise.
    pub fn reads_tables_of(&self, sweep: usize) -> bool {
        let reads =
            |quantity: &Quantity| !matches!(quantity.column.source, Source::Summary | Source::Path);
        let figures = self
            .figures
            .iter()
            .filter(|of| of.chosen.sweeps.contains(&sweep));
        let rows = self.tables.iter().flat_map(|table| &table.rows);
        let mut rows = rows.filter(|of| of.chosen.sweeps.contains(&sweep));
        figures.flat_map(Figure::quantities).any(reads)
            || rows.any(|row| reads(&row.number.quantity))
    }
}

static STUDY_FILE: Kind = Kind {
    noun: "study",
    needs: "it needs at least one [[sweep]]",
    tables: || &crate::schema::STUDY_TABLES,
};

/// Reads the study at `path`. `columns` is what its figures and tables may show.
///
/// # Errors
/// A report of every mistake that was found, if there is one. The cases themselves are not read.
pub fn load(path: &Path, columns: &[ColumnName]) -> Result<Study, Report> {
    let (name, text) = read_file(path, "study")?;
    parse(&name, &text, columns)
}

/// Reads a study from its text; `name` is what diagnostics call it.
///
/// # Errors
/// As [`load`].
pub fn parse(name: &str, text: &[u8], columns: &[ColumnName]) -> Result<Study, Report> {
    let (root, mut reader) = tree(name, text, &STUDY_FILE)?;
    let table = StudyTable::read(&root, Place::default(), &mut reader);
    let study = build(name, &table, columns, &mut reader);
    let failed = reader.has_errors();
    let report = reader.into_report();
    match study {
        Some(study) if !failed => Ok(Study {
            warnings: report,
            ..study
        }),
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
    let given = table.figure.optional()?.map_or(&[][..], |at| &at.value);
    let mut names = Names::default();
    let figures: Vec<Figure> = given
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
    all(given.len(), figures.len())?;
    all(tables_given.len(), tables.len())?;
    let stem = || {
        let stem = Path::new(name).file_stem();
        stem.map_or_else(
            || "study".to_owned(),
            |stem| stem.to_string_lossy().into_owned(),
        )
    };
    Some(Study {
        name: table
            .name
            .optional()?
            .map_or_else(stem, |at| at.value.clone()),
        description: text(&table.description)?,
        units: *table.units.get()?,
        sweeps,
        figures,
        tables,
        warnings: Report::default(),
    })
}

/// A text that may be left out.
fn text(field: &Field<String>) -> Option<String> {
    Some(
        field
            .optional()?
            .map_or_else(String::new, |at| at.value.clone()),
    )
}

/// Names of files, each given once.
#[derive(Default)]
struct Names(Vec<String>);

impl Names {
    /// The name that is given, or one of the kind and number.
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
                    reader.report(
                        Diagnostic::error(message).at(at.place, "expected another file name"),
                    );
                    return None;
                }
                at.value.clone()
            }
            None => format!("{kind}-{:02}", index + 1),
        };
        self.0.push(name.to_lowercase());
        Some(name)
    }
}

/// The name of a file without its ending: what every system takes.
pub(crate) struct FileName;

impl wholestring_config::rule::Rule for FileName {
    type Value = String;

    fn read(&self, node: &wholestring_config::node::Node, reader: &mut Reader) -> Option<String> {
        let name = Text.read(node, reader)?;
        let sound = |letter: char| letter.is_ascii_alphanumeric() || "-_ +=,()".contains(letter);
        if name.chars().all(sound) && name.len() <= 80 && name.trim() == name {
            return Some(name);
        }
        let message = format!("`{}` makes no file name on every system", short(&name));
        reader.report(Diagnostic::error(message).at(
            node.place,
            "expected letters, digits, blanks and - _ + = , ( ), 80 at most",
        ));
        None
    }

    fn schema(&self) -> serde_json::Value {
        serde_json::json!({ "type": "string", "pattern": "^[A-Za-z0-9_+=,() -]{1,80}$" })
    }
}

/// The keys that choose cases, as a figure, a table and a row have them.
struct Choosing<'a> {
    sweeps: &'a Field<Vec<At<String>>>,
    models: &'a Field<Vec<At<ModelKind>>>,
    operations: &'a Field<Vec<At<OperationKind>>>,
    only: &'a Field<Selection>,
}

impl Choosing<'_> {
    /// What is chosen; all of `outer` where a key is not given.
    fn within(&self, outer: &Chosen, sweeps: &[Sweep], reader: &mut Reader) -> Option<Chosen> {
        let named = match self.sweeps.optional()? {
            None => Some(outer.sweeps.clone()),
            Some(names) => names
                .value
                .iter()
                .map(|at| sweep_named(at, sweeps, reader))
                .collect(),
        };
        let models = self.models.optional()?;
        let operations = self.operations.optional()?;
        let mut only = outer.only.clone();
        if let Some(more) = self.only.optional()? {
            only = only.narrowed(&more.value);
        }
        let chosen = Chosen {
            sweeps: named?,
            models: models.map_or_else(
                || outer.models.clone(),
                |at| at.value.iter().map(|at| at.value).collect(),
            ),
            operations: operations.map_or_else(
                || outer.operations.clone(),
                |at| at.value.iter().map(|at| at.value).collect(),
            ),
            only,
        };
        for sweep in &chosen.sweeps {
            chosen.only.check(&sweeps[*sweep], reader)?;
        }
        Some(chosen)
    }
}

impl Chosen {
    fn all(sweeps: &[Sweep]) -> Self {
        Self {
            sweeps: (0..sweeps.len()).collect(),
            models: Vec::new(),
            operations: Vec::new(),
            only: Selection::default(),
        }
    }
}

fn sweep_named(at: &At<String>, sweeps: &[Sweep], reader: &mut Reader) -> Option<usize> {
    let found = sweeps.iter().position(|sweep| sweep.name == at.value);
    if found.is_none() {
        let names: Vec<&str> = sweeps.iter().map(|sweep| sweep.name.as_str()).collect();
        let mut diagnostic = Diagnostic::error(format!("there is no sweep `{}`", short(&at.value)))
            .at(at.place, "expected the name of a [[sweep]]");
        if let Some(near) = nearest(&at.value, names.iter().copied()) {
            diagnostic = diagnostic.help(format!("did you mean \"{near}\"?"));
        }
        reader.report(diagnostic.help(format!("sweeps of this study: {}", names.join(", "))));
    }
    found
}

/// Warns of keys that say nothing here.
fn unheeded(
    fields: impl IntoIterator<Item = (&'static str, Option<Place>)>,
    why: &str,
    reader: &mut Reader,
) {
    for (name, place) in fields {
        if let Some(place) = place {
            let message = format!("`{name}` has no effect here");
            reader.report(Diagnostic::warning(message).at(place, why));
        }
    }
}

fn place<T>(field: &Field<T>) -> Option<Place> {
    field.given().map(|at| at.place)
}

const NAMES: List<Text> = List {
    item: Text,
    or_one: true,
    noun: "names of sweeps",
    most: 100,
};

const MODELS: List<ModelRule> = List {
    item: ModelRule,
    or_one: true,
    noun: "models",
    most: 10,
};

const OPERATIONS: List<crate::operation_kind::KindRule> = List {
    item: crate::operation_kind::KindRule,
    or_one: true,
    noun: "operations",
    most: 7,
};

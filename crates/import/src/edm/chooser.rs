//! Selection of well, wellbore and case in an export.

use super::{
    reader::parent,
    row::{Row, Rows},
    table::Table,
};
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::Note,
};

/// Rows of the selected case or path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chosen<'a> {
    pub(super) well: Option<Row<'a>>,
    pub(super) wellbore: Option<Row<'a>>,
    /// The case; `None` in an export of paths only.
    pub(super) case: Option<Row<'a>>,
    pub(super) scenario: Option<Row<'a>>,
    /// The path of an export without cases.
    pub(super) path: Option<Row<'a>>,
}

impl Chosen<'_> {
    /// Name of a case, for messages.
    pub(super) fn name(&self) -> String {
        let name = |row: Option<Row>| row.map(|row| label(row).to_owned());
        let names = [name(self.wellbore.or(self.well)), name(self.case)];
        names.into_iter().flatten().collect::<Vec<_>>().join(", ")
    }
}

/// Names that `--pick` accepts, in the order in which they are required.
const LEVELS: [&str; 5] = ["well", "wellbore", "case", "scenario", "wellpath"];

/// A possible selection: the row at each level.
struct Candidate<'a> {
    levels: [Option<Row<'a>>; LEVELS.len()],
}

/// Name of a row, or its id.
pub(super) fn label(row: Row<'_>) -> &str {
    let columns: &[&str] = match row.table {
        Table::Well => &["well_common_name", "well_legal_name", "well_id"],
        Table::Wellbore => &["wellbore_name", "wellbore_id"],
        Table::Case => &["case_name", "case_id"],
        Table::Scenario => &["name", "scenario_id"],
        Table::SurveyHeader => &["name", "def_survey_header_id"],
        Table::Assembly => &["assembly_name", "assembly_id"],
        Table::Datum => &["datum_name", "datum_id"],
        Table::Fluid => &["fluid_name", "fluid_id"],
        _ => &[],
    };
    columns.iter().find_map(|column| row.get(column)).unwrap_or("without a name")
}

/// Whether a picked name is the name or id of a row.
fn is_called(row: Row, picked: &str) -> bool {
    let id = match row.table {
        Table::Well => "well_id",
        Table::Wellbore => "wellbore_id",
        Table::Case => "case_id",
        Table::Scenario => "scenario_id",
        _ => "def_survey_header_id",
    };
    label(row).eq_ignore_ascii_case(picked) || row.get(id) == Some(picked)
}

/// Distinct names in file order.
fn names<'a>(rows: impl Iterator<Item = Row<'a>>) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let mut seen = std::collections::HashSet::new();
    for row in rows {
        if seen.insert(label(row)) {
            names.push(label(row).to_owned());
        }
    }
    names
}

/// Selects by the user's choice, and adds a note on the selection.
pub(super) fn choose<'a>(
    rows: &'a Rows,
    choices: &Choices,
    notes: &mut Vec<Note>,
) -> Result<Chosen<'a>, ImportError> {
    let mut left = candidates(rows)?;
    let all = left.len();
    for (level, what) in LEVELS.iter().enumerate() {
        let has_level = left.iter().any(|one| one.levels[level].is_some());
        let picked = if has_level { choices.picked(what) } else { None };
        let Some(picked) = picked else { continue };
        let known = names(left.iter().filter_map(|one| one.levels[level]));
        left.retain(|one| one.levels[level].is_some_and(|row| is_called(row, picked)));
        if left.is_empty() {
            let kind = ImportErrorKind::NoSuch {
                what: (*what).to_owned(),
                name: picked.to_owned(),
                names: known,
            };
            return Err(rows.error(kind));
        }
    }
    if left.len() > 1 {
        return Err(rows.error(ambiguous(&left)));
    }
    let Some(one) = left.pop() else {
        return Err(rows.error(ImportErrorKind::Missing {
            what: "a case (CD_CASE) or a path (CD_DEFINITIVE_SURVEY_HEADER)".to_owned(),
        }));
    };
    let [well, wellbore, case, scenario, path] = one.levels;
    let taken: Vec<String> = LEVELS
        .iter()
        .zip(one.levels)
        .filter_map(|(what, row)| row.map(|row| format!("{what} '{}'", label(row))))
        .collect();
    let count = if all > 1 { format!(", of {all} in the file") } else { String::new() };
    notes.push(Note::Read(format!("{}{count}", taken.join(", "))));
    if let (None, Some(id)) = (scenario, case.and_then(|case| case.get("scenario_id"))) {
        notes.push(Note::Warning(format!(
            "the case refers to the scenario '{id}', which the file does not have"
        )));
    }
    Ok(Chosen { well, wellbore, case, scenario, path })
}

/// Returns the cases, or the paths if there are none, each with its parents.
fn candidates(rows: &Rows) -> Result<Vec<Candidate<'_>>, ImportError> {
    let of_cases = rows.of(Table::Case).next().is_some();
    let table = if of_cases { Table::Case } else { Table::SurveyHeader };
    let mut found: Vec<Candidate> = Vec::new();
    for row in rows.of(table) {
        let is_listed =
            |one: &Candidate| one.levels[2].or(one.levels[4]).is_some_and(|other| other.same(row));
        if found.iter().any(is_listed) {
            continue;
        }
        let above = |table, keys: &[&str]| parent(rows, table, row, keys);
        let well = above(Table::Well, &["well_id"])?;
        let wellbore = above(Table::Wellbore, &["well_id", "wellbore_id"])?;
        let scenario = match of_cases {
            true => above(Table::Scenario, &["well_id", "wellbore_id", "scenario_id"])?,
            false => None,
        };
        let own = |is: bool| is.then_some(row);
        found.push(Candidate { levels: [well, wellbore, own(of_cases), scenario, own(!of_cases)] });
    }
    Ok(found)
}

/// Error that requests the first level at which the remaining candidates differ.
fn ambiguous(left: &[Candidate]) -> ImportErrorKind {
    for (level, what) in LEVELS.iter().enumerate() {
        let names = names(left.iter().filter_map(|one| one.levels[level]));
        if names.len() > 1 {
            return ImportErrorKind::Ambiguous { what: (*what).to_owned(), names };
        }
    }
    let ids = left.iter().filter_map(|one| one.levels[2].or(one.levels[4]));
    let ids = ids.filter_map(|row| row.get("case_id").or(row.get("def_survey_header_id")));
    let what = if left[0].levels[2].is_some() { LEVELS[2] } else { LEVELS[4] };
    ImportErrorKind::Ambiguous { what: what.to_owned(), names: ids.map(str::to_owned).collect() }
}

/// Maximum number of listed cases or paths; a whole database may have thousands.
const LISTED: usize = 200;

/// Lists every candidate, one line each.
pub(super) fn list(rows: &Rows) -> Result<Vec<String>, ImportError> {
    let all = candidates(rows)?;
    let mut lines: Vec<String> = Vec::new();
    for one in all.iter().take(LISTED) {
        let named = LEVELS.iter().zip(one.levels);
        let named = named.filter_map(|(what, row)| {
            let row = row?;
            let phase = row.get("phase").filter(|_| row.table != Table::Scenario);
            let phase = phase.map_or(String::new(), |phase| format!(" ({phase})"));
            Some(format!("{what} '{}'{phase}", label(row)))
        });
        lines.push(named.collect::<Vec<_>>().join(", "));
    }
    if all.len() > LISTED {
        lines.push(format!("and {} more", all.len() - LISTED));
    }
    Ok(lines)
}

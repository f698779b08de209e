//! The surveys of a file: on several sheets, or one below the other.

use std::borrow::Cow;

use super::{
    imported::{ImportedSurvey, SurveyTable},
    preamble::{self, About},
    said::Said,
    stations::{self, Broken},
};
use crate::{
    cells::{
        self,
        table::{Source, Table},
    },
    columns::{
        header::{self, Header},
        layout,
        names::SURVEY,
    },
};

/// Maximum number of surveys one below the other; each is searched for after the previous one.
const MOST: usize = 20;

/// The surveys of a table with a header, one below the other.
pub(crate) fn each(table: &Table, header: Header, said: &Said) -> Vec<SurveyTable> {
    let mut found = Vec::new();
    let mut rest = (Cow::Borrowed(table), header);
    loop {
        let (table, header) = rest;
        let name = name(&table, &header);
        let sheet = match table.source {
            Source::Sheet { sheet, .. } => Some(sheet.to_owned()),
            Source::Text { .. } => None,
        };
        let broken = match read(&table, header.clone(), said) {
            Ok(survey) => {
                found.push(SurveyTable { name, sheet, survey: Ok(survey) });
                return found;
            }
            Err(broken) => broken,
        };
        let next = broken.behind.filter(|_| found.len() + 1 < MOST).and_then(|row| {
            let below = cells::below(&table, row);
            let header = header::find(&below, &SURVEY).ok()?;
            Some((row, below, header))
        });
        let Some((row, below, next)) = next else {
            found.push(SurveyTable { name, sheet, survey: Err(broken.error) });
            return found;
        };
        let survey = read(&cells::above(&table, row), header, said).map_err(|broken| broken.error);
        found.push(SurveyTable { name, sheet, survey });
        rest = (Cow::Owned(below), next);
    }
}

fn read(table: &Table, header: Header, said: &Said) -> Result<ImportedSurvey, Broken> {
    stations::read(table, &layout::below(table, header, said)?)
}

/// Name of a table.
fn name(table: &Table, header: &Header) -> String {
    let design = || {
        let stated = preamble::above(table, header.row).into_iter();
        stated.rev().find(|stated| stated.about == About::Design).map(|stated| stated.value)
    };
    let row = || format!("the table of {}", table.source.row_name(table.rows[header.row].end));
    match table.source {
        Source::Sheet { sheet, .. } => sheet.to_owned(),
        Source::Text { .. } => {
            design().or_else(|| preamble::title(table, header.row)).unwrap_or_else(row)
        }
    }
}

/// Adds the places of their rows to the names of tables of the same name.
pub(crate) fn told_apart(mut tables: Vec<SurveyTable>) -> Vec<SurveyTable> {
    let names: Vec<String> = tables.iter().map(|table| table.name.clone()).collect();
    for (at, table) in tables.iter_mut().enumerate() {
        if names.iter().filter(|name| **name == table.name).count() > 1 {
            table.name = match &table.survey {
                Ok(survey) => format!("{}, {}", table.name, survey.place),
                Err(_) => format!("{}, number {}", table.name, at + 1),
            };
        }
    }
    tables
}

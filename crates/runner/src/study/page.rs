//! Figures and tables of a study, and a page with all of them.

use std::path::Path;

use wholestring_report::study::{StudyFigure, StudyPage, study_html};
use wholestring_results::{ResultsError, ResultsFolder};
use wholestring_study::Study;

use super::{
    figure,
    numbers::numbers,
    results::{CaseResults, keys_of},
};
use crate::page::{FILE, write_picture};

/// Writes every figure and table, and the page.
pub(super) fn show(
    study: &Study,
    results: &CaseResults,
    folder: &ResultsFolder,
    png: bool,
) -> Result<(), ResultsError> {
    let sweeps: Vec<String> = study.sweeps.iter().map(|sweep| sweep.name.clone()).collect();
    let figures = within(folder, "figures")?;
    let tables = within(folder, "tables")?;
    let mut parts = Vec::new();
    for figure in &study.figures {
        let curves = figure::curves(figure, results)?;
        let drawn = StudyFigure { figure, curves: &curves, sweeps: &sweeps, units: study.units };
        let keys = keys_of(results.chosen(&figure.chosen));
        drawn.data(&keys).write_csv(&figures.path().join(format!("{}.csv", figure.name)))?;
        let picture = drawn.picture();
        write_picture(&figures, &figure.name, &picture, png)?;
        parts.push(drawn.part(picture, png));
    }
    for table in &study.tables {
        let computed = numbers(table, results, &sweeps, study.units)?;
        computed.data().write_csv(&tables.path().join(format!("{}.csv", table.name)))?;
        let grid = computed.grid();
        let text = computed.markdown(&grid);
        tables.write_file(&format!("{}.md", table.name), text.as_bytes())?;
        parts.push(computed.part(grid));
    }
    folder.write_file(FILE, study_html(&StudyPage::new(study, parts)).as_bytes())
}

fn within(folder: &ResultsFolder, name: &str) -> Result<ResultsFolder, ResultsError> {
    ResultsFolder::create(Path::join(folder.path(), name))
}

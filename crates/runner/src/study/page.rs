//! Figures and tables of a study, and a page with all of them.

use std::path::Path;

use wholestring_report::{StudyPage, StudyPart, study_html};
use wholestring_results::{ResultsError, ResultsFolder};
use wholestring_study::Study;

use super::{data, figure, formats, numbers::Computed, picture, results::CaseResults};
use crate::page::{FILE, PROGRAM, write_picture};

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
        let data = data::table(figure, &curves, results, &sweeps);
        data.write_csv(&figures.path().join(format!("{}.csv", figure.name)))?;
        let picture = picture::picture(figure, &curves, &sweeps, study.units);
        write_picture(&figures, &figure.name, &picture, png)?;
        parts.push(StudyPart::Figure {
            title: figure.title.clone(),
            caption: figure.caption.clone(),
            figure: (!curves.is_empty()).then(|| Box::new(picture)),
            files: format!("figures/{}", figure.name),
            painted: png,
        });
    }
    for table in &study.tables {
        let computed = Computed::of(table, results)?;
        let data = formats::data(&computed, &sweeps);
        data.write_csv(&tables.path().join(format!("{}.csv", table.name)))?;
        let grid = formats::grid(&computed, &sweeps, study.units);
        let text = formats::markdown(&table.title, &table.caption, &grid);
        tables.write_file(&format!("{}.md", table.name), text.as_bytes())?;
        parts.push(StudyPart::Table {
            title: table.title.clone(),
            caption: table.caption.clone(),
            grid,
            files: format!("tables/{}", table.name),
            endings: &["md", "csv"],
        });
    }
    let page = study_html(&StudyPage {
        program: PROGRAM.into(),
        title: study.name.clone(),
        description: study.description.clone(),
        parts,
    });
    folder.write_file(FILE, page.as_bytes())
}

fn within(folder: &ResultsFolder, name: &str) -> Result<ResultsFolder, ResultsError> {
    ResultsFolder::create(Path::join(folder.path(), name))
}

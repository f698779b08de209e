//! `wholestring study`: solves the cases of a study, and makes its figures and tables.

mod answers;
mod cases;
mod columns;
mod figure;
mod looks;
mod map;
mod numbers;
mod picture;
mod texts;

use std::path::Path;

use wholestring_case::{Report, study::Study};
use wholestring_report::{StudyPage, StudyPart, study_html};
use wholestring_results::ResultsFolder;

use self::{answers::Answers, cases::Templates, numbers::Computed};
use crate::{
    args::StudyArgs,
    color,
    failure::Failure,
    folder_name::file_name,
    keep::Keep,
    plot::write_picture,
    report::{FILE, PROGRAM},
    sweep::{Batch, Ending, Set, Sound},
    tell,
};

pub(crate) fn study(args: &StudyArgs) -> Result<(), Failure> {
    let refused = |report: Report| Failure::BadInput(report.render(color()));
    args.kept.check(&args.batch)?;
    let study = wholestring_case::study::load(&args.study, &columns::all()).map_err(refused)?;
    if !args.batch.quiet && !study.warnings.is_empty() {
        tell(&study.warnings.render(color()));
    }
    let templates = Templates::read(&study, &args.study)?;
    let sound = Sound::check(templates.points(&study, &args.overrides)?, &args.batch)?;
    let of_set = |path: &Path, set: usize| path.join(file_name(&study.sweeps[set].name));
    let claimed = sound.claim("study", &study.name, &args.batch, &of_set)?;
    let folder = &claimed.folder;
    let sets = study.sweeps.iter().enumerate().map(|(i, sweep)| {
        Ok(Set {
            prefix: format!("{}/", sweep.name),
            folder: ResultsFolder::create(folder.path().join(file_name(&sweep.name)))?,
            keys: sweep.keys().map(str::to_owned).collect(),
            keep: args.kept.keep,
            needs: if study.reads_tables_of(i) {
                Keep::Tables
            } else {
                Keep::Summary
            },
        })
    });
    let sets = sets.collect::<Result<_, Failure>>()?;
    let mut batch = Batch::new("study", &args.batch, sets, sound);
    batch.solve_all()?;
    let mut answers = Answers(Vec::new());
    for (set, point, ending) in batch.cases() {
        if let Some(Ending { solved, .. }) = ending {
            let values = (&set.keys[..], &point.values[..]);
            answers.add(
                point.set,
                values,
                solved,
                &set.folder.path().join(&point.name),
            );
        }
    }
    show(&study, &answers, folder, args.png)?;
    batch.conclude(folder.path(), args.strict)
}

/// Writes every figure and table, and the page of all.
fn show(
    study: &Study,
    answers: &Answers,
    folder: &ResultsFolder,
    png: bool,
) -> Result<(), Failure> {
    let sweeps: Vec<String> = study
        .sweeps
        .iter()
        .map(|sweep| sweep.name.clone())
        .collect();
    let figures = within(folder, "figures")?;
    let tables = within(folder, "tables")?;
    let mut parts = Vec::new();
    for of in &study.figures {
        let curves = figure::curves(of, answers)?;
        let data = figure::table(of, &curves, answers, &sweeps);
        data.write_csv(&figures.path().join(format!("{}.csv", of.name)))?;
        let picture = picture::picture(of, &curves, &sweeps, study.units);
        write_picture(&figures, &of.name, &picture, png)?;
        parts.push(StudyPart::Figure {
            title: of.title.clone(),
            caption: of.caption.clone(),
            figure: (!curves.is_empty()).then(|| Box::new(picture)),
            files: format!("figures/{}", of.name),
            painted: png,
        });
    }
    for table in &study.tables {
        let computed = Computed::of(table, answers)?;
        let data = texts::data(&computed, &sweeps);
        data.write_csv(&tables.path().join(format!("{}.csv", table.name)))?;
        let grid = texts::grid(&computed, &sweeps, study.units);
        let text = texts::markdown(&table.title, &table.caption, &grid);
        tables.write_file(&format!("{}.md", table.name), text.as_bytes())?;
        parts.push(StudyPart::Table {
            title: table.title.clone(),
            caption: table.caption.clone(),
            grid,
            files: format!("tables/{}", table.name),
        });
    }
    let page = study_html(&StudyPage {
        program: PROGRAM.into(),
        title: study.name.clone(),
        description: study.description.clone(),
        parts,
    });
    Ok(folder.write_file(FILE, page.as_bytes())?)
}

fn within(folder: &ResultsFolder, name: &str) -> Result<ResultsFolder, Failure> {
    Ok(ResultsFolder::create(Path::join(folder.path(), name))?)
}

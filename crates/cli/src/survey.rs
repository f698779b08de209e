//! `wholestring survey`: position and dogleg severity along a survey.

use std::fs;

use wholestring::well::Interpolation;
use wholestring_runner::survey::{self, Said};

use crate::{
    args::SurveyArgs,
    failure::Failure,
    terminal::{print_stderr, print_stdout},
};

pub(crate) fn survey(args: &SurveyArgs) -> Result<(), Failure> {
    let survey = survey::read(&args.survey, &Said { length_unit: args.unit })?;
    for note in &survey.notes {
        print_stderr(&format!("note: {note}\n"));
    }
    let positions = survey::positions(&survey, Interpolation::from(args.path), args.step);
    let file = args.survey.display();
    let positions =
        positions.map_err(|error| Failure::BadInput(format!("error: {file}: {error}")))?;
    let text = survey::to_csv(&positions);
    match &args.output {
        Some(output) => fs::write(output, &text).map_err(|error| {
            Failure::Failed(format!("error: cannot write {}: {error}", output.display()))
        }),
        None => print_stdout(&text),
    }
}

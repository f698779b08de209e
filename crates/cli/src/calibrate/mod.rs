//! `wholestring calibrate`: friction factors from readings at the surface.

mod args;
mod screen;

use wholestring_case::{Case, Template};
use wholestring_runner::calibrate::{self, CheckDynamics, FRAGMENT, Fit, NamedCase, Request};

use crate::{
    conclusion::refuse_errors, failure::Failure, input::load_with_template, interrupt,
    progress::BatchScreen, shared_args::CaseArgs, terminal::print_stdout,
};

pub(crate) use args::CalibrateArgs;

pub(crate) fn calibrate(args: &CalibrateArgs) -> Result<(), Failure> {
    let load = |file: &std::path::PathBuf| {
        let case_args = CaseArgs { case: file.clone(), overrides: args.overrides.clone() };
        load_with_template(&case_args, args.page.quiet)
    };
    let cases: Vec<(Template, Case)> =
        args.cases.iter().map(load).collect::<Result<_, Failure>>()?;
    let named = args.cases.iter().zip(&cases).map(|(file, (template, case))| NamedCase {
        file: file.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        template,
        overrides: &args.overrides,
        case,
    });
    let named: Vec<NamedCase> = named.collect();
    let units = args.page.units.unwrap_or(cases[0].1.units);
    let request = Request {
        cases: &named,
        data: &args.data,
        content: None,
        fit: Fit {
            one_factor: args.one_factor,
            by_section: args.by_section,
            friction_around: args.friction_around,
            block_weight: args.block_weight,
            bit_torque: args.bit_torque,
            hold: args.hold.clone(),
            errors: [args.weight_error, args.rotating_error, args.torque_error],
            outlier_beyond: args.outlier,
            without_outliers: args.without_outliers,
            band_confidence: args.band,
            model: args.model.into(),
        },
        check: args
            .check_dynamics
            .as_ref()
            .map(|depths| CheckDynamics { bit_depths_m: depths.clone(), jobs: args.jobs }),
        units: Some(units),
        output: args.output.output(),
        png: args.page.png,
    };
    let outcome =
        calibrate::run(&request, &BatchScreen::dynamics(args.page.quiet), &interrupt::listen())?;
    if !args.page.quiet {
        print_stdout(&screen::text(&outcome.summary, units))?;
        let took_ms = 1e3 * outcome.took.as_secs_f64();
        let place = outcome.folder.display();
        print_stdout(&format!(
            "Found in {took_ms:.0} ms\nResults in {place}; {FRAGMENT} there is for the case file\n"
        ))?;
    }
    if outcome.interrupted {
        let place = outcome.folder.display();
        return Err(Failure::Interrupted(format!(
            "interrupted: the calibration is in {place}, its check by the dynamics is not complete"
        )));
    }
    let rows = outcome.summary.checks.iter();
    refuse_errors(args.page.strict, rows.map(|row| (String::new(), &row.check)))
}

//! `wholestring bha`: static analysis of the bottom-hole assembly.

mod args;
mod screen;

use wholestring_case::read_values;
use wholestring_runner::{
    Silent,
    bha::{self, Request, Sweeps},
};
use wholestring_units::Dimension;

use crate::{
    color::color, conclusion::refuse_errors, failure::Failure, input::load, interrupt,
    shared_args::operation, stopped::unless_interrupted, terminal::print_stdout,
};

pub(crate) use args::BhaArgs;

pub(crate) fn bha(args: &BhaArgs) -> Result<(), Failure> {
    let operation = args.operation.as_deref().map(operation).transpose()?;
    let sweeps = sweeps(args)?;
    let case = load(&args.case, args.quiet)?;
    let units = args.units.unwrap_or(case.units);
    let request = Request {
        operation,
        whole: args.whole,
        sweeps,
        units: Some(units),
        output: args.output.output(),
        csv: args.csv,
        jobs: args.jobs,
        ..Request::new(&case)
    };
    let outcome = bha::run(&request, &Silent, &interrupt::listen())?;
    if !args.quiet {
        let [alone_s, all_s] = outcome.took_s;
        let place = outcome.folder.display();
        print_stdout(&format!(
            "{}The assembly took {alone_s:.2} s, everything {all_s:.1} s\nResults in {place}\n",
            screen::text(&outcome.summary, units)
        ))?;
    }
    unless_interrupted(outcome.interrupted, &outcome.folder)?;
    let named = outcome.summary.checks.iter().map(|check| (String::new(), check));
    refuse_errors(args.strict, named)
}

fn sweeps(args: &BhaArgs) -> Result<Sweeps, Failure> {
    let read = |option: &str, text: &Option<String>, dimension: Dimension| {
        let values = text.as_deref().map(|text| read_values(option, text, dimension));
        values.transpose().map_err(|report| Failure::BadInput(report.render(color())))
    };
    let rates = read("--build", &args.build, Dimension::DoglegSeverity)?;
    let build_rate_rad_per_m = match rates.as_deref() {
        None => 0.0,
        Some([rate]) => *rate,
        Some(_) => {
            return Err(Failure::BadInput("error: --build takes one rate".into()));
        }
    };
    Ok(Sweeps {
        toolfaces_rad: read("--toolface", &args.toolface, Dimension::Angle)?,
        weights_N: read("--weight", &args.weight, Dimension::Force)?,
        inclinations_rad: read("--inclination", &args.inclination, Dimension::Angle)?,
        build_rate_rad_per_m,
    })
}

//! `wholestring check`: is the case valid?

use std::{f64::consts::TAU, fs::File, io::Read, path::Path};

use clap::Args;
use wholestring::{
    dynamics::{BitLaw, Effort},
    outcome::ModelKind,
    rock::{BitShape, DrillingSpec},
    rod::stability::StepHolder,
    sizing::SizeReason,
};
use wholestring_case::{BitTest, Case, Template};
use wholestring_runner::{
    import::{self, Contents},
    job::OnDisk,
};
use wholestring_units::Dimension;

use crate::{
    failure::Failure,
    screen::color,
    shared_args::CaseArgs,
    terminal::{print_stderr, print_stdout},
};

#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,
}

pub(crate) fn check(args: &CheckArgs) -> Result<(), Failure> {
    let file = &args.case.case;
    let case = if OnDisk::is_pipe(file) {
        // A pipe can be read only once.
        let template = OnDisk::template(file)?;
        let (name, bytes) = (template.name(), template.bytes());
        let is_case = wholestring_case::is_case(&String::from_utf8_lossy(bytes));
        if args.case.overrides.is_empty() && !is_case {
            return show(name, import::contents_of(name, bytes)?);
        }
        case_of(&template, &args.case)?
    } else if file.exists() && args.case.overrides.is_empty() && !is_case(file) {
        return show(&file.display().to_string(), import::contents(file)?);
    } else {
        case_of(&OnDisk::template(file)?, &args.case)?
    };
    print_stdout(&format!(
        "{} is valid: {}\n{}{}{}{}",
        args.case.case.display(),
        outline(&case),
        meshes(&case),
        survey(&case),
        case.drilling().map_or_else(String::new, |spec| rock(spec, &case)),
        case.bit_test.as_ref().map_or_else(String::new, |test| points(test, &case)),
    ))
}

/// The case of a template with the overrides; its warnings are printed.
fn case_of(template: &Template, args: &CaseArgs) -> Result<Case, Failure> {
    let case = template.case(&args.overrides)?;
    if !case.warnings.is_empty() {
        print_stderr(&case.warnings.render(color()));
    }
    Ok(case)
}

/// Leading bytes of a file that are searched for the keys of a case.
const HEAD: u64 = 1 << 16;

/// Whether a file is a case: by its content, and by its name only if the content does not decide.
fn is_case(file: &Path) -> bool {
    let is_called = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    if !file.is_file() {
        return is_called;
    }
    let mut head = Vec::new();
    let read = File::open(file).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    if read.is_ok() && wholestring_case::is_case(&String::from_utf8_lossy(&head)) {
        return true;
    }
    is_called && import::contents(file).is_err()
}

/// Format and contents of another program's file. Readings that a calibration refuses are a failure.
fn show(name: &str, contents: Contents) -> Result<(), Failure> {
    let lines: String = contents.lines.iter().map(|line| format!("  {line}\n")).collect();
    print_stdout(&format!("{name}: {}\n{lines}", contents.what))?;
    match &contents.errors[..] {
        [] => Ok(()),
        errors => Err(Failure::BadInput(format!("error: {name}: {}", errors.join("\n")))),
    }
}

/// The operations and models that a run of the case would solve, in one line.
pub(crate) fn outline(case: &Case) -> String {
    let models = case.models.iter().copied().map(ModelKind::name);
    let operations = case.operations.iter().map(|operation| operation.kind.name());
    let depth = case.operations.first().map_or(0.0, |operation| operation.bit_depth_m);
    format!(
        "{}; {}; bit at {}",
        list(operations),
        list(models),
        Dimension::Length.format(depth, case.units),
    )
}

/// Mesh of the string of each operation, and the element that limits its time step.
fn meshes(case: &Case) -> String {
    if !ModelKind::any_in_time(&case.models) {
        return String::new();
    }
    let each = case.operations.iter().filter_map(|operation| {
        let effort = Effort::of(&case.model, operation, &case.dynamics).ok()?;
        Some((operation.kind.name(), mesh(&effort, case)))
    });
    let each: Vec<(&str, String)> = each.collect();
    match each.as_slice() {
        // All operations share one mesh.
        [(_, first), others @ ..] if others.iter().all(|(_, text)| text == first) => first.clone(),
        each => each.iter().map(|(operation, text)| format!("{operation}: {text}")).collect(),
    }
}

/// The elements, grouped by the reason for their length, and the one that limits the time step.
fn mesh(effort: &Effort, case: &Case) -> String {
    let length = |si_m: f64| Dimension::Length.format(si_m, case.units);
    let elements = &effort.mesh.elements;
    let lengths_m = || elements.iter().map(|one| one.length_m);
    let by_reason = SizeReason::ALL.iter().filter_map(|reason| {
        let count = elements.iter().filter(|one| one.reason == *reason).count();
        (count > 0).then(|| format!("{count} {}", reason.name()))
    });
    let shortest = length(lengths_m().fold(f64::INFINITY, f64::min));
    let longest = length(lengths_m().fold(0.0, f64::max));
    let lengths = match shortest == longest {
        true => shortest,
        false => format!("{shortest} to {longest}"),
    };
    let plan = &effort.plan;
    let step = format!("steps of {:.3} ms", 1e3 * plan.dt_s);
    let mut text = format!(
        "{} elements of {lengths} ({}), ",
        elements.len(),
        by_reason.collect::<Vec<_>>().join(", ")
    );
    match &plan.subcycling {
        None => {
            text += &format!("{step}\n");
            text += &held("the step", plan.holder, effort, case);
        }
        Some(lower) => {
            text += &format!(
                "{step}, each in {} below {} above the bit\n",
                lower.parts,
                length(effort.mesh.nodes[lower.border_node + 1].from_bit_m),
            );
            text += &held("the step above", plan.holder, effort, case);
            text += &held("the step below", lower.holder, effort, case);
        }
    }
    text
}

/// Smallest added mass that is shown, as a fraction of the string's.
const SHOWN_MASS: f64 = 5e-4;

/// The element that limits the time step, and the motion by which it does.
fn held(step: &str, holder: Option<StepHolder>, effort: &Effort, case: &Case) -> String {
    let Some(holder) = holder else {
        return String::new();
    };
    let length = |si_m: f64| Dimension::Length.format(si_m, case.units);
    let lower_m = effort.mesh.nodes[holder.element + 1].from_bit_m;
    let element = &effort.mesh.elements[holder.element];
    let (_, component) = case.model.string.component_at(lower_m + 0.5 * element.length_m);
    let mut text = format!(
        "{step} is limited by the {} motion of the element of {} at {} above the bit ({})",
        holder.motion.name(),
        length(element.length_m),
        length(lower_m),
        component.name,
    );
    // A region that takes integer fractions of the other's step may not use all of its allowance.
    if holder.scaled && effort.plan.added_axial_mass_fraction > SHOWN_MASS {
        text += &format!(
            ", whose mass scaling is at its limit ({:.1} % of the string in total)",
            100.0 * effort.plan.added_axial_mass_fraction,
        );
    }
    text.push('\n');
    text
}

/// The survey and the casing programme as they were interpreted, and the mud rheology fitted to
/// viscometer readings.
fn survey(case: &Case) -> String {
    let notes = case.survey_notes.iter().map(|note| format!("survey: {note}\n"));
    let hole = case.hole_notes.iter().map(|note| format!("hole: {note}\n"));
    let mud = case.mud_notes.iter().map(|note| format!("mud: {note}\n"));
    notes.chain(hole).chain(mud).collect()
}

/// The rock and the bit's face, and the expected drilling response.
fn rock(spec: &DrillingSpec, case: &Case) -> String {
    let block = &spec.block;
    let show = |dimension: Dimension, si: f64| dimension.format(si, case.units);
    let face = match &spec.bit {
        BitShape::Pdc(bit) => {
            format!("{} blades with {} cutters", bit.blades, bit.blades * bit.cutters_per_blade)
        }
        BitShape::Insert(bit) => format!("{} rows of inserts", bit.rows),
    };
    let [nx, ny, nz] = block.cells;
    let size_m = block.size_m[0];
    let mut text = format!(
        "rock of {} under {face}: {nx} x {ny} x {nz} elements of {}",
        show(Dimension::Stress, block.rock.ucs_Pa()),
        show(Dimension::Diameter, size_m),
    );
    if let Ok(step_s) = block.step_s() {
        text += &format!(", steps of {:.1} us", step_s * 1e6);
    }
    text.push('\n');
    let drills = case.operations.iter().find(|one| one.kind.on_bottom());
    if let (BitLaw::Rock(law), Some(operation)) = (&case.dynamics.bit.law, drills) {
        let speed = case.dynamics.bit.drilling_speed_rad_per_s(operation);
        let cut = law.steady(operation.weight_on_bit_N, speed);
        text += &format!(
            "to begin with, it is taken to drill {}, {} per revolution ({:.1} elements)\n",
            show(Dimension::RateOfPenetration, cut.rate_of_penetration_m_per_s),
            show(Dimension::Diameter, cut.depth_of_cut_m),
            cut.depth_of_cut_m / size_m,
        );
    }
    text
}

/// The points of a bit test.
fn points(test: &BitTest, case: &Case) -> String {
    let forces = test.weights_N.iter();
    let forces = forces.map(|force| Dimension::Force.format(*force, case.units));
    let speeds = test.rotary_speeds_rad_per_s.iter();
    let speeds = speeds.map(|speed| format!("{:.0}", speed * 60.0 / TAU));
    format!(
        "bit test: {} at {} rev/min, {:.0} s of drilling\n",
        forces.collect::<Vec<_>>().join(", "),
        speeds.collect::<Vec<_>>().join(", "),
        test.time_s(),
    )
}

fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}

//! Whether the uncertain numbers of a case are numbers of the case, and every draw one that it takes.

use wholestring::operation::Operation;
use wholestring_config::{diagnostic::Severity, prelude::*};
use wholestring_plan::{FrictionLevel, uncertainty::Distribution};

use crate::{
    case::Case,
    overrides::{put, standing},
    uncertain::{Uncertain, UncertainInput, make_certain},
};

/// Makes a case of the tree with a change, and says what is wrong with it.
type Make<'a> = &'a dyn Fn(Change<'_>) -> (Option<Case>, Vec<Diagnostic>);

/// Changes a tree.
type Change<'a> = &'a dyn Fn(&mut Entries, &mut Reader);

/// Checks the uncertain numbers of a case that is valid without them. What is wrong goes to the reader.
pub(crate) fn check(case: &Case, root: &Entries, reader: &mut Reader, make: Make<'_>) {
    let Some(uncertain) = &case.plan.uncertain else { return };
    if !uncertain.inputs.iter().all(|input| is_number(input, root, reader))
        || !each_its_own(uncertain, root, reader)
    {
        return;
    }
    let points = uncertain.points();
    for (place, input) in uncertain.inputs.iter().enumerate() {
        excludes_own(input, root, reader);
        let draws = points.iter().map(|point| point[place]);
        let least = draws.clone().fold(f64::INFINITY, f64::min);
        let largest = draws.fold(f64::NEG_INFINITY, f64::max);
        let Some(low) = with(input, least, "least", reader, make) else { continue };
        let Some(high) = with(input, largest, "largest", reader, make) else { continue };
        if planned(&low) == planned(&high) && input.ends().is_some() {
            has_no_effect(input, root, reader);
        }
    }
}

/// Whether what stands at its key is a number, if anything does.
fn is_number(input: &UncertainInput, root: &Entries, reader: &mut Reader) -> bool {
    for node in standing(root, &input.key) {
        let is_number = match &node.value {
            Value::Number { .. } => true,
            Value::Text { text, .. } => Dimension::ALL.iter().any(|of| of.parse(text).is_ok()),
            _ => false,
        };
        if !is_number {
            let noun = node.value.noun();
            Diagnostic::error(format!("`{}` is no number of the case", short(&input.key)))
                .at(input.key_place, "expected the key of a number")
                .at(node.place, format!("it is {noun}"))
                .report(reader);
            return false;
        }
    }
    true
}

/// Whether no two of them set the same number.
fn each_its_own(uncertain: &Uncertain, root: &Entries, reader: &mut Reader) -> bool {
    let inputs = &uncertain.inputs;
    for (place, input) in inputs.iter().enumerate() {
        let own = standing(root, &input.key);
        for other in &inputs[..place] {
            let others = standing(root, &other.key);
            if own.iter().any(|a| others.iter().any(|b| std::ptr::eq(*a, *b))) {
                Diagnostic::error(format!(
                    "`{}` and `{}` are the same number",
                    short(&other.key),
                    short(&input.key)
                ))
                .at(input.key_place, "is set here")
                .at(other.key_place, "and here")
                .report(reader);
                return false;
            }
        }
    }
    true
}

/// Warns where what the case has itself is not to be expected.
fn excludes_own(input: &UncertainInput, root: &Entries, reader: &mut Reader) {
    let Some(ends) = input.ends() else { return };
    let written = ends.map(|end| input.written(end));
    for node in standing(root, &input.key) {
        let is_outside = match &node.value {
            Value::Number { value, .. } if input.unit.is_empty() => {
                Some(*value < ends[0] || *value > ends[1])
            }
            Value::Text { text, .. } if !input.unit.is_empty() => {
                let parsed = Dimension::ALL.iter().find_map(|of| {
                    let si = |text: &str| of.parse(text).ok();
                    Some([si(text)?, si(&written[0])?, si(&written[1])?])
                });
                parsed.map(|[own, from, to]| own < from || own > to)
            }
            // A bare number is in a unit that only its key knows.
            _ => None,
        };
        if is_outside == Some(true) {
            let own = reader.written(node.place);
            let [from, to] = ends.map(|end| input.rounded(end));
            let about = match input.distribution {
                Distribution::Uniform { .. } | Distribution::Triangular { .. } => "all",
                _ => "nearly all",
            };
            let message =
                format!("the case's own `{}` is not what is uncertain: {own}", short(&input.key));
            Diagnostic::warning(message)
                .at(input.place, format!("{about} of it lies between {from} and {to}"))
                .at(node.place, "the case's own")
                .help("the curves are those of the case, the bands those of the samples: they part")
                .report(reader);
            return;
        }
    }
}

/// The case with an end of what was drawn; none where that is no case, which is reported.
fn with(
    input: &UncertainInput,
    value: f64,
    which: &str,
    reader: &mut Reader,
    make: Make<'_>,
) -> Option<Case> {
    let (case, found) = make(&|root, checked| {
        make_certain(root);
        put(root, &input.key, &input.node(value), input.key_place, checked);
    });
    let is_error = |of: &&Diagnostic| of.severity == Severity::Error;
    if let Some(error) = found.iter().find(is_error) {
        let mut error = error.clone();
        let is_told = error
            .labels
            .iter()
            .any(|label| label.place == input.place || label.place == input.key_place);
        if !is_told {
            error = error.at(input.place, "by this");
        }
        let written = input.rounded(value);
        let draw = match input.values.is_empty() {
            true => format!("its {which} draw is {written}"),
            false => format!("one of its values is {written}"),
        };
        error.help(draw).report(reader);
        return None;
    }
    // What is doubted of the draw itself; the rest is told of the case already.
    for warning in found {
        if warning.labels.first().is_some_and(|label| label.place == input.place) {
            warning.report(reader);
        }
    }
    case
}

/// All that the expected curves of a plan depend on.
fn planned(case: &Case) -> Option<String> {
    let broomstick = case.broomstick_at(Vec::new()).ok()?;
    let setup = broomstick.setup(FrictionLevel::Expected);
    // Depths are the plan's.
    let operations = case.plan.operations.iter();
    let operations: Vec<Operation> =
        operations.map(|of| Operation { bit_depth_m: 0.0, ..*of }).collect();
    let stiff = case.dynamics.stiff_string();
    Some(format!("{setup:?} {operations:?} {:?} {:?} {stiff:?}", case.plan.limits, case.soft))
}

fn has_no_effect(input: &UncertainInput, root: &Entries, reader: &mut Reader) {
    let mut warning =
        Diagnostic::warning(format!("`{}` has no effect on the plan", short(&input.key)))
            .at(input.place, "whatever it is, the plan is the same");
    if input.key.contains("friction") && !standing(root, "plan.friction.expected").is_empty() {
        warning = warning.help("`expected` of [plan.friction] takes its place");
    }
    warning.report(reader);
}

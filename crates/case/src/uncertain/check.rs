//! Whether the uncertain numbers of a case are numbers of the case, and every draw is valid.

use wholestring::operation::Operation;
use wholestring_config::{diagnostic::Severity, prelude::*};
use wholestring_plan::{FrictionLevel, uncertainty::Distribution};

use crate::{
    case::Case,
    edit::overrides::{put, standing},
    uncertain::{Uncertain, UncertainInput, make_certain},
};

/// Builds a case from the tree with a change, and returns its mistakes.
type Make<'a> = &'a dyn Fn(Change<'_>) -> (Option<Case>, Vec<Diagnostic>);

/// Changes a tree.
type Change<'a> = &'a dyn Fn(&mut Entries, &mut Reader);

/// Checks the uncertain numbers of a case that is valid without them. Mistakes are reported to the
/// reader.
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

/// Whether the value at its key is a number, if there is one.
fn is_number(input: &UncertainInput, root: &Entries, reader: &mut Reader) -> bool {
    for node in standing(root, &input.key) {
        let is_number = match &node.value {
            Value::Number { .. } => true,
            Value::Text { text, .. } => {
                Dimension::ALL.iter().any(|dimension| dimension.parse(text).is_ok())
            }
            _ => false,
        };
        if !is_number {
            let noun = node.value.noun();
            Diagnostic::error(format!("`{}` is not a number of the case", short(&input.key)))
                .at(input.key_place, "expected the key of a number")
                .at(node.place, format!("it is {noun}"))
                .report(reader);
            return false;
        }
    }
    true
}

/// Whether no two inputs set the same number.
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

/// Warns where the value of the case itself is outside the distribution.
fn excludes_own(input: &UncertainInput, root: &Entries, reader: &mut Reader) {
    let Some(ends) = input.ends() else { return };
    let written = ends.map(|end| input.written(end));
    for node in standing(root, &input.key) {
        let is_outside = match &node.value {
            Value::Number { value, .. } if input.unit.is_empty() => {
                Some(*value < ends[0] || *value > ends[1])
            }
            Value::Text { text, .. } if !input.unit.is_empty() => {
                let parsed = Dimension::ALL.iter().find_map(|dimension| {
                    let si = |text: &str| dimension.parse(text).ok();
                    Some([si(text)?, si(&written[0])?, si(&written[1])?])
                });
                parsed.map(|[own, from, to]| own < from || own > to)
            }
            // The unit of a bare number is known to its key only.
            _ => None,
        };
        if is_outside == Some(true) {
            let own = reader.written(node.place);
            let [from, to] = ends.map(|end| input.rounded(end));
            let about = match input.distribution {
                Distribution::Uniform { .. } | Distribution::Triangular { .. } => "all",
                _ => "nearly all",
            };
            let message = format!(
                "the case's own `{}` is outside the uncertain range: {own}",
                short(&input.key)
            );
            Diagnostic::warning(message)
                .at(input.place, format!("{about} values are between {from} and {to}"))
                .at(node.place, "the case's own")
                .help("the curves are those of the case, the bands those of the samples: they part")
                .report(reader);
            return;
        }
    }
}

/// Returns the case with an end of the drawn range; `None` where that is not valid, which is
/// reported.
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
    let is_error = |diagnostic: &&Diagnostic| diagnostic.severity == Severity::Error;
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
    // Only doubts of the draw itself; the others have been reported for the case.
    for warning in found {
        if warning.labels.first().is_some_and(|label| label.place == input.place) {
            warning.report(reader);
        }
    }
    case
}

/// Returns all inputs of the expected curves of a plan.
fn planned(case: &Case) -> Option<String> {
    let broomstick = case.broomstick_at(Vec::new()).ok()?;
    let setup = broomstick.setup(FrictionLevel::Expected);
    // Depths are set by the plan.
    let operations = case.plan.operations.iter();
    let operations: Vec<Operation> =
        operations.map(|operation| Operation { bit_depth_m: 0.0, ..*operation }).collect();
    let stiff = case.dynamics.stiff_string();
    Some(format!("{setup:?} {operations:?} {:?} {:?} {stiff:?}", case.plan.limits, case.soft))
}

fn has_no_effect(input: &UncertainInput, root: &Entries, reader: &mut Reader) {
    let mut warning =
        Diagnostic::warning(format!("`{}` has no effect on the plan", short(&input.key)))
            .at(input.place, "whatever it is, the plan is the same");
    if input.key.contains("friction") && !standing(root, "plan.friction.expected").is_empty() {
        warning = warning.help("`expected` of [plan.friction] replaces it");
    }
    warning.report(reader);
}

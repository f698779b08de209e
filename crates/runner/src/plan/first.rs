//! What would break first, in the summary and in sentences.

use wholestring::outcome::QuantityKind;
use wholestring_plan::{dynamic::Event, limits::LimitKind};
use wholestring_report::operation_name;
use wholestring_results::{PlanLimit, PlanSummary};
use wholestring_units::{Dimension, UnitSet};

fn kind(of: &PlanLimit) -> Option<LimitKind> {
    LimitKind::ALL.iter().copied().find(|kind| kind.name() == of.kind)
}

/// Of each operation the limit with the least reserve among those that break something where they
/// are passed: not buckling, nor an overpull that was asked for. In the order of the operations.
pub(super) fn first(limits: &[PlanLimit]) -> Vec<PlanLimit> {
    let mut found: Vec<&PlanLimit> = Vec::new();
    for of in limits.iter().filter(|of| kind(of).is_some_and(LimitKind::breaks)) {
        match found.iter_mut().find(|one| one.operation == of.operation) {
            Some(one) if of.reserve() < one.reserve() => *one = of,
            Some(_) => {}
            None => found.push(of),
        }
    }
    found.into_iter().cloned().collect()
}

/// A sentence for each operation: which limit, of which component, where, and how much is left of
/// it.
pub fn breaks_first(summary: &PlanSummary, units: UnitSet) -> Vec<String> {
    summary.breaks_first.iter().map(|of| sentence(of, units)).collect()
}

fn sentence(of: &PlanLimit, units: UnitSet) -> String {
    let length = Dimension::Length.unit_in(units);
    let depth = |depth_m: f64| format!("{:.0} {}", length.from_si(depth_m) + 0.0, length.symbol);
    let operation = match Event::from_name(&of.operation) {
        Some(event) => format!("{} by the dynamics", event.label()),
        None => operation_name(&of.operation).to_owned(),
    };
    let limit = kind(of).map_or_else(|| of.kind.replace('_', " "), words);
    let place = match (&of.component, of.md_m) {
        (Some(component), Some(md_m)) => format!(" of {component} at {}", depth(md_m)),
        _ => String::new(),
    };
    let load = load(of, units);
    format!(
        "{operation}: {limit}{place} comes first, with {} friction and the bit at {}: \
         {load}, factor {:.2}, required {:.2}: {}.",
        of.friction,
        depth(of.bit_depth_m),
        of.factor,
        of.required,
        of.standing
    )
}

/// The label of a kind within a sentence.
fn words(kind: LimitKind) -> String {
    match kind {
        LimitKind::VonMises => "von Mises stress".to_owned(),
        kind => kind.label().to_lowercase(),
    }
}

/// `1066.7 of 2110.3 kN`.
fn load(of: &PlanLimit, units: UnitSet) -> String {
    let dimension = match kind(of).map(LimitKind::quantity) {
        Some(QuantityKind::Torque) => Dimension::Torque,
        Some(QuantityKind::Pressure) => Dimension::Pressure,
        _ => Dimension::Force,
    };
    let unit = dimension.unit_in(units);
    format!("{:.1} of {:.1} {}", unit.from_si(of.load), unit.from_si(of.capacity), unit.symbol)
}

//! Loads of operations against the capacities of pipe and rig, by the soft string.

use std::collections::BTreeMap;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::{operation::Operation, statics::soft::SoftString};
use wholestring_case::Case;
use wholestring_judge::{Check, CheckKind, Checks};

use crate::words::Severity;

/// The limits of an operation.
#[derive(Debug, Serialize, ToSchema)]
pub struct OperationLimits {
    /// The operation: `drill`, `trip_out`, ...
    operation: &'static str,
    /// The limit with the smallest reserve for each kind, in the order of the plan's tables.
    limits: Vec<Limit>,
    /// Limits that could not be checked.
    unchecked: Vec<Unchecked>,
}

/// A load against its capacity.
#[derive(Debug, Serialize, ToSchema)]
pub struct Limit {
    /// Kind of limit, as in `plan_limits.parquet`: `hoist`, `von_mises`, ...
    kind: &'static str,
    /// Label for display.
    label: &'static str,
    /// The component; null for the rig.
    component: Option<String>,
    /// Measured depth of the place, m; null for the rig.
    md_m: Option<f64>,
    /// Dimension of load and capacity: `force`, `torque`, `pressure`, `stress`.
    dimension: &'static str,
    /// The load, SI.
    load: f64,
    /// The capacity, SI.
    capacity: f64,
    /// Required capacity over load.
    required: f64,
    /// Capacity over load, divided by the required factor: the factor by which the load may grow.
    /// Less than 1 is insufficient.
    reserve: f64,
    /// The verdict: `OK`, `marginal`, `below required factor` or `exceeded`.
    verdict: &'static str,
    /// Its severity.
    #[schema(value_type = Severity)]
    severity: &'static str,
    /// The result as a sentence, in the units of the case.
    sentence: String,
}

/// A missing input, with the components that lack it; no components for the rig.
#[derive(Debug, Serialize, ToSchema)]
pub struct Unchecked {
    /// Description: `no yield strength`.
    missing: &'static str,
    /// The components.
    components: Vec<String>,
}

/// The limits of every operation of a case that the soft string can solve.
pub fn of_operations(case: &Case) -> Vec<OperationLimits> {
    let judge = case.judge(case.units);
    let limits = |operation: &Operation| {
        let string = SoftString::new(&case.model, operation.bit_depth_m, &case.soft).ok()?;
        let loads = string.loads(operation).ok()?;
        let checks = judge.soft_limits(&case.model, operation, &loads);
        Some(OperationLimits {
            operation: operation.kind.name(),
            limits: worst_of(&checks),
            unchecked: unchecked(&checks),
        })
    };
    case.operations.iter().filter_map(limits).collect()
}

fn worst_of(checks: &Checks) -> Vec<Limit> {
    let limit = |check: &Check| {
        Some(Limit {
            kind: check.kind.name(),
            label: check.kind.label(),
            component: check.component.clone(),
            md_m: check.md_m,
            dimension: check.kind.quantity().dimension(),
            load: check.value?,
            capacity: check.limit?,
            required: check.required?,
            reserve: check.reserve(),
            verdict: check.verdict.words(),
            severity: check.severity.name(),
            sentence: check.sentence.clone(),
        })
    };
    CheckKind::LIMITS.iter().filter_map(|kind| limit(checks.worst(*kind)?)).collect()
}

fn unchecked(checks: &Checks) -> Vec<Unchecked> {
    let mut all: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for lack in &checks.unchecked {
        let components = all.entry(lack.missing.words()).or_default();
        if let Some(component) = &lack.component
            && !components.contains(component)
        {
            components.push(component.clone());
        }
    }
    let row = |(missing, components)| Unchecked { missing, components };
    all.into_iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use wholestring::statics::soft;
    use wholestring_case::load;

    use super::*;

    fn slant() -> Case {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slant.toml");
        load(&file, &[]).expect("a valid case")
    }

    /// A hoist with twice the capacity of its load has a reserve of two divided by its factor.
    #[test]
    fn the_reserve_is_capacity_over_load_and_factor() {
        let mut case = slant();
        let operation = case.operations[0];
        let solved = soft::solve(&case.model, &operation, &case.soft).expect("an answer");
        let hangs_N = solved.scalars.hook_load_N;
        case.model.rig.block_weight_N = None;
        case.model.rig.hoist_capacity_N = Some(2.0 * hangs_N);
        let found = of_operations(&case);
        assert_eq!(found.len(), case.operations.len());
        let hoist = found[0].limits.iter().find(|one| one.kind == "hoist").expect("a hoist");
        // Both are sums of the same loads along the string, in a different order.
        assert!((hoist.load / hangs_N - 1.0).abs() < 1e-12, "{} {hangs_N}", hoist.load);
        assert!((hoist.reserve * hoist.required - 2.0).abs() < 1e-12, "{}", hoist.reserve);
        assert_eq!((hoist.dimension, hoist.verdict), ("force", "OK"));
    }

    /// The table of limits and the checks of the same results come from the judge and agree on
    /// every kind of limit, short buckled stretches included.
    #[test]
    fn the_table_and_the_checks_say_the_same() {
        let shipped = |name: &str, set: &[&str]| {
            let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name);
            let set: Vec<_> = set.iter().map(|one| one.parse().expect("a change")).collect();
            load(&file, &set).expect("a valid case")
        };
        let weights = ["20 kN", "45 kN", "60 kN", "150 kN", "240 kN"];
        let slants = weights.map(|weight| shipped("slant.toml", &[&format!("wob={weight}")]));
        let others =
            [shipped("horizontal.toml", &[]), shipped("lateral-that-cannot-be-drilled.toml", &[])];
        let (mut compared, mut short) = (0, 0);
        for mut case in slants.into_iter().chain(others) {
            case.models = vec![wholestring::outcome::ModelKind::Soft];
            let limits = of_operations(&case);
            let token = wholestring_runner::CancellationToken::new();
            let run =
                wholestring_runner::run::answer(&case, None, &wholestring_runner::Silent, &token);
            let run = run.expect("a run");
            for table in limits {
                let mut operations = run.answers.summary().operations.iter();
                let solved = operations.find(|one| one.operation.name() == table.operation);
                let checks = &solved.expect("the operation").checks;
                for row in &table.limits {
                    let own = checks.iter().filter(|check| check.kind.name() == row.kind);
                    let own = own.filter(|check| check.factor.is_some());
                    let least = own.min_by(|a, b| a.reserve().total_cmp(&b.reserve()));
                    let least = least.unwrap_or_else(|| panic!("no check of {}", row.kind));
                    assert_eq!(least.verdict.words(), row.verdict, "{}", row.sentence);
                    assert_eq!(least.severity.name(), row.severity, "{}", row.sentence);
                    assert_eq!(least.sentence, row.sentence);
                    compared += 1;
                    let length_m = least.to_md_m.zip(least.md_m).map(|(to, from)| to - from);
                    short += usize::from(length_m.is_some_and(|length_m| length_m < 10.0));
                }
                for check in checks.iter().filter(|check| check.factor.is_some()) {
                    assert!(table.limits.iter().any(|row| row.kind == check.kind.name()));
                }
            }
        }
        assert!(compared > 100 && short > 0, "{compared} compared, {short} short stretches");
    }

    #[test]
    fn what_is_not_known_is_told_once_for_all_components() {
        let case = slant();
        let found = of_operations(&case);
        let unchecked = &found[0].unchecked;
        let mut words: Vec<&str> = unchecked.iter().map(|one| one.missing).collect();
        assert!(words.contains(&"no rated torque of the top drive"), "{words:?}");
        words.dedup();
        assert_eq!(words.len(), unchecked.len());
    }
}

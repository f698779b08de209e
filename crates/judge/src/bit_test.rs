//! Checks of a bit test: points without a result, points at which the bit does not drill, and
//! points at which the rock is moved rather than deformed.

use wholestring::rock::TrialOutcome;

use crate::{Check, CheckKind, Severity};

/// Ratio of the rock's kinetic energy to the work of its deformation, above which it is reported.
const MUCH_KINETIC: f64 = 0.05;

/// A point of a bit test.
#[derive(Debug, Clone, Copy)]
pub struct TriedPoint<'a> {
    /// Name of the point.
    pub name: &'a str,
    /// Reason why it has no outcome; `None` for a point that is finished or has not started.
    pub failure: Option<&'a str>,
    /// Outcome, where it is finished.
    pub outcome: Option<&'a TrialOutcome>,
}

/// Returns the checks of all points of a bit test, the most severe first. A bit that drills at none
/// of the finished points is an error, because their table holds no rate of penetration.
pub fn bit_test_checks(points: &[TriedPoint<'_>]) -> Vec<Check> {
    let mut outcomes = points.iter().filter_map(|point| point.outcome).peekable();
    let none_drills = outcomes.peek().is_some() && outcomes.all(|outcome| !drills(outcome));
    let severity = if none_drills { Severity::Error } else { Severity::Warning };
    let checks = points.iter().flat_map(|point| {
        let outcome = point.outcome;
        let idle = outcome.filter(|outcome| !drills(outcome)).map(|_| {
            let sentence = format!("{}: the bit does not drill", point.name);
            Check::of_readings(CheckKind::BitDoesNotDrill, severity, [None; 2], sentence)
        });
        let kinetic = outcome.and_then(|outcome| rock_moves(point.name, outcome));
        [failed(point), idle, kinetic].into_iter().flatten()
    });
    let mut checks: Vec<Check> = checks.collect();
    checks.sort_by_key(|check| std::cmp::Reverse(check.severity));
    checks
}

fn drills(outcome: &TrialOutcome) -> bool {
    outcome.bricks_broken > 0
}

fn failed(point: &TriedPoint<'_>) -> Option<Check> {
    let sentence = format!("{}: {}", point.name, point.failure?);
    Some(Check::of_readings(CheckKind::PointFailed, Severity::Error, [None; 2], sentence))
}

fn rock_moves(name: &str, outcome: &TrialOutcome) -> Option<Check> {
    let part = outcome.kinetic_fraction;
    let sentence = || {
        format!(
            "{name}: the rock's kinetic energy is {:.0} % of the work of its deformation: lower \
             rock.density_factor",
            100.0 * part
        )
    };
    let numbers = [Some(part), Some(MUCH_KINETIC)];
    let (kind, severity) = (CheckKind::RockKineticEnergy, Severity::Warning);
    (part > MUCH_KINETIC).then(|| Check::of_readings(kind, severity, numbers, sentence()))
}

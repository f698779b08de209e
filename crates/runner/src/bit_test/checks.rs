//! Checks of a bit test: points without an answer, at which the bit does not drill, or at which the
//! rock is moved rather than deformed.

use wholestring_judge::{Check, CheckKind, Severity};
use wholestring_results::{BitTestPoint, Status};

/// Kinetic energy of the rock, over the work of its deformation, from which it is reported.
const MUCH_KINETIC: f64 = 0.05;

/// The checks of all points, the most severe first.
pub(super) fn checks(points: &[BitTestPoint]) -> Vec<Check> {
    let mut checks: Vec<Check> = points.iter().flat_map(of_point).collect();
    checks.sort_by_key(|check| std::cmp::Reverse(check.severity));
    checks
}

fn of_point(point: &BitTestPoint) -> Vec<Check> {
    let mut checks = Vec::new();
    let name = &point.point;
    if let Status::Failed(reason) = &point.status {
        let sentence = format!("{name}: {reason}");
        let kind = CheckKind::PointFailed;
        checks.push(Check::of_readings(kind, Severity::Error, [None; 2], sentence));
    }
    let Some(outcome) = &point.outcome else { return checks };
    if outcome.bricks_broken == 0 {
        let sentence = format!("{name}: the bit does not drill");
        let kind = CheckKind::BitDoesNotDrill;
        checks.push(Check::of_readings(kind, Severity::Warning, [None; 2], sentence));
    }
    let part = outcome.kinetic_fraction;
    if part > MUCH_KINETIC {
        let sentence = format!(
            "{name}: the rock's kinetic energy is {:.0} % of the work of its deformation: lower \
             rock.density_factor",
            100.0 * part
        );
        let numbers = [Some(part), Some(MUCH_KINETIC)];
        let kind = CheckKind::RockKineticEnergy;
        checks.push(Check::of_readings(kind, Severity::Warning, numbers, sentence));
    }
    checks
}

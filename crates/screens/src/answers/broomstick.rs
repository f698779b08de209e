//! Hook load and torque against bit depth, by the soft string.

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_case::Case;
use wholestring_plan::{FrictionLevel, Statics};
use wholestring_results::Table;
use wholestring_runner::{CancellationToken, Error, Instant, plan};

use super::column::Column;
use crate::words;

/// Number of bit depths; the plan of the case has more.
const DEPTHS: usize = 15;

/// A broomstick.
#[derive(Debug, Serialize, ToSchema)]
pub struct Broomstick {
    /// A curve for each operation at each friction.
    curves: Vec<BroomstickCurve>,
    /// Levels of friction, from the least to the most.
    frictions: Vec<FrictionOfLevel>,
    /// Capacity of the hoist minus the block weight, N; null if unknown.
    hoist_N: Option<f64>,
    /// Continuous torque of the top drive, N·m; null if unknown.
    top_drive_N_m: Option<f64>,
    /// Wall-clock time of the solving, s.
    took_s: f64,
}

/// Friction of the hole at a level.
#[derive(Debug, Serialize, ToSchema)]
pub struct FrictionOfLevel {
    /// The level.
    #[schema(value_type = words::FrictionLevel)]
    name: &'static str,
    /// Kinetic coefficients of the hole sections, from the surface down.
    coefficients: Vec<f64>,
}

/// An operation at a friction level, against bit depth. Points without a result are null.
#[derive(Debug, Serialize, ToSchema)]
pub struct BroomstickCurve {
    /// The operation: `trip_out`, `trip_in`, ...
    operation: String,
    /// Level of friction, as in the plan of the case.
    #[schema(value_type = words::FrictionLevel)]
    friction: String,
    /// Bit depths, m.
    bit_depth_m: Column,
    /// Hook load without the block, N.
    hook_load_N: Column,
    /// Torque at the top, N·m.
    surface_torque_N_m: Column,
}

/// The operations of the case's plan at some of its depths, with low, expected and high friction.
///
/// # Errors
/// A cancellation, or a plan with settings that the case does not support.
pub fn broomstick(case: &Case, cancellation: &CancellationToken) -> Result<Broomstick, Error> {
    let begun = Instant::now();
    let request = plan::BroomstickRequest {
        case,
        models: vec![Statics::Soft],
        frictions: Vec::new(),
        bit_depths_m: some_of(&case.plan.bit_depths_m),
        operations: Vec::new(),
        jobs: None,
    };
    let found = plan::broomstick(&request, cancellation)?;
    if found.missing > 0 {
        return Err(Error::Interrupted);
    }
    let rig = &case.model.rig;
    let block_N = rig.block_weight_N.unwrap_or(0.0);
    Ok(Broomstick {
        curves: curves(&found.table),
        frictions: FrictionLevel::ALL.iter().map(|level| level_of(case, *level)).collect(),
        hoist_N: rig.hoist_capacity_N.map(|capacity_N| capacity_N - block_N),
        top_drive_N_m: rig.top_drive_torque_N_m,
        took_s: begun.elapsed().as_secs_f64(),
    })
}

fn level_of(case: &Case, level: FrictionLevel) -> FrictionOfLevel {
    let frictions = case.plan.frictions.of(level);
    let sections = case.model.well.hole.sections().iter();
    FrictionOfLevel {
        name: level.name(),
        coefficients: sections.map(|at| frictions.of(at).kinetic).collect(),
    }
}

/// The first, the last, and evenly spaced ones between them.
fn some_of(depths_m: &[f64]) -> Vec<f64> {
    if depths_m.len() <= DEPTHS {
        return depths_m.to_vec();
    }
    let last = depths_m.len() - 1;
    (0..DEPTHS).map(|i| depths_m[(i * last + (DEPTHS - 1) / 2) / (DEPTHS - 1)]).collect()
}

fn curves(table: &Table) -> Vec<BroomstickCurve> {
    let (Some(operations), Some(frictions)) = (table.words("operation"), table.words("friction"))
    else {
        return Vec::new();
    };
    let mut curves = Vec::new();
    let mut from = 0;
    while from < table.rows() {
        let key = (&operations[from], &frictions[from]);
        let is_of = |row: &usize| (&operations[*row], &frictions[*row]) == key;
        let rows = from..from + (from..table.rows()).take_while(is_of).count();
        let column = |name: &str| -> Column {
            let numbers = table.numbers(name).map_or(&[][..], |numbers| &numbers[rows.clone()]);
            numbers.iter().map(|number| number.unwrap_or(f64::NAN)).collect()
        };
        curves.push(BroomstickCurve {
            operation: key.0.clone(),
            friction: key.1.clone(),
            bit_depth_m: column("bit_depth_m"),
            hook_load_N: column("hook_load_N"),
            surface_torque_N_m: column("surface_torque_N_m"),
        });
        from = rows.end;
    }
    curves
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use wholestring_case::load;

    use super::*;

    #[test]
    fn depths_are_spread_from_the_first_to_the_last() {
        let all: Vec<f64> = (0..31).map(f64::from).collect();
        let some = some_of(&all);
        assert_eq!(some.len(), DEPTHS);
        assert_eq!((some[0], some[DEPTHS - 1]), (0.0, 30.0));
        assert!(some.windows(2).all(|pair| pair[1] - pair[0] >= 2.0));
        assert_eq!(some_of(&all[..3]), all[..3]);
    }

    /// More friction increases the hook load of a string that is pulled, and reduces that of one
    /// lowered.
    #[test]
    fn friction_spreads_the_broomstick() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/np13-x1042.toml");
        let case = load(&file, &[]).expect("a valid case");
        let found = broomstick(&case, &CancellationToken::new()).expect("a broomstick");
        let at_depth = |operation: &str, friction: &str| {
            let is_it = |curve: &&BroomstickCurve| {
                curve.operation == operation && curve.friction == friction
            };
            found.curves.iter().find(is_it).expect("a curve").hook_load_N.last().expect("a number")
        };
        assert!(at_depth("trip_out", "high") > at_depth("trip_out", "low") + 1e4);
        assert!(at_depth("trip_in", "high") < at_depth("trip_in", "low") - 1e4);
        let levels = found.frictions.iter().map(|friction| friction.coefficients[0]);
        assert!(levels.is_sorted_by(|a, b| a < b));
        assert_eq!(found.frictions[1].coefficients, [0.3, 0.3]);
        assert_eq!((found.hoist_N, found.top_drive_N_m), (None, None));
    }
}

//! What a finding says of means that do not stand still.

use wholestring::outcome::scalars_by_row;
use wholestring_results::OperationSummary;
use wholestring_units::{Dimension, UnitSet};

use super::quantities::{deviation, shown, symbol};

/// Travel of the bit in the window from which it is named as what may change a mean, m.
const TRAVELS_M: f64 = 1.0;

/// What drifts in the window of an operation, as a sentence; none where nothing of the table does.
pub(super) fn sentence(solved: &OperationSummary, units: UnitSet) -> Option<String> {
    let statistics = solved.statistics.as_ref()?;
    let drifts: Vec<String> = scalars_by_row()
        .into_iter()
        .filter_map(|scalar| {
            let quantity = scalar.quantity;
            let statistic = statistics.get(quantity.name).filter(|of| of.drifts)?;
            let verb = if statistic.drift < 0.0 { "falls" } else { "rises" };
            let shown = deviation(shown(quantity.kind, statistic.drift.abs(), units));
            let symbol = symbol(quantity.kind, units);
            let label = scalar.label.to_lowercase();
            Some(format!("{label} {verb} by {shown} {symbol}"))
        })
        .collect();
    let (first, rest) = drifts.split_first()?;
    let list = match rest.split_last() {
        None => first.clone(),
        Some((last, [])) => format!("{first} and {last}"),
        Some((last, between)) => format!("{first}, {} and {last}", between.join(", ")),
    };
    let travel_m = solved.numerics.as_ref().map(|of| of.run.bit_travel_m);
    let why = match travel_m.map(f64::abs).filter(|m| *m >= TRAVELS_M) {
        Some(travel_m) => format!(
            "the string goes {} through the hole meanwhile, and a shorter window shows less of \
             that",
            Dimension::Length.format((10.0 * travel_m).round() / 10.0, units)
        ),
        None => "settle longer".to_owned(),
    };
    let sentence =
        format!("{list} over the window (↗ ↘): there ± is drift, not motion alone; {why}");
    let mut letters = sentence.chars();
    let first = letters.next().map(char::to_uppercase);
    Some(first.into_iter().flatten().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};
    use wholestring_results::Summary;

    use super::*;

    /// A summary of one operation with these statistics and numerics.
    fn summary(statistics: Value, numerics: Value) -> Summary {
        let statistic = |of: &Value| {
            let mut all = json!({
                "mean": 200e3, "std": 700.0, "min": 0.0, "max": 0.0, "p05": 0.0, "p95": 0.0,
                "std_error": 10.0,
                "drift": 0.0, "drifts": false,
            });
            for (key, value) in of.as_object().unwrap() {
                all[key] = value.clone();
            }
            all
        };
        let statistics = statistics.as_object().unwrap().iter();
        let statistics: serde_json::Map<String, Value> =
            statistics.map(|(name, of)| (name.clone(), statistic(of))).collect();
        let mut all = json!({
            "elements": 100, "time_step_s": 1e-3, "steps": 1000, "added_axial_mass_fraction": 0.0,
            "max_penetration_m": 0.0, "energy_residual": 0.0,
            "instructions": "avx2", "wall_time_s": 1.0,
            "real_time_factor": 10.0, "settle_s": 30.0, "settled": true, "mean_bit_depth_m": 1000.0,
            "bit_travel_m": 0.05,
        });
        for (key, value) in numerics.as_object().unwrap() {
            all[key] = value.clone();
        }
        let solved = json!({
            "model": "dynamic", "operation": "trip_in", "status": "complete",
            "friction": 0.3, "bit_depth_m": 1000.0, "weight_on_bit_N": 0.0, "bit_torque_N_m": 0.0,
            "hook_load_N": 200e3, "surface_torque_N_m": 0.0, "friction_torque_N_m": 0.0,
            "axial_friction_N": 0.0, "side_force_total_N": 0.0, "twist_rad": 0.0, "stretch_m": 0.2,
            "neutral_point_m": null, "cutoff_depth_m": null, "statistics": statistics,
            "numerics": all,
        });
        Summary {
            schema_version: wholestring_results::SCHEMA_VERSION,
            engine_version: None,
            identity: None,
            case: "a case".into(),
            settings: Value::Null,
            operations: vec![serde_json::from_value(solved).expect("a summary")],
        }
    }

    fn drift_sentence(summary: &Summary) -> Option<String> {
        sentence(&summary.operations[0], UnitSet::Si)
    }

    #[test]
    fn what_drifts_is_told() {
        let drifts = summary(
            json!({
                "hook_load_N": {"drift": -2100.0, "drifts": true},
                "axial_friction_N": {"drift": -2000.0},
                "stretch_m": {"std": 0.003, "drift": 0.01, "drifts": true},
            }),
            json!({}),
        );
        assert_eq!(
            drift_sentence(&drifts).as_deref(),
            Some(
                "Hook load without block falls by 2.1 kN and stretch rises by 0.010 m over the \
                 window (↗ ↘): there \
                 ± is drift, not motion alone; settle longer"
            )
        );
    }

    #[test]
    fn a_string_that_travels_is_not_told_to_settle() {
        let travels = json!({"bit_travel_m": 18.0});
        let drifts = summary(json!({"hook_load_N": {"drift": 2600.0, "drifts": true}}), travels);
        let drift_sentence = drift_sentence(&drifts).expect("a sentence");
        assert!(
            drift_sentence.contains("the string goes 18 m through the hole meanwhile"),
            "{drift_sentence}"
        );
        assert!(!drift_sentence.contains("settle"), "{drift_sentence}");
    }

    #[test]
    fn what_stands_still_is_not_told() {
        let still = summary(json!({"hook_load_N": {}}), json!({}));
        assert_eq!(drift_sentence(&still), None);
    }
}

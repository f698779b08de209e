//! Marks in the table for means that drift.

use wholestring_runner::Drift;

/// The mark after the deviation of a drifting quantity.
pub(super) fn mark(drift: Drift) -> &'static str {
    match drift {
        Drift::None => "",
        Drift::Upwards => " ↗",
        Drift::Downwards => " ↘",
    }
}

/// A column of deviations, padded so that marked and unmarked ones align.
pub(super) fn aligned(cells: Vec<String>) -> Vec<String> {
    let is_marked = |cell: &String| cell.ends_with(['↗', '↘']);
    if !cells.iter().any(is_marked) {
        return cells;
    }
    let pad = |cell: String| if is_marked(&cell) { cell } else { cell + "  " };
    cells.into_iter().map(pad).collect()
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};
    use wholestring_results::Summary;
    use wholestring_units::UnitSet;

    use super::super::table;

    /// The table of one operation whose quantities have these deviations and drifts.
    fn screen(spreads: &[(&str, f64, f64, bool)]) -> String {
        let statistics = spreads.iter().map(|(name, std, drift, drifts)| {
            let statistic = json!({
                "mean": 200e3, "std": std, "min": 0.0, "max": 0.0, "p05": 0.0, "p95": 0.0, "std_error": 10.0,
                "drift": drift, "drifts": drifts,
            });
            ((*name).to_owned(), statistic)
        });
        let statistics: serde_json::Map<String, Value> = statistics.collect();
        let solved = json!({
            "model": "dynamic", "operation": "trip_in", "status": "complete", "friction": 0.3, "bit_depth_m": 1000.0,
            "weight_on_bit_N": 0.0, "bit_torque_N_m": 0.0, "hook_load_N": 200e3, "surface_torque_N_m": 0.0,
            "friction_torque_N_m": 0.0, "axial_friction_N": 0.0, "side_force_total_N": 0.0, "twist_rad": 0.0,
            "stretch_m": 0.2, "neutral_point_m": null, "cutoff_depth_m": null, "statistics": statistics,
        });
        let summary = Summary {
            schema_version: wholestring_results::SCHEMA_VERSION,
            engine_version: None,
            identity: None,
            case: "a case".into(),
            settings: Value::Null,
            operations: vec![serde_json::from_value(solved).expect("a summary")],
        };
        table(&summary, UnitSet::Si, None)
    }

    #[test]
    fn what_drifts_is_marked() {
        let screen = screen(&[
            ("hook_load_N", 700.0, -2100.0, true),
            ("axial_friction_N", 700.0, -2000.0, false),
            ("stretch_m", 0.003, 0.01, true),
        ]);
        let row = |label: &str| screen.lines().find(|line| line.starts_with(label)).unwrap();
        assert!(row("Hook load").ends_with("0.70 ↘"), "{screen}");
        assert!(row("Stretch").ends_with("0.0030 ↗"), "{screen}");
        // Digits are aligned.
        assert!(row("Axial friction").ends_with("0.70"), "{screen}");
        let place = |label| row(label).chars().position(|letter| letter == '.');
        assert_eq!(place("Axial friction"), place("Hook load"), "{screen}");
    }

    #[test]
    fn what_stands_still_is_not_marked() {
        let still = screen(&[("hook_load_N", 700.0, 0.0, false)]);
        assert!(!still.contains(['↗', '↘']), "{still}");
    }
}

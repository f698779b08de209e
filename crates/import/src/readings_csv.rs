//! Weights and torques as a file for a plan and a calibration.

use std::fmt::Write;

use wholestring_tabular::ImportedReading;
use wholestring_units::{Dimension, Unit, UnitSet, significant};

/// A column: its heading, dimension and value.
struct Column {
    heading: &'static str,
    dimension: Dimension,
    value: fn(&ImportedReading) -> Option<f64>,
}

const COLUMNS: [Column; 7] = [
    Column {
        heading: "Bit depth",
        dimension: Dimension::Length,
        value: |reading| Some(reading.bit_depth_m),
    },
    Column { heading: "Pick-up", dimension: Dimension::Force, value: |reading| reading.pick_up_N },
    Column {
        heading: "Slack-off",
        dimension: Dimension::Force,
        value: |reading| reading.slack_off_N,
    },
    Column {
        heading: "Rotating",
        dimension: Dimension::Force,
        value: |reading| reading.rotating_N,
    },
    Column { heading: "Torque", dimension: Dimension::Torque, value: |reading| reading.torque_N_m },
    Column {
        heading: "Torque on bottom",
        dimension: Dimension::Torque,
        value: |reading| reading.torque_on_bottom_N_m,
    },
    Column {
        heading: "Mud density",
        dimension: Dimension::Density,
        value: |reading| reading.mud_density_kg_per_m3,
    },
];

/// Twelve significant digits: more than any reading has, and without the rounding errors of
/// conversion factors.
fn number(si: f64, unit: &Unit) -> String {
    significant(unit.from_si(si), 12).to_string()
}

/// A row for each reading in these units, which are given in the headings; columns without any
/// reading are left out.
pub(crate) fn readings_csv(readings: &[ImportedReading], units: UnitSet) -> String {
    let used = |column: &&Column| readings.iter().any(|reading| (column.value)(reading).is_some());
    let columns: Vec<&Column> = COLUMNS.iter().filter(used).collect();
    let unit = |column: &Column| column.dimension.unit_in(units);
    let headings: Vec<String> = columns
        .iter()
        .map(|column| format!("{} ({})", column.heading, unit(column).symbol))
        .collect();
    let held_out = readings.iter().any(|reading| reading.held_out);
    let mut text = headings.join(",");
    text.push_str(if held_out { ",use\n" } else { "\n" });
    for reading in readings {
        let cells = columns.iter().map(|column| {
            (column.value)(reading).map_or(String::new(), |si| number(si, unit(column)))
        });
        let _ = write!(text, "{}", cells.collect::<Vec<_>>().join(","));
        text.push_str(match (held_out, reading.held_out) {
            (false, _) => "\n",
            (true, true) => ",no\n",
            (true, false) => ",yes\n",
        });
    }
    text
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use wholestring_tabular::read_readings;

    use super::*;

    fn reading() -> impl Strategy<Value = ImportedReading> {
        let load = || prop::option::of(-1e6..5e6_f64);
        let held_out = any::<bool>();
        (1.0..1e4_f64, 0.0..1e6_f64, [load(), load(), load(), load()], held_out).prop_map(
            |(bit_depth_m, pick_up, [slack_off, rotating, torque, on_bottom], held_out)| {
                ImportedReading {
                    place: String::new(),
                    bit_depth_m,
                    pick_up_N: Some(pick_up),
                    slack_off_N: slack_off,
                    rotating_N: rotating,
                    torque_N_m: torque,
                    torque_on_bottom_N_m: on_bottom,
                    mud_density_kg_per_m3: None,
                    case: None,
                    held_out,
                    keys: Vec::new(),
                }
            },
        )
    }

    proptest! {
        /// Written in any units and read back, readings are equal to eleven digits.
        #[test]
        fn read_back(all in prop::collection::vec(reading(), 1..20)) {
            for units in [UnitSet::Si, UnitSet::Metric, UnitSet::Field] {
                let text = readings_csv(&all, units);
                let back = read_readings(text.as_bytes(), "a.csv").expect("readings").readings;
                prop_assert_eq!(all.len(), back.len());
                for (one, other) in all.iter().zip(&back) {
                    prop_assert_eq!(one.held_out, other.held_out);
                    for column in &COLUMNS {
                        match ((column.value)(one), (column.value)(other)) {
                            (Some(a), Some(b)) => prop_assert!((a - b).abs() <= 1e-10 * a.abs().max(1e-9)),
                            (a, b) => prop_assert_eq!(a.is_some(), b.is_some()),
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn headings_in_field_units() {
        let reading = ImportedReading {
            place: String::new(),
            bit_depth_m: 304.8,
            pick_up_N: Some(444_822.161_526_05),
            slack_off_N: None,
            rotating_N: None,
            torque_N_m: Some(1_355.817_948_331_400_4),
            torque_on_bottom_N_m: None,
            mud_density_kg_per_m3: None,
            case: None,
            held_out: false,
            keys: Vec::new(),
        };
        assert_eq!(
            readings_csv(&[reading], UnitSet::Field),
            "Bit depth (ft),Pick-up (klbf),Torque (ft-lbf)\n1000,100,1000\n"
        );
    }
}

//! Bits that left their tables.

use std::f64::consts::TAU;

use wholestring_results::Summary;
use wholestring_units::{Dimension, UnitSet};

/// A line for every operation whose bit was where its table is not; empty where none was.
pub(crate) fn warnings(summary: &Summary, units: UnitSet) -> String {
    let mut lines = String::new();
    for solved in &summary.operations {
        let Some(of) = solved.bit_table.filter(|of| of.outside_fraction > 0.0) else {
            continue;
        };
        let forces = |[least, largest]: [f64; 2]| {
            let [least, largest] =
                [least, largest].map(|force| Dimension::Force.format(force, units));
            format!("{least} to {largest}")
        };
        let speeds = |[slowest, fastest]: [f64; 2]| {
            let [slowest, fastest] = [slowest, fastest].map(|speed| speed * 60.0 / TAU);
            format!("{slowest:.0} to {fastest:.0} rev/min")
        };
        lines += &format!(
            "warning: {}: the bit was outside its table for {:.1} % of the time on the rock, which stays at its edge there: \
             weight on bit {} (table {}), rotary speed {} (table {})\n",
            solved.operation.replace('_', " "),
            of.outside_fraction * 100.0,
            forces(of.weights_N),
            forces(of.table_weights_N),
            speeds(of.speeds_rad_per_s),
            speeds(of.table_speeds_rad_per_s),
        );
    }
    lines
}

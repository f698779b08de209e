//! `stability.parquet`: the map of torsional stability.

use wholestring::torsional_stability::StabilityLine;

use crate::{STABILITY, StableFrom, Table};

/// A row for each speed at each weight.
pub fn stability_table(lines: &[StabilityLine]) -> Table {
    let mut table = Table::with_columns(STABILITY);
    for line in lines {
        let from = StableFrom::from(line.threshold);
        let threshold = from.threshold_rad_per_s.unwrap_or(f64::NAN);
        for point in &line.points {
            let stability = &point.stability;
            let worst = stability.worst;
            let [growth, frequency] =
                worst.map_or([f64::NAN; 2], |worst| [worst.growth_per_s, worst.frequency_Hz]);
            let truth = |value: bool| f64::from(u8::from(value));
            table.append(
                &[("stable", &[from.stable.name()]), ("lies_by", &[line.lies_by.name()])],
                &[
                    ("weight_on_bit_N", &[point.weight_on_bit_N]),
                    ("rotary_speed_rad_per_s", &[point.rotary_speed_rad_per_s]),
                    ("unstable_roots", &[stability.unstable_roots as f64]),
                    ("growth_per_s", &[growth]),
                    ("frequency_Hz", &[frequency]),
                    ("complete", &[truth(stability.complete)]),
                    ("threshold_rad_per_s", &[threshold]),
                    ("surface_torque_N_m", &[line.surface_torque_N_m]),
                    ("stalls", &[truth(line.stalls)]),
                ],
            );
        }
    }
    table
}

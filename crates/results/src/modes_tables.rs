//! `modes.parquet` and `critical_speeds.parquet`: what the summary has, as tables.

use crate::{CRITICAL_SPEEDS, MODES, ModesSummary, Table};

impl ModesSummary {
    /// A row for each mode.
    pub fn modes_table(&self) -> Table {
        let mut table = Table::with_columns(MODES);
        for of in &self.modes {
            let whirl = of.whirl.as_deref().unwrap_or_default();
            let [lateral, axial, torsional] = of.energy;
            table.append(
                &[
                    ("family", &[&of.family]),
                    ("whirl", &[whirl]),
                    ("component", &[&of.most_strained.component]),
                ],
                &[
                    ("number", &[of.number as f64]),
                    ("frequency_Hz", &[of.frequency_Hz]),
                    ("precession", &[of.precession]),
                    ("lateral_energy", &[lateral]),
                    ("axial_energy", &[axial]),
                    ("torsional_energy", &[torsional]),
                    ("most_strained_md_m", &[of.most_strained.md_m]),
                    ("most_strained_from_bit_m", &[of.most_strained.from_bit_m]),
                ],
            );
        }
        table
    }

    /// A row for each critical speed.
    pub fn critical_speeds_table(&self) -> Table {
        let mut table = Table::with_columns(CRITICAL_SPEEDS);
        for of in &self.critical_speeds {
            table.append(
                &[("family", &[&of.family]), ("component", &[&of.most_strained.component])],
                &[
                    ("order", &[of.order]),
                    ("rotary_speed_rad_per_s", &[of.rotary_speed_rad_per_s]),
                    ("frequency_Hz", &[of.frequency_Hz]),
                    ("branch", &[of.branch as f64]),
                    ("number", &[of.number as f64]),
                    ("most_strained_md_m", &[of.most_strained.md_m]),
                    ("most_strained_from_bit_m", &[of.most_strained.from_bit_m]),
                ],
            );
        }
        table
    }
}

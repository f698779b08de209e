//! `modes.parquet` and `critical_speeds.parquet`: the contents of the summary as tables.

use crate::{CRITICAL_SPEEDS, MODES, ModesSummary, Table};

impl ModesSummary {
    /// A row for each mode.
    pub fn modes_table(&self) -> Table {
        let mut table = Table::with_columns(MODES);
        for mode in &self.modes {
            let whirl = mode.whirl.as_deref().unwrap_or_default();
            let [lateral, axial, torsional] = mode.energy;
            table.append(
                &[
                    ("family", &[&mode.family]),
                    ("whirl", &[whirl]),
                    ("component", &[&mode.most_strained.component]),
                ],
                &[
                    ("number", &[mode.number as f64]),
                    ("frequency_Hz", &[mode.frequency_Hz]),
                    ("precession", &[mode.precession]),
                    ("lateral_energy", &[lateral]),
                    ("axial_energy", &[axial]),
                    ("torsional_energy", &[torsional]),
                    ("most_strained_md_m", &[mode.most_strained.md_m]),
                    ("most_strained_from_bit_m", &[mode.most_strained.from_bit_m]),
                ],
            );
        }
        table
    }

    /// A row for each critical speed.
    pub fn critical_speeds_table(&self) -> Table {
        let mut table = Table::with_columns(CRITICAL_SPEEDS);
        for critical_speed in &self.critical_speeds {
            table.append(
                &[
                    ("family", &[&critical_speed.family]),
                    ("component", &[&critical_speed.most_strained.component]),
                ],
                &[
                    ("order", &[critical_speed.order]),
                    ("rotary_speed_rad_per_s", &[critical_speed.rotary_speed_rad_per_s]),
                    ("frequency_Hz", &[critical_speed.frequency_Hz]),
                    ("branch", &[critical_speed.branch as f64]),
                    ("number", &[critical_speed.number as f64]),
                    ("most_strained_md_m", &[critical_speed.most_strained.md_m]),
                    ("most_strained_from_bit_m", &[critical_speed.most_strained.from_bit_m]),
                ],
            );
        }
        table
    }
}

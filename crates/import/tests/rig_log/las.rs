//! The log as a recorder writes it: LAS 2.0.

use std::fmt::Write;

use super::Rig;

impl<Of> Rig<Of> {
    /// The whole log as a file, with a hundredth of the noise as its resolution.
    pub fn las(&self) -> String {
        let mut text = String::from(
            "~V\nVERS. 2.0:\nWRAP. NO:\n~W\nSTRT.s 0:\nNULL. -999.25:\nWELL. MADE UP 1:\n~C\nTIME.s:\nDBTM.m:\n\
             DMEA.m:\nBPOS.m:\nHKLA.kN: block included\nTQA.kN.m:\nRPMA.rpm:\n~A\n",
        );
        for record in &self.records {
            let shown = |value: f64, digits: usize| match value.is_nan() {
                true => "-999.25".to_owned(),
                false => format!("{value:.digits$}"),
            };
            let values = [
                shown(record.time_s, 1),
                shown(record.bit_depth_m, 3),
                shown(record.hole_depth_m, 3),
                shown(record.block_position_m, 4),
                shown(1e-3 * record.hook_load_N, 2),
                shown(1e-3 * record.torque_N_m, 3),
                shown(record.rotary_speed_rad_per_s * 30.0 / std::f64::consts::PI, 1),
            ];
            let _ = writeln!(text, "{}", values.join(" "));
        }
        text
    }
}

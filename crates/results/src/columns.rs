//! Every column of every table: name, unit and meaning in one place.

use crate::{Column, Data};

/// Name, unit and meaning of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColumnSpec {
    /// Name in the file, with the unit in it.
    pub name: &'static str,
    /// Unit symbol; empty where there is none.
    pub unit: &'static str,
    /// What it holds, in one sentence.
    pub meaning: &'static str,
    /// Whether it holds words rather than numbers.
    pub text: bool,
}

impl ColumnSpec {
    const fn text(name: &'static str, meaning: &'static str) -> Self {
        Self {
            name,
            unit: "",
            meaning,
            text: true,
        }
    }

    const fn number(name: &'static str, unit: &'static str, meaning: &'static str) -> Self {
        Self {
            name,
            unit,
            meaning,
            text: false,
        }
    }

    pub(crate) fn empty(&self) -> Column {
        Column {
            name: self.name.into(),
            unit: self.unit.into(),
            meaning: self.meaning.into(),
            data: if self.text {
                Data::Text(Vec::new())
            } else {
                Data::Number(Vec::new())
            },
        }
    }
}

/// Columns of `nodes.parquet`: the profile along the string, one row per node, from the surface to the
/// bit, for each model and operation.
pub const NODES: &[ColumnSpec] = &[
    ColumnSpec::text("model", "`soft` or `dynamic`"),
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::number("md_m", "m", "Measured depth of the node"),
    ColumnSpec::number(
        "tension_N",
        "N",
        "Effective tension; negative in compression",
    ),
    ColumnSpec::number("torque_N_m", "N·m", "Torque that the string carries"),
    ColumnSpec::number(
        "side_force_N_per_m",
        "N/m",
        "Side force of the wall on the string per length; positive where the string lies on the high side",
    ),
    ColumnSpec::number(
        "contact_fraction",
        "",
        "Share of the time in contact with the wall",
    ),
    ColumnSpec::number("tension_std_N", "N", "Standard deviation of `tension_N`"),
    ColumnSpec::number(
        "torque_std_N_m",
        "N·m",
        "Standard deviation of `torque_N_m`",
    ),
    ColumnSpec::number("contact_force_N", "N", "Contact force of the node itself"),
    ColumnSpec::number(
        "contact_force_std_N",
        "N",
        "Standard deviation of `contact_force_N`",
    ),
    ColumnSpec::number(
        "contact_force_max_N",
        "N",
        "Largest contact force of any sample",
    ),
    ColumnSpec::number(
        "climb_rad",
        "rad",
        "Angle of the node's mean contact force from the low side, from −π to π; positive to the right looking down the hole, `null` where nothing touched and for the soft string",
    ),
    ColumnSpec::number(
        "lateral_offset_m",
        "m",
        "Distance between the string's axis and the hole's",
    ),
    ColumnSpec::number(
        "axial_friction_N_per_m",
        "N/m",
        "Wall friction along the string per length; positive adds to hook load",
    ),
    ColumnSpec::number(
        "friction_torque_N_m_per_m",
        "N·m/m",
        "Torque of wall friction per length",
    ),
    ColumnSpec::number(
        "wear_work_J_per_m",
        "J/m",
        "Work of friction over the window per metre of string: force times sliding distance",
    ),
    ColumnSpec::number(
        "twist_rad",
        "rad",
        "Turn of the node against the bit; positive where it leads",
    ),
    ColumnSpec::number(
        "stretch_m",
        "m",
        "Elongation of the string between the node and the bit",
    ),
    ColumnSpec::text(
        "contact_class",
        "`none`, `intermittent` or `continuous`: in contact for less than 1 %, up to 99 % or more of the time",
    ),
    ColumnSpec::text(
        "contact_side",
        "`high` or `low`, by the sign of the mean side force; `none` where nothing presses",
    ),
    ColumnSpec::number(
        "side_force_per_joint_N",
        "N",
        "Side force that a tool joint carries, `side_force_N_per_m` over the spacing of the joints; `null` where the string has none",
    ),
    ColumnSpec::number("tension_p05_N", "N", "5th percentile of `tension_N`"),
    ColumnSpec::number("tension_p50_N", "N", "Median of `tension_N`"),
    ColumnSpec::number("tension_p95_N", "N", "95th percentile of `tension_N`"),
    ColumnSpec::number("torque_p05_N_m", "N·m", "5th percentile of `torque_N_m`"),
    ColumnSpec::number("torque_p50_N_m", "N·m", "Median of `torque_N_m`"),
    ColumnSpec::number("torque_p95_N_m", "N·m", "95th percentile of `torque_N_m`"),
    ColumnSpec::number(
        "contact_force_p05_N",
        "N",
        "5th percentile of `contact_force_N`",
    ),
    ColumnSpec::number("contact_force_p50_N", "N", "Median of `contact_force_N`"),
    ColumnSpec::number(
        "contact_force_p95_N",
        "N",
        "95th percentile of `contact_force_N`",
    ),
    ColumnSpec::number(
        "true_tension_N",
        "N",
        "Force in the metal, `T + p_i A_i − p_o A_o + ρ Q²/A_i`: effective tension and what the mud's pressures and its stream add",
    ),
    ColumnSpec::number(
        "outside_pressure_Pa",
        "Pa",
        "Pressure of the mud in the annulus: of its weight and its flow",
    ),
    ColumnSpec::number(
        "inside_pressure_Pa",
        "Pa",
        "Pressure of the mud in the bore",
    ),
    ColumnSpec::number(
        "bending_moment_N_m",
        "N·m",
        "Bending moment, whatever its direction",
    ),
    ColumnSpec::number(
        "bending_moment_max_N_m",
        "N·m",
        "Largest bending moment of any sample",
    ),
    ColumnSpec::number(
        "bending_moment_p05_N_m",
        "N·m",
        "5th percentile of `bending_moment_N_m`",
    ),
    ColumnSpec::number(
        "bending_moment_p50_N_m",
        "N·m",
        "Median of `bending_moment_N_m`",
    ),
    ColumnSpec::number(
        "bending_moment_p95_N_m",
        "N·m",
        "95th percentile of `bending_moment_N_m`",
    ),
    ColumnSpec::number(
        "bending_stress_Pa",
        "Pa",
        "Stress that alternates at the body's surface as it turns, `M D/2I`",
    ),
    ColumnSpec::number(
        "von_mises_stress_Pa",
        "Pa",
        "Von Mises stress where the body's surface bears most",
    ),
    ColumnSpec::number(
        "von_mises_stress_max_Pa",
        "Pa",
        "Largest von Mises stress of any sample",
    ),
    ColumnSpec::number(
        "yield_use",
        "",
        "`von_mises_stress_max_Pa` over the minimum yield strength; `null` where that is not known",
    ),
    ColumnSpec::number(
        "whirl_rate_rad_per_s",
        "rad/s",
        "Mean angular velocity of the string's axis about the hole's; positive with the rotation",
    ),
    ColumnSpec::number(
        "whirl_coherence",
        "",
        "How much of the lateral motion that whirl is, from 0 to 1",
    ),
    ColumnSpec::number(
        "lateral_speed_rms_m_per_s",
        "m/s",
        "Root mean square of the lateral speed",
    ),
];

/// Columns of `wear.parquet`: the work of friction on the hole over the window, one row per 5 m of hole, from
/// the surface down, for each operation that was solved by dynamics.
pub const WEAR: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::number("md_m", "m", "Measured depth of the middle of the stretch"),
    ColumnSpec::number(
        "wear_work_J_per_m",
        "J/m",
        "Work of friction over the window per metre of hole: force times sliding distance",
    ),
    ColumnSpec::number(
        "wear_power_W_per_m",
        "W/m",
        "Its mean rate; times 3600, the work in an hour of the same",
    ),
];

/// Columns of `time.parquet`: the scalars against time, one row per sample, for each operation that was
/// solved by dynamics.
pub const TIME: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::number(
        "time_s",
        "s",
        "Simulated time from the start, settling included",
    ),
    ColumnSpec::number("bit_depth_m", "m", "Measured depth of the bit"),
    ColumnSpec::number("weight_on_bit_N", "N", "Weight on bit"),
    ColumnSpec::number("bit_torque_N_m", "N·m", "Torque at the bit"),
    ColumnSpec::number(
        "depth_of_cut_m",
        "m",
        "Rock that a revolution of the bit takes away; 0 where a motor turns it at a speed that is not given",
    ),
    ColumnSpec::number(
        "hook_load_N",
        "N",
        "Tension at the top of the string; block and top drive excluded",
    ),
    ColumnSpec::number(
        "surface_torque_N_m",
        "N·m",
        "Torque at the top of the string",
    ),
    ColumnSpec::number(
        "friction_torque_N_m",
        "N·m",
        "Torque of wall friction, summed along the string",
    ),
    ColumnSpec::number(
        "axial_friction_N",
        "N",
        "Wall friction along the string, summed; positive adds to hook load",
    ),
    ColumnSpec::number(
        "side_force_total_N",
        "N",
        "Magnitude of the side force, summed along the string",
    ),
    ColumnSpec::number(
        "twist_rad",
        "rad",
        "Turn of the top against the bit; positive where the top leads",
    ),
    ColumnSpec::number("stretch_m", "m", "Elongation against the unloaded string"),
    ColumnSpec::number(
        "neutral_point_m",
        "m",
        "Measured depth of the shallowest zero of effective tension; `null` if none",
    ),
    ColumnSpec::number(
        "cutoff_depth_m",
        "m",
        "Deepest change of the side force, averaged over the second before, from high to low side: a value a second, `null` between and if none",
    ),
    ColumnSpec::number(
        "block_velocity_m_per_s",
        "m/s",
        "Speed of the travelling block; positive downwards",
    ),
    ColumnSpec::number(
        "bit_rotary_speed_rad_per_s",
        "rad/s",
        "Rotary speed of the bit",
    ),
    ColumnSpec::number("rotary_speed_rad_per_s", "rad/s", "Rotary speed at surface"),
    ColumnSpec::number(
        "rotary_speed_set_rad_per_s",
        "rad/s",
        "What the rotary speed at surface is set to",
    ),
    ColumnSpec::number(
        "block_velocity_set_m_per_s",
        "m/s",
        "What the speed of the block is set to; positive downwards, `null` where something else is",
    ),
    ColumnSpec::number(
        "weight_on_bit_set_N",
        "N",
        "What the autodriller is set to hold; `null` where it is not in control",
    ),
    ColumnSpec::number("flow_rate_m3_per_s", "m³/s", "What the pumps deliver"),
    ColumnSpec::number(
        "pump_pressure_Pa",
        "Pa",
        "Pressure that the pumps deliver at; `null` without a rheology",
    ),
    ColumnSpec::text(
        "note",
        "Note of the line of the schedule that began last; empty without one",
    ),
];

/// Columns of `frames.parquet`: the whole string, a row per node of every frame. Channels that were not asked
/// for have no column.
pub const FRAMES: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::number(
        "time_s",
        "s",
        "Simulated time from the start, settling included",
    ),
    ColumnSpec::number("node", "", "Number of the node, from 0 at the surface"),
    ColumnSpec::number("md_m", "m", "Measured depth of the node"),
    ColumnSpec::number(
        "offset_high_m",
        "m",
        "Offset of the string's axis from the hole's towards the high side",
    ),
    ColumnSpec::number(
        "offset_right_m",
        "m",
        "Offset to the right, looking down the hole",
    ),
    ColumnSpec::number("north_m", "m", "North of the node"),
    ColumnSpec::number("east_m", "m", "East of the node"),
    ColumnSpec::number("tvd_m", "m", "True vertical depth of the node"),
    ColumnSpec::number(
        "velocity_high_m_per_s",
        "m/s",
        "Velocity towards the high side",
    ),
    ColumnSpec::number("velocity_right_m_per_s", "m/s", "Velocity to the right"),
    ColumnSpec::number("axial_velocity_m_per_s", "m/s", "Velocity down the hole"),
    ColumnSpec::number(
        "rotary_speed_rad_per_s",
        "rad/s",
        "Rotary speed of the node; positive clockwise looking down the hole",
    ),
    ColumnSpec::number(
        "twist_rad",
        "rad",
        "Turn of the node against the bit; positive where it leads",
    ),
    ColumnSpec::number(
        "tilt_high_rad",
        "rad",
        "Angle of the string's axis with the hole's towards the high side",
    ),
    ColumnSpec::number("tilt_right_rad", "rad", "Angle to the right"),
    ColumnSpec::number(
        "contact_force_N",
        "N",
        "Contact force of the node, averaged over the sample; positive on the high side",
    ),
    ColumnSpec::number(
        "axial_friction_N",
        "N",
        "Wall friction along the string on the node, averaged over the sample; positive adds to hook load",
    ),
    ColumnSpec::number(
        "friction_torque_N_m",
        "N·m",
        "Torque of wall friction on the node, averaged over the sample",
    ),
    ColumnSpec::number(
        "tension_N",
        "N",
        "Effective tension; negative in compression",
    ),
    ColumnSpec::number("torque_N_m", "N·m", "Torque that the string carries"),
    ColumnSpec::number(
        "bending_moment_N_m",
        "N·m",
        "Bending moment, whatever its direction",
    ),
    ColumnSpec::number(
        "von_mises_stress_Pa",
        "Pa",
        "Von Mises stress where the body's surface bears most",
    ),
];

/// Columns of `spectra.parquet`: power spectral densities over the window, a row per frequency.
pub const SPECTRA: &[ColumnSpec] = &[
    ColumnSpec::text("operation", "`trip_out`, `drill`, ..."),
    ColumnSpec::text(
        "signal",
        "Column of `time.parquet` or, of a node, of `frames.parquet` without its unit: `surface_torque`, ...",
    ),
    ColumnSpec::number(
        "md_m",
        "m",
        "Measured depth of the node; `null` for a scalar",
    ),
    ColumnSpec::text("unit", "Unit of the signal"),
    ColumnSpec::number("frequency_Hz", "Hz", "Frequency"),
    ColumnSpec::number(
        "density",
        "",
        "One-sided power spectral density, square of the signal's unit per Hz",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_end_in_their_unit() {
        for table in [NODES, TIME, WEAR, FRAMES, SPECTRA] {
            for (index, column) in table.iter().enumerate() {
                assert!(
                    table[..index].iter().all(|other| other.name != column.name),
                    "{} stands twice",
                    column.name
                );
                let suffix = match column.unit {
                    "" => "",
                    "m" => "_m",
                    "s" => "_s",
                    "N" => "_N",
                    "rad" => "_rad",
                    "N·m" => "_N_m",
                    "N/m" => "_N_per_m",
                    "N·m/m" => "_N_m_per_m",
                    "J/m" => "_J_per_m",
                    "W/m" => "_W_per_m",
                    "m/s" => "_m_per_s",
                    "m³/s" => "_m3_per_s",
                    "rad/s" => "_rad_per_s",
                    "Pa" => "_Pa",
                    "Hz" => "_Hz",
                    other => panic!("{}: unknown unit {other}", column.name),
                };
                assert!(column.name.ends_with(suffix), "{}", column.name);
            }
        }
    }
}

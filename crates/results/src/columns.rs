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
        "twist_rad",
        "rad",
        "Turn of the node against the bit; positive where it leads",
    ),
    ColumnSpec::number(
        "stretch_m",
        "m",
        "Elongation of the string between the node and the bit",
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
        "Rock that a revolution of the bit takes away; `null` where a motor turns it at a speed that is not given",
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
        "Measured depth of the shallowest zero of effective tension; not sampled in time, `null`",
    ),
    ColumnSpec::number(
        "cutoff_depth_m",
        "m",
        "Deepest change of the side force from high to low side; not sampled in time, `null`",
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
    ColumnSpec::text(
        "note",
        "Note of the line of the schedule that began last; empty without one",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_end_in_their_unit() {
        for table in [NODES, TIME] {
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
                    "m/s" => "_m_per_s",
                    "rad/s" => "_rad_per_s",
                    other => panic!("{}: unknown unit {other}", column.name),
                };
                assert!(column.name.ends_with(suffix), "{}", column.name);
            }
        }
    }
}

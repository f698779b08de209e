//! Columns of `time.parquet`.

use crate::ColumnSpec;

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
        "bit_force_high_N",
        "N",
        "Force of rock and hole on the bit across the hole, towards its high side",
    ),
    ColumnSpec::number(
        "bit_force_right_N",
        "N",
        "The same to the right, looking down the hole",
    ),
    ColumnSpec::number(
        "bit_moment_N_m",
        "N·m",
        "Bending moment of solid rock on the bit, whatever its direction; 0 of other laws",
    ),
    ColumnSpec::number(
        "depth_of_cut_m",
        "m",
        "Rock that a revolution of the bit takes away; 0 where a motor turns it at a speed that is not given",
    ),
    ColumnSpec::number(
        "rate_of_penetration_m_per_s",
        "m/s",
        "Rock that the bit takes away per time",
    ),
    ColumnSpec::number(
        "motor_speed_rad_per_s",
        "rad/s",
        "Speed of the mud motor against the string; `null` without a motor",
    )
    .null_where("there is no motor"),
    ColumnSpec::number(
        "motor_pressure_Pa",
        "Pa",
        "Pressure that the mud motor takes off the mud; `null` without a motor or where its speed alone is given",
    )
    .null_where("there is no motor, or its speed alone is given"),
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
    )
    .null_where("there is none"),
    ColumnSpec::number(
        "cutoff_depth_m",
        "m",
        "Deepest change of the side force, averaged over the second before, from high to low side: a value a second, `null` between and if none",
    )
    .null_where("there is none, and between whole seconds"),
    ColumnSpec::number(
        "block_velocity_m_per_s",
        "m/s",
        "Speed of the travelling block; positive downwards",
    ),
    ColumnSpec::number(
        "bit_rotary_speed_rad_per_s",
        "rad/s",
        "Rotary speed of the string at the bit; a mud motor's comes on top",
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
    )
    .null_where("something else is set"),
    ColumnSpec::number(
        "weight_on_bit_set_N",
        "N",
        "What the autodriller is set to hold; `null` where it is not in control",
    )
    .null_where("the autodriller is not in control"),
    ColumnSpec::number("flow_rate_m3_per_s", "m³/s", "What the pumps deliver"),
    ColumnSpec::number(
        "pump_pressure_Pa",
        "Pa",
        "Pressure that the pumps deliver at; `null` without a rheology",
    )
    .null_where("the mud has no rheology"),
    ColumnSpec::text(
        "note",
        "Note of the line of the schedule that began last; empty without one",
    )
    .null_where("no line of the schedule with a note has begun"),
];

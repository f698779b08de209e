//! Columns of `nodes.parquet`.

use super::DYNAMIC;
use crate::ColumnSpec;

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
    ColumnSpec::number("tension_std_N", "N", "Standard deviation of `tension_N`").of(DYNAMIC),
    ColumnSpec::number(
        "torque_std_N_m",
        "N·m",
        "Standard deviation of `torque_N_m`",
    )
    .of(DYNAMIC),
    ColumnSpec::number("contact_force_N", "N", "Contact force of the node itself").of(DYNAMIC),
    ColumnSpec::number(
        "contact_force_std_N",
        "N",
        "Standard deviation of `contact_force_N`",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "contact_force_max_N",
        "N",
        "Largest contact force of any sample",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "climb_rad",
        "rad",
        "Angle of the mean contact force from the low side, from −π to π; positive to the right looking down the hole, `null` where nothing touched",
    )
    .null_where("nothing touched"),
    ColumnSpec::number(
        "lateral_offset_m",
        "m",
        "Distance between the string's axis and the hole's; a soft string lies on the wall",
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
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "wear_power_W_per_m",
        "W/m",
        "Its mean rate, of a soft string the rate: friction force times sliding speed per metre of string",
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
    )
    .null_where("the string has no joints"),
    ColumnSpec::number("tension_p05_N", "N", "5th percentile of `tension_N`").of(DYNAMIC),
    ColumnSpec::number("tension_p50_N", "N", "Median of `tension_N`").of(DYNAMIC),
    ColumnSpec::number("tension_p95_N", "N", "95th percentile of `tension_N`").of(DYNAMIC),
    ColumnSpec::number("torque_p05_N_m", "N·m", "5th percentile of `torque_N_m`").of(DYNAMIC),
    ColumnSpec::number("torque_p50_N_m", "N·m", "Median of `torque_N_m`").of(DYNAMIC),
    ColumnSpec::number("torque_p95_N_m", "N·m", "95th percentile of `torque_N_m`").of(DYNAMIC),
    ColumnSpec::number(
        "side_force_p05_N_per_m",
        "N/m",
        "5th percentile of `side_force_N_per_m`",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "side_force_p50_N_per_m",
        "N/m",
        "Median of `side_force_N_per_m`",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "side_force_p95_N_per_m",
        "N/m",
        "95th percentile of `side_force_N_per_m`",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "contact_force_p05_N",
        "N",
        "5th percentile of `contact_force_N`",
    )
    .of(DYNAMIC),
    ColumnSpec::number("contact_force_p50_N", "N", "Median of `contact_force_N`").of(DYNAMIC),
    ColumnSpec::number(
        "contact_force_p95_N",
        "N",
        "95th percentile of `contact_force_N`",
    )
    .of(DYNAMIC),
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
        "Bending moment, whatever its direction; of a soft string the larger of that at tool joints and half-way",
    ),
    ColumnSpec::number(
        "bending_moment_max_N_m",
        "N·m",
        "Largest bending moment of any sample",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "bending_moment_p05_N_m",
        "N·m",
        "5th percentile of `bending_moment_N_m`",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "bending_moment_p50_N_m",
        "N·m",
        "Median of `bending_moment_N_m`",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "bending_moment_p95_N_m",
        "N·m",
        "95th percentile of `bending_moment_N_m`",
    )
    .of(DYNAMIC),
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
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "yield_use",
        "",
        "Largest von Mises stress, of a soft string `von_mises_stress_Pa`, over the minimum yield strength; `null` where that is not known",
    )
    .null_where("the yield strength is not known"),
    ColumnSpec::number(
        "whirl_rate_rad_per_s",
        "rad/s",
        "Mean angular velocity of the string's axis about the hole's; positive with the rotation",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "whirl_coherence",
        "",
        "How much of the lateral motion that whirl is, from 0 to 1",
    )
    .of(DYNAMIC),
    ColumnSpec::number(
        "lateral_speed_rms_m_per_s",
        "m/s",
        "Root mean square of the lateral speed",
    )
    .of(DYNAMIC),
];

//! Indicators of dynamic runs as columns of a sweep.

/// An indicator: its path in `summary.json` below `indicators`, and its column: name, unit and
/// meaning.
pub(super) struct Indicator {
    pub(super) path: &'static [&'static str],
    pub(super) about: (&'static str, &'static str, &'static str),
}

const fn indicator(
    path: &'static [&'static str],
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
) -> Indicator {
    Indicator { path, about: (name, unit, meaning) }
}

/// The indicators in the order of the columns.
pub(super) const INDICATORS: &[Indicator] = &[
    indicator(
        &["stick_slip", "severity"],
        "stick_slip_severity",
        "",
        "Stick-slip: half the swing of the bit's rotary speed over its mean; 1 where it just stops.",
    ),
    indicator(
        &["stick_slip", "torque_severity"],
        "stick_slip_torque_severity",
        "",
        "Half the swing of the surface torque over its mean.",
    ),
    indicator(
        &["stick_slip", "period_s"],
        "stick_slip_period_s",
        "s",
        "Mean period of the bit's rotary speed.",
    ),
    indicator(
        &["stick_slip", "stuck_fraction"],
        "stuck_fraction",
        "",
        "Part of the time in which the bit turned slower than 1 rev/min.",
    ),
    indicator(
        &["stick_slip", "bit_speed_max_rad_per_s"],
        "bit_speed_max_rad_per_s",
        "rad/s",
        "Largest rotary speed of the bit.",
    ),
    indicator(
        &["backward_whirl", "ratio"],
        "backward_whirl_ratio",
        "",
        "Fastest backward whirl over the rotary speed.",
    ),
    indicator(
        &["backward_whirl", "md_m"],
        "backward_whirl_md_m",
        "m",
        "Measured depth of the fastest backward whirl.",
    ),
    indicator(
        &["forward_whirl", "ratio"],
        "forward_whirl_ratio",
        "",
        "Fastest forward whirl over the rotary speed.",
    ),
    indicator(
        &["forward_whirl", "md_m"],
        "forward_whirl_md_m",
        "m",
        "Measured depth of the fastest forward whirl.",
    ),
    indicator(
        &["top_drive", "p95"],
        "top_drive_p95",
        "",
        "95th percentile of the surface torque over the top drive's rated torque.",
    ),
    indicator(
        &["top_drive", "max"],
        "top_drive_max",
        "",
        "Largest surface torque over the top drive's rated torque.",
    ),
];

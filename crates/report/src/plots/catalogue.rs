//! What is drawn of a run: one list for the page and for the files.

use serde::Serialize;

use super::near::JOINT_REACH_M;
use crate::figure::{OUTLIERS, Outliers};

/// How tracks are drawn, on the page and in files alike.
#[derive(Debug, Clone, Copy, Serialize)]
pub(crate) struct Rules {
    /// Where more of the string than this is in view, joints are too many to tell apart, m.
    pub(crate) far_m: f64,
    /// Half of the distance between joints, and a little, m.
    pub(crate) joint_reach_m: f64,
    /// A curve is seen beside another where it is this part of the largest value from it somewhere.
    pub(crate) min_difference: f64,
    /// Values that no axis reaches.
    pub(crate) outliers: Outliers,
}

pub(crate) const RULES: Rules =
    Rules { far_m: 400.0, joint_reach_m: JOINT_REACH_M, min_difference: 0.01, outliers: OUTLIERS };

/// A quantity against measured depth.
#[derive(Debug, Clone, Copy, Serialize)]
pub(crate) struct Track {
    /// Name of its file.
    #[serde(skip)]
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    pub(crate) dimension: &'static str,
    /// Column of its table.
    pub(crate) column: &'static str,
    /// Columns of the 5th and the 95th percentile.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) band: Option<[&'static str; 2]>,
    pub(crate) from: Source,
    /// What the axis spans at least, SI: less than that is no difference to an engineer.
    pub(crate) min_span: f64,
    /// Whether the axis goes to zero.
    pub(crate) zero: bool,
    /// Whether its sign is a side of the hole.
    pub(crate) sides: bool,
    /// Whether joints touch and what lies between them does not.
    pub(crate) touches: bool,
    /// Whether it swings from joint to joint.
    pub(crate) swings: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) range: Option<[f64; 2]>,
}

/// The table that a track is a column of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Source {
    Profile,
    Wear,
    Well,
}

const TRACK: Track = Track {
    name: "",
    title: "",
    dimension: "",
    column: "",
    band: None,
    from: Source::Profile,
    min_span: 0.0,
    zero: false,
    sides: false,
    touches: false,
    swings: false,
    range: None,
};

pub(crate) const TRACKS: &[Track] = &[
    Track {
        name: "tension",
        title: "Effective tension",
        dimension: "force",
        min_span: 2e4,
        column: "tension_N",
        band: Some(["tension_p05_N", "tension_p95_N"]),
        zero: true,
        ..TRACK
    },
    Track {
        name: "torque",
        title: "Torque",
        dimension: "torque",
        min_span: 500.0,
        column: "torque_N_m",
        band: Some(["torque_p05_N_m", "torque_p95_N_m"]),
        ..TRACK
    },
    Track {
        name: "side-force",
        title: "Side force",
        dimension: "force per length",
        min_span: 100.0,
        column: "side_force_N_per_m",
        band: Some(["side_force_p05_N_per_m", "side_force_p95_N_per_m"]),
        zero: true,
        sides: true,
        ..TRACK
    },
    Track {
        name: "contact",
        title: "In contact",
        dimension: "percent",
        column: "contact_fraction",
        touches: true,
        range: Some([0.0, 1.04]),
        ..TRACK
    },
    Track {
        name: "bending-moment",
        title: "Bending moment",
        dimension: "torque",
        min_span: 500.0,
        column: "bending_moment_N_m",
        band: Some(["bending_moment_p05_N_m", "bending_moment_p95_N_m"]),
        swings: true,
        ..TRACK
    },
    Track {
        name: "wear",
        title: "Wear work, hole",
        dimension: "work per length",
        min_span: 1e3,
        column: "wear_work_J_per_m",
        from: Source::Wear,
        ..TRACK
    },
    Track {
        name: "inclination",
        title: "Inclination",
        dimension: "angle",
        min_span: 0.035,
        column: "inclination_rad",
        from: Source::Well,
        zero: true,
        ..TRACK
    },
    Track {
        name: "dogleg-severity",
        title: "Dogleg severity",
        dimension: "dogleg severity",
        min_span: 6e-4,
        column: "dogleg_rad_per_m",
        from: Source::Well,
        zero: true,
        ..TRACK
    },
];

/// Quantities against time.
#[derive(Debug, Clone, Copy, Serialize)]
pub(crate) struct TimePlot {
    /// Name of its file.
    #[serde(skip)]
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    pub(crate) dimension: &'static str,
    /// What the axis spans at least, SI: less than that is no difference to an engineer.
    pub(crate) min_span: f64,
    /// Columns of the history, and what each is called.
    pub(crate) columns: &'static [[&'static str; 2]],
    /// Column of a profile in equilibrium whose value at the surface stands beside them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) at_surface: Option<&'static str>,
    /// Whether it is single points, on an axis that grows down: depths.
    pub(crate) points: bool,
}

const TIME_PLOT: TimePlot = TimePlot {
    name: "",
    title: "",
    dimension: "",
    min_span: 0.0,
    columns: &[],
    at_surface: None,
    points: false,
};

pub(crate) const TIME_PLOTS: &[TimePlot] = &[
    TimePlot {
        name: "time-hook-load",
        title: "Hook load without block",
        dimension: "force",
        min_span: 2e4,
        columns: &[["hook_load_N", "hook load"]],
        at_surface: Some("tension_N"),
        ..TIME_PLOT
    },
    TimePlot {
        name: "time-torque",
        title: "Torque",
        dimension: "torque",
        min_span: 1e3,
        columns: &[
            ["surface_torque_N_m", "surface"],
            ["friction_torque_N_m", "friction"],
            ["bit_torque_N_m", "bit"],
        ],
        at_surface: Some("torque_N_m"),
        ..TIME_PLOT
    },
    TimePlot {
        name: "time-rotary-speed",
        title: "Rotary speed",
        dimension: "rotary speed",
        min_span: 1.0,
        columns: &[
            ["rotary_speed_rad_per_s", "top"],
            ["bit_rotary_speed_rad_per_s", "bit"],
            ["rotary_speed_set_rad_per_s", "set"],
        ],
        ..TIME_PLOT
    },
    TimePlot {
        name: "time-block-velocity",
        title: "Block velocity, down",
        dimension: "speed",
        min_span: 0.02,
        columns: &[["block_velocity_m_per_s", "block"], ["block_velocity_set_m_per_s", "set"]],
        ..TIME_PLOT
    },
    TimePlot {
        name: "time-axial-friction",
        title: "Axial friction",
        dimension: "force",
        min_span: 1e4,
        columns: &[["axial_friction_N", "along the string"]],
        ..TIME_PLOT
    },
    TimePlot {
        name: "time-depths",
        title: "Neutral point and cut-off depth",
        dimension: "length",
        min_span: 20.0,
        columns: &[["neutral_point_m", "neutral point"], ["cutoff_depth_m", "cut-off depth"]],
        points: true,
        ..TIME_PLOT
    },
];

/// What the bit does, of a run that drills.
pub(crate) const BIT_PLOTS: &[TimePlot] = &[
    TimePlot {
        name: "bit-rate-of-penetration",
        title: "Rate of penetration",
        dimension: "rate of penetration",
        min_span: 5e-4,
        columns: &[["rate_of_penetration_m_per_s", "rate of penetration"]],
        ..TIME_PLOT
    },
    TimePlot {
        name: "bit-depth-of-cut",
        title: "Depth of cut",
        dimension: "diameter",
        min_span: 2e-4,
        columns: &[["depth_of_cut_m", "per revolution"]],
        ..TIME_PLOT
    },
    TimePlot {
        name: "bit-weight",
        title: "Weight on bit",
        dimension: "force",
        min_span: 1e4,
        columns: &[["weight_on_bit_N", "on bit"], ["weight_on_bit_set_N", "set"]],
        ..TIME_PLOT
    },
    TimePlot {
        name: "bit-torque",
        title: "Torque on bit",
        dimension: "torque",
        min_span: 500.0,
        columns: &[["bit_torque_N_m", "torque on bit"]],
        ..TIME_PLOT
    },
    TimePlot {
        name: "bit-speed",
        title: "Speed at the bit",
        dimension: "rotary speed",
        min_span: 1.0,
        columns: &[["bit_rotary_speed_rad_per_s", "string"], ["motor_speed_rad_per_s", "motor"]],
        ..TIME_PLOT
    },
    TimePlot {
        name: "bit-motor-pressure",
        title: "Motor pressure",
        dimension: "pressure",
        min_span: 2e5,
        columns: &[["motor_pressure_Pa", "pressure drop"]],
        ..TIME_PLOT
    },
    TimePlot {
        name: "bit-force-across",
        title: "Force across",
        dimension: "force",
        min_span: 1e3,
        columns: &[["bit_force_high_N", "to the high side"], ["bit_force_right_N", "to the right"]],
        ..TIME_PLOT
    },
    TimePlot {
        name: "bit-bending-moment",
        title: "Bending moment",
        dimension: "torque",
        min_span: 200.0,
        columns: &[["bit_moment_N_m", "bending moment"]],
        ..TIME_PLOT
    },
];

#[cfg(test)]
mod tests {
    use wholestring::outcome::{HOLE_WEAR, PROFILE, Quantity, QuantityKind, TIME_SERIES};

    use super::*;

    /// The kind of quantity that a dimension of the page shows.
    fn shows(dimension: &str, kind: QuantityKind) -> bool {
        match dimension {
            "percent" => kind == QuantityKind::Ratio,
            "force" => kind == QuantityKind::Force,
            "torque" => kind == QuantityKind::Torque,
            "force per length" => kind == QuantityKind::ForcePerLength,
            "work per length" => kind == QuantityKind::WorkPerLength,
            "rotary speed" => kind == QuantityKind::RotarySpeed,
            "speed" => kind == QuantityKind::Speed,
            "rate of penetration" => kind == QuantityKind::RateOfPenetration,
            "length" => kind == QuantityKind::Depth,
            "diameter" => kind == QuantityKind::Length,
            "pressure" => kind == QuantityKind::Pressure,
            other => panic!("{other} shows no kind of quantity"),
        }
    }

    #[test]
    fn what_is_drawn_is_declared_and_of_its_dimension() {
        let profile = || PROFILE.iter().map(|of| of.quantity);
        let wear = || HOLE_WEAR.iter().map(|of| of.quantity);
        let time = || TIME_SERIES.iter().map(|of| of.quantity);
        let check = |mut all: Box<dyn Iterator<Item = Quantity>>, name: &str, dimension: &str| {
            let found = all.find(|of| of.name == name);
            let found = found.unwrap_or_else(|| panic!("nothing declares `{name}`"));
            assert!(shows(dimension, found.kind), "{name}: {dimension}");
        };
        for track in TRACKS {
            let names = track.band.into_iter().flatten().chain([track.column]);
            for name in names {
                match track.from {
                    Source::Profile => check(Box::new(profile()), name, track.dimension),
                    Source::Wear => check(Box::new(wear()), name, track.dimension),
                    // The path is no answer of a method.
                    Source::Well => {}
                }
            }
        }
        for plot in TIME_PLOTS.iter().chain(BIT_PLOTS) {
            for [name, _] in plot.columns {
                check(Box::new(time()), name, plot.dimension);
            }
            if let Some(name) = plot.at_surface {
                check(Box::new(profile()), name, plot.dimension);
            }
        }
    }
}

//! Quantities drawn against measured depth.

use serde::Serialize;
use wholestring::outcome::{HOLE_WEAR, PROFILE, Quantity, WELL_PATH};

use super::{Shows, declared};

/// A quantity against measured depth.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct Track {
    /// Name of its file.
    #[serde(skip)]
    pub(crate) name: &'static str,
    #[serde(flatten)]
    pub(crate) shows: Shows,
    /// Columns of the 5th and the 95th percentile.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) band: Option<[&'static str; 2]>,
    /// Columns of the compressions at which the pipe buckles, to a sinusoid and to a helix.
    #[serde(skip)]
    pub(crate) buckles: Option<[&'static str; 2]>,
    pub(crate) from: Source,
    /// Minimum span of the axis, SI: smaller changes do not matter to an engineer.
    pub(crate) min_span: f64,
    /// Whether the axis includes zero.
    pub(crate) zero: bool,
    /// Whether its sign is a side of the hole.
    pub(crate) sides: bool,
    /// Whether it is a contact of joints, which the pipe between them does not have.
    pub(crate) touches: bool,
    /// Whether it alternates from joint to joint.
    pub(crate) swings: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) range: Option<[f64; 2]>,
}

/// The table that has the column of a track.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Source {
    Profile,
    Wear,
    Well,
}

impl Track {
    fn of(from: Source, quantity: &'static Quantity) -> Self {
        Self {
            name: "",
            shows: Shows::of(quantity),
            band: None,
            buckles: None,
            from,
            min_span: 0.0,
            zero: false,
            sides: false,
            touches: false,
            swings: false,
            range: None,
        }
    }

    fn titled(self, title: &str) -> Self {
        Self { shows: self.shows.titled(title), ..self }
    }
}

/// The names of two columns of the profile.
macro_rules! band {
    ($low:ident, $high:ident) => {
        Some([declared!(PROFILE, $low).name, declared!(PROFILE, $high).name])
    };
}

/// The tracks from left to right.
pub(crate) fn tracks() -> Vec<Track> {
    let profile = |quantity| Track::of(Source::Profile, quantity);
    let well = |quantity| Track::of(Source::Well, quantity);
    vec![
        Track {
            name: "tension",
            min_span: 2e4,
            band: band!(tension_p05_N, tension_p95_N),
            buckles: band!(sinusoidal_load_N, helical_load_N),
            zero: true,
            ..profile(declared!(PROFILE, tension_N))
        },
        Track {
            name: "torque",
            min_span: 500.0,
            band: band!(torque_p05_N_m, torque_p95_N_m),
            ..profile(declared!(PROFILE, torque_N_m))
        },
        Track {
            name: "side-force",
            min_span: 100.0,
            band: band!(side_force_p05_N_per_m, side_force_p95_N_per_m),
            zero: true,
            sides: true,
            ..profile(declared!(PROFILE, side_force_N_per_m))
        },
        Track {
            name: "contact",
            touches: true,
            range: Some([0.0, 1.04]),
            ..profile(declared!(PROFILE, contact_fraction)).titled("In contact")
        },
        Track {
            name: "bending-moment",
            min_span: 500.0,
            band: band!(bending_moment_p05_N_m, bending_moment_p95_N_m),
            swings: true,
            ..profile(declared!(PROFILE, bending_moment_N_m))
        },
        Track {
            name: "wear",
            min_span: 1e3,
            ..Track::of(Source::Wear, declared!(HOLE_WEAR, wear_work_J_per_m))
                .titled("Wear work, hole")
        },
        Track {
            name: "inclination",
            min_span: 0.035,
            zero: true,
            ..well(declared!(WELL_PATH, inclination_rad))
        },
        Track {
            name: "dogleg-severity",
            min_span: 6e-4,
            zero: true,
            ..well(declared!(WELL_PATH, dogleg_severity_rad_per_m))
        },
    ]
}

//! Why numbers make no bit.

use crate::named_numbers::named_numbers;

named_numbers! {
    /// Numbers that describe the face of a bit.
    FaceNumber {
        Diameter "diameter",
        CoreDiameter "core diameter",
        Nose "nose position",
        NoseRadius "nose radius",
        CoreNoseRadius "nose radius of a core bit",
        ShoulderRadius "shoulder radius",
        GaugeLength "gauge length",
        ConeAngle "cone angle",
        Blades "number of blades",
        CuttersPerBlade "cutters per blade",
        CuttersPerTrack "cutters per track",
        CutterDiameter "cutter diameter",
        CutterLength "cutter length",
        Chamfer "chamfer",
        BackRake "back rake",
        SideRake "side rake",
        GaugeRelief "gauge relief",
        Spiral "spiral of the blades",
        Exposure "exposure",
        BladeWidth "blade width",
        CentreSpacing "centre spacing",
        InsertDiameter "insert diameter",
        Protrusion "protrusion",
        Rows "rows of inserts",
        Pitch "pitch of the inserts",
        HalfAngle "half angle of the inserts",
        TipRadius "tip radius of the inserts",
    }
}

/// Why a bit cannot be built from its numbers. Cutters count from zero, from the axis outwards.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FaceError {
    /// A number that is not finite or outside its range.
    #[error("bit face: {number} is {value}, expected {expected}")]
    OutOfRange {
        /// Which of the numbers.
        number: FaceNumber,
        /// Its value, SI.
        value: f64,
        /// Expected range.
        expected: &'static str,
    },
    /// Arcs of these radii do not join the nose to the gauge.
    #[error(
        "bit face: a nose arc of {nose_radius_m} m and a shoulder arc of {shoulder_radius_m} m \
         cannot meet: \
         one must be no smaller, the other no larger than the {reach_m} m from nose to gauge"
    )]
    Profile {
        /// Radius of the nose's arc, m.
        nose_radius_m: f64,
        /// Radius of the shoulder's arc, m.
        shoulder_radius_m: f64,
        /// From the nose to the gauge, m.
        reach_m: f64,
    },
    /// The cutters of a track cannot be spread evenly over the blades.
    #[error(
        "bit face: {cutters_per_track} cutters on a track do not divide {blades} blades evenly"
    )]
    Unspread {
        /// Cutters that follow each other on a track.
        cutters_per_track: usize,
        /// Blades.
        blades: usize,
    },
    /// Two cutters of a blade, or two inserts of neighbouring rows, are in the same place.
    #[error(
        "bit face: cutters {first} and {second} of one blade overlap: {distance_m} m apart, \
         {diameter_m} m wide"
    )]
    Overlap {
        /// The inner one.
        first: usize,
        /// The outer one.
        second: usize,
        /// Between their centres, m.
        distance_m: f64,
        /// Diameter of a cutter, m.
        diameter_m: f64,
    },
    /// No cutter reaches this ring of the bottom: rock would remain there until the body rests on
    /// it.
    #[error("bit face: no cutter cuts the ring between the radii {from_m} and {to_m} m")]
    UncutRing {
        /// Beginning of the ring, m.
        from_m: f64,
        /// End of the ring, m.
        to_m: f64,
    },
}

/// `value`, if it is finite and within `range`.
pub(super) fn within(
    number: FaceNumber,
    value: f64,
    range: std::ops::RangeInclusive<f64>,
    expected: &'static str,
) -> Result<(), FaceError> {
    if range.contains(&value) && value.is_finite() {
        Ok(())
    } else {
        Err(FaceError::OutOfRange { number, value, expected })
    }
}

/// `value`, if it is finite and above zero.
pub(super) fn positive(number: FaceNumber, value: f64) -> Result<(), FaceError> {
    within(number, value, f64::MIN_POSITIVE..=f64::MAX, "above zero")
}

//! The columns of surveys, of readings and of tallies.

use std::fmt;

use wholestring_units::Dimension;

/// Column of a survey, of readings at the surface, or of a tally.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Column {
    /// Measured depth along the hole.
    MeasuredDepth,
    /// Inclination from vertical.
    Inclination,
    /// Azimuth from north, clockwise.
    Azimuth,
    /// True vertical depth; only the first station's is used.
    TrueVerticalDepth,
    /// Distance north; only the first station's is used.
    North,
    /// Distance east; only the first station's is used.
    East,
    /// Measured depth of the bit at the time of reading.
    BitDepth,
    /// Hook load while the string is pulled out.
    PickUp,
    /// Hook load while it is run in.
    SlackOff,
    /// Hook load while it turns off bottom.
    Rotating,
    /// Torque at surface off bottom.
    Torque,
    /// Torque at surface on bottom.
    TorqueOnBottom,
    /// Density of the mud at that time.
    MudDensity,
    /// The case to which the row belongs.
    Case,
    /// Whether a calibration uses the row.
    Use,
    /// Its number in the tally, or its position.
    Number,
    /// Kind of component.
    Component,
    /// Outside diameter of the body.
    OutsideDiameter,
    /// Inside diameter of the body.
    InsideDiameter,
    /// Diameter of the bit, or over the blades of a stabiliser.
    Gauge,
    /// Number of joints.
    Joints,
    /// Length of all of them.
    Length,
    /// Length of one joint.
    JointLength,
    /// Length from the first row on.
    CumulativeLength,
    /// Mass per length, tool joints included.
    Mass,
    /// Nominal weight in the name of a pipe, without tool joints.
    NominalMass,
    /// Mass of the whole component.
    TotalMass,
    /// Outside diameter of the tool joints.
    JointOutsideDiameter,
    /// Inside diameter of the tool joints.
    JointInsideDiameter,
    /// Name of the connections.
    Connection,
    /// Grade of the steel.
    Grade,
    /// Minimum yield strength of the steel.
    YieldStrength,
    /// Length of the blades of a stabiliser.
    BladeLength,
    /// Density of the metal.
    MetalDensity,
    /// Young's modulus of the metal.
    YoungsModulus,
    /// Shear modulus of the metal.
    ShearModulus,
}

impl Column {
    /// Every column of a survey, the required ones first.
    pub const ALL: [Column; 6] = [
        Column::MeasuredDepth,
        Column::Inclination,
        Column::Azimuth,
        Column::TrueVerticalDepth,
        Column::North,
        Column::East,
    ];

    /// The columns that a survey requires.
    pub const NEEDED: [Column; 3] = [Column::MeasuredDepth, Column::Inclination, Column::Azimuth];

    /// Every column of readings.
    pub const READINGS: [Column; 9] = [
        Column::BitDepth,
        Column::PickUp,
        Column::SlackOff,
        Column::Rotating,
        Column::Torque,
        Column::TorqueOnBottom,
        Column::MudDensity,
        Column::Case,
        Column::Use,
    ];

    /// Every column of a tally.
    pub const TALLY: [Column; 21] = [
        Column::Component,
        Column::OutsideDiameter,
        Column::Length,
        Column::JointLength,
        Column::InsideDiameter,
        Column::Gauge,
        Column::Joints,
        Column::CumulativeLength,
        Column::Mass,
        Column::NominalMass,
        Column::TotalMass,
        Column::JointOutsideDiameter,
        Column::JointInsideDiameter,
        Column::Connection,
        Column::Grade,
        Column::YieldStrength,
        Column::BladeLength,
        Column::MetalDensity,
        Column::YoungsModulus,
        Column::ShearModulus,
        Column::Number,
    ];

    /// Whether it contains words or counts, which have no unit.
    pub fn is_words(self) -> bool {
        matches!(
            self,
            Column::Case
                | Column::Use
                | Column::Number
                | Column::Component
                | Column::Joints
                | Column::Connection
                | Column::Grade
        )
    }

    /// Whether it is a column of readings.
    pub(crate) fn is_read(self) -> bool {
        Self::READINGS.contains(&self)
    }

    /// Dimension of its numbers.
    pub fn dimension(self) -> Dimension {
        match self {
            Column::Inclination | Column::Azimuth => Dimension::Angle,
            Column::PickUp | Column::SlackOff | Column::Rotating => Dimension::Force,
            Column::Torque | Column::TorqueOnBottom => Dimension::Torque,
            Column::MudDensity | Column::MetalDensity => Dimension::Density,
            Column::OutsideDiameter
            | Column::InsideDiameter
            | Column::Gauge
            | Column::JointOutsideDiameter
            | Column::JointInsideDiameter => Dimension::Diameter,
            Column::Mass | Column::NominalMass => Dimension::MassPerLength,
            Column::TotalMass => Dimension::Mass,
            Column::YieldStrength | Column::YoungsModulus | Column::ShearModulus => {
                Dimension::Stress
            }
            _ => Dimension::Length,
        }
    }

    /// A recognised heading, for advice.
    pub fn example(self) -> &'static str {
        match self {
            Column::MeasuredDepth => "MD (m)",
            Column::Inclination => "Inc (deg)",
            Column::Azimuth => "Azi (deg)",
            Column::TrueVerticalDepth => "TVD (m)",
            Column::North => "North (m)",
            Column::East => "East (m)",
            Column::BitDepth => "Bit depth (m)",
            Column::PickUp => "Pick-up (kN)",
            Column::SlackOff => "Slack-off (kN)",
            Column::Rotating => "Rotating (kN)",
            Column::Torque => "Torque (kN.m)",
            Column::TorqueOnBottom => "Torque on bottom (kN.m)",
            Column::MudDensity => "Mud (sg)",
            Column::Case => "Case",
            Column::Use => "Use",
            Column::Number => "No.",
            Column::Component => "Component",
            Column::OutsideDiameter => "OD (in)",
            Column::InsideDiameter => "ID (in)",
            Column::Gauge => "Gauge OD (in)",
            Column::Joints => "Joints",
            Column::Length => "Length (ft)",
            Column::JointLength => "Joint length (ft)",
            Column::CumulativeLength => "Cum. length (ft)",
            Column::Mass => "Weight (lb/ft)",
            Column::NominalMass => "Nominal weight (lb/ft)",
            Column::TotalMass => "Total weight (lb)",
            Column::JointOutsideDiameter => "Tool joint OD (in)",
            Column::JointInsideDiameter => "Tool joint ID (in)",
            Column::Connection => "Connection",
            Column::Grade => "Grade",
            Column::YieldStrength => "Yield strength (psi)",
            Column::BladeLength => "Blade length (ft)",
            Column::MetalDensity => "Metal density (kg/m3)",
            Column::YoungsModulus => "Young's modulus (GPa)",
            Column::ShearModulus => "Shear modulus (GPa)",
        }
    }
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Column::MeasuredDepth => "measured depth",
            Column::Inclination => "inclination",
            Column::Azimuth => "azimuth",
            Column::TrueVerticalDepth => "true vertical depth",
            Column::North => "north",
            Column::East => "east",
            Column::BitDepth => "bit depth",
            Column::PickUp => "pick-up weight",
            Column::SlackOff => "slack-off weight",
            Column::Rotating => "rotating weight",
            Column::Torque => "torque off bottom",
            Column::TorqueOnBottom => "torque on bottom",
            Column::MudDensity => "mud density",
            Column::Case => "case",
            Column::Use => "use",
            Column::Number => "number",
            Column::Component => "component",
            Column::OutsideDiameter => "outside diameter",
            Column::InsideDiameter => "inside diameter",
            Column::Gauge => "gauge",
            Column::Joints => "number of joints",
            Column::Length => "length",
            Column::JointLength => "length of a joint",
            Column::CumulativeLength => "cumulative length",
            Column::Mass => "weight per length",
            Column::NominalMass => "nominal weight",
            Column::TotalMass => "total weight",
            Column::JointOutsideDiameter => "outside diameter of the tool joints",
            Column::JointInsideDiameter => "inside diameter of the tool joints",
            Column::Connection => "connection",
            Column::Grade => "grade",
            Column::YieldStrength => "yield strength",
            Column::BladeLength => "length of the blades",
            Column::MetalDensity => "density of the metal",
            Column::YoungsModulus => "Young's modulus",
            Column::ShearModulus => "shear modulus",
        })
    }
}

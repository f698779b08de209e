//! The columns of surveys and of readings.

use std::fmt;

use wholestring_units::Dimension;

/// What a column of a survey, or of readings at the surface, holds.
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
    /// Measured depth of the bit while something is read.
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
    /// Density of the mud then.
    MudDensity,
    /// Which case it belongs to.
    Case,
    /// Whether something is to be found from it.
    Use,
}

impl Column {
    /// Every column of a survey, those that it cannot do without first.
    pub const ALL: [Column; 6] = [
        Column::MeasuredDepth,
        Column::Inclination,
        Column::Azimuth,
        Column::TrueVerticalDepth,
        Column::North,
        Column::East,
    ];

    /// The columns that a survey cannot do without.
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

    /// Whether it holds words and no numbers.
    pub fn is_words(self) -> bool {
        matches!(self, Column::Case | Column::Use)
    }

    /// Whether it is of readings.
    pub(crate) fn is_read(self) -> bool {
        Self::READINGS.contains(&self)
    }

    /// What its numbers measure.
    pub fn dimension(self) -> Dimension {
        match self {
            Column::Inclination | Column::Azimuth => Dimension::Angle,
            Column::PickUp | Column::SlackOff | Column::Rotating => Dimension::Force,
            Column::Torque | Column::TorqueOnBottom => Dimension::Torque,
            Column::MudDensity => Dimension::Density,
            _ => Dimension::Length,
        }
    }

    /// A heading that is understood, for advice.
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
        })
    }
}

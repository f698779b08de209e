//! The columns of a survey.

use std::fmt;

use wholestring_units::Dimension;

/// What a column of a survey holds.
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
}

impl Column {
    /// Every column, those that a survey cannot do without first.
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

    /// What its numbers measure.
    pub fn dimension(self) -> Dimension {
        match self {
            Column::Inclination | Column::Azimuth => Dimension::Angle,
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
        })
    }
}

//! Curves of the cases.

use crate::{
    abscissa::Abscissa,
    chosen::Chosen,
    column::{Quantity, Statistic},
};

/// Direction of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pointing {
    /// To the right.
    Across,
    /// Down the page.
    Down,
}

/// Curves to draw.
#[derive(Debug, Clone)]
pub struct Figure {
    /// Name of its files.
    pub name: String,
    /// Its title.
    pub title: String,
    /// Text below it; may be empty.
    pub caption: String,
    /// The cases whose results it shows.
    pub chosen: Chosen,
    /// Its data.
    pub data: FigureData,
    /// Direction of the axis of `x`.
    pub x_axis: Pointing,
    /// The vertical axis.
    pub y: Vec<Quantity>,
    /// Values to compare the curves with.
    pub levels: Vec<Level>,
}

/// Source of the curves of a figure.
#[derive(Debug, Clone)]
pub enum FigureData {
    /// A point for each case.
    Summary {
        /// The key on the horizontal axis.
        x: Abscissa,
        /// The statistics.
        statistics: Vec<Statistic>,
    },
    /// Rows of a table, or of the path.
    Rows {
        /// The column on the horizontal axis.
        x: Quantity,
        /// First and last time, s.
        window_s: Option<[f64; 2]>,
    },
    /// Frames at these times, s.
    Times {
        /// The column on the horizontal axis.
        x: Quantity,
        /// The times.
        times_s: Vec<f64>,
    },
    /// Contact over time and depth, a map for each case.
    Map {
        /// The quantity of the colours.
        colour: Quantity,
        /// First and last time, s.
        window_s: Option<[f64; 2]>,
    },
    /// Nodes at these measured depths, m, against time.
    Depths {
        /// The column on the horizontal axis.
        x: Quantity,
        /// The depths.
        depths_m: Vec<f64>,
        /// First and last time, s.
        window_s: Option<[f64; 2]>,
    },
}

impl Figure {
    /// The columns of the figure.
    pub(crate) fn quantities(&self) -> impl Iterator<Item = &Quantity> {
        let other = match &self.data {
            FigureData::Summary { .. } => None,
            FigureData::Rows { x, .. }
            | FigureData::Times { x, .. }
            | FigureData::Depths { x, .. } => Some(x),
            FigureData::Map { colour, .. } => Some(colour),
        };
        self.y.iter().chain(other)
    }
}

/// A value for comparison with the curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// Its label.
    pub label: String,
    /// The value, SI.
    pub value: f64,
}

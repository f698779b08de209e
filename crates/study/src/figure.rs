//! Curves to draw of the cases.

use crate::{
    abscissa::Abscissa,
    chosen::Chosen,
    column::{Quantity, Statistic},
};

/// Where an axis points.
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
    /// What stands over it.
    pub title: String,
    /// What stands under it; may be empty.
    pub caption: String,
    /// Whose results it shows.
    pub chosen: Chosen,
    /// What is drawn.
    pub data: FigureData,
    /// Where the axis of `x` points.
    pub x_axis: Pointing,
    /// The vertical axis.
    pub y: Vec<Quantity>,
    /// Values to compare the curves with.
    pub levels: Vec<Level>,
}

/// Where the curves of a figure come from.
#[derive(Debug, Clone)]
pub enum FigureData {
    /// A point for each case.
    Summary {
        /// The key on the horizontal axis.
        x: Abscissa,
        /// What is shown.
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
        /// What colours it.
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
    /// The columns that it is made of.
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

/// A value to hold curves against.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// What it is.
    pub label: String,
    /// The value, SI.
    pub value: f64,
}

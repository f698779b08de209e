//! Numbers of the cases, compared with given ones.

use wholestring::outcome::ModelKind;
use wholestring_units::Dimension;

use crate::{
    chosen::Chosen,
    column::{Quantity, Statistic},
    selection::Selection,
};

/// Shape of numbers along a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// Share of their variance that a straight line explains.
    Linearity,
    /// Share of the increasing steps.
    Growth,
    /// The smallest.
    Least,
    /// The largest.
    Most,
}

/// Numbers compared with given ones.
#[derive(Debug, Clone)]
pub struct NumberTable {
    /// Name of its files.
    pub name: String,
    /// Its title.
    pub title: String,
    /// Text below it; may be empty.
    pub caption: String,
    /// Its rows.
    pub rows: Vec<Row>,
}

/// One number of the cases, compared with a given one.
#[derive(Debug, Clone)]
pub struct Row {
    /// Its label.
    pub label: String,
    /// Source of the given number; may be empty.
    pub source: String,
    /// The cases of the number.
    pub chosen: Chosen,
    /// The number.
    pub number: Number,
    /// Subtracts the same number of the case with these values.
    pub less: Option<Selection>,
    /// Divides by the same number of the case with these values.
    pub over: Option<Selection>,
    /// Divides by the same number of this model.
    pub over_model: Option<ModelKind>,
    /// Reports the shape of the numbers along a key.
    pub along: Option<(String, Shape)>,
    /// The accepted values.
    pub wanted: Wanted,
}

/// Definition of a number.
#[derive(Debug, Clone, PartialEq)]
pub struct Number {
    /// The column.
    pub quantity: Quantity,
    /// The statistic of its values.
    pub statistic: Statistic,
    /// At this measured depth, m.
    pub depth_m: Option<f64>,
    /// At this time, s.
    pub time_s: Option<f64>,
    /// First and last time, s.
    pub window_s: Option<[f64; 2]>,
}

/// The accepted values of a number, SI.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wanted {
    /// The given number.
    pub expected: Option<f64>,
    /// The smallest accepted number.
    pub least: Option<f64>,
    /// The largest accepted number.
    pub most: Option<f64>,
}

impl Row {
    /// Dimension of the number; none for a bare one.
    pub fn dimension(&self) -> Option<Dimension> {
        let bare = matches!(self.along, Some((_, Shape::Linearity | Shape::Growth)));
        self.number
            .quantity
            .column
            .dimension
            .filter(|_| !bare && self.over.is_none() && self.over_model.is_none())
    }
}

//! Numbers of the cases, compared with given ones.

use wholestring::outcome::ModelKind;
use wholestring_units::Dimension;

use crate::{
    chosen::Chosen,
    column::{Quantity, Statistic},
    selection::Selection,
};

/// What is reported of numbers along a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// Share of their variance that a straight line explains.
    Linearity,
    /// Share of the steps that go up.
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
    /// What stands over it.
    pub title: String,
    /// What stands under it; may be empty.
    pub caption: String,
    /// Its rows.
    pub rows: Vec<Row>,
}

/// One number of the cases, compared with a given one.
#[derive(Debug, Clone)]
pub struct Row {
    /// What it is.
    pub label: String,
    /// Where the given number comes from; may be empty.
    pub source: String,
    /// Whose results it is about.
    pub chosen: Chosen,
    /// What it is made of.
    pub number: Number,
    /// Subtract the same of the case with these values.
    pub less: Option<Selection>,
    /// Divide by the same of the case with these values.
    pub over: Option<Selection>,
    /// Divide by the same of this model.
    pub over_model: Option<ModelKind>,
    /// Report the shape of the numbers along a key.
    pub along: Option<(String, Shape)>,
    /// What it is compared with.
    pub wanted: Wanted,
}

/// What a number is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Number {
    /// The column.
    pub quantity: Quantity,
    /// What is made of its values.
    pub statistic: Statistic,
    /// At this measured depth, m.
    pub depth_m: Option<f64>,
    /// At this time, s.
    pub time_s: Option<f64>,
    /// First and last time, s.
    pub window_s: Option<[f64; 2]>,
}

/// What a number is compared with, SI.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wanted {
    /// The number that is given.
    pub expected: Option<f64>,
    /// The smallest number that agrees.
    pub least: Option<f64>,
    /// The largest number that agrees.
    pub most: Option<f64>,
}

impl Row {
    /// What the number measures; none for a bare one.
    pub fn dimension(&self) -> Option<Dimension> {
        let bare = matches!(self.along, Some((_, Shape::Linearity | Shape::Growth)));
        self.number
            .quantity
            .column
            .dimension
            .filter(|_| !bare && self.over.is_none() && self.over_model.is_none())
    }
}

//! A figure: panels that share one axis, with curves, bands and maps.

mod beyond;
mod found;
mod layout;
mod legend;
mod marks;
mod names;
mod outliers;
mod panel;
mod place;
mod ruler;

use crate::Severity;
pub use crate::draw::{Hue, Ink};
pub(crate) use marks::{BAND, CURVE};
pub(crate) use outliers::{OUTLIERS, Outliers};

/// A figure: panels in a line, or one below the other, that share one axis.
///
/// Everything is in the reader's units already; labels contain them.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Title, such as the case's name; may be empty.
    pub title: String,
    /// Subtitle, such as friction and mud; may be empty.
    pub subtitle: String,
    /// Entries of the legend.
    pub keys: Vec<Key>,
    /// Layout of the panels.
    pub layout: Layout,
    /// The axis that all panels share.
    pub shared: Axis,
    /// The panels, line by line.
    pub panels: Vec<Panel>,
    /// The hole next to the panels, from the surface down; for a shared axis of depth that points
    /// down.
    pub hole: Vec<Interval>,
}

/// Arrangement and size of the panels of a figure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layout {
    /// Direction of the shared axis.
    pub direction: Direction,
    /// Panels in a line; where there are more, another line follows.
    pub columns: usize,
    /// Width of the figure, mm.
    pub width_mm: f64,
    /// Height of a panel's frame, mm; for a plan the largest.
    pub panel_mm: f64,
}

impl Layout {
    /// Panels over a shared axis that points across the page.
    pub const fn across(columns: usize, width_mm: f64, panel_mm: f64) -> Self {
        Self { direction: Direction::Across, columns, width_mm, panel_mm }
    }
}

/// Direction of the axis that panels share.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Down the page: depth.
    Down,
    /// Across the page: time, or anything else.
    Across,
    /// Across the page, with both axes to the same scale: a plan view, or a vertical section.
    /// Frames are as wide or as high as the page allows.
    Plan,
}

/// An axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Its quantity, unit included.
    pub label: String,
    /// Placement of the values.
    pub scale: Scale,
    /// Its ends.
    pub range: Range,
    /// Names of the sides before and after zero, where the sign means a side.
    pub sides: Option<[String; 2]>,
    /// Whether it grows down the page; an axis across the page never does.
    pub down: bool,
    /// Whether it leaves out single values far from all others, so that they do not flatten these.
    /// Values beyond its ends are marked there, with the largest value in numbers. For a panel's
    /// own axis only.
    pub clips: bool,
    /// Smallest span, so that an almost constant quantity is not magnified; zero without such a
    /// bound.
    pub min_span: f64,
}

impl Axis {
    /// A linear axis that grows to the right or up.
    pub fn new(label: impl Into<String>, range: Range) -> Self {
        Self {
            label: label.into(),
            scale: Scale::Linear,
            range,
            sides: None,
            down: false,
            clips: false,
            min_span: 0.0,
        }
    }
}

/// Placement of values on an axis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithm; a value that is not above zero has no place.
    Logarithmic,
    /// By words: 0 is the first, 1 the second.
    Words(Vec<String>),
}

/// Ends of an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range {
    /// From the smallest value to the largest.
    Tight,
    /// A little further, and to zero where the values are near it.
    Near,
    /// A little further, and to zero.
    Zero,
    /// Between these ends.
    Fixed(f64, f64),
}

/// A frame with an axis of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Its own axis.
    pub axis: Axis,
    /// Its marks, in the order of drawing.
    pub marks: Vec<Mark>,
    /// Entries of its own legend, where colours and strokes are not the same in all panels.
    pub keys: Vec<Key>,
}

impl Panel {
    /// A panel without a legend of its own.
    pub fn new(axis: Axis, marks: Vec<Mark>) -> Self {
        Self { axis, marks, keys: Vec::new() }
    }
}

/// A mark of a panel. Points are a value of the shared axis and one of the panel's own.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A curve; it breaks where a point is not finite.
    Curve {
        /// Its colour.
        ink: Ink,
        /// Its stroke.
        stroke: Stroke,
        /// Its points.
        points: Vec<(f64, f64)>,
    },
    /// The area between two values.
    Band {
        /// Its colour.
        ink: Ink,
        /// Shared value, and the two of the panel's own.
        points: Vec<(f64, f64, f64)>,
    },
    /// The area between a curve and zero, one colour a side.
    Sides {
        /// The curve.
        points: Vec<(f64, f64)>,
    },
    /// Single points.
    Points {
        /// Their colour.
        ink: Ink,
        /// Their shape.
        shape: Shape,
        /// Their places.
        points: Vec<(f64, f64)>,
    },
    /// Spread of points: from one end to the other.
    Bars {
        /// Their colour.
        ink: Ink,
        /// Ends, along either axis.
        bars: Vec<[(f64, f64); 2]>,
    },
    /// A line across the panel at a value of the shared axis.
    SharedRule {
        /// The value.
        at: f64,
        /// Its label; may be empty.
        label: String,
    },
    /// A line along the panel at one of its own values.
    OwnRule {
        /// The value.
        at: f64,
        /// Its label; may be empty.
        label: String,
    },
    /// A stretch of the shared axis that is shaded.
    Shade {
        /// Its first end.
        from: f64,
        /// Its other end.
        to: f64,
    },
    /// A stretch of the shared axis with a finding, or a single place of it where both ends are
    /// one.
    Found {
        /// Severity of the finding.
        level: Severity,
        /// Its first end.
        from: f64,
        /// Its other end.
        to: f64,
    },
    /// Rings about points with a finding.
    Rings {
        /// Severity of the finding.
        level: Severity,
        /// The points.
        points: Vec<(f64, f64)>,
    },
    /// A map in colours.
    Map(Map),
    /// The following marks, up to the next of these, belong to these keys of the figure's legend: a
    /// page hides them together.
    Of {
        /// Places of the keys in [`Figure::keys`].
        keys: Vec<usize>,
    },
    /// The name of a point, next to it.
    Name {
        /// The point.
        at: (f64, f64),
        /// The name.
        text: String,
    },
    /// The name of a curve, at its end: names of curves that end together are in the order of the
    /// ends.
    Foot {
        /// The end.
        at: (f64, f64),
        /// The name.
        text: String,
    },
    /// Points for which a page shows the rows of its table.
    Spots {
        /// Their places.
        points: Vec<(f64, f64)>,
        /// The rows.
        rows: Vec<usize>,
    },
}

/// Values over the shared axis and a panel's own, as colours.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    /// Beginning of the first stretch of the shared axis.
    pub from: f64,
    /// End of each stretch.
    pub ends: Vec<f64>,
    /// The middles of the stretches of the panel's own axis.
    pub middles: Vec<f64>,
    /// A value for each of `middles`, then again for the next of `ends`; one that is not finite has
    /// no colour.
    pub values: Vec<f64>,
    /// Meaning of the colours.
    pub hue: Hue,
    /// The value of the last colour; for sides, the first colour has its negative.
    pub largest: f64,
    /// Label of the colours, unit included.
    pub label: String,
    /// Names of the first and the last colour's side.
    pub sides: Option<[String; 2]>,
}

/// An entry of a legend.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Key {
    /// Its name.
    pub name: String,
    /// Its sample.
    pub sample: Sample,
}

/// Sample of a legend's entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sample {
    /// Curves.
    Line(Ink, Stroke),
    /// A band around a curve.
    Band(Ink),
    /// An area.
    Area(Ink),
    /// Single points.
    Point(Ink, Shape),
    /// Curves with points.
    Marked(Ink, Stroke, Shape),
    /// Spread of points.
    Spread(Ink),
    /// Stretches with a finding.
    Found(Severity),
    /// Rings about points with a finding.
    Ring(Severity),
    /// Words alone.
    Words,
}

/// Stroke of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// A full line.
    Solid,
    /// A dashed line.
    Dashed,
    /// A dotted line.
    Dotted,
    /// A line of long dashes.
    LongDashed,
    /// A line of short dashes.
    ShortDashed,
    /// A line of dashes far apart.
    WideDashed,
    /// A line of dots far apart.
    WideDotted,
}

impl Stroke {
    /// The stroke of a curve by its place, where its colour depends on that too: seven can be
    /// distinguished.
    pub fn of(place: usize) -> Self {
        const ALL: [Stroke; 7] = [
            Stroke::Solid,
            Stroke::Dashed,
            Stroke::Dotted,
            Stroke::LongDashed,
            Stroke::ShortDashed,
            Stroke::WideDashed,
            Stroke::WideDotted,
        ];
        ALL[place % ALL.len()]
    }

    /// Lengths of dash and gap, points; `None` for a full line.
    pub(crate) const fn dash(self) -> Option<[f64; 2]> {
        match self {
            Self::Solid => None,
            Self::Dashed => Some([4.0, 2.2]),
            Self::Dotted => Some([1.1, 1.5]),
            Self::LongDashed => Some([9.0, 2.2]),
            Self::ShortDashed => Some([2.2, 1.2]),
            Self::WideDashed => Some([4.5, 4.5]),
            Self::WideDotted => Some([1.1, 3.2]),
        }
    }
}

/// The shape of single points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A circle.
    Circle,
    /// A square.
    Square,
    /// A triangle on its base.
    Triangle,
    /// A square on its corner.
    Diamond,
    /// A triangle on its tip.
    Tip,
}

impl Shape {
    /// The shape of the series of this place; they repeat.
    pub fn of(place: usize) -> Self {
        const ALL: [Shape; 5] =
            [Shape::Circle, Shape::Square, Shape::Triangle, Shape::Diamond, Shape::Tip];
        ALL[place % ALL.len()]
    }
}

/// A stretch of hole.
#[derive(Debug, Clone, PartialEq)]
pub struct Interval {
    /// Depth of its upper end.
    pub from: f64,
    /// Depth of its lower end.
    pub to: f64,
    /// Whether its wall is casing rather than rock.
    pub cased: bool,
    /// Whether the shoe of the casing is at its lower end.
    pub shoe: bool,
    /// Its name: `casing, 222.96 mm`.
    pub label: String,
}

#[cfg(test)]
mod tests;

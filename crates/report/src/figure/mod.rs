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
mod scale;

use crate::Severity;
pub use crate::draw::{Hue, Ink};
pub(crate) use marks::{BAND, CURVE};
pub(crate) use outliers::{OUTLIERS, Outliers};

/// A figure: panels side by side, or one below the other, that share one axis.
///
/// Everything is in the reader's units already; labels name them.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Title, such as the case's name; may be empty.
    pub title: String,
    /// What stands under it, such as friction and mud; may be empty.
    pub subtitle: String,
    /// What colours, strokes and shapes mean.
    pub keys: Vec<Key>,
    /// Where the panels stand.
    pub layout: Layout,
    /// The axis that all panels share.
    pub shared: Axis,
    /// The panels, line by line.
    pub panels: Vec<Panel>,
    /// The hole beside the panels, from the surface down; for a shared axis of depth that points
    /// down.
    pub hole: Vec<Interval>,
}

/// Where the panels of a figure stand, and how large they are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layout {
    /// Which way the shared axis points.
    pub direction: Direction,
    /// Panels in a line; where there are more, another line follows.
    pub columns: usize,
    /// Width of the figure, mm.
    pub width_mm: f64,
    /// Height of a panel's frame, mm; of a plan the most that it may be.
    pub panel_mm: f64,
}

impl Layout {
    /// Panels over a shared axis that points across the page.
    pub const fn across(columns: usize, width_mm: f64, panel_mm: f64) -> Self {
        Self { direction: Direction::Across, columns, width_mm, panel_mm }
    }
}

/// Which way the axis that panels share points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Down the page: depth.
    Down,
    /// Across the page: time, or anything else.
    Across,
    /// Across the page, with both axes to the same scale: a plan view, or a vertical section.
    /// Frames are as wide or as high as there is room.
    Plan,
}

/// An axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// What it shows, unit included.
    pub label: String,
    /// How values are placed.
    pub scale: Scale,
    /// How far it reaches.
    pub range: Range,
    /// What lies on either side of zero, before and after it, where the sign means a side.
    pub sides: Option<[String; 2]>,
    /// Whether it grows down the page; an axis across the page never does.
    pub down: bool,
    /// Whether it leaves out single values far from all others, so that they do not flatten these.
    /// What lies beyond its ends is marked there, with the largest value in numbers. Of a panel's
    /// own axis alone.
    pub clips: bool,
    /// The least that it spans, so that what hardly moves is not blown up; zero where there is no
    /// such bound.
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

/// How an axis places values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithm; what is not above zero has no place.
    Logarithmic,
    /// By words: 0 is the first, 1 the second.
    Words(Vec<String>),
}

/// How far an axis reaches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range {
    /// From the smallest value to the largest.
    Tight,
    /// A little further, and to zero where the values come near it.
    Near,
    /// A little further, and to zero.
    Zero,
    /// From here to there.
    Fixed(f64, f64),
}

/// A frame with an axis of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Its own axis.
    pub axis: Axis,
    /// What is drawn in it, in this order.
    pub marks: Vec<Mark>,
    /// What its colours and strokes mean, where that is not the same in all panels.
    pub keys: Vec<Key>,
}

impl Panel {
    /// A panel without a legend of its own.
    pub fn new(axis: Axis, marks: Vec<Mark>) -> Self {
        Self { axis, marks, keys: Vec::new() }
    }
}

/// What is drawn in a panel. Points are a value of the shared axis and one of the panel's own.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A curve; it breaks where a point is not finite.
    Curve {
        /// Its colour.
        ink: Ink,
        /// How it is drawn.
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
        /// Where they are.
        points: Vec<(f64, f64)>,
    },
    /// How far points spread: from one end to the other.
    Bars {
        /// Their colour.
        ink: Ink,
        /// Ends, along either axis.
        bars: Vec<[(f64, f64); 2]>,
    },
    /// A line across the panel at a value of the shared axis.
    SharedRule {
        /// Where.
        at: f64,
        /// What it is; may be empty.
        label: String,
    },
    /// A line along the panel at one of its own values.
    OwnRule {
        /// Where.
        at: f64,
        /// What it is; may be empty.
        label: String,
    },
    /// A stretch of the shared axis that is set apart.
    Shade {
        /// Where it begins.
        from: f64,
        /// Where it ends.
        to: f64,
    },
    /// A stretch of the shared axis where something was found, or a place of it where both ends are
    /// one.
    Found {
        /// How grave it is.
        level: Severity,
        /// Where it begins.
        from: f64,
        /// Where it ends.
        to: f64,
    },
    /// Rings about points of which something was found.
    Rings {
        /// How grave it is.
        level: Severity,
        /// The points.
        points: Vec<(f64, f64)>,
    },
    /// A map in colours.
    Map(Map),
    /// What follows, up to the next of these, is what these keys of the figure's legend say: a page
    /// hides it with them.
    Of {
        /// Places of the keys in [`Figure::keys`].
        keys: Vec<usize>,
    },
    /// The name of a point, beside it.
    Name {
        /// The point.
        at: (f64, f64),
        /// The name.
        text: String,
    },
    /// The name of a curve, at its end: names of curves that end together are in the order of the ends.
    Foot {
        /// The end.
        at: (f64, f64),
        /// The name.
        text: String,
    },
    /// Points at which a page says which rows of its table they show.
    Spots {
        /// Where they are.
        points: Vec<(f64, f64)>,
        /// The rows.
        rows: Vec<usize>,
    },
}

/// Values over the shared axis and a panel's own, as colours.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    /// Where the first stretch of the shared axis begins.
    pub from: f64,
    /// Where each ends.
    pub ends: Vec<f64>,
    /// The middles of the stretches of the panel's own axis.
    pub middles: Vec<f64>,
    /// A value for each of `middles`, then again for the next of `ends`; one that is not finite has
    /// no colour.
    pub values: Vec<f64>,
    /// What the colours mean.
    pub hue: Hue,
    /// The value of the last colour; of sides, the negative of it is the first's.
    pub largest: f64,
    /// Label of the colours, unit included.
    pub label: String,
    /// Names of the first and the last colour's side.
    pub sides: Option<[String; 2]>,
}

/// An entry of a legend.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Key {
    /// What it says.
    pub name: String,
    /// What it is about.
    pub sample: Sample,
}

/// What an entry of a legend is about.
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
    /// How far points spread.
    Spread(Ink),
    /// Stretches where something was found.
    Found(Severity),
    /// Rings about points of which something was found.
    Ring(Severity),
    /// Words alone.
    Words,
}

/// How a curve is drawn.
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
    /// The stroke of a curve by its place, where its colour goes by that too: seven can be
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

    /// Lengths of dash and gap, points; none of a full line.
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
    /// The shape of the series of this place; they come round again.
    pub fn of(place: usize) -> Self {
        const ALL: [Shape; 5] =
            [Shape::Circle, Shape::Square, Shape::Triangle, Shape::Diamond, Shape::Tip];
        ALL[place % ALL.len()]
    }
}

/// A stretch of hole.
#[derive(Debug, Clone, PartialEq)]
pub struct Interval {
    /// Depth where it begins.
    pub from: f64,
    /// Depth where it ends.
    pub to: f64,
    /// Whether its wall is casing rather than rock.
    pub cased: bool,
    /// Whether the shoe of the casing stands at its lower end.
    pub shoe: bool,
    /// What it is: `casing, 222.96 mm`.
    pub label: String,
}

#[cfg(test)]
mod tests;

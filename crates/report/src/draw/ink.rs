//! Inks and scales of colours.

use super::palette::{LINES, on_paper};

/// Ink of a mark. A file has the colours of paper; a page may assign its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ink {
    /// A curve by its place; seven can be distinguished, and after the last the first follows
    /// again.
    Line(usize),
    /// Text.
    Text,
    /// Text and lines of less weight.
    Note,
    /// Frames.
    Frame,
    /// Lines of the grid.
    Grid,
    /// Time before the window of the statistics.
    Settling,
    /// Casing.
    Casing,
    /// Rock.
    Rock,
    /// The high side of the hole.
    HighSide,
    /// The low side.
    LowSide,
    /// Errors.
    Error,
    /// Warnings.
    Warning,
    /// The ground.
    Paper,
}

impl Ink {
    /// Lines whose colours differ.
    pub(crate) const LINES: usize = LINES;

    /// Its colour on paper.
    pub(crate) fn rgb(self) -> [u8; 3] {
        on_paper(self.name())
    }

    /// Its name among the page's colours.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Line(index) => {
                ["line-0", "line-1", "line-2", "line-3", "line-4", "line-5", "line-6"]
                    [index % LINES]
            }
            Self::Text => "text",
            Self::Note => "muted",
            Self::Frame => "frame",
            Self::Grid => "grid",
            Self::Settling => "settling",
            Self::Casing => "casing",
            Self::Rock => "rock",
            Self::HighSide => "high-side",
            Self::LowSide => "low-side",
            Self::Error => "over",
            Self::Warning => "near",
            Self::Paper => "paper",
        }
    }
}

/// Quantity shown by a scale of colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hue {
    /// An amount, from small to large.
    Amount,
    /// A depth, from shallow to deep, which is dark.
    Depth,
    /// A side, from the low side over zero to the high side.
    Side,
}

/// A scale of colours.
pub(crate) struct ColourScale {
    stops: Vec<[u8; 3]>,
    backwards: bool,
}

impl ColourScale {
    pub(crate) fn new(hue: Hue) -> Self {
        let stops = match hue {
            Hue::Amount | Hue::Depth => {
                (0..=9).map(|place| on_paper(&format!("amount-{place}"))).collect()
            }
            Hue::Side => ["low-side-strong", "low-side", "middle", "high-side", "high-side-strong"]
                .map(on_paper)
                .to_vec(),
        };
        Self { stops, backwards: hue == Hue::Depth }
    }

    /// The colour of a part from 0 to 1.
    pub(crate) fn at(&self, part: f64) -> [u8; 3] {
        let part = if self.backwards { 1.0 - part } else { part };
        let place = part.clamp(0.0, 1.0) * (self.stops.len() - 1) as f64;
        let low = (place as usize).min(self.stops.len() - 2);
        let rest = place - low as f64;
        std::array::from_fn(|i| {
            let (from, to) = (f64::from(self.stops[low][i]), f64::from(self.stops[low + 1][i]));
            (from + rest * (to - from)).round() as u8
        })
    }
}

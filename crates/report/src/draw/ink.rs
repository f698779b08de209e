//! Colours that the colour-blind tell apart.

/// What something is drawn with. A file has the colours of paper; a page may give each its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ink {
    /// A curve by its place; seven can be told apart, and after the last comes the first.
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
    /// The ground.
    Paper,
}

/// The palette of Okabe and Ito (*Color Universal Design*, 2008) without its yellow, the fainter ones darkened until a
/// thin line on white shows them; the strongest first.
const LINES: [[u8; 3]; 7] = [
    [0, 114, 178],
    [213, 94, 0],
    [0, 158, 115],
    [184, 92, 147],
    [184, 125, 0],
    [63, 159, 216],
    [68, 68, 68],
];

impl Ink {
    /// Its colour on paper.
    pub(crate) fn rgb(self) -> [u8; 3] {
        match self {
            Self::Line(index) => LINES[index % LINES.len()],
            Self::Text => [29, 34, 38],
            Self::Note => [89, 99, 107],
            Self::Frame => [90, 98, 105],
            Self::Grid => [227, 230, 233],
            Self::Settling => [240, 242, 244],
            Self::Casing => [111, 122, 131],
            Self::Rock => [222, 208, 184],
            Self::HighSide => [240, 176, 80],
            Self::LowSide => [79, 191, 160],
            Self::Paper => [255, 255, 255],
        }
    }

    /// Its name among the page's colours.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Line(index) => [
                "line-0", "line-1", "line-2", "line-3", "line-4", "line-5", "line-6",
            ][index % LINES.len()],
            Self::Text => "text",
            Self::Note => "muted",
            Self::Frame => "frame",
            Self::Grid => "grid",
            Self::Settling => "settling",
            Self::Casing => "casing",
            Self::Rock => "rock",
            Self::HighSide => "high-side",
            Self::LowSide => "low-side",
            Self::Paper => "paper",
        }
    }
}

/// What a scale of colours tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hue {
    /// From little to much.
    Amount,
    /// From the shallow to the deep, which is dark.
    Depth,
    /// From the low side over nothing to the high side.
    Side,
}

/// A scale of colours.
pub(crate) struct ColourScale {
    stops: &'static [[u8; 3]],
    backwards: bool,
}

impl ColourScale {
    pub(crate) fn new(hue: Hue) -> Self {
        let stops: &[[u8; 3]] = match hue {
            // Cividis (Nuñez, Anderton and Renslow 2018), by a few of its colours: even in lightness to every
            // kind of eye.
            Hue::Amount | Hue::Depth => &[
                [0, 34, 78],
                [18, 53, 112],
                [59, 73, 108],
                [87, 93, 109],
                [112, 113, 115],
                [138, 134, 120],
                [165, 156, 116],
                [195, 179, 105],
                [225, 204, 85],
                [254, 232, 56],
            ],
            Hue::Side => &[
                [0, 97, 74],
                [79, 191, 160],
                [247, 247, 247],
                [240, 176, 80],
                [166, 94, 0],
            ],
        };
        Self {
            stops,
            backwards: hue == Hue::Depth,
        }
    }

    /// The colour of a part from 0 to 1.
    pub(crate) fn at(&self, part: f64) -> [u8; 3] {
        let part = if self.backwards { 1.0 - part } else { part };
        let place = part.clamp(0.0, 1.0) * (self.stops.len() - 1) as f64;
        let low = (place as usize).min(self.stops.len() - 2);
        let rest = place - low as f64;
        std::array::from_fn(|i| {
            let (from, to) = (
                f64::from(self.stops[low][i]),
                f64::from(self.stops[low + 1][i]),
            );
            (from + rest * (to - from)).round() as u8
        })
    }
}

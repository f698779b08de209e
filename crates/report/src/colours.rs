//! Colours that the colour-blind tell apart.

use plotters::style::RGBColor;

/// The palette of Okabe and Ito (*Color Universal Design*, 2008) without its yellow, which is too
/// faint for a line on white; the strongest first.
const LINES: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
];

/// The colour of that index; after the last comes the first.
pub(crate) fn line(index: usize) -> RGBColor {
    LINES[index % LINES.len()]
}

pub(crate) const TEXT: RGBColor = RGBColor(30, 30, 30);
pub(crate) const NOTE: RGBColor = RGBColor(95, 95, 95);
pub(crate) const FRAME: RGBColor = RGBColor(60, 60, 60);
pub(crate) const GRID: RGBColor = RGBColor(228, 228, 228);
pub(crate) const CASING: RGBColor = RGBColor(150, 155, 162);
pub(crate) const ROCK: RGBColor = RGBColor(222, 208, 184);

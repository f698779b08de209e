//! Drawing: lines, areas, text and images on a page, written as SVG or painted as PNG.

mod drawing;
mod font;
mod ink;
mod line;
pub(crate) mod palette;
mod png;
mod svg;

pub use self::{
    drawing::Drawing,
    ink::{Hue, Ink},
};
pub(crate) use self::{
    drawing::{Anchor, Box, Image, Pen},
    font::{fitting, text_width},
    ink::ColourScale,
    line::{envelope, thinned},
};

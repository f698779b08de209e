//! The page that everything is drawn on, and the only place that draws.

use plotters::{
    coord::Shift,
    prelude::*,
    style::{
        FontTransform, RGBColor,
        text_anchor::{HPos, Pos, VPos},
    },
};

use crate::{line::dashes, profile::Stroke};

/// The backend draws on whole pixels: a canvas ten times as large keeps curves smooth.
pub(crate) const FINE: f64 = 10.0;

/// The backend takes a font's size as the height of its line and divides by this to get the em.
const EM: f64 = 1.24;
/// Mean width of a letter over its size; generous, so that entries never touch.
pub(crate) const LETTER: f64 = 0.6;

/// Whether something was drawn.
pub(crate) type Drawn = Result<(), Box<dyn std::error::Error>>;

/// What is drawn on a white page of that size, in points, as the text of an SVG file.
pub(crate) fn sheet(width: f64, height: f64, draw: impl FnOnce(&Canvas) -> Drawn) -> String {
    let mut svg = String::new();
    let size = [width, height].map(|side| (side * FINE) as u32);
    {
        let root = SVGBackend::with_string(&mut svg, size.into()).into_drawing_area();
        // Drawing into memory does not fail.
        let drawn = root.fill(&WHITE).map_err(Into::into);
        let drawn = drawn.and_then(|()| draw(&Canvas { area: &root }));
        debug_assert!(drawn.is_ok(), "{drawn:?}");
    }
    // The canvas is too large by `FINE`: the file says how large it should be shown.
    let large = format!("width=\"{}\" height=\"{}\"", size[0], size[1]);
    svg.replacen(&large, &format!("width=\"{width}\" height=\"{height}\""), 1)
}

/// The page in points of the finished picture.
pub(crate) struct Canvas<'a, 'b> {
    area: &'a DrawingArea<SVGBackend<'b>, Shift>,
}

impl Canvas<'_, '_> {
    fn fine(points: &[(f64, f64)]) -> Vec<(i32, i32)> {
        let fine = |value: f64| (value * FINE).round() as i32;
        points.iter().map(|(x, y)| (fine(*x), fine(*y))).collect()
    }

    pub(crate) fn line(&self, points: &[(f64, f64)], colour: RGBColor, width: f64) -> Drawn {
        let style = colour.stroke_width((width * FINE) as u32);
        self.area
            .draw(&PathElement::new(Self::fine(points), style))?;
        Ok(())
    }

    pub(crate) fn dashed(
        &self,
        points: &[(f64, f64)],
        colour: RGBColor,
        width: f64,
        dash: f64,
    ) -> Drawn {
        for piece in dashes(points, dash, dash) {
            self.line(&piece, colour, width)?;
        }
        Ok(())
    }

    pub(crate) fn curve(&self, points: &[(f64, f64)], colour: RGBColor, stroke: Stroke) -> Drawn {
        match stroke {
            Stroke::Solid => self.line(points, colour, 1.6),
            Stroke::Dashed => {
                for piece in dashes(points, 6.0, 4.0) {
                    self.line(&piece, colour, 1.6)?;
                }
                Ok(())
            }
        }
    }

    pub(crate) fn fill(&self, corners: &[(f64, f64)], colour: RGBColor) -> Drawn {
        self.area
            .draw(&Polygon::new(Self::fine(corners), colour.filled()))?;
        Ok(())
    }

    /// A dot around each point.
    pub(crate) fn dots(&self, points: &[(f64, f64)], colour: RGBColor, radius: f64) -> Drawn {
        for place in Self::fine(points) {
            let radius = (radius * FINE) as i32;
            self.area
                .draw(&Circle::new(place, radius, colour.filled()))?;
        }
        Ok(())
    }

    pub(crate) fn text(
        &self,
        text: &str,
        x: f64,
        y: f64,
        size: f64,
        colour: RGBColor,
        at: HPos,
    ) -> Drawn {
        self.styled_text(text, x, y, size, colour, at, FontTransform::None)
    }

    /// Text that reads from the bottom up, centred on the point.
    pub(crate) fn upright(&self, text: &str, x: f64, y: f64, size: f64, colour: RGBColor) -> Drawn {
        self.styled_text(
            text,
            x,
            y,
            size,
            colour,
            HPos::Center,
            FontTransform::Rotate270,
        )
    }

    #[allow(
        clippy::too_many_arguments,
        reason = "the two above are its short forms"
    )]
    fn styled_text(
        &self,
        text: &str,
        x: f64,
        y: f64,
        size: f64,
        colour: RGBColor,
        at: HPos,
        turned: FontTransform,
    ) -> Drawn {
        let style = ("sans-serif", size * FINE * EM)
            .into_font()
            .transform(turned)
            .color(&colour)
            .pos(Pos::new(at, VPos::Center));
        let place = Self::fine(&[(x, y)])[0];
        self.area.draw(&Text::new(text, place, style))?;
        Ok(())
    }
}

/// The text, cut off where it is too long for the width.
pub(crate) fn fitting(text: &str, size: f64, width: f64) -> String {
    let letters = (width / (LETTER * size)) as usize;
    if text.chars().count() <= letters {
        return text.to_owned();
    }
    text.chars().take(letters - 1).chain(['\u{2026}']).collect()
}

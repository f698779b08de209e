//! The letters of pictures.

use std::sync::LazyLock;

use skrifa::{
    FontRef, GlyphId, MetadataProvider,
    charmap::Charmap,
    instance::{LocationRef, Size},
    metrics::GlyphMetrics,
    outline::{DrawSettings, OutlineGlyphCollection, OutlinePen},
};

/// Arimo, as wide as Helvetica and Arial: what is measured and painted with it fits where a file is
/// read with one of those.
static FACE: LazyLock<Face> = LazyLock::new(|| {
    let bytes = include_bytes!("../../assets/fonts/Arimo-subset.ttf");
    let font = FontRef::new(bytes).expect("the font that is built in");
    let (unscaled, plain) = (Size::unscaled(), LocationRef::default());
    Face {
        em: f64::from(font.metrics(unscaled, plain).units_per_em),
        letters: font.charmap(),
        widths: font.glyph_metrics(unscaled, plain),
        outlines: font.outline_glyphs(),
    }
});

/// What is asked of a font, in its own units.
struct Face {
    /// Its size.
    em: f64,
    letters: Charmap<'static>,
    widths: GlyphMetrics<'static>,
    outlines: OutlineGlyphCollection<'static>,
}

impl Face {
    /// What a letter looks like; a box where the font does not have it.
    fn glyph(&self, letter: char) -> GlyphId {
        self.letters.map(letter).unwrap_or_default()
    }
}

/// The families with which a file is read, the likeliest first.
pub(super) const FAMILIES: &str =
    "Helvetica, Arial, Arimo, &quot;Liberation Sans&quot;, sans-serif";

/// Half the height of a capital over the size: what a text stands lower than its middle.
pub(super) const HALF_CAPITAL: f64 = 0.358;

/// The width of a text of this size.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    let advances = text.chars().map(advance);
    advances.sum::<f64>() * size
}

/// How far a letter moves the pen, over the size.
fn advance(letter: char) -> f64 {
    let advance = FACE.widths.advance_width(FACE.glyph(letter)).unwrap_or(0.0);
    f64::from(advance) / FACE.em
}

/// The text, cut off where it is too long for the width.
pub(crate) fn fitting(text: &str, size: f64, width: f64) -> String {
    if text_width(text, size) <= width {
        return text.to_owned();
    }
    let room = width - text_width("\u{2026}", size);
    let mut used = 0.0;
    let kept = text.chars().take_while(|letter| {
        used += advance(*letter) * size;
        used <= room
    });
    let kept: String = kept.collect();
    format!("{}\u{2026}", kept.trim_end())
}

/// Gives the outline of a text that begins at the origin, x to the right and y up, in parts of its
/// size.
pub(super) fn outline(text: &str, to: &mut impl FnMut(Stroke)) {
    struct Glyph<'a, F: FnMut(Stroke)> {
        to: &'a mut F,
        left: f64,
        em: f64,
    }
    impl<F: FnMut(Stroke)> Glyph<'_, F> {
        fn at(&self, x: f32, y: f32) -> (f64, f64) {
            (self.left + f64::from(x) / self.em, f64::from(y) / self.em)
        }
    }
    impl<F: FnMut(Stroke)> OutlinePen for Glyph<'_, F> {
        fn move_to(&mut self, x: f32, y: f32) {
            let at = self.at(x, y);
            (self.to)(Stroke::Move(at));
        }
        fn line_to(&mut self, x: f32, y: f32) {
            let at = self.at(x, y);
            (self.to)(Stroke::Line(at));
        }
        fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
            let (by, at) = (self.at(x1, y1), self.at(x, y));
            (self.to)(Stroke::Quadratic(by, at));
        }
        fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
            let (first, second, at) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
            (self.to)(Stroke::Cubic(first, second, at));
        }
        fn close(&mut self) {
            (self.to)(Stroke::Close);
        }
    }
    let mut left = 0.0;
    for letter in text.chars() {
        let mut pen = Glyph { to: &mut *to, left, em: FACE.em };
        if let Some(glyph) = FACE.outlines.get(FACE.glyph(letter)) {
            let size = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
            // Nothing is drawn of what cannot be: a test asks for every sign.
            let _ = glyph.draw(size, &mut pen);
        }
        left += advance(letter);
    }
}

/// A stroke of an outline.
pub(super) enum Stroke {
    Move((f64, f64)),
    Line((f64, f64)),
    Quadratic((f64, f64), (f64, f64)),
    Cubic((f64, f64), (f64, f64), (f64, f64)),
    Close,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Helvetica's widths, in thousandths of the size, from its font metrics (Adobe,
    /// `Helvetica.afm`).
    #[test]
    fn letters_are_as_wide_as_those_of_helvetica() {
        for (text, thousandths) in [("0", 556.0), ("A", 667.0), ("i", 222.0), ("W", 944.0)] {
            let width = text_width(text, 1000.0);
            assert!((width - thousandths).abs() < 1.0, "{text}: {width}");
        }
    }

    #[test]
    fn every_sign_that_pictures_use_has_a_letter() {
        for sign in "\u{2212}\u{202f}\u{2009}°·²³ⁿ⁻⁰¹⁴⁵⁶⁷⁸⁹–…×±".chars()
        {
            assert!(FACE.letters.map(sign).is_some(), "{sign:?}");
            let mut strokes = 0;
            outline(&sign.to_string(), &mut |_| strokes += 1);
            assert!(strokes > 0 || sign.is_whitespace(), "{sign:?}");
        }
    }

    #[test]
    fn a_long_text_is_cut_where_it_must_be() {
        assert_eq!(fitting("short", 10.0, 100.0), "short");
        let cut = fitting("far too long for its place", 10.0, 60.0);
        assert!(cut.ends_with('\u{2026}'), "{cut}");
        assert!(text_width(&cut, 10.0) <= 60.0, "{cut}");
    }
}

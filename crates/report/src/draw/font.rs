//! The letters of pictures.

use std::{collections::HashMap, sync::LazyLock};

/// Arimo, with the widths of Helvetica and Arial, so that text measured and painted with it fits
/// where a file is read with one of those.
static FACE: LazyLock<Face> = LazyLock::new(|| {
    let text = include_str!("../../assets/fonts/letters.txt");
    Face::read(text).expect("the letters that are built in")
});

/// Letters, in parts of their size.
struct Face {
    letters: HashMap<char, Letter>,
    /// Replacement for the letters that it does not have.
    none: Letter,
}

/// A letter in drawable form.
#[derive(Clone, Default)]
struct Letter {
    /// Horizontal advance of the pen.
    advance: f64,
    outline: Vec<Stroke>,
}

impl Face {
    /// The face that `assets/fonts/letters.py` has written.
    fn read(text: &str) -> Option<Self> {
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let units_per_size: f64 = lines.next()?.parse().ok()?;
        let mut face = Self { letters: HashMap::new(), none: Letter::default() };
        for line in lines {
            let mut words = line.split(' ');
            let character = words.next()?;
            let letter = Letter::read(&mut words, units_per_size)?;
            if character == "none" {
                face.none = letter;
            } else {
                let code = u32::from_str_radix(character, 16).ok()?;
                face.letters.insert(char::from_u32(code)?, letter);
            }
        }
        Some(face)
    }

    /// The letter of a character; a box where the font does not have it.
    fn letter(&self, character: char) -> &Letter {
        self.letters.get(&character).unwrap_or(&self.none)
    }
}

impl Letter {
    fn read<'a>(words: &mut impl Iterator<Item = &'a str>, units_per_size: f64) -> Option<Self> {
        fn number<'a>(words: &mut impl Iterator<Item = &'a str>, unit: f64) -> Option<f64> {
            Some(words.next()?.parse::<f64>().ok()? / unit)
        }
        let point =
            |words: &mut _| Some((number(words, units_per_size)?, number(words, units_per_size)?));
        let advance = number(words, units_per_size)?;
        let mut outline = Vec::new();
        while let Some(word) = words.next() {
            outline.push(match word {
                "M" => Stroke::Move(point(words)?),
                "L" => Stroke::Line(point(words)?),
                "Q" => Stroke::Quadratic(point(words)?, point(words)?),
                "Z" => Stroke::Close,
                _ => return None,
            });
        }
        Some(Self { advance, outline })
    }
}

/// The families with which a file is read, the likeliest first.
pub(super) const FAMILIES: &str =
    "Helvetica, Arial, Arimo, &quot;Liberation Sans&quot;, sans-serif";

/// Half the height of a capital over the size, by which a text is lowered to be centred.
pub(super) const HALF_CAPITAL: f64 = 0.358;

/// The width of a text of this size.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    let advances = text.chars().map(|character| FACE.letter(character).advance);
    advances.sum::<f64>() * size
}

/// The text, cut off where it is too long for the width.
pub(crate) fn fitting(text: &str, size: f64, width: f64) -> String {
    if text_width(text, size) <= width {
        return text.to_owned();
    }
    let room = width - text_width("\u{2026}", size);
    let mut used = 0.0;
    let shortened = text.chars().take_while(|character| {
        used += FACE.letter(*character).advance * size;
        used <= room
    });
    let shortened: String = shortened.collect();
    format!("{}\u{2026}", shortened.trim_end())
}

/// Passes the outline of a text that begins at the origin to `to`, x to the right and y up, in
/// parts of its size.
pub(super) fn outline(text: &str, to: &mut impl FnMut(Stroke)) {
    let mut left = 0.0;
    for character in text.chars() {
        let Letter { advance, outline } = FACE.letter(character);
        let at = |(x, y): (f64, f64)| (left + x, y);
        for stroke in outline {
            to(match *stroke {
                Stroke::Move(end) => Stroke::Move(at(end)),
                Stroke::Line(end) => Stroke::Line(at(end)),
                Stroke::Quadratic(by, end) => Stroke::Quadratic(at(by), at(end)),
                Stroke::Close => Stroke::Close,
            });
        }
        left += advance;
    }
}

/// A stroke of an outline, whose curves are of second order.
#[derive(Clone, Copy)]
pub(super) enum Stroke {
    Move((f64, f64)),
    Line((f64, f64)),
    Quadratic((f64, f64), (f64, f64)),
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
            assert!(FACE.letters.contains_key(&sign), "{sign:?}");
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

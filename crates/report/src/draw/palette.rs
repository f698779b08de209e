//! The colours of pages and figures, declared once: pages take their custom properties from here,
//! figures their inks.

use std::fmt::Write;

use wholestring::operation::OperationKind;

/// A colour by its name on a page, on paper and on a dark screen.
#[derive(Debug)]
pub(crate) struct Colour {
    pub(crate) name: &'static str,
    pub(crate) light: u32,
    pub(crate) dark: u32,
}

const fn colour(name: &'static str, light: u32, dark: u32) -> Colour {
    Colour { name, light, dark }
}

/// Number of curves with a colour of their own.
pub(crate) const LINES: usize = 7;

/// Every colour.
///
/// Curves and the sides of the hole were found by a search for the largest minimum difference, as
/// seen by eyes without red, green or blue cones, each in a range of hues that fits its name in
/// light and dark; the tests below check it.
pub(crate) const PALETTE: &[Colour] = &[
    // The ground, text, and grey tones.
    colour("paper", 0xffffff, 0x1b2025),
    colour("page", 0xf6f7f8, 0x13171b),
    colour("text", 0x1d2226, 0xe6eaed),
    colour("muted", 0x59636b, 0x9fabb5),
    colour("grid", 0xe3e6e9, 0x2b3238),
    colour("frame", 0x7d878f, 0x6f7b85),
    colour("accent", 0x005a8f, 0x6cb8ea),
    colour("settling", 0xeceff1, 0x242a30),
    // The hole and the string.
    colour("casing", 0x6f7a83, 0x93a0aa),
    colour("rock", 0xa08040, 0xc5a66d),
    colour("bore", 0xe9edf0, 0x262d33),
    // Curves by their place: blue, orange, green, purple, brown, teal, black on paper.
    colour("line-0", 0x18008e, 0x5368e0),
    colour("line-1", 0xe85800, 0xd75c1c),
    colour("line-2", 0x19997d, 0x67be94),
    colour("line-3", 0xa855b3, 0xf69dff),
    colour("line-4", 0x633e1b, 0xffef70),
    colour("line-5", 0x105d5b, 0xdffcf9),
    colour("line-6", 0x13100b, 0x767275),
    // Sides of the hole, as areas; maps extend them to strong colours.
    colour("high-side", 0xf1d585, 0x4c3a13),
    colour("high-side-strong", 0x7d5200, 0xffd479),
    colour("low-side", 0xaccdfc, 0x014069),
    colour("low-side-strong", 0x0c4a9e, 0x8cc6ff),
    colour("middle", 0xf7f7f7, 0x22282e),
    // Severities, which are always shown with a word and a shape.
    colour("good", 0x047973, 0x52dfd9),
    colour("near", 0x876817, 0xffc934),
    colour("over", 0x6b0018, 0xf3597c),
    // Cividis (Nuñez, Anderton and Renslow 2018), by a few of its colours: even in lightness to
    // every kind of eye.
    colour("amount-0", 0x00224e, 0x00224e),
    colour("amount-1", 0x123570, 0x123570),
    colour("amount-2", 0x3b496c, 0x3b496c),
    colour("amount-3", 0x575d6d, 0x575d6d),
    colour("amount-4", 0x707173, 0x707173),
    colour("amount-5", 0x8a8678, 0x8a8678),
    colour("amount-6", 0xa59c74, 0xa59c74),
    colour("amount-7", 0xc3b369, 0xc3b369),
    colour("amount-8", 0xe1cc55, 0xe1cc55),
    colour("amount-9", 0xfee838, 0xfee838),
];

/// A colour on paper; black where no colour has the name.
pub(crate) fn on_paper(name: &str) -> [u8; 3] {
    let found = PALETTE.iter().find(|colour| colour.name == name);
    rgb(found.map_or(0, |colour| colour.light))
}

/// Red, green and blue.
const fn rgb(colour: u32) -> [u8; 3] {
    let [_, red, green, blue] = colour.to_be_bytes();
    [red, green, blue]
}

/// Custom properties of a set of colours.
fn properties(value: fn(&Colour) -> u32) -> String {
    PALETTE.iter().fold(String::new(), |mut css, colour| {
        let _ = write!(css, "--{}:#{:06x};", colour.name, value(colour));
        css
    })
}

/// Custom properties of the operations, such as `--operation-drill`: each has a colour of curves.
fn operations() -> String {
    OperationKind::ALL.iter().fold(String::new(), |mut css, &kind| {
        let _ = write!(css, "--operation-{}:var(--line-{});", kind.name(), operation_colour(kind));
        css
    })
}

/// The colours of pages and app as custom properties: light, and dark where the page is set so.
fn root_css() -> String {
    format!(
        ":root{{{}{}color-scheme:light}}\n:root[data-theme=dark]{{{}color-scheme:dark}}\n",
        properties(|colour| colour.light),
        operations(),
        properties(|colour| colour.dark),
    )
}

/// The colours of a page as CSS; figures in the page use them.
pub(crate) fn css() -> String {
    let mut css = root_css();
    for Colour { name, .. } in PALETTE {
        let _ = writeln!(
            css,
            ".figure .stroke-{name}{{stroke:var(--{name})}}.figure \
             .fill-{name}{{fill:var(--{name})}}"
        );
    }
    css
}

/// The same for a page without a program, which is dark where the reader's system is.
pub(crate) fn css_by_window() -> String {
    format!(
        "{}@media screen and (prefers-color-scheme:dark){{:root{{{}color-scheme:dark}}}}\n",
        css(),
        properties(|colour| colour.dark),
    )
}

// Colours of operations.

/// Operations with a colour of their own, in the order of the colours of curves; others share the
/// next.
const COLOURED: [OperationKind; 6] = [
    OperationKind::TripIn,
    OperationKind::TripOut,
    OperationKind::RotateOffBottom,
    OperationKind::Drill,
    OperationKind::Slide,
    OperationKind::Ream,
];

/// Place of an operation among the colours of curves: the same in every picture.
pub fn operation_colour(kind: OperationKind) -> usize {
    COLOURED.iter().position(|coloured| *coloured == kind).unwrap_or(COLOURED.len())
}

#[cfg(test)]
mod vision;

#[cfg(test)]
mod tests {
    use std::{env, fs, path::Path};

    use super::{
        vision::{contrast, min_difference},
        *,
    };

    const SIDES: [&str; 2] = ["high-side", "low-side"];

    fn find(name: &str) -> &'static Colour {
        PALETTE.iter().find(|colour| colour.name == name).unwrap()
    }

    type Palette = fn(&Colour) -> u32;

    /// Light and dark, each as a function to a colour.
    const STYLES: [(&str, Palette); 2] =
        [("light", |colour| colour.light), ("dark", |colour| colour.dark)];

    /// The colours that the app takes from a file. With `WHOLESTRING_UPDATE_DOCS=1` this writes it.
    #[test]
    fn the_app_has_the_colours_of_the_pages() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/components/palette.css");
        let expected = format!(
            "/* Written by a test of crates/report: the_app_has_the_colours. */\n{}",
            root_css()
        );
        if env::var_os("WHOLESTRING_UPDATE_DOCS").is_some() {
            fs::write(path, expected).expect("written colours");
            return;
        }
        let found = fs::read_to_string(path).unwrap_or_default().replace("\r\n", "\n");
        assert_eq!(found, expected, "WHOLESTRING_UPDATE_DOCS=1 writes the colours of now");
    }

    fn lines() -> Vec<&'static Colour> {
        (0..LINES).map(|place| find(&format!("line-{place}"))).collect()
    }

    /// All colours that may appear together in one chart, the curves and the areas of the sides of
    /// the hole, differ by at least 20 of CIEDE2000 to every eye, in light and in dark. About 1 is
    /// just noticed between adjacent areas; 20 is the bound of this program for thin lines and
    /// small areas apart from one another.
    #[test]
    fn every_eye_tells_the_colours_of_a_chart_apart() {
        for (style, palette) in STYLES {
            let mut all = lines();
            all.extend(SIDES.map(find));
            for (i, a) in all.iter().enumerate() {
                for b in &all[..i] {
                    let apart = min_difference(rgb(palette(a)), rgb(palette(b)));
                    assert!(apart >= 20.0, "{style}: {} and {}: {apart:.1}", a.name, b.name);
                }
            }
        }
    }

    /// A figure of more than seven curves continues with the colours of rock and casing. Adjacent
    /// to any other they are distinguished, though less well: from 7 on (the least is rock from
    /// orange, 7.2).
    #[test]
    fn two_more_colours_follow_those_of_lines() {
        for (style, palette) in STYLES {
            let mut all = lines();
            for more in ["rock", "casing"].map(find) {
                for other in &all {
                    let apart = min_difference(rgb(palette(more)), rgb(palette(other)));
                    assert!(apart >= 7.0, "{style}: {} and {}: {apart:.1}", more.name, other.name);
                }
                all.push(more);
            }
        }
    }

    /// Lights appear with words and marks, and every eye distinguishes them without: by 20, as
    /// curves. Text on the ground of an exceeded limit, its light thinned to 16 %, is readable.
    #[test]
    fn every_eye_tells_the_lights_apart() {
        for (style, palette) in STYLES {
            let lights = ["good", "near", "over"].map(find);
            for (a, b) in [(0, 1), (1, 2), (0, 2)] {
                let apart = min_difference(rgb(palette(lights[a])), rgb(palette(lights[b])));
                let [a, b] = [lights[a].name, lights[b].name];
                assert!(apart >= 20.0, "{style}: {a} and {b}: {apart:.1}");
            }
            let [over, paper] = ["over", "paper"].map(|name| rgb(palette(find(name))));
            let mixed = |k: usize| 0.16 * f64::from(over[k]) + 0.84 * f64::from(paper[k]);
            let ground = [0, 1, 2].map(|k| mixed(k).round() as u8);
            let text = contrast(rgb(palette(find("text"))), ground);
            assert!(text >= 4.5, "{style}: text on an exceeded limit: {text:.2}");
            let mark = contrast(over, ground);
            assert!(mark >= 3.0, "{style}: its mark: {mark:.2}");
        }
    }

    /// The ends of a map's colours and its middle are distinguished too.
    #[test]
    fn every_eye_tells_the_sides_of_a_map_apart() {
        for (style, palette) in STYLES {
            let names = ["low-side-strong", "middle", "high-side-strong"].map(find);
            for (a, b) in [(0, 1), (1, 2), (0, 2)] {
                let apart = min_difference(rgb(palette(names[a])), rgb(palette(names[b])));
                assert!(apart >= 20.0, "{style}: {}: {apart:.1}", names[a].name);
            }
        }
    }

    /// WCAG 2.2, success criteria 1.4.3 and 1.4.11: text has a contrast of 4.5, the essential parts
    /// of a picture 3.
    #[test]
    fn text_and_lines_stand_out_from_their_ground() {
        for (style, palette) in STYLES {
            let ratio = |a: &str, b: &str| contrast(rgb(palette(find(a))), rgb(palette(find(b))));
            for text in ["text", "muted", "accent", "good", "near", "over"] {
                for ground in ["paper", "page", "settling"] {
                    let ratio = ratio(text, ground);
                    assert!(ratio >= 4.5, "{style}: {text} on {ground}: {ratio:.2}");
                }
            }
            // A chosen button has inverted colours.
            assert!(ratio("paper", "accent") >= 4.5, "{style}: a pressed button");
            let lines = lines();
            let lines = lines.iter().map(|colour| colour.name);
            for line in lines.chain(["frame", "casing", "rock"]) {
                for ground in ["paper", "settling"] {
                    let ratio = ratio(line, ground);
                    assert!(ratio >= 3.0, "{style}: {line} on {ground}: {ratio:.2}");
                }
            }
        }
    }

    #[test]
    fn a_page_has_every_colour_in_both_looks() {
        let css = css();
        for colour in PALETTE {
            assert_eq!(css.matches(&format!("--{}:#", colour.name)).count(), 2);
        }
    }
}

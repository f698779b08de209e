//! A drawing as SVG.

use std::fmt::Write;

use base64::{Engine, engine::general_purpose::STANDARD};
use wholestring_units::without_trailing_zeros;

use super::{
    Anchor, Box, Drawing, Ink, Pen,
    drawing::Item,
    font::{FAMILIES, HALF_CAPITAL},
    png,
};

/// Pixels of a point on a page below which the smallest letters of a figure, of 6.5 points, cannot
/// be read.
const READABLE: f64 = 1.5;

impl Drawing {
    /// The drawing as the text of an SVG file: its text is text, its lines are lines.
    pub fn svg(&self) -> String {
        let millimetres = |points: f64| number(points * 25.4 / 72.0);
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" \
             width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {} {}\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{}</svg>\n",
            millimetres(self.width),
            millimetres(self.height),
            number(self.width),
            number(self.height),
            self.content("clip", false),
        )
    }

    /// The drawing as an element of a page, whose colours follow the page's. `name` differs from
    /// that of every other element.
    pub(crate) fn element(&self, name: &str) -> String {
        format!(
            "<svg class=\"figure\" role=\"img\" viewBox=\"0 0 {} {}\" \
             style=\"width:{}px;--readable:{}px\">\n{}</svg>",
            number(self.width),
            number(self.height),
            number(self.width * 2.0),
            number(self.width * READABLE),
            self.content(name, true),
        )
    }

    /// For a page, items that belong together are marked, so that its program can hide them and
    /// describe a point.
    fn content(&self, name: &str, of_page: bool) -> String {
        let mut clips: Vec<Box> = Vec::new();
        let mut body = String::new();
        for item in &self.items {
            if !of_page && matches!(item, Item::Begin { .. } | Item::End | Item::Spots(_)) {
                continue;
            }
            let written = match item {
                Item::Path { lines, closed, fill, pen, clip } => {
                    let clip = clip.map(|clip| {
                        let known = clips.iter().position(|other| *other == clip);
                        known.unwrap_or_else(|| {
                            clips.push(clip);
                            clips.len() - 1
                        })
                    });
                    let clip = clip.map_or(String::new(), |index| {
                        format!(" clip-path=\"url(#{name}-{index})\"")
                    });
                    writeln!(
                        body,
                        "<path{}{clip} d=\"{}\"/>",
                        style(*fill, *pen),
                        data(lines, *closed)
                    )
                }
                Item::Text { text, at, size, ink, anchor, upright } => {
                    let (x, y) = *at;
                    let drop = HALF_CAPITAL * size;
                    let place = if *upright {
                        format!(
                            "transform=\"translate({} {}) rotate(-90)\"",
                            number(x + drop),
                            number(y)
                        )
                    } else {
                        format!("x=\"{}\" y=\"{}\"", number(x), number(y + drop))
                    };
                    writeln!(
                        body,
                        "<text {place} font-size=\"{}\"{}{}>{}</text>",
                        number(*size),
                        match anchor {
                            Anchor::Start => "",
                            Anchor::Middle => " text-anchor=\"middle\"",
                            Anchor::End => " text-anchor=\"end\"",
                        },
                        style(Some((*ink, 1.0)), None),
                        escaped(text)
                    )
                }
                Item::Begin { keys, of_legend } => {
                    let class = if *of_legend { "legend-key" } else { "series" };
                    let keys: Vec<String> = keys.iter().map(usize::to_string).collect();
                    writeln!(body, "<g class=\"{class}\" data-keys=\"{}\">", keys.join(" "))
                }
                Item::End => writeln!(body, "</g>"),
                Item::Spots(spots) => {
                    // The page's program makes circles of them, because a sweep has thousands, in
                    // three sets of units.
                    let spots = spots.iter();
                    let spots =
                        spots.map(|((x, y), row)| format!("{} {} {row}", number(*x), number(*y)));
                    let spots: Vec<String> = spots.collect();
                    writeln!(body, "<g class=\"spots\" data-spots=\"{}\"/>", spots.join(" "))
                }
                Item::Image { image, place } => writeln!(
                    body,
                    "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" \
                     preserveAspectRatio=\"none\" \
                     style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{}\"/>",
                    number(place.left),
                    number(place.top),
                    number(place.width),
                    number(place.height),
                    STANDARD.encode(png::encoded(image)),
                ),
            };
            debug_assert!(written.is_ok(), "writing to memory does not fail");
        }
        let mut defined = String::new();
        for (index, clip) in clips.iter().enumerate() {
            defined += &format!(
                "<clipPath id=\"{name}-{index}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" \
                 height=\"{}\"/></clipPath>\n",
                number(clip.left),
                number(clip.top),
                number(clip.width),
                number(clip.height),
            );
        }
        format!(
            "<title>{}</title>\n<defs>\n{defined}</defs>\n<g \
             font-family=\"{FAMILIES}\">\n{body}</g>\n",
            escaped(&self.title)
        )
    }
}

fn hex(ink: Ink) -> String {
    let [r, g, b] = ink.rgb();
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Attributes for fill and line, and classes through which a page assigns its own colours.
fn style(fill: Option<(Ink, f64)>, pen: Option<Pen>) -> String {
    let mut classes = Vec::new();
    let mut attributes = String::new();
    match fill {
        None => attributes += " fill=\"none\"",
        Some((ink, opacity)) => {
            classes.push(format!("fill-{}", ink.name()));
            attributes += &format!(" fill=\"{}\"", hex(ink));
            if opacity < 1.0 {
                attributes += &format!(" fill-opacity=\"{}\"", number(opacity));
            }
        }
    }
    if let Some(pen) = pen {
        classes.push(format!("stroke-{}", pen.ink.name()));
        attributes += &format!(
            " stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
            hex(pen.ink),
            number(pen.width)
        );
        if let Some([dash, gap]) = pen.dash {
            attributes += &format!(" stroke-dasharray=\"{} {}\"", number(dash), number(gap));
        }
    }
    format!(" class=\"{}\"{attributes}", classes.join(" "))
}

/// The lines of a path. Each begins with its absolute place; then the steps from point to point
/// follow, in whole hundredths so that no rounding accumulates: half the length of absolute
/// coordinates.
fn data(lines: &[Vec<(f64, f64)>], closed: bool) -> String {
    let hundredths = |value: f64| (value * 100.0).round() as i64;
    let mut data = String::new();
    for line in lines {
        let mut points = line.iter().map(|(x, y)| [hundredths(*x), hundredths(*y)]);
        let Some(mut last) = points.next() else {
            continue;
        };
        data.push('M');
        push(&mut data, last);
        for (i, point) in points.enumerate() {
            if i == 0 {
                data.push('l');
            }
            push(&mut data, [point[0] - last[0], point[1] - last[1]]);
            last = point;
        }
        if closed {
            data.push('Z');
        }
    }
    data
}

/// Adds two coordinates, in hundredths, with a separator only where one is required.
fn push(data: &mut String, coordinates: [i64; 2]) {
    for hundredths in coordinates {
        let text = number(hundredths as f64 / 100.0);
        let text = match text.split_once("0.") {
            Some((sign @ ("" | "-"), rest)) => format!("{sign}.{rest}"),
            _ => text,
        };
        // A number has at most one point and one sign.
        let last = data.trim_end_matches(|letter: char| letter.is_ascii_digit());
        let parted = match text.as_bytes()[0] {
            b'-' => true,
            b'.' => last.ends_with('.'),
            _ => false,
        };
        if !parted && last.len() < data.len() {
            data.push(' ');
        }
        data.push_str(&text);
    }
}

/// A number to a hundredth of a point.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = without_trailing_zeros(&text);
    if text == "-0" { "0" } else { text }.to_owned()
}

fn escaped(text: &str) -> String {
    // XML does not allow most control characters, escaped or not.
    let text: String =
        text.chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect();
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers of a path as SVG reads them: a sign or a second point begins another.
    fn numbers(path: &str) -> Vec<f64> {
        let mut numbers = vec![String::new()];
        for letter in path.chars() {
            let last = &numbers[numbers.len() - 1];
            let next = letter == '-' || letter == '.' && last.contains('.');
            if next || !matches!(letter, '0'..='9' | '.') {
                numbers.push(String::new());
            }
            if matches!(letter, '0'..='9' | '.' | '-') {
                numbers.last_mut().unwrap().push(letter);
            }
        }
        let numbers = numbers.iter().filter(|number| !number.is_empty());
        numbers.map(|number| number.parse().unwrap()).collect()
    }

    #[test]
    fn paths_are_short() {
        let line = vec![(10.0, 0.5), (10.25, 0.0), (10.256, 100.0), (-0.5, 99.5)];
        assert_eq!(data(&[line], false), "M10 .5l.25-.5.01 100-10.76-.5");
        let two = [vec![(1.0, 2.0), (3.0, 2.0)], vec![(0.0, 0.0)]];
        assert_eq!(data(&two, true), "M1 2l2 0ZM0 0Z");
    }

    /// Each step is a whole number of hundredths, so that a long line ends where it should.
    #[test]
    fn a_path_ends_where_its_last_point_is() {
        let count = 3000;
        let third = |i: u32| (-f64::from(i) / 3.0, f64::from(i) / 7.0);
        let numbers = numbers(&data(&[(0..count).map(third).collect()], false));
        assert_eq!(numbers.len(), 2 * count as usize);
        for (axis, last) in [-999.67, 428.43].into_iter().enumerate() {
            let sum: f64 = numbers.iter().skip(axis).step_by(2).sum();
            assert!((sum - last).abs() < 1e-6, "{sum}");
        }
    }
}

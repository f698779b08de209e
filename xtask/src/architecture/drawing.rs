//! The picture of rows of crates.

use std::fmt::Write as _;

use super::layers::Place;

/// Widths of a crate and of a passing line, and the gap between them.
const BOX: f64 = 104.0;
const LINE: f64 = 16.0;
const GAP: f64 = 14.0;
/// Height of a crate, and distance of the rows.
const HEIGHT: f64 = 30.0;
const ROW: f64 = 76.0;
const MARGIN: f64 = 14.0;

pub(super) fn svg(rows: &[Vec<Place>]) -> String {
    let widths: Vec<f64> = rows.iter().map(|row| width(row)).collect();
    let full = widths.iter().copied().fold(0.0, f64::max);
    let (wide, high) =
        (full + 2.0 * MARGIN, rows.len() as f64 * ROW - (ROW - HEIGHT) + 2.0 * MARGIN);
    let middles: Vec<Vec<f64>> =
        rows.iter().zip(&widths).map(|(row, own)| middles(row, (full - own) / 2.0)).collect();
    let mut lines = String::new();
    let mut boxes = String::new();
    for (number, row) in rows.iter().enumerate() {
        let top = MARGIN + number as f64 * ROW;
        for (place, x) in row.iter().zip(&middles[number]) {
            if place.name.is_none() {
                let _ = writeln!(lines, "<path d=\"M{x:.0} {top:.0}v{HEIGHT:.0}\"/>");
            }
            let (from, to) = (top + HEIGHT, top + ROW);
            for below in &place.below {
                let end = middles[number + 1][*below];
                let half = (from + to) / 2.0;
                let _ = writeln!(
                    lines,
                    "<path d=\"M{x:.0} {from:.0}C{x:.0} {half:.0} {end:.0} {half:.0} {end:.0} \
                     {to:.0}\"/>"
                );
            }
            if let Some(name) = &place.name {
                let short = name.strip_prefix("wholestring-").unwrap_or(name);
                let (left, base) = (x - BOX / 2.0, top + HEIGHT / 2.0 + 5.0);
                let _ = writeln!(
                    boxes,
                    "<rect x=\"{left:.0}\" y=\"{top:.0}\" width=\"{BOX:.0}\" \
                     height=\"{HEIGHT:.0}\" rx=\"4\"/><text x=\"{x:.0}\" y=\"{base:.0}\">{short}\
                     </text>"
                );
            }
        }
    }
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {wide:.0} {high:.0}\" \
         width=\"{wide:.0}\" height=\"{high:.0}\" role=\"img\">\n<title>The crates of wholestring: \
         each uses those to which a line goes down</title>\n<rect width=\"{wide:.0}\" \
         height=\"{high:.0}\" fill=\"#fff\"/>\n<g fill=\"none\" \
         stroke=\"#7b8794\">\n{lines}</g>\n<g fill=\"#e8f0f7\" stroke=\"#33536f\" \
         font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\" \
         text-anchor=\"middle\">\n<style>text {{ fill: #12212e; stroke: none }}</style>\n\
         {boxes}</g>\n</svg>\n"
    )
}

fn own(place: &Place) -> f64 {
    if place.name.is_some() { BOX } else { LINE }
}

fn width(row: &[Place]) -> f64 {
    row.iter().map(|place| own(place) + GAP).sum::<f64>() - GAP
}

/// The middle of each place, for a row that begins at `left`.
fn middles(row: &[Place], left: f64) -> Vec<f64> {
    let mut next = MARGIN + left;
    let middle = |place: &Place| {
        let middle = next + own(place) / 2.0;
        next += own(place) + GAP;
        middle
    };
    row.iter().map(middle).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_crate_has_a_box_and_every_use_a_line() {
        let place =
            |name: &str, below: &[usize]| Place { name: Some(name.into()), below: below.to_vec() };
        let rows = [vec![place("wholestring-a", &[0, 1])], vec![place("b", &[]), place("c", &[])]];
        let svg = svg(&rows);
        assert_eq!(svg.matches("<rect x=").count(), 3);
        assert_eq!(svg.matches("<path").count(), 2);
        assert!(svg.contains(">a</text>"), "{svg}");
    }
}

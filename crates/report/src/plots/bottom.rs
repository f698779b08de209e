//! The bottom of a hole from above.

use std::f64::consts::TAU;

use super::{
    display::DisplayUnits,
    run::{Context, Plot, title},
};
use crate::{
    BottomPicture,
    figure::{Axis, Direction, Figure, Hue, Key, Layout, Map, Mark, Panel, Range, Sample},
};

/// Number of places along an edge of a picture at which colours are computed.
const FINE: usize = 480;

/// Sides up and across the picture: the right side is to the right of a reader who looks down the
/// hole.
const SIDES: [&str; 2] = ["To the high side", "To the right"];

/// The bottoms from above, each with its name, all in the same colours and at the same scale.
/// `sides` names the sides up and across.
pub(crate) fn bottoms_figure(
    title: String,
    subtitle: String,
    bottoms: &[(String, &BottomPicture)],
    sides: [&str; 2],
    display: DisplayUnits<'_>,
) -> Figure {
    let length = |si: f64| display.value(si, "diameter");
    let reach_m = bottoms.iter().map(|(_, bottom)| bottom.edges_m()[1]);
    let reach_m = 1.04 * reach_m.fold(0.0, f64::max);
    let deepest_m = bottoms.iter().map(|(_, bottom)| deepest_m(bottom));
    let deepest_m = deepest_m.fold(0.0, f64::max);
    let range = Range::Fixed(-length(reach_m), length(reach_m));
    let place_m =
        |index: usize, part: f64| reach_m * (2.0 * (index as f64 + part) / FINE as f64 - 1.0);
    let panel = |(name, bottom): &(String, &BottomPicture)| {
        let cells = Cells::of(bottom);
        let column = |right: usize| {
            let right_m = place_m(right, 0.5);
            let cells = &cells;
            (0..FINE).map(move |high| length(cells.depth_m(place_m(high, 0.5), right_m)))
        };
        let names = (!name.is_empty()).then(|| Key { name: name.clone(), sample: Sample::Words });
        Panel {
            axis: Axis::new(display.label(sides[0], "diameter"), range),
            marks: vec![Mark::Map(Map {
                from: -length(reach_m),
                ends: (0..FINE).map(|right| length(place_m(right, 1.0))).collect(),
                middles: (0..FINE).map(|high| length(place_m(high, 0.5))).collect(),
                values: (0..FINE).flat_map(column).collect(),
                hue: Hue::Depth,
                largest: if deepest_m > 0.0 { length(deepest_m) } else { 1.0 },
                label: display.label("Depth below the rim", "diameter"),
                sides: None,
            })],
            keys: names.into_iter().collect(),
        }
    };
    let columns = if bottoms.len() > 1 { 2 } else { 1 };
    Figure {
        title,
        subtitle,
        keys: Vec::new(),
        layout: Layout {
            direction: Direction::Plan,
            columns,
            width_mm: if columns > 1 { 180.0 } else { 130.0 },
            panel_mm: if columns > 1 { 58.0 } else { 95.0 },
        },
        shared: Axis::new(display.label(sides[1], "diameter"), range),
        panels: bottoms.iter().map(panel).collect(),
        hole: Vec::new(),
    }
}

/// The bottoms at the end of an operation of some runs.
pub(super) fn plots(context: Context<'_>) -> Vec<Plot> {
    let (runs, display) = (context.runs, context.display);
    let bottoms: Vec<(String, &BottomPicture)> = context
        .timed()
        .filter_map(|(place, timed)| {
            let name = if runs.len() > 1 { runs[place].name } else { "" };
            Some((name.to_owned(), timed.bottom.as_ref()?))
        })
        .collect();
    if bottoms.is_empty() {
        return Vec::new();
    }
    let subtitle = context.subtitle.to_owned();
    let figure = bottoms_figure(title(runs), subtitle, &bottoms, SIDES, display);
    vec![context.plot("bottom-hole", figure)]
}

fn deepest_m(bottom: &BottomPicture) -> f64 {
    let depths = bottom.depth_m.values().into_iter();
    depths.filter(|depth| depth.is_finite()).fold(0.0, f64::max)
}

/// A bottom with at least one known depth.
struct Cells {
    edges_m: [f64; 2],
    rings: usize,
    sectors: usize,
    depth_m: Vec<f64>,
}

impl Cells {
    fn of(bottom: &BottomPicture) -> Self {
        Self {
            edges_m: bottom.edges_m(),
            rings: bottom.radius_m.values().len(),
            sectors: bottom.angle_rad.values().len(),
            depth_m: bottom.depth_m.values(),
        }
    }

    /// Depth of the cell at a place, m; not a number outside the rings.
    fn depth_m(&self, high_m: f64, right_m: f64) -> f64 {
        let [inner, outer] = self.edges_m;
        let part = (high_m.hypot(right_m) - inner) / (outer - inner);
        if !(0.0..1.0).contains(&part) {
            return f64::NAN;
        }
        let ring = ((part * self.rings as f64) as usize).min(self.rings - 1);
        let turn = right_m.atan2(high_m).rem_euclid(TAU) / TAU;
        let sector = ((turn * self.sectors as f64) as usize).min(self.sectors - 1);
        self.depth_m[ring * self.sectors + sector]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four sectors, of which one is deep and one unknown: each is at its place, the high side up
    /// and the right to the right.
    #[test]
    fn sectors_lie_where_they_belong() {
        let quarter = TAU / 4.0;
        let angles = [0.5, 1.5, 2.5, 3.5].map(|part| part * quarter);
        let bottom = BottomPicture::new(&[0.05], &angles, &[0.0, 0.004, f64::NAN, 0.001]);
        let bottom = bottom.expect("depths are known");
        let cells = Cells::of(&bottom);
        let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
        // The first sector is between the high side and the right.
        assert!(near(cells.depth_m(0.02, 0.03), 0.0));
        assert!(near(cells.depth_m(-0.02, 0.03), 0.004));
        assert!(cells.depth_m(-0.02, -0.03).is_nan());
        assert!(near(cells.depth_m(0.02, -0.03), 0.001));
        assert!(cells.depth_m(0.09, 0.09).is_nan(), "outside");
    }
}

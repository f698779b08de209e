//! The hole as the integration steps through it, with the buckling loads of the string there: the
//! data that do not depend on operation or friction.

use nalgebra::Vector3;

use super::load::Point;
use crate::{
    model::Model,
    statics::buckling::{BucklingLoads, Pipe},
    well::{Heading, Path},
};

/// The end of a step.
pub(super) struct Node {
    pub(super) md_m: f64,
    pub(super) point: Point,
    pub(super) high_side: Vector3<f64>,
    pub(super) buckling_loads: BucklingLoads,
}

/// A step up from the node below it.
pub(super) struct Step {
    /// Half-way.
    pub(super) middle: Point,
    /// Its upper end.
    pub(super) upper: Node,
}

/// A stretch of hole on which everything but the path's direction is constant.
pub(super) struct Stretch {
    /// Upper and lower end, m.
    pub(super) from_md_m: f64,
    pub(super) to_md_m: f64,
    /// Length of its steps, m.
    pub(super) step_m: f64,
    /// Its lower end. Where the curvature jumps there, with its value just above.
    pub(super) lowest: Node,
    /// From the lower end up.
    pub(super) steps: Vec<Step>,
}

/// The stretches of a hole, from the bit up, in steps of a length at the most, m.
pub(super) fn stretches(model: &Model, bit_depth_m: f64, longest_m: f64) -> Vec<Stretch> {
    let ends = ends(model, bit_depth_m);
    let stretch_between = |pair: &[f64]| stretch(model, bit_depth_m, [pair[0], pair[1]], longest_m);
    ends.windows(2).map(stretch_between).collect()
}

/// Ends of the stretches, from the bit up: where the path's curvature or its slope, the component, the
/// hole section or a fluid may change.
fn ends(model: &Model, bit_depth_m: f64) -> Vec<f64> {
    let kinks = model.well.path.kinks_m();
    let sections = model.well.hole.sections().iter().map(|section| section.to_md_m);
    let components = model.string.spans().map(|span| bit_depth_m - span.to_bit_m);
    let mut ends: Vec<f64> = kinks
        .chain(sections)
        .chain(components)
        .chain(model.fluids.boundaries_m())
        .filter(|&md_m| md_m > SHORTEST_M && md_m < bit_depth_m - SHORTEST_M)
        .chain([0.0, bit_depth_m])
        .collect();
    ends.sort_by(|a, b| b.total_cmp(a));
    ends.dedup_by(|above, below| *below - *above < SHORTEST_M);
    ends
}

/// Boundaries that are closer together than this are one, m. The path's headings are taken as far
/// inside a stretch.
const SHORTEST_M: f64 = 1e-6;

/// Part of a step that a stretch may be longer by than so many of them: last digits of depths, which
/// other units change, make no further step.
const SAME_STEPS: f64 = 1e-6;

fn stretch(
    model: &Model,
    bit_depth_m: f64,
    [to_md_m, from_md_m]: [f64; 2],
    longest_m: f64,
) -> Stretch {
    let path = &model.well.path;
    let middle_m = 0.5 * (from_md_m + to_md_m);
    let (_, component) = model.string.component_at(bit_depth_m - middle_m);
    let hole_diameter_m = model.well.hole.at(middle_m).diameter_m;
    let pipe = Pipe::new(component, hole_diameter_m, model.densities_at(middle_m));
    let node = |md_m: f64, point: Point| node(model, &pipe, md_m, point);
    let length_m = to_md_m - from_md_m;
    let count = (length_m / longest_m - SAME_STEPS).ceil().max(1.0);
    let step_m = length_m / count;
    let heading = |md_m: f64| heading_within(path, [from_md_m, to_md_m], md_m);
    let lowest = Point::new(heading(to_md_m), [to_md_m, path.at(to_md_m).position_m.z]);
    let (mut lower_md_m, mut lower) = (to_md_m, lowest);
    let steps = (1..=count as usize).map(|index| {
        let upper_md_m =
            if index == count as usize { from_md_m } else { to_md_m - index as f64 * step_m };
        let (middle, upper) = points(heading, [lower_md_m, upper_md_m], step_m, &lower);
        (lower_md_m, lower) = (upper_md_m, upper);
        Step { middle, upper: node(upper_md_m, upper) }
    });
    let steps = steps.collect();
    Stretch { from_md_m, to_md_m, step_m, lowest: node(to_md_m, lowest), steps }
}

/// The path's heading at a measured depth of a stretch between two others, m: at its ends that of the
/// stretch, on whichever side of a station rounding has them.
pub(super) fn heading_within(path: &Path, [from_md_m, to_md_m]: [f64; 2], md_m: f64) -> Heading {
    let inside_m = SHORTEST_M.min(0.5 * (to_md_m - from_md_m));
    path.heading_beside(md_m, md_m.max(from_md_m + inside_m).min(to_md_m - inside_m))
}

/// The middle and the upper end of a step, of which the lower end is known.
pub(super) fn points(
    heading: impl Fn(f64) -> Heading,
    [lower_md_m, upper_md_m]: [f64; 2],
    step_m: f64,
    lower: &Point,
) -> (Point, Point) {
    let middle_md_m = 0.5 * (lower_md_m + upper_md_m);
    let middle = heading(middle_md_m);
    let upper = heading(upper_md_m);
    // Simpson's rule from the stretch's lower end up: `κ⁴ step⁵/2880` a step, for pressures.
    let [low_z, middle_z, up_z] = [lower.tangent.z, middle.tangent.z, upper.tangent.z];
    let middle_tvd_m = lower.tvd_m - step_m / 24.0 * (5.0 * low_z + 8.0 * middle_z - up_z);
    let upper_tvd_m = lower.tvd_m - step_m / 6.0 * (low_z + 4.0 * middle_z + up_z);
    (Point::new(middle, [middle_md_m, middle_tvd_m]), Point::new(upper, [upper_md_m, upper_tvd_m]))
}

fn node(model: &Model, pipe: &Pipe, md_m: f64, point: Point) -> Node {
    let place = pipe.at(&point.tangent, &point.curvature_per_m);
    Node {
        md_m,
        point,
        high_side: model.well.path.high_side_of(md_m, &point.tangent),
        buckling_loads: place.buckling_loads(model.buckling),
    }
}

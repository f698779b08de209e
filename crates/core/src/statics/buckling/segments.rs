//! The string in its hole as stretches to push through.

use super::{place::Pipe, push::Segment};
use crate::{model::Model, operation::Operation};

/// Longest stretch on which the compression is followed, m.
const STRETCH_M: f64 = 5.0;

/// The string of an operation in stretches, from the bit up, cut at the depths of a profile, m,
/// from the surface down.
pub fn segments(model: &Model, operation: &Operation, md_m: &[f64]) -> Vec<Segment> {
    let bit_depth_m = operation.bit_depth_m;
    let mut segments = Vec::new();
    let mut to_md_m = bit_depth_m;
    for row in (0..md_m.len().saturating_sub(1)).rev() {
        let from_md_m = md_m[row];
        let jumps = {
            let (above, _) =
                model.string.component_at(bit_depth_m - 0.5 * (from_md_m + md_m[row + 1]));
            let next = row.checked_sub(1).map(|next| 0.5 * (md_m[next] + from_md_m));
            next.is_some_and(|next| {
                model.string.component_at(bit_depth_m - next).0 != above
                    || model.well.hole.at(next) != model.well.hole.at(from_md_m)
            })
        };
        if row > 0 && !jumps && to_md_m - from_md_m < STRETCH_M {
            continue;
        }
        let length_m = to_md_m - from_md_m;
        let middle_m = 0.5 * (from_md_m + to_md_m);
        let heading = model.well.path.heading_at(middle_m);
        let (_, component) = model.string.component_at(bit_depth_m - middle_m);
        let section = model.well.hole.at(middle_m);
        let densities = model.densities_at(middle_m);
        let pipe = Pipe::new(component, section.diameter_m, densities);
        segments.push(Segment {
            length_m,
            place: pipe.at(&heading.tangent, &heading.curvature_per_m),
            friction: section.friction.kinetic,
            weight_along_N_per_m: component.weight_in_N_per_m(densities) * heading.tangent.z,
        });
        to_md_m = from_md_m;
    }
    segments
}

//! Mandatory positions of nodes: ends, blades, bends, lateral forces, and joints where they can.

use crate::{
    sizing::Sizing,
    string::{Blades, Component, DrillString, NEAREST_BEND_M, Span},
};

/// A mandatory position of a node.
pub(super) struct Mark {
    pub(super) from_bit_m: f64,
    pub(super) contact_radius_m: f64,
    /// The ends, the stabilisers, the bends and the lateral forces never give way; joints do, where
    /// they crowd.
    pub(super) fixed: bool,
}

/// Blades that are shorter than this and than an element touch at their middle, m: the tilt that
/// they allow in their clearance is more than a string bends over their length.
const SHORT_BLADE_M: f64 = 0.5;

/// A component without blades of its own that is wider than both its neighbours and no longer than
/// this touches as one point, at its middle, m.
const LONGEST_BLADE_M: f64 = 4.0;

/// A joint nearer to the bit, the top, a stabiliser or the joint below than this part of the
/// element length, and than [`CROWDED_M`], has no node of its own.
const CROWDED: f64 = 0.5;

/// Longest distance over which joints share the node of another one, m.
const CROWDED_M: f64 = 2.0;

/// A blade's edge nearer than this to another one or to an end of the string shares its node, m.
const SAME_M: f64 = 0.05;

/// Radii that differ by less are the same, m.
const RADIUS_M: f64 = 1e-9;

/// Minimum height of a blade over its neighbours, m.
pub(super) const BLADE_HEIGHT_M: f64 = 1e-3;

/// Contact radius between marks: that of the blades, where there are blades, or of the body.
pub(super) fn body_radius_m(string: &DrillString, from_bit_m: f64) -> f64 {
    let (index, component) = string.component_at(from_bit_m);
    if let Some(blades) = component.blades
        && let Some(span) = string.spans().nth(index)
    {
        let middle = 0.5 * (span.from_bit_m + span.to_bit_m);
        if (from_bit_m - middle).abs() <= 0.5 * blades.length_m {
            return 0.5 * blades.od_m;
        }
    }
    component.od_m / 2.0
}

/// The component that touches at a node, counted from the bit: the one whose radius the node has.
/// At the end of a component that is the one with the blades or the joint, whichever of the two the
/// mark is of.
pub(super) fn touching_component(string: &DrillString, node: &MeshNode) -> usize {
    let (above, _) = string.component_at(node.from_bit_m);
    let near = string.spans().enumerate().filter(|(_, span)| {
        (span.from_bit_m - SAME_M..=span.to_bit_m + SAME_M).contains(&node.from_bit_m)
    });
    let touches = |component: &Component| {
        let blades = component.blades.map(|blades| 0.5 * blades.od_m);
        let radii_m = [component.contact_radius_m(), 0.5 * component.od_m];
        let own = |radius_m: f64| (radius_m - node.contact_radius_m).abs() < RADIUS_M;
        // Blades first, then the widest, then the body.
        if blades.is_some_and(own) {
            3
        } else if own(radii_m[0]) {
            2
        } else {
            usize::from(own(radii_m[1]))
        }
    };
    // Of equal ones that in which the node is.
    let rank = |(index, span): &(usize, Span<'_>)| (touches(span.component), *index == above);
    near.max_by_key(rank).map_or(above, |(index, _)| index)
}

/// Contact radius between two nodes that are not moved: that of blades only between nodes on them,
/// so that a component that touches at its middle alone continues to do so.
pub(super) fn radius_between_m(string: &DrillString, from_bit_m: f64, ends: [&MeshNode; 2]) -> f64 {
    let touching = body_radius_m(string, from_bit_m);
    if ends.iter().all(|node| node.contact_radius_m >= touching - BLADE_HEIGHT_M) {
        return touching;
    }
    let (index, component) = string.component_at(from_bit_m);
    let components = string.components();
    if !is_blade(components, index) {
        return 0.5 * component.od_m;
    }
    let beside = [index - 1, index + 1].into_iter().filter_map(|other| components.get(other));
    beside.map(|other| 0.5 * other.od_m).fold(0.0, f64::max)
}

/// Contact positions of the blades of a component from `bottom` to `top`: distances from the bit,
/// m.
fn blade_places_m(blades: &Blades, bottom: f64, top: f64, element_length_m: f64) -> Vec<f64> {
    let middle = 0.5 * (bottom + top);
    let half = 0.5 * blades.length_m;
    let resolved = blades.length_m >= element_length_m;
    if blades.length_m > CROWDED * element_length_m && (resolved || blades.length_m > SHORT_BLADE_M)
    {
        vec![middle - half, middle + half]
    } else {
        vec![middle]
    }
}

/// The marks of a string from the bit up, without the joints that crowd another mark.
pub(super) fn of(string: &DrillString, sizing: &Sizing) -> Vec<Mark> {
    let components = string.components();
    let length = string.length_m();
    let mut marks = vec![
        Mark { from_bit_m: 0.0, contact_radius_m: components[0].contact_radius_m(), fixed: true },
        Mark {
            from_bit_m: length,
            contact_radius_m: components[components.len() - 1].contact_radius_m(),
            fixed: true,
        },
    ];
    let mut bottom = 0.0;
    for (index, component) in components.iter().enumerate() {
        let top = bottom + component.length_m;
        let radius = component.contact_radius_m();
        if let Some(joints) = component.joints {
            let mut from_bit_m = bottom;
            while from_bit_m < top {
                marks.push(Mark { from_bit_m, contact_radius_m: radius, fixed: false });
                from_bit_m += joints.spacing_m;
            }
        } else if let Some(blades) = &component.blades {
            let element_length_m = sizing.at(0.5 * (bottom + top)).element_length_m;
            for from_bit_m in blade_places_m(blades, bottom, top, element_length_m) {
                let near = |m: &&mut Mark| (m.from_bit_m - from_bit_m).abs() < SAME_M;
                match marks.iter_mut().filter(|m| m.fixed).find(near) {
                    Some(mark) => mark.contact_radius_m = mark.contact_radius_m.max(radius),
                    None => marks.push(Mark { from_bit_m, contact_radius_m: radius, fixed: true }),
                }
            }
        } else if is_blade(components, index) {
            let from_bit_m = 0.5 * (bottom + top);
            marks.push(Mark { from_bit_m, contact_radius_m: radius, fixed: true });
        }
        bottom = top;
    }
    // A bend takes the node of a bit or a blade that is next to it, and a lateral force theirs.
    let bends = string
        .spans()
        .filter_map(|span| span.component.bend.map(|bend| span.from_bit_m + bend.from_lower_end_m));
    let forces = string.spans().filter_map(|span| {
        span.component.lateral_force.map(|force| span.from_bit_m + force.from_lower_end_m)
    });
    for from_bit_m in bends.chain(forces) {
        let taken = |m: &Mark| m.fixed && (m.from_bit_m - from_bit_m).abs() < NEAREST_BEND_M;
        if !marks.iter().any(taken) {
            marks.push(Mark {
                from_bit_m,
                contact_radius_m: body_radius_m(string, from_bit_m),
                fixed: true,
            });
        }
    }
    marks.sort_by(|a, b| a.from_bit_m.total_cmp(&b.from_bit_m));
    thin(marks, sizing)
}

/// Whether a component is wider than both its neighbours over a short length: a stabiliser, a
/// reamer. The bit is neither such a neighbour nor such a component.
fn is_blade(components: &[Component], index: usize) -> bool {
    let radius = components[index].contact_radius_m();
    let over = |other: Option<&Component>| {
        other.is_none_or(|c| radius > c.contact_radius_m() + BLADE_HEIGHT_M)
    };
    index > 0
        && components[index].length_m <= LONGEST_BLADE_M
        && over(if index == 1 { None } else { components.get(index - 1) })
        && over(components.get(index + 1))
}

/// Drops joints that crowd a fixed mark or the joint below.
fn thin(marks: Vec<Mark>, sizing: &Sizing) -> Vec<Mark> {
    let fixed: Vec<f64> = marks.iter().filter(|m| m.fixed).map(|m| m.from_bit_m).collect();
    let mut result: Vec<Mark> = Vec::with_capacity(marks.len());
    for mark in marks {
        let length_m = sizing.at(mark.from_bit_m).element_length_m;
        let near = (CROWDED * length_m).min(CROWDED_M);
        let crowds_fixed = !mark.fixed && fixed.iter().any(|f| (f - mark.from_bit_m).abs() < near);
        let crowds_last = !mark.fixed
            && result.last().is_some_and(|last| mark.from_bit_m - last.from_bit_m < near);
        if !crowds_fixed && !crowds_last {
            result.push(mark);
        }
    }
    result
}

// A node of the mesh.

/// A node of the string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshNode {
    /// Distance from the bit along the unloaded string, m.
    pub from_bit_m: f64,
    /// Radius that touches the wall here: of the joint, of the stabiliser or of the body, m.
    pub contact_radius_m: f64,
}

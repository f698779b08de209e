//! From marks to nodes: how many elements between them, and which joints give way.
//!
//! Distances are counted in element lengths of the sizing, so that one rule serves elements of any
//! length and the places where the length changes.

use std::ops::RangeInclusive;

use super::marks::{Mark, MeshNode, body_radius_m};
use crate::{sizing::Sizing, string::DrillString};

/// Part of an element that a stretch may lack and still be cut once more. Between marks the
/// elements are rather longer than requested than shorter: short ones bound the step.
const SLACK: f64 = 0.2;

/// Maximum ratio of an element's length to the requested length.
const LONGEST: f64 = 1.25;

/// Part of its neighbours' length, or of the length requested where that is less, below which an
/// element is short.
const SHORTEST: f64 = 0.8;

/// Maximum number of gaps next to a short one over which it is spread.
const MAX_SPREAD: usize = 3;

/// The nodes of a string with such marks, from the bit up.
pub(super) fn nodes(string: &DrillString, marks: Vec<Mark>, sizing: &Sizing) -> Vec<MeshNode> {
    let gaps: Vec<f64> = marks
        .windows(2)
        .map(|pair| sizing.lengths_between(pair[0].from_bit_m, pair[1].from_bit_m))
        .collect();
    let node = |mark: &Mark| MeshNode {
        from_bit_m: mark.from_bit_m,
        contact_radius_m: mark.contact_radius_m,
    };
    let mut nodes = vec![node(&marks[0])];
    let mut gap = 0;
    while gap < gaps.len() {
        // The first short gap whose joints can be moved, and the gaps that are spread with it.
        let group = (gap..gaps.len().min(gap + MAX_SPREAD + 1))
            .filter(|short| is_short(&gaps, *short))
            .find_map(|short| spread(&gaps, &marks, short, gap))
            .filter(|group| *group.start() == gap);
        let (last, parts) = match group {
            Some(group) => (*group.end(), parts_of_group(&gaps, &group)),
            None => (gap, parts(gaps[gap])),
        };
        let (low, high) = (&marks[gap], &marks[last + 1]);
        let lengths: f64 = gaps[gap..=last].iter().sum();
        let first = nodes.len();
        for part in 1..parts {
            let part = lengths * part as f64 / parts as f64;
            let from_bit_m = sizing.place_above(low.from_bit_m, part);
            let contact_radius_m = body_radius_m(string, from_bit_m);
            nodes.push(MeshNode { from_bit_m, contact_radius_m });
        }
        // A joint that gave way touches at the nearest node in its place.
        for joint in &marks[gap + 1..=last] {
            let off = |node: &MeshNode| (node.from_bit_m - joint.from_bit_m).abs();
            let nearest = nodes[first..].iter_mut().min_by(|a, b| off(a).total_cmp(&off(b)));
            if let Some(node) = nearest {
                node.contact_radius_m = node.contact_radius_m.max(joint.contact_radius_m);
            }
        }
        nodes.push(node(high));
        gap = last + 1;
    }
    nodes
}

/// Whether the elements of a gap are short compared with those of its neighbours and with the
/// requested length.
fn is_short(gaps: &[f64], gap: usize) -> bool {
    let below = if gap > 0 { element_of(gaps[gap - 1]) } else { 0.0 };
    let above = gaps.get(gap + 1).copied().map_or(0.0, element_of);
    element_of(gaps[gap]) < SHORTEST * below.max(above).min(1.0)
}

/// The elements that a gap is cut into by itself, in element lengths.
fn element_of(gap: f64) -> f64 {
    gap / parts(gap) as f64
}

/// The fewest gaps around a short one, none below `first`, that can be cut into elements of
/// ordinary length once the joints between them give way; none where fixed marks are in the way.
fn spread(
    gaps: &[f64],
    marks: &[Mark],
    short: usize,
    first: usize,
) -> Option<RangeInclusive<usize>> {
    let free = |group: &RangeInclusive<usize>| {
        marks[group.start() + 1..=*group.end()].iter().all(|mark| !mark.fixed)
    };
    // To both sides alike before to one of them: nodes move less.
    [(0, 1), (1, 0), (1, 1), (0, 2), (2, 0), (1, 2), (2, 1), (0, 3), (3, 0)]
        .into_iter()
        .filter(|(below, above)| short >= first + below && short + above < gaps.len())
        .map(|(below, above)| short - below..=short + above)
        .filter(|group| free(group))
        .find(|group| {
            let unit = unit_of(gaps, group);
            let one = gaps[group.clone()].iter().sum::<f64>() / parts_of_group(gaps, group) as f64;
            (SHORTEST * unit..=LONGEST * unit).contains(&one)
        })
}

/// Length that elements of a group should have, in element lengths.
fn unit_of(gaps: &[f64], group: &RangeInclusive<usize>) -> f64 {
    gaps[group.clone()].iter().fold(0.0_f64, |most, gap| most.max(element_of(*gap))).min(1.0)
}

/// Into how many elements a group is cut.
fn parts_of_group(gaps: &[f64], group: &RangeInclusive<usize>) -> usize {
    let lengths: f64 = gaps[group.clone()].iter().sum();
    parts(lengths / unit_of(gaps, group))
}

/// Number of elements for a stretch of `lengths` times their length.
fn parts(lengths: f64) -> usize {
    let few = (lengths + SLACK).floor().max(1.0);
    let parts = if lengths > LONGEST * few { few + 1.0 } else { few };
    parts as usize
}

//! Where the nodes stand.

use super::section::Section;
use crate::string::{Blades, Component, DrillString, NEAREST_BEND_M};

/// A node of the string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshNode {
    /// Distance from the bit along the unloaded string, m.
    pub from_bit_m: f64,
    /// Radius that touches the wall here: of the joint, of the stabiliser or of the body, m.
    pub contact_radius_m: f64,
}

/// An element between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshElement {
    /// Length of the unloaded element, m.
    pub length_m: f64,
    /// Its mean section.
    pub section: Section,
}

/// The string cut into elements, from the surface down to the bit: node 0 is the top, the last node
/// the bit, element `i` lies between nodes `i` and `i + 1`.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Nodes, one more than elements.
    pub nodes: Vec<MeshNode>,
    /// Elements.
    pub elements: Vec<MeshElement>,
}

/// A place where a node must stand.
struct Mark {
    from_bit_m: f64,
    contact_radius_m: f64,
    /// The ends, the stabilisers and the bends never give way; joints do, where they crowd.
    fixed: bool,
}

/// Blades that are shorter than this touch at their middle, m: the tilt that they allow in their
/// clearance is more than a string bends over their length.
const SHORT_BLADE_M: f64 = 0.5;

/// A component without blades of its own that stands out over both its neighbours and is no longer
/// than this touches as one point, at its middle, m.
const LONGEST_BLADE_M: f64 = 4.0;

/// A joint nearer to the bit, the top, a stabiliser or the joint below than this part of the
/// element length, and than [`CROWDED_M`], has no node of its own.
const CROWDED: f64 = 0.5;

/// Longest distance over which joints give way, m.
const CROWDED_M: f64 = 2.0;

/// Part of an element that a stretch may lack and still be cut once more. Between marks the
/// elements are rather longer than requested than shorter: short ones bound the step.
const SLACK: f64 = 0.2;

/// How much longer than requested an element may be.
const LONGEST: f64 = 1.25;

/// A blade's edge nearer than this to another one or to an end of the string shares its node, m.
const SAME_M: f64 = 0.05;

/// How far a blade stands out over its neighbours, m.
const BLADE_HEIGHT_M: f64 = 1e-3;

impl Mesh {
    /// Cuts `string` into elements of about `element_length_m`, with a node at the bit, at the top,
    /// on every stabiliser, at every bend of a body and on every tool joint that is not crowded by
    /// another.
    ///
    /// Blades touch at both edges where they are longer than half a metre and half an element, so
    /// that a stabiliser resists tilting in its hole; shorter ones touch at their middle.
    pub fn new(string: &DrillString, element_length_m: f64) -> Self {
        let marks = marks(string, element_length_m);
        let mut nodes = Vec::new();
        for pair in marks.windows(2) {
            let (low, high) = (&pair[0], &pair[1]);
            let span = high.from_bit_m - low.from_bit_m;
            let parts = parts(span / element_length_m);
            nodes.push(MeshNode {
                from_bit_m: low.from_bit_m,
                contact_radius_m: low.contact_radius_m,
            });
            for part in 1..parts {
                let from_bit_m = low.from_bit_m + span * part as f64 / parts as f64;
                nodes.push(MeshNode {
                    from_bit_m,
                    contact_radius_m: body_radius_m(string, from_bit_m),
                });
            }
        }
        let top = &marks[marks.len() - 1];
        nodes.push(MeshNode { from_bit_m: top.from_bit_m, contact_radius_m: top.contact_radius_m });
        nodes.reverse();
        let elements = nodes
            .windows(2)
            .map(|pair| MeshElement {
                length_m: pair[0].from_bit_m - pair[1].from_bit_m,
                section: Section::between(string, pair[1].from_bit_m, pair[0].from_bit_m),
            })
            .collect();
        Self { nodes, elements }
    }

    /// The node nearest to a place.
    pub fn nearest_node(&self, from_bit_m: f64) -> usize {
        // The distances go down along the nodes.
        let below = self.nodes.partition_point(|n| n.from_bit_m >= from_bit_m);
        let above = below.saturating_sub(1);
        let below = below.min(self.nodes.len() - 1);
        let off = |i: usize| (self.nodes[i].from_bit_m - from_bit_m).abs();
        if off(below) < off(above) { below } else { above }
    }

    /// The node nearest to a place between the ends, the ends left out.
    ///
    /// # Panics
    /// Where the mesh has no node but the ends.
    pub fn nearest_inner_node(&self, from_bit_m: f64) -> usize {
        let off = |i: &usize| (self.nodes[*i].from_bit_m - from_bit_m).abs();
        (1..self.nodes.len() - 1)
            .min_by(|a, b| off(a).total_cmp(&off(b)))
            .expect("a bend has a node between the ends")
    }

    /// From how many nodes to how many most of the string has a node that stands out over the one
    /// below it, as tool joints do; one where there is no such rule.
    pub fn nodes_per_joint(&self) -> usize {
        let stands_out = |pair: &[MeshNode]| {
            pair[0].contact_radius_m > pair[1].contact_radius_m + BLADE_HEIGHT_M
        };
        let pairs = self.nodes.windows(2).enumerate();
        let joints: Vec<usize> = pairs.filter(|(_, p)| stands_out(p)).map(|(i, _)| i).collect();
        let gaps = || joints.windows(2).map(|pair| pair[1] - pair[0]);
        let many = |gap: usize| gaps().filter(|g| *g == gap).count() * gap;
        gaps().find(|gap| 2 * many(*gap) > self.nodes.len()).unwrap_or(1)
    }

    /// Length of the unloaded string, m.
    pub fn length_m(&self) -> f64 {
        self.nodes[0].from_bit_m
    }

    /// Half of each neighbouring element: the length that a node answers for, m.
    pub fn tributary_length_m(&self, node: usize) -> f64 {
        let above = if node > 0 { self.elements[node - 1].length_m } else { 0.0 };
        let below = self.elements.get(node).map_or(0.0, |e| e.length_m);
        0.5 * (above + below)
    }
}

/// What touches between marks: the blades, where they are, or the body.
fn body_radius_m(string: &DrillString, from_bit_m: f64) -> f64 {
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

/// Where the blades of a component touch that reaches from `bottom` to `top`: distances from the
/// bit, m.
fn blade_places_m(blades: &Blades, bottom: f64, top: f64, element_length_m: f64) -> Vec<f64> {
    let middle = 0.5 * (bottom + top);
    let half = 0.5 * blades.length_m;
    if blades.length_m > SHORT_BLADE_M.max(CROWDED * element_length_m) {
        vec![middle - half, middle + half]
    } else {
        vec![middle]
    }
}

fn marks(string: &DrillString, element_length_m: f64) -> Vec<Mark> {
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
    // A bend takes the node of a bit or a blade that is next to it.
    for span in string.spans() {
        let Some(bend) = span.component.bend else {
            continue;
        };
        let from_bit_m = span.from_bit_m + bend.from_lower_end_m;
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
    thin(marks, element_length_m)
}

/// Number of elements for a stretch of `lengths` times their length.
fn parts(lengths: f64) -> usize {
    let few = (lengths + SLACK).floor().max(1.0);
    let parts = if lengths > LONGEST * few { few + 1.0 } else { few };
    parts as usize
}

/// Whether a component stands out over both its neighbours over a short length: a stabiliser, a
/// reamer. The bit is no neighbour to stand out from, and is none itself.
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
fn thin(marks: Vec<Mark>, element_length_m: f64) -> Vec<Mark> {
    let near = (CROWDED * element_length_m).min(CROWDED_M);
    let fixed: Vec<f64> = marks.iter().filter(|m| m.fixed).map(|m| m.from_bit_m).collect();
    let mut kept: Vec<Mark> = Vec::with_capacity(marks.len());
    for mark in marks {
        let crowds_fixed = !mark.fixed && fixed.iter().any(|f| (f - mark.from_bit_m).abs() < near);
        let crowds_last =
            !mark.fixed && kept.last().is_some_and(|last| mark.from_bit_m - last.from_bit_m < near);
        if !crowds_fixed && !crowds_last {
            kept.push(mark);
        }
    }
    kept
}

//! Bending of the elements between their nodes: [`beam_column`](crate::rod::beam_column).

use nalgebra::Vector3;

use super::{state::State, string_in_hole::StringInHole};
use crate::{
    ends::{BitEnd, TopEnd},
    rod::{
        beam_column::{BeamColumn, Middle},
        mesh::Mesh,
    },
    simd::vector::Vector,
};

/// Bending moments and sag of an element.
#[derive(Debug, Clone, Copy)]
struct Bent {
    /// Moment at the upper and at the lower end and half-way, N·m, towards the centre of curvature.
    ends_N_m: [Vector3<f64>; 2],
    half_way_N_m: Vector3<f64>,
    sag_m: f64,
    touches: f64,
    /// Rotational stiffness of its upper and its lower end, N·m.
    holds_N_m: [f64; 2],
    /// Carry-over factor: part of a moment on one end that reaches the other.
    carry_over: f64,
    /// Moment half-way over the moment that turns one end.
    to_half_way: f64,
    /// `cosh (L/4)√(T/EI)`, in compression a cosine, down to that of Euler's load.
    quarter: f64,
}

impl Bent {
    /// Excess of the largest moment along the element over those at its ends and half-way, N·m.
    /// Between `M1`, `M2` and `Mh` half-way the beam-column has at the quarter points
    /// `Mh + (E − Mh)/(2 (c + 1)) ± O/(2 c)`, with `E` and `O` the mean and half the difference of
    /// the ends and `c = cosh (L/4)√(T/EI)`. The peak is that of the parabola through each end, the
    /// quarter point next to it and the middle.
    fn peak_excess_N_m(&self, [upper, lower]: [Vector3<f64>; 2]) -> f64 {
        let half_way = self.half_way_N_m;
        let (mean, half) = ((upper + lower) * 0.5, (upper - lower) * 0.5);
        let even = half_way + (mean - half_way) / (2.0 * (self.quarter + 1.0));
        let odd = half / (2.0 * self.quarter);
        let known_N_m = upper.norm().max(lower.norm()).max(half_way.norm());
        let halves = [[upper, even + odd, half_way], [lower, even - odd, half_way]];
        let peak_N_m = halves.map(|half| {
            let largest = half.iter().max_by(|a, b| a.norm().total_cmp(&b.norm()));
            let along = largest.and_then(|moment| moment.try_normalize(0.0)).unwrap_or_default();
            peak(half.map(|moment| moment.dot(&along)))
        });
        peak_N_m[0].max(peak_N_m[1]) - known_N_m
    }
}

/// Returns the peak of the parabola through three values at equal distances where it is between
/// them, else the middle value.
fn peak([before, middle, after]: [f64; 3]) -> f64 {
    let (rises, bends) = (0.5 * (after - before), before - 2.0 * middle + after);
    if bends < 0.0 && rises.abs() <= -bends { middle - 0.5 * rises * rises / bends } else { middle }
}

/// Upper limit of `(L/4)√(T/EI)`: beyond it the quarter points bend like the middle.
const MOST_ROOT: f64 = 30.0;

/// An element's ends.
const UPPER: usize = 0;
const LOWER: usize = 1;

/// Releases the ends of the string that are free to tilt. The moment of the element there is
/// carried over to its other end, and its difference from the moment of the next element to the far
/// end of that element, as in the [dynamics](crate::dynamics).
fn release(elements: &mut [Bent], ends: &crate::ends::Ends) {
    if ends.top != TopEnd::Clamped {
        release_end(elements.iter_mut(), UPPER);
    }
    if ends.bit != BitEnd::Clamped {
        release_end(elements.iter_mut().rev(), LOWER);
    }
}

/// Releases an end of the first of the elements, which are ordered from that end on.
fn release_end<'a>(mut elements: impl Iterator<Item = &'a mut Bent>, end: usize) {
    let other = 1 - end;
    let Some(own) = elements.next() else { return };
    let released = std::mem::take(&mut own.ends_N_m[end]);
    own.ends_N_m[other] += released * own.carry_over;
    own.half_way_N_m -= released * own.to_half_way;
    own.holds_N_m[other] *= 1.0 - own.carry_over * own.carry_over;
    let Some(next) = elements.next() else { return };
    let takes = next.holds_N_m[end] / (next.holds_N_m[end] + own.holds_N_m[other]);
    let differs = own.ends_N_m[other] - next.ends_N_m[end];
    next.ends_N_m[other] -= differs * (takes * next.carry_over);
}

/// Bending moments at the nodes and in the elements below them, from the top down.
#[derive(Debug, Clone, Default)]
pub(super) struct Bending {
    /// At the node, N·m.
    pub(super) at_node_N_m: Vec<f64>,
    /// Difference between the moments of the elements on the two sides of the node, N·m, which is
    /// due to their finite lengths.
    pub(super) jump_N_m: Vec<f64>,
    /// The same as a vector towards the centre of curvature.
    pub(super) towards_N_m: Vec<Vector3<f64>>,
    /// Half-way to the next node, N·m; zero at the bit.
    pub(super) between_N_m: Vec<f64>,
    /// Excess of the largest moment on the way to the next node over those at both nodes and
    /// half-way, N·m.
    pub(super) peak_excess_N_m: Vec<f64>,
    /// Sag half-way, m.
    pub(super) sag_m: Vec<f64>,
    /// One where the body touches the wall half-way, else zero.
    pub(super) touches: Vec<f64>,
}

impl Bending {
    /// Computes the moments of the string in its state.
    pub(super) fn of(string: &StringInHole, state: &State, mesh: &Mesh) -> Self {
        let mut elements: Vec<Bent> =
            (0..string.elements.len()).map(|index| bent(string, state, mesh, index)).collect();
        release(&mut elements, &string.ends);
        let mut bending = Self::default();
        for index in 0..string.nodes.len() {
            let above = index.checked_sub(1).map(|above| &elements[above]);
            let below = elements.get(index);
            // The moments on the two sides of a node differ only by the error of the mesh: their
            // mean, weighted by the stiffnesses of the two sides.
            let moment = match (above, below) {
                (Some(above), Some(below)) => {
                    let [above_N_m, below_N_m] = [above.holds_N_m[LOWER], below.holds_N_m[UPPER]];
                    let part = above_N_m / (above_N_m + below_N_m);
                    below.ends_N_m[UPPER] * part + above.ends_N_m[LOWER] * (1.0 - part)
                }
                (None, Some(below)) if string.ends.top == TopEnd::Clamped => below.ends_N_m[UPPER],
                (Some(above), None) if string.ends.bit == BitEnd::Clamped => above.ends_N_m[LOWER],
                // An end that is free to tilt carries none.
                _ => Vector3::zeros(),
            };
            let jump = above
                .zip(below)
                .map(|(above, below)| below.ends_N_m[UPPER] - above.ends_N_m[LOWER]);
            bending.at_node_N_m.push(moment.norm());
            bending.jump_N_m.push(jump.map_or(0.0, |jump| jump.norm()));
            bending.towards_N_m.push(moment);
            bending.between_N_m.push(below.map_or(0.0, |element| element.half_way_N_m.norm()));
            bending.sag_m.push(below.map_or(0.0, |element| element.sag_m));
            bending.touches.push(below.map_or(0.0, |element| element.touches));
        }
        for (index, element) in elements.iter().enumerate() {
            let ends = [bending.towards_N_m[index], bending.towards_N_m[index + 1]];
            bending.peak_excess_N_m.push(element.peak_excess_N_m(ends));
        }
        bending
    }
}

fn bent(string: &StringInHole, state: &State, mesh: &Mesh, index: usize) -> Bent {
    let (element, section) = (&string.elements[index], &mesh.elements[index].section);
    let [upper, lower] = [index, index + 1].map(|node| state.moved_m(string, node));
    let k = &element.stiffness;
    let length_m = k.length;
    let t = state.chord_m(string, index).normalize();
    let across = |v: Vector3<f64>| v - t * t.dot(&v);
    let d1 = element.seen(&state.heading[index]);
    let d2 = state.heading[index + 1].along;
    let (odd, even) = (across(d1 + d2), across(d2 - d1));
    let tension_N = state.tension_N[index];
    let stiffness_N_m2 = section.bending_stiffness_N_m2;
    let pull_N_per_m = tension_N / length_m;
    let weight_N_per_m = across(Vector3::z()) * string.in_fluid[index].weight_N_per_m;
    let load = even * pull_N_per_m + weight_N_per_m;
    let column = BeamColumn::of(tension_N * length_m * length_m / (64.0 * stiffness_N_m2));
    let nodes = [&string.nodes[index], &string.nodes[index + 1]];
    // Half-way, the hole's axis is off its chord by `L/8` times the difference of its directions.
    let hole = nodes[1].axes[2] - nodes[0].axes[2];
    let chord_middle = (upper + lower) * 0.5 + across(hole) * (0.125 * length_m);
    let middle = Middle {
        load: Vector::from(load),
        offset: Vector::from(across(chord_middle - even * (0.125 * length_m))),
        clearance: string.elements[index].body_clearance_m,
    };
    let shape = column.bent(length_m, stiffness_N_m2, &middle);
    let by = |part: f64| even * (k.bending + part * pull_N_per_m) + weight_N_per_m * part;
    // `EI/L`, of which shear takes its part.
    let turned = (k.bending_far + k.bending) / 3.0 * column.odd();
    let (at_ends, off) = (by(shape.at_ends), odd * turned);
    let stiff = |part: f64| k.bending + pull_N_per_m * part;
    let holds_N_m = stiff(shape.at_ends) + turned;
    Bent {
        ends_N_m: [at_ends - off, at_ends + off],
        half_way_N_m: by(shape.half_way),
        sag_m: shape.sag,
        touches: shape.touches,
        holds_N_m: [holds_N_m; 2],
        carry_over: (turned - stiff(shape.at_ends)) / holds_N_m,
        to_half_way: stiff(shape.half_way) / holds_N_m,
        quarter: quarter(tension_N * length_m * length_m / (16.0 * stiffness_N_m2)),
    }
}

/// Returns `cosh z` for `z²`; a cosine where `z²` is negative.
fn quarter(square: f64) -> f64 {
    if square < 0.0 {
        libm::cos((-square).sqrt().min(std::f64::consts::FRAC_PI_4))
    } else {
        libm::cosh(square.sqrt().min(MOST_ROOT))
    }
}

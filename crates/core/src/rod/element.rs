//! One element of the rod: its energy, and the forces that follow from it.
//!
//! A two-node beam with unit directors `d1`, `d2`, the normals of the cross-sections at its ends.
//! With the chord's direction `t` and length `l`, `c1 = t·d1`, `c2 = t·d2`, `c12 = d1·d2`, and the
//! rest length `L`,
//!
#![doc = include_str!("../../equations/element-energy.html")]
//!
//! Forces and moments are its gradient. Theory, with `a`, `b`, `A₀` and `B₀`:
//! `docs/src/theory/rod.md`.

use super::section::Section;
pub use super::section::shear_factor;
use crate::simd::{
    number::{Number, Real},
    vector::Vector,
};

/// Properties of an element, prepared for the time loop.
#[derive(Debug, Clone, Copy)]
pub struct Stiffness<N> {
    /// Rest length `L`, m.
    pub length: N,
    /// `EA/L`, N/m.
    pub axial: N,
    /// `B₀ EI/L`, N·m.
    pub bending_far: N,
    /// `a L/2`, m: half of how tension stiffens a director against its own chord.
    pub half_bow_near: N,
    /// `b L`, m: how tension couples the two directors.
    pub bow_far: N,
    /// `GJ/L`, N·m.
    pub twist: N,
    /// `EI/L`, N·m: stiffness-proportional damping acts on it, too.
    pub bending: N,
}

impl Stiffness<f64> {
    /// The stiffness of `section` over the length `length_m`.
    pub fn new(section: &Section, length_m: f64) -> Self {
        let l = length_m;
        let ei = section.bending_stiffness_N_m2;
        // φ weighs shear against bending; A₀, B₀, a and b follow from it.
        let phi = 12.0 * ei / (section.shear_stiffness_N * l * l);
        let over = 1.0 / (1.0 + phi);
        let bow = phi / 6.0 + phi * phi / 12.0;
        Self {
            length: l,
            axial: section.axial_stiffness_N / l,
            bending_far: ei / l * (2.0 - phi) * over,
            half_bow_near: 0.5 * (2.0 / 15.0 + bow) * over * over * l,
            bow_far: (1.0 / 30.0 + bow) * over * over * l,
            twist: section.torsional_stiffness_N_m2 / l,
            bending: ei / l,
        }
    }
}

impl<N: Number> Stiffness<N> {
    /// `A₀ EI/L`, N·m: `A₀ = B₀ + 2`.
    #[inline(always)]
    pub fn bending_near(&self) -> N {
        self.bending_far + (self.bending + self.bending)
    }
}

/// Pose and motion of an element.
#[derive(Debug, Clone, Copy)]
pub struct Pose<N> {
    /// Chord of the element when both ends are on their anchors, m.
    pub anchor_chord: Vector<N>,
    /// `|anchor_chord|² − L²`, m²: kept apart so that the stretch loses no digits.
    pub anchor_excess: N,
    /// Displacement of end 2 from its anchor less that of end 1, m.
    pub displacement: Vector<N>,
    /// Velocity of end 2 less that of end 1, m/s.
    pub velocity: Vector<N>,
    /// Director of end 1.
    pub d1: Vector<N>,
    /// Director of end 2.
    pub d2: Vector<N>,
    /// Angular velocity of end 1 across its director, rad/s.
    pub w1: Vector<N>,
    /// Angular velocity of end 2 across its director, rad/s.
    pub w2: Vector<N>,
    /// Spin of end 2 less that of end 1, rad/s.
    pub spin: N,
    /// Twist at the beginning of the step, rad.
    pub twist: N,
}

/// Forces and moments of an element on its ends.
#[derive(Debug, Clone, Copy)]
pub struct Reaction<N> {
    /// Force on end 2, N; end 1 takes the opposite.
    pub force: Vector<N>,
    /// Bends end 1, N·m: the moment `bend1 × d1`.
    pub bend1: Vector<N>,
    /// Bends end 2, N·m: the moment `bend2 × d2`.
    pub bend2: Vector<N>,
    /// Moment of torque and bending damping on end 1, N·m; end 2 takes the opposite. It holds the
    /// torque about the director, too.
    pub couple: Vector<N>,
    /// Torque `M`, N·m: about the director, `+M` on end 1 and `−M` on end 2.
    pub torque: N,
    /// Effective tension, N.
    pub tension: N,
    /// Twist at the end of the step, rad.
    pub twist: N,
    /// Power lost to stiffness-proportional damping, W.
    pub damping_power: N,
}

impl<N: Number> Reaction<N> {
    /// Moment across the director on end 1, whose director is `d1`, N·m.
    pub fn moment1(&self, d1: Vector<N>) -> Vector<N> {
        across(self.bend1, self.couple, d1)
    }

    /// Moment across the director on end 2, whose director is `d2`, N·m.
    pub fn moment2(&self, d2: Vector<N>) -> Vector<N> {
        across(self.bend2, -self.couple, d2)
    }
}

/// Moment across a director: the bending part, and a couple without its part about the director.
/// Sums over the elements of a node can be used as well as those of one element.
#[inline(always)]
pub(crate) fn across<N: Number>(
    bend: Vector<N>,
    couple: Vector<N>,
    director: Vector<N>,
) -> Vector<N> {
    bend.cross(director) + couple.minus(director, couple.dot(director))
}

/// Forces of an element in `pose`, with its twist first advanced by `dt`, with
/// stiffness-proportional damping of time constant `beta`.
///
/// The damping acts on the rates of the chord's length, of the twist and of the directors' rotation
/// against one another, `w2 − w1`. None of them is there when a bent pipe spins in place, so the
/// damping never drives whirl; a bent pipe that whirls as one rigid body loses a little by the
/// last.
#[inline(always)]
pub fn react<N: Number>(k: &Stiffness<N>, p: &Pose<N>, dt: N, beta: N) -> Reaction<N> {
    let twisted = twist(k, p, dt, beta);
    let chord = chord(k, p);
    let strained = strain(k, &chord, p, twisted.apart, beta);
    let bent = bend(&chord, p, &strained.strain);
    Reaction {
        force: bent.force,
        bend1: bent.bend1,
        bend2: bent.bend2,
        couple: twisted.couple,
        torque: twisted.torque,
        tension: strained.tension,
        twist: twisted.twist,
        damping_power: strained.damping_power + twisted.damping_power,
    }
}

/// The chord of an element.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Chord<N> {
    /// Its direction `t`.
    pub direction: Vector<N>,
    /// `1/l`, 1/m.
    pub inverse_length: N,
    /// `l − L`, m.
    pub longer: N,
}

/// The chord between two nodes. The root and the division do not wait for one another.
#[inline(always)]
pub(crate) fn chord<N: Number>(k: &Stiffness<N>, p: &Pose<N>) -> Chord<N> {
    let r = p.anchor_chord + p.displacement;
    if N::Real::FINE {
        // Enough digits to take one length from the other.
        let l2 = r.dot(r);
        let l = l2.sqrt();
        let inverse_length = l * (N::splat(1.0) / l2);
        return Chord { direction: r.scaled(inverse_length), inverse_length, longer: l - k.length };
    }
    // l² − L², without cancellation.
    let excess = (p.anchor_chord + r).dot(p.displacement) + p.anchor_excess;
    let l2 = k.length.mul_add(k.length, excess);
    let l = l2.sqrt();
    let inverse_length = l * (N::splat(1.0) / l2);
    // l − L, and the part lost to its own cancellation: excess = (l − L)(l − L + 2L).
    let longer = l - k.length;
    let lost = longer.neg_mul_add(longer + (k.length + k.length), excess);
    Chord {
        direction: r.scaled(inverse_length),
        inverse_length,
        longer: (N::splat(0.5) * inverse_length).mul_add(lost, longer),
    }
}

/// Strain of an element: the generalised forces on its chord and its two directors.
///
/// `U`'s gradients are `b d2 − s1 t` and `b d1 − s2 t` on the directors, without the part along the
/// own director, and `−(s1 d1 + s2 d2)/l` on the chord, without the part along it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Strain<N> {
    /// `s1 = a c1 + b c2`, N·m.
    pub near1: N,
    /// `s2 = a c2 + b c1`, N·m.
    pub near2: N,
    /// `b`, N·m.
    pub shared: N,
    /// The tension less the part of the directors' pull along the chord, N.
    pub along: N,
}

/// A strain, and the intermediate values of its computation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Strained<N> {
    /// Inputs of [`bend`].
    pub strain: Strain<N>,
    /// As in [`Reaction`].
    pub tension: N,
    /// Power lost to damping, W.
    pub damping_power: N,
}

/// Tension and bending.
///
/// Angles are small compared with one: all expressions of them are written over the differences `d1
/// − t`, `d2 − t` and `d2 − d1`, which are exact, and their squares `2(1 − cos)`; a cosine's own
/// last digit is a large part of `1 − c²`. `apart`, `1 − c12`, comes from the [`twist`].
#[inline(always)]
pub(crate) fn strain<N: Number>(
    k: &Stiffness<N>,
    chord: &Chord<N>,
    p: &Pose<N>,
    apart: N,
    beta: N,
) -> Strained<N> {
    let off = Off::of(chord, p, apart);
    let elastic_tension = k.axial * off.longer(k, chord);
    let lengthening = chord.direction.dot(p.velocity);
    let damping_tension = k.axial * (beta * lengthening);
    let tension = elastic_tension + damping_tension;
    Strained {
        strain: off.strain(k, chord, elastic_tension, tension),
        tension,
        damping_power: damping_tension * lengthening,
    }
}

/// Elongation of an element, its bowing included, m: `ε L`.
pub(crate) fn longer(k: &Stiffness<f64>, chord: &Chord<f64>, p: &Pose<f64>) -> f64 {
    Off::of(chord, p, apart(p)).longer(k, chord)
}

/// Strain of an element of that shape with a known tension, N.
pub(crate) fn strain_under(
    k: &Stiffness<f64>,
    chord: &Chord<f64>,
    p: &Pose<f64>,
    tension: f64,
) -> Strain<f64> {
    Off::of(chord, p, apart(p)).strain(k, chord, tension, tension)
}

/// `1 − c12`.
#[inline(always)]
fn apart<N: Number>(p: &Pose<N>) -> N {
    let bend = p.d2 - p.d1;
    N::splat(0.5) * bend.dot(bend)
}

/// Deviations of the directors from the chord and from each other: `1 − c1`, `1 − c2`, `c1`, `c2`,
/// `1 − c12`.
#[derive(Clone, Copy)]
struct Off<N> {
    x1: N,
    x2: N,
    c1: N,
    c2: N,
    apart: N,
}

impl<N: Number> Off<N> {
    #[inline(always)]
    fn of(chord: &Chord<N>, p: &Pose<N>, apart: N) -> Self {
        let half = N::splat(0.5);
        let t = chord.direction;
        let (off1, off2) = (p.d1 - t, p.d2 - t);
        let (x1, x2) = (half * off1.dot(off1), half * off2.dot(off2));
        let one = N::splat(1.0);
        Self { x1, x2, c1: one - x1, c2: one - x2, apart }
    }

    /// `(1 − c1²) + (1 − c2²)` and `c12 − c1 c2`.
    #[inline(always)]
    fn bows(&self) -> (N, N) {
        let one = N::splat(1.0);
        let Self { x1, x2, c1, c2, apart } = *self;
        // By 1 − c² = x (1 + c) with x = 1 − c, and c12 − c1 c2 = x1 c2 + x2 − (1 − c12).
        (x1.mul_add(one + c1, x2 * (one + c2)), x1.mul_add(c2, x2 - apart))
    }

    /// `ε L`: the chord's stretch, bowing by the two directors, and their common part.
    #[inline(always)]
    fn longer(&self, k: &Stiffness<N>, chord: &Chord<N>) -> N {
        let (near, far) = self.bows();
        k.bow_far.neg_mul_add(far, k.half_bow_near.mul_add(near, chord.longer))
    }

    /// The strain under an elastic tension, which stiffens, and the whole one, N: damping knows
    /// the chord alone, it neither stiffens the directors nor works on them.
    #[inline(always)]
    fn strain(&self, k: &Stiffness<N>, chord: &Chord<N>, elastic: N, tension: N) -> Strain<N> {
        let Self { x1, x2, c1, c2, .. } = *self;
        // A = A₀ EI/L + a L T and B = B₀ EI/L − b L T: tension stiffens, compression softens.
        let a = k.half_bow_near.mul_add(elastic + elastic, k.bending_near());
        let b = k.bow_far.neg_mul_add(elastic, k.bending_far);
        let s1 = a.mul_add(c1, b * c2);
        let s2 = a.mul_add(c2, b * c1);
        // `bend` pulls with s (d − t)/l, which has −s x/l along the chord: taken out here, the
        // force along the chord is the tension.
        let along = chord.inverse_length.neg_mul_add(s1.mul_add(x1, s2 * x2), tension);
        Strain { near1: s1, near2: s2, shared: b, along }
    }
}

/// Forces of tension and bending.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bent<N> {
    /// As in [`Reaction`].
    pub force: Vector<N>,
    /// As in [`Reaction`].
    pub bend1: Vector<N>,
    /// As in [`Reaction`].
    pub bend2: Vector<N>,
}

/// Forces and moments on its ends of an element with this strain.
#[inline(always)]
pub(crate) fn bend<N: Number>(chord: &Chord<N>, p: &Pose<N>, strain: &Strain<N>) -> Bent<N> {
    let t = chord.direction;
    let part1 = (p.d1 - t).scaled(strain.near1);
    let part2 = (p.d2 - t).scaled(strain.near2);
    let shared = (p.d2 - p.d1).scaled(strain.shared);
    Bent {
        force: (part1 + part2).scaled(chord.inverse_length).minus(t, strain.along),
        bend1: part1 + shared,
        bend2: part2 - shared,
    }
}

/// Forces of the twist.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Twisted<N> {
    /// As in [`Reaction`].
    pub couple: Vector<N>,
    /// As in [`Reaction`].
    pub torque: N,
    /// As in [`Reaction`].
    pub twist: N,
    /// Power lost to damping, that of bending included, W.
    pub damping_power: N,
    /// `1 − c12`.
    pub apart: N,
}

/// Twist, and the damping of bending: `τ' = s2 − s1 + (w2·d1 − w1·d2)/(1 + c12)`, rad/s.
#[inline(always)]
pub(crate) fn twist<N: Number>(k: &Stiffness<N>, p: &Pose<N>, dt: N, beta: N) -> Twisted<N> {
    let half = N::splat(0.5);
    let bend = p.d2 - p.d1;
    let e = apart(p);
    // 1/(1 + c12) by its series in e = 1 − c12: within 1e-8 for a bend of 12° in an element, 4e-8
    // for 15°, and the same in the rate and in its moments, so that no work is lost.
    let share =
        e.mul_add(e.mul_add(e.mul_add(N::splat(0.0625), N::splat(0.125)), N::splat(0.25)), half);
    // w2·d1 − w1·d2, for each is across its own director.
    let rate = (p.w1 + p.w2).dot(bend).neg_mul_add(share, p.spin);
    let twist = rate.mul_add(dt, p.twist);
    let damping_torque = k.twist * (beta * rate);
    let torque = k.twist.mul_add(twist, damping_torque);
    // Damping of bending acts on the rate between the directors, none in a bent pipe that spins.
    let turning = p.w2 - p.w1;
    let bending_damping = beta * k.bending;
    Twisted {
        // M (d1 + d2)/(1 + c12): the torque about the directors and its part across them.
        couple: (p.d1 + p.d2).scaled(torque * share).plus(turning, bending_damping),
        torque,
        twist,
        damping_power: damping_torque.mul_add(rate, bending_damping * turning.dot(turning)),
        apart: e,
    }
}

/// Elastic energy of an element in `pose`, J.
pub fn energy(k: &Stiffness<f64>, p: &Pose<f64>) -> f64 {
    let r = p.anchor_chord + p.displacement;
    let l = r.dot(r).sqrt();
    let t = r.scaled(1.0 / l);
    let (c1, c2, c12) = (t.dot(p.d1), t.dot(p.d2), p.d1.dot(p.d2));
    // The terms of ε and U.
    let near = 2.0 - c1 * c1 - c2 * c2;
    let far = c12 - c1 * c2;
    let excess =
        (p.anchor_chord.scaled(2.0) + p.displacement).dot(p.displacement) + p.anchor_excess;
    let longer = excess / (l + k.length) + k.half_bow_near * near - k.bow_far * far;
    0.5 * k.axial * longer * longer
        + 0.5 * k.bending_near() * near
        + k.bending_far * far
        + 0.5 * k.twist * p.twist * p.twist
}

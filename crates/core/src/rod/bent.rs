//! A bend fixed in the body: a bent housing, a bent sub, one of the many bends of a curved rod.
//!
//! The element above the node sees the node's director `d`, the element below it
//! `d' = cos θ d + sin θ m`, with the bend's angle `θ` and direction `m` across `d`. All else is an
//! ordinary [`element`](super::element). Theory: `docs/src/theory/bends.md`.

use super::element::{Pose, Reaction};
use crate::simd::vector::Vector;

/// The director of the element below a bend.
pub fn director_below(director: Vector<f64>, toward: Vector<f64>, angle_rad: f64) -> Vector<f64> {
    let (sine, cosine) = libm::sincos(angle_rad);
    director.scaled(cosine).plus(toward, sine)
}

/// The pose of the element below a bend: `pose` is the one that the node's own director gives,
/// `spin` the node's spin about it, rad/s, `below` the [director below](director_below). With the
/// whole angular velocity `ω = w + s d` it is `w' = ω − (ω·d') d'`, `s' = ω·d'`.
pub fn pose_below(pose: &Pose<f64>, spin: f64, below: Vector<f64>) -> Pose<f64> {
    let turn = pose.w1.plus(pose.d1, spin);
    let about = turn.dot(below);
    Pose { d1: below, w1: turn.minus(below, about), spin: pose.spin + spin - about, ..*pose }
}

/// The whole moment of an element on its upper node, N·m; `d1` is the director that the element
/// sees there.
pub fn moment_above(reaction: &Reaction<f64>, d1: Vector<f64>) -> Vector<f64> {
    reaction.moment1(d1).plus(d1, reaction.torque)
}

/// The whole moment of an element on its lower node, N·m.
pub fn moment_below(reaction: &Reaction<f64>, d2: Vector<f64>) -> Vector<f64> {
    reaction.moment2(d2).minus(d2, reaction.torque)
}

/// `vector` turned by the least rotation that takes the unit vector `from` to `to`. A rod that
/// bends without twisting carries directions across its axis along it like this; so does a node
/// that moves without spinning.
pub fn transported(vector: Vector<f64>, from: Vector<f64>, to: Vector<f64>) -> Vector<f64> {
    // For a vector across `from`; a part along it goes to `to`.
    let along = vector.dot(from);
    let across = vector.minus(from, along);
    let share = across.dot(to) / (1.0 + from.dot(to));
    across.minus(from + to, share).plus(to, along)
}

/// A direction across the director and fixed in the body, after the director went from `from` to
/// `to` and the body spun by `turn_rad` about it. Of unit length and across the director to
/// rounding.
pub fn carried(
    mark: Vector<f64>,
    from: Vector<f64>,
    to: Vector<f64>,
    turn_rad: f64,
) -> Vector<f64> {
    let moved = transported(mark, from, to);
    let (sine, cosine) = libm::sincos(turn_rad);
    let turned = moved.scaled(cosine).plus(to.cross(moved), sine);
    let across = turned.minus(to, turned.dot(to));
    across.scaled(1.0 / across.dot(across).sqrt())
}

/// Twist of an element whose ends carry the marks `m1` and `m2`, fixed in the body and parallel
/// where it is not twisted, rad, between −π and π: the angle of `m2` against `m1` brought along the
/// element without twisting. Its rate is the `τ'` of the [element](super::element).
pub fn twist(m1: Vector<f64>, d1: Vector<f64>, m2: Vector<f64>, d2: Vector<f64>) -> f64 {
    let brought = transported(m1, d1, d2);
    libm::atan2(d2.dot(brought.cross(m2)), brought.dot(m2))
}

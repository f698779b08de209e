//! Effect of an eccentric centre of mass on a node's step.
//!
//! With the imbalance `U = Σ m e` (kg·m) in the direction `q`, fixed in the body and across the
//! director, and the angular velocity `ω = w + s d`,
//!
//! ```text
//! M v' + U (ω × q)' = F            the centre of mass is thrown outwards
//! I ω' + U q × v'   = m + U q × g  a sideways acceleration turns the pipe, and gravity does
//! ```
//!
//! The force from the rotation of `q` at the present `ω` acts in the step, so that the wall carries
//! it like weight; the effect of the step's changes of `ω` and `v` is added after it, solved
//! together. `q` is known at the positions; half a step before, where the velocities are, it is the
//! middle of two of them. In a step the director turns by a small angle, and so does the pipe about
//! it: roots, sines and cosines are the first terms of their series. Theory:
//! `docs/src/theory/bends.md`.

use crate::simd::{
    number::{Number, Real},
    vector::Vector,
};

/// Force and moment in the step, and the follow-up after it.
#[derive(Debug, Clone, Copy)]
pub struct Throw<N> {
    /// `−ω × (ω × q)`, 1/s²: times `U`, the force that throws the node outwards.
    pub outwards: Vector<N>,
    /// `ω × q` in the middle of the step that this leads to from that in the middle of the last,
    /// 1/s.
    pub led: Vector<N>,
}

/// Effect of the rotation of `q`, which was `half` in the middle of the last step, on the next
/// step.
#[inline(always)]
pub fn throw<N: Number>(toward: Vector<N>, half: Vector<N>, omega: Vector<N>, dt: N) -> Throw<N> {
    let inwards = omega.cross(omega.cross(toward));
    Throw { outwards: -inwards, led: omega.cross(half).plus(inwards, dt) }
}

/// A direction that is fixed in the body, as the step has turned it.
#[derive(Debug, Clone, Copy)]
pub struct Turned<N> {
    /// Across the new director, not yet turned about it.
    pub tilted: Vector<N>,
    /// Across both.
    pub across: Vector<N>,
    /// Change of the direction, kept separately because it is small.
    pub gain: Vector<N>,
    /// The direction half a step before, where the velocities are.
    pub half: Vector<N>,
    /// Cosine of the angle between that and `tilted`.
    pub cosine: N,
    /// One less the cosine of the whole angle.
    pub versine: N,
}

/// `toward` turned by the least rotation that takes `from`, across which it is, to `to`, and by
/// `angle` about that: [`super::bent::carried`] but for the fourth power of the director's turn in
/// the step and the seventh of the angle. That turn is left out of the length of `half`, of which
/// an eighth of its square is missing: of a turn by 1e-5, 1e-11.
#[inline(always)]
pub fn turned<N: Number>(toward: Vector<N>, from: Vector<N>, to: Vector<N>, angle: N) -> Turned<N> {
    let (splat, half, one) = (N::splat, N::splat(0.5), N::splat(1.0));
    let (both, share) = (from + to, half * toward.dot(to));
    let tilted = toward.minus(both, share);
    let across = to.cross(tilted);
    // sin a, 1 − cos a and 1/cos(a/2).
    let x = angle * angle;
    let sine = x.mul_add(splat(1.0 / 120.0), splat(-1.0 / 6.0));
    let sine = angle * x.mul_add(sine, one);
    let versine = x.mul_add(splat(1.0 / 720.0), splat(-1.0 / 24.0));
    let versine = x * x.mul_add(versine, half);
    let secant = x.mul_add(splat(61.0 / 46080.0), splat(5.0 / 384.0));
    let secant = x.mul_add(x.mul_add(secant, splat(1.0 / 8.0)), one);
    let gain = across.scaled(sine).minus(tilted, versine).minus(both, share);
    Turned {
        tilted,
        across,
        gain,
        half: toward.plus(gain, half).scaled(secant),
        cosine: secant.neg_mul_add(half * versine, secant),
        versine,
    }
}

/// Inverses of a node's inertia.
#[derive(Debug, Clone, Copy)]
pub struct Mobility<N> {
    /// Tangent of the hole: less mass moves along it than across it.
    pub tangent: Vector<N>,
    /// Across the hole, 1/kg.
    pub lateral: N,
    /// Along the hole, 1/kg.
    pub axial: N,
    /// About the director, 1/(kg·m²).
    pub polar: N,
    /// Across the director, 1/(kg·m²).
    pub rotary: N,
}

/// Motion of a node.
#[derive(Debug, Clone, Copy)]
pub struct Motion<N> {
    /// Director.
    pub director: Vector<N>,
    /// Velocity, m/s.
    pub velocity: Vector<N>,
    /// Angular velocity across the director, rad/s.
    pub turning: Vector<N>,
    /// Spin about it, rad/s.
    pub spin: N,
}

/// Change of a node's momenta by their balance.
#[derive(Debug, Clone, Copy)]
pub struct Change<N> {
    /// Velocity that it takes, m/s.
    pub slowed: Vector<N>,
    /// Angular velocity that it gives about the direction across director and offset, rad/s.
    pub tilting: N,
    /// Spin that it takes, rad/s.
    pub braked: N,
}

/// `M Δv = −U (ω × q − led)` and `I Δω = −U q × (v − v₀)` at once, `ω` and `v` being those at the
/// step's end, with `Δω` and `Δv`; `before` is `v₀`.
///
/// Of `v − v₀` two parts act on the angular velocity: `x` along the director, and `y` across
/// director and offset, `Δω = U (x/I_t p − y/J d)`. These two are found.
#[inline(always)]
pub fn balance<N: Number>(
    moment: N,
    turned: &Turned<N>,
    led: Vector<N>,
    before: Vector<N>,
    motion: &Motion<N>,
    mobility: &Mobility<N>,
) -> Change<N> {
    let one = N::splat(1.0);
    let Motion { director: d, velocity, turning, spin } = *motion;
    let Turned { across: p, half, cosine, .. } = *turned;
    let t = mobility.tangent;
    // U M⁻¹ is `lateral`, and `excess` more along the hole.
    let (lateral, rotary) = (moment * mobility.lateral, moment * mobility.rotary);
    let excess = moment * (mobility.axial - mobility.lateral);
    let polar = moment * mobility.polar;
    let left = turning.plus(d, spin).cross_plus(half, -led);
    let gained = (velocity - before).minus(left, lateral);
    let arm = half.cross(t);
    let (arm_d, arm_p, left_t) = (arm.dot(d), arm.dot(p), left.dot(t));
    let (excess_d, excess_p) = (excess * t.dot(d), excess * t.dot(p));
    let b1 = excess_d.neg_mul_add(left_t, d.dot(gained));
    let b2 = excess_p.neg_mul_add(left_t, p.dot(gained));
    let straight = lateral * cosine;
    let a11 = rotary.mul_add(excess_d.mul_add(arm_p, -straight), one);
    let a12 = polar * excess_d * arm_d;
    let a21 = rotary * excess_p * arm_p;
    let a22 = polar.neg_mul_add(excess_p.mul_add(arm_d, straight), one);
    let inverse = one / a11.mul_add(a22, a12 * a21);
    let tilting = rotary * inverse * a22.mul_add(b1, a12 * b2);
    let braked = polar * inverse * a21.neg_mul_add(b1, a11 * b2);
    // ω × q − led with Δω, and its part along the hole.
    let omega = p.scaled(tilting).minus(d, braked);
    let all_t = tilting.mul_add(arm_p, braked.neg_mul_add(arm_d, left_t));
    let slowed = omega.cross_plus(half, left).scaled(lateral).plus(t, excess * all_t);
    Change { slowed, tilting, braked }
}

/// A node as it moves after `change`: the step has turned the director by its own angular velocity,
/// and the rest follows. Where nothing changes, every digit is preserved. The director becomes
/// longer by half the square of its rotation here.
#[inline(always)]
pub fn changed<N: Number>(
    motion: &Motion<N>,
    turned: &Turned<N>,
    change: &Change<N>,
    dt: N,
) -> Motion<N> {
    let Motion { director, velocity, turning, spin } = *motion;
    let Turned { tilted, across, .. } = *turned;
    // (p × d) dt is towards the offset.
    let x = change.tilting * dt;
    let director = director.plus(tilted, x);
    let turning = turning.plus(across, change.tilting).minus(director, x * turning.dot(tilted));
    Motion { director, velocity: velocity - change.slowed, turning, spin: spin - change.braked }
}

/// A direction that is kept with more digits than its numbers have, where those are single: turned
/// a little in every step, it would drift by the rounding of each step.
#[derive(Debug, Clone, Copy)]
pub struct Direction<N> {
    /// The direction.
    pub toward: Vector<N>,
    /// Rounding remainder.
    pub rest: Vector<N>,
}

/// `before` as the step and the `change` after it have turned it, across `director` and of unit
/// length.
#[inline(always)]
pub fn carried<N: Number>(
    before: &Direction<N>,
    turned: &Turned<N>,
    change: &Change<N>,
    director: Vector<N>,
    dt: N,
) -> Direction<N> {
    let half = N::splat(0.5);
    let Direction { toward, rest } = *before;
    // By this angle about the director: `across` lags the direction's own motion by one angle.
    let back = change.braked * dt;
    let mut gain = turned.gain.minus(turned.across, turned.versine.mul_add(back, back));
    if !N::Real::FINE {
        gain = gain + rest;
    }
    let askew = toward + gain;
    let along = askew.dot(director);
    // 1/√(1 − x) − 1 is x/2, of x a rounding.
    let longer = half.neg_mul_add(askew.dot(askew), half);
    if N::Real::FINE {
        let toward = askew.minus(director, along).plus(askew, longer);
        return Direction { toward, rest };
    }
    let gain = gain.minus(director, along).plus(askew, longer);
    let now = toward + gain;
    Direction { toward: now, rest: gain - (now - toward) }
}

/// The direction half a step before one that turns with `omega`.
pub fn half_before(toward: Vector<f64>, omega: Vector<f64>, dt: f64) -> Vector<f64> {
    let half = toward.minus(omega.cross(toward), 0.5 * dt);
    half.scaled(1.0 / half.dot(half).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rod::bent;

    fn unit(v: Vector<f64>) -> Vector<f64> {
        v.scaled(1.0 / v.dot(v).sqrt())
    }

    fn length(v: Vector<f64>) -> f64 {
        v.dot(v).sqrt()
    }

    /// A direction across a director, and where a step turns that.
    fn step() -> [Vector<f64>; 3] {
        let from = unit(Vector(0.3, -0.2, 0.9));
        let toward = unit(Vector(0.5, 0.7, -0.1).cross(from));
        [toward, from, unit(from + Vector(2e-6, 1e-6, 3e-6))]
    }

    /// To the last digits at two degrees a step; at six the sine's seventh power is 2e-11, and the
    /// cosine's eighth 3e-13. An eighth of the square of the director's turn, 4e-6, is 2e-12.
    #[test]
    fn a_direction_is_turned_as_it_is_carried() {
        let [toward, from, to] = step();
        for (angle, within) in [(-0.03, 1e-14), (0.1, 3e-11)] {
            let turned = turned(toward, from, to, angle);
            let exact = bent::carried(toward, from, to, angle);
            assert!(length(toward + turned.gain - exact) < within);
            let half = unit(toward + exact);
            let within = within + 2e-12;
            assert!(length(turned.half - half) < within);
            assert!((turned.cosine - half.dot(turned.tilted)).abs() < within);
        }
    }

    /// Both balances hold, for an offset far larger than any, in a string askew in its hole: to
    /// rounding, and to the 2e-12 that the director's turn takes of the length of `half`.
    #[test]
    fn momentum_and_moment_of_momentum_balance() {
        let [toward, from, to] = step();
        let turned = turned(toward, from, to, 0.02);
        let tangent = unit(to + Vector(0.2, 0.3, -0.1));
        let mobility = Mobility { tangent, lateral: 0.4, axial: 0.7, polar: 30.0, rotary: 5.0 };
        let motion = Motion {
            director: to,
            velocity: Vector(0.1, -0.3, 0.2),
            turning: Vector(0.4, 0.1, 0.3).cross(to),
            spin: 7.0,
        };
        let (moment, before) = (0.2, Vector(-0.2, 0.1, 0.4));
        let led = Vector(3.0, -5.0, 1.0);
        let change = balance(moment, &turned, led, before, &motion, &mobility);
        let gained = turned.across.scaled(change.tilting).minus(to, change.braked);
        let slow = -change.slowed;

        let omega = motion.turning.plus(to, motion.spin) + gained;
        let along = slow.dot(tangent);
        let momentum = slow.minus(tangent, along).scaled(1.0 / 0.4).plus(tangent, along / 0.7);
        let thrown = (omega.cross(turned.half) - led).scaled(moment);
        assert!(length(momentum + thrown) < 1e-14 * length(thrown));

        let about = gained.dot(to);
        let turning = gained.minus(to, about).scaled(1.0 / 5.0).plus(to, about / 30.0);
        let accelerated = motion.velocity + slow - before;
        let lever = turned.tilted.cross(accelerated).scaled(moment);
        assert!(length(turning + lever) < 2e-12 * length(lever));
    }
}

//! One element: its forces are the gradient of its energy, they balance, and its damping only
//! takes.

use nalgebra::{Rotation3, Unit, Vector3};
use wholestring::rod::{
    element::{Pose, Reaction, Stiffness, energy, react, shear_factor},
    section::Section,
};

use crate::{common::assert_close, plane::at_rest, random::Random};

type V = Vector3<f64>;

/// A five-inch drill pipe, with a shear stiffness that matters at the length of an element.
pub fn pipe() -> Section {
    Section {
        axial_stiffness_N: 7.0e8,
        shear_stiffness_N: 1.4e8,
        bending_stiffness_N_m2: 1.2e6,
        torsional_stiffness_N_m2: 9.4e5,
        steel_kg_per_m: 30.0,
        steel_m2: 3.8e-3,
        bore_m2: 9.0e-3,
        polar_inertia_kg_m: 0.1,
        od_m: 0.127,
        pressure_strain_per_Pa: 2e-12,
        thermal_strain_per_K: 12e-6,
    }
}

const LENGTH_M: f64 = 1.7;

/// Moments across the directors on both ends.
fn moments(ends: &Ends, r: &Reaction<f64>) -> [V; 2] {
    [r.moment1(ends.d[0].into()).into(), r.moment2(ends.d[1].into()).into()]
}

/// A place and a motion of both ends, all independent.
#[derive(Clone, Copy)]
struct Ends {
    x: [V; 2],
    d: [V; 2],
    v: [V; 2],
    w: [V; 2],
    spin: [f64; 2],
    twist: f64,
}

impl Ends {
    /// Anywhere in space, strained by up to 0.2 %, its directors up to 15° from its chord and up to
    /// 15° from one another.
    fn random(random: &mut Random) -> Self {
        let chord = random.vector(1.0).normalize();
        let one = random.vector(1000.0);
        let length = LENGTH_M * (1.0 + random.between(-2e-3, 2e-3));
        let tilt = |random: &mut Random| {
            let axis = Unit::new_normalize(random.across(chord, 1.0));
            Rotation3::from_axis_angle(&axis, random.between(-0.13, 0.13)) * chord
        };
        let d = [tilt(random), tilt(random)];
        Self {
            x: [one, one + length * chord],
            d,
            v: [random.vector(3.0), random.vector(3.0)],
            w: d.map(|d| random.across(d, 2.0)),
            spin: [random.between(-20.0, 20.0), random.between(-20.0, 20.0)],
            twist: random.between(-0.05, 0.05),
        }
    }

    /// As the solver sees it: the anchors of the two ends are a little off them.
    fn pose(&self) -> Pose<f64> {
        let anchor = (self.x[1] - self.x[0]) + V::new(0.011, -0.007, 0.004);
        let displacement = (self.x[1] - self.x[0]) - anchor;
        Pose {
            displacement: displacement.into(),
            velocity: (self.v[1] - self.v[0]).into(),
            w1: self.w[0].into(),
            w2: self.w[1].into(),
            spin: self.spin[1] - self.spin[0],
            twist: self.twist,
            ..at_rest(anchor, LENGTH_M, self.d)
        }
    }

    fn energy(&self, k: &Stiffness<f64>) -> f64 {
        energy(k, &self.pose())
    }

    fn react(&self, k: &Stiffness<f64>, beta: f64) -> Reaction<f64> {
        react(k, &self.pose(), 0.0, beta)
    }

    /// Power of the element on its ends, W.
    fn power(&self, r: &Reaction<f64>) -> f64 {
        V::from(r.force).dot(&(self.v[1] - self.v[0]))
            + V::from(r.moment1(self.d[0].into())).dot(&self.w[0])
            + V::from(r.moment2(self.d[1].into())).dot(&self.w[1])
            + r.torque * (self.spin[0] - self.spin[1])
    }

    /// A time `t` later, the twist carried on at its rate.
    fn after(&self, t: f64, twist_rate: f64) -> Self {
        let turn = |i: usize| Rotation3::new(self.w[i] * t) * self.d[i];
        Self {
            x: [self.x[0] + t * self.v[0], self.x[1] + t * self.v[1]],
            d: [turn(0), turn(1)],
            twist: self.twist + t * twist_rate,
            ..*self
        }
    }
}

/// Fourth-order central difference of `f` at zero.
fn slope(f: impl Fn(f64) -> f64, h: f64) -> f64 {
    (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h)
}

/// The difference is exact to its rounding, 1e-16 U/h, of forces of 1e5 N and more: 1e-7 of the
/// largest is ten times the measured value while `h` was varied.
#[test]
fn forces_and_moments_are_minus_the_gradient_of_the_energy() {
    let k = Stiffness::new(&pipe(), LENGTH_M);
    let mut random = Random(1);
    let mut worst: f64 = 0.0;
    for _ in 0..300 {
        // Untwisted: the work of the torque is tested by its rate, below.
        let ends = Ends {
            twist: 0.0,
            v: [V::zeros(); 2],
            w: [V::zeros(); 2],
            spin: [0.0; 2],
            ..Ends::random(&mut random)
        };
        let r = ends.react(&k, 0.0);
        let (force, size) = (V::from(r.force), V::from(r.force).norm());
        for end in 0..2 {
            let direction = random.vector(1.0).normalize();
            let moved = |h: f64| {
                let mut e = ends;
                e.x[end] += h * direction;
                e.energy(&k)
            };
            let expected = -slope(moved, 1e-5);
            let on_end = if end == 1 { force } else { -force };
            worst = worst.max((on_end.dot(&direction) - expected).abs() / size);

            let axis = random.across(ends.d[end], 1.0).normalize();
            let turned = |h: f64| {
                let mut e = ends;
                e.d[end] = Rotation3::new(h * axis) * e.d[end];
                e.energy(&k)
            };
            let moment = moments(&ends, &r)[end];
            let expected = -slope(turned, 1e-4);
            worst = worst.max((moment.dot(&axis) - expected).abs() / moment.norm());
        }
    }
    assert!(worst < 1e-7, "{worst:e}");
}

/// The whole element, twist included, loses the work that it does on its ends. 1e-8 of the sum of
/// its parts is the rounding of the difference, `1e-16 U/(P h)`.
#[test]
fn energy_changes_by_the_power_of_the_forces() {
    let k = Stiffness::new(&pipe(), LENGTH_M);
    let mut random = Random(2);
    for _ in 0..300 {
        let ends = Ends::random(&mut random);
        let r = ends.react(&k, 0.0);
        let dt = 1e-6;
        let rate = (react(&k, &ends.pose(), dt, 0.0).twist - ends.twist) / dt;
        let expected = -slope(|t| ends.after(t, rate).energy(&k), 1e-5);
        let scale = V::from(r.force).norm() * 3.0
            + moments(&ends, &r)[0].norm() * 2.0
            + r.torque.abs() * 20.0;
        let error = (ends.power(&r) - expected).abs() / scale;
        assert!(error < 1e-8, "{error:e}");
    }
}

/// Without axial and bending stiffness only the torque works, and its power is `M τ'` to rounding,
/// for any bend: rate and moments share the series of `1/(1 + c12)`.
#[test]
fn torque_does_the_work_of_its_rate() {
    let nothing = Section { axial_stiffness_N: 0.0, bending_stiffness_N_m2: 0.0, ..pipe() };
    let k = Stiffness::new(&nothing, LENGTH_M);
    let mut random = Random(3);
    for _ in 0..300 {
        let mut ends = Ends::random(&mut random);
        ends.d[1] = random.vector(1.0).normalize();
        ends.w[1] = random.across(ends.d[1], 2.0);
        let r = react(&k, &ends.pose(), 1.0, 0.0);
        let rate = r.twist - ends.twist;
        let (sum, parts) = (ends.power(&r) + r.torque * rate, r.torque.abs() * 50.0);
        assert!(sum.abs() < 1e-14 * parts, "{sum:e} of {parts:e}");
    }
}

/// The series is within 4e-8 of `1/(1 + c12)` for a bend of 15°: the rate of twist is that of a
/// body that turns rigidly, none, and the moments balance, to that part of the angular velocities.
#[test]
fn rigid_motion_neither_strains_nor_twists() {
    let k = Stiffness::new(&pipe(), LENGTH_M);
    let mut random = Random(4);
    let mut worst: f64 = 0.0;
    for _ in 0..300 {
        let mut ends = Ends::random(&mut random);
        let omega = random.vector(20.0);
        let at = random.vector(5.0);
        for i in 0..2 {
            ends.v[i] = at + omega.cross(&(ends.x[i] - ends.x[0]));
            ends.spin[i] = omega.dot(&ends.d[i]);
            ends.w[i] = omega - ends.spin[i] * ends.d[i];
        }
        let rate = react(&k, &ends.pose(), 1.0, 0.0).twist - ends.twist;
        worst = worst.max(rate.abs() / omega.norm());
        // The elastic power of a rigid motion is that of an unbalanced moment.
        let r = ends.react(&k, 0.0);
        let scale = (V::from(r.force).norm() * LENGTH_M + r.torque.abs()) * omega.norm();
        assert!(ends.power(&r).abs() < 1e-8 * scale);
    }
    assert!(worst < 1e-8, "{worst:e}");
}

/// A straight unstrained element, put anywhere and turned anyhow, pulls at nothing: rounding of a
/// thousand metres' coordinates in the chord, times its stiffness.
#[test]
fn an_unstrained_element_is_at_rest_wherever_it_lies() {
    let k = Stiffness::new(&pipe(), LENGTH_M);
    let mut random = Random(5);
    for _ in 0..100 {
        let mut ends = Ends::random(&mut random);
        let t = random.vector(1.0).normalize();
        ends.x[1] = ends.x[0] + LENGTH_M * t;
        ends.d = [t, t];
        ends.twist = 0.0;
        let r = ends.react(&k, 0.0);
        let rounding = 1e-12;
        assert!(V::from(r.force).norm() < 10.0 * k.axial * k.length * rounding);
        for moment in moments(&ends, &r) {
            assert!(moment.norm() < 10.0 * k.bending_near() * rounding);
        }
        assert_eq!(r.torque, 0.0);
    }
}

/// About any point: the forces are a pair by construction, the moments balance to the series of
/// `1/(1 + c12)` in the torque, 1e-8, and to rounding without torque.
#[test]
fn the_total_moment_is_balanced() {
    let k = Stiffness::new(&pipe(), LENGTH_M);
    let mut random = Random(6);
    for case in 0..300 {
        let mut ends = Ends::random(&mut random);
        if case % 2 == 0 {
            ends.twist = 0.0;
        }
        let r = ends.react(&k, 0.0);
        let force = V::from(r.force);
        let [moment1, moment2] = moments(&ends, &r);
        let total = (ends.x[1] - ends.x[0]).cross(&force)
            + moment1
            + moment2
            + r.torque * (ends.d[0] - ends.d[1]);
        let scale = LENGTH_M * force.norm() + r.torque.abs();
        let tolerance = if case % 2 == 0 { 1e-12 } else { 1e-8 };
        assert!(total.norm() < tolerance * scale, "{:e}", total.norm() / scale);
    }
}

/// The damping part of the forces dissipates exactly the power that is reported, never a negative
/// one.
#[test]
fn damping_takes_the_power_that_it_reports() {
    let k = Stiffness::new(&pipe(), LENGTH_M);
    let mut random = Random(7);
    for _ in 0..1000 {
        let ends = Ends::random(&mut random);
        let (damped, elastic) = (ends.react(&k, 1e-3), ends.react(&k, 0.0));
        assert!(damped.damping_power >= 0.0);
        let taken = ends.power(&elastic) - ends.power(&damped);
        let rounding = 1e-13 * (ends.power(&elastic).abs() + 1e6);
        let difference = taken - damped.damping_power;
        assert!(difference.abs() < rounding.max(1e-12 * taken), "{taken} {difference:e}");
    }
}

#[test]
fn a_bent_pipe_that_spins_in_place_loses_nothing() {
    let k = Stiffness::new(&pipe(), LENGTH_M);
    let mut random = Random(8);
    for _ in 0..100 {
        let ends = Ends {
            v: [V::zeros(); 2],
            w: [V::zeros(); 2],
            spin: [7.3; 2],
            ..Ends::random(&mut random)
        };
        let (damped, elastic) = (ends.react(&k, 1e-2), ends.react(&k, 0.0));
        assert_eq!(damped.damping_power, 0.0);
        assert_eq!(V::from(damped.force), V::from(elastic.force));
        assert_eq!(moments(&ends, &damped), moments(&ends, &elastic));
        assert_eq!(damped.torque, elastic.torque);
    }
}

/// The whirling bent pipe loses `β EI/L |w2 − w1|²`, small compared with any other loss: for a
/// dogleg of 3° in 30 m at 70 rev/min and β = 1e-5 s, less than a hundredth of a watt in an element
/// of 3.2 m.
#[test]
fn a_bent_pipe_that_whirls_rigidly_loses_next_to_nothing() {
    let length = 3.2;
    let k = Stiffness::new(&pipe(), length);
    let bend = 3f64.to_radians() / 30.0 * length;
    let omega = V::new(0.0, 0.0, 70.0 * std::f64::consts::TAU / 60.0);
    let d = [-0.5, 0.5].map(|part| V::new((part * bend).sin(), 0.0, (part * bend).cos()));
    let w = d.map(|d| omega - d * omega.dot(&d));
    let pose = Pose {
        w1: w[0].into(),
        w2: w[1].into(),
        spin: omega.dot(&(d[1] - d[0])),
        ..at_rest(V::new(0.0, 0.0, length), length, d)
    };
    let loss = react(&k, &pose, 0.0, 1e-5).damping_power;
    let by_hand = 1e-5 * k.bending * (w[1] - w[0]).norm_squared();
    assert_close("loss", loss, by_hand, 1e-6);
    assert!(loss < 1e-2, "{loss}");
}

/// Cowper's thin ring, `2(1 + ν)/(4 + 3ν)`, and solid circle, `6(1 + ν)/(7 + 6ν)` (his table 1).
#[test]
fn shear_factor_has_cowpers_limits() {
    for nu in [0.0, 0.25, 0.3, 0.5] {
        assert_close("thin", shear_factor(nu, 1.0), 2.0 * (1.0 + nu) / (4.0 + 3.0 * nu), 1e-15);
        assert_close("solid", shear_factor(nu, 0.0), 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu), 1e-15);
    }
}

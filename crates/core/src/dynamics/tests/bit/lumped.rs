//! A mass and a wheel on a torsion spring with the regenerative law: when steady drilling is
//! stable, and how it sticks and slips.

use super::{
    delay::System,
    regenerative::{LAW, pressed, settings},
    roots::Drilling,
    *,
};
use crate::dynamics::boundary::bit::{Cutters, RegenerativeLaw};
use wholestring_verification::verify;

const TAU: f64 = std::f64::consts::TAU;

/// A mass and a wheel on a torsion spring, the top of which turns at a constant speed: Richard,
/// Germay and Detournay's string.
struct Lumped {
    rig: Rig,
    weight_N: f64,
    speed_rad_per_s: f64,
    damping_N_m_s: f64,
    dt: f64,
    steps: u64,
    angle_rad: f64,
    lead_rad: f64,
}

const MASS: f64 = 34_000.0;
const POLAR: f64 = 116.0;
const STIFFNESS: f64 = 938.0;

impl Lumped {
    /// Drilling steadily under a weight, the spring damped so much.
    fn new(law: RegenerativeLaw, weight_N: f64, speed: f64, damping_N_m_s: f64, dt: f64) -> Self {
        let mut rig = Rig::with(pressed(weight_N), settings(law));
        node!(rig.chain, 0, inv_mass_axial = 1.0 / MASS);
        node!(rig.chain, 0, inv_polar = 1.0 / POLAR);
        let steady = law.steady(weight_N, speed);
        rig.chain.set_velocity(0, Vector(0.0, 0.0, steady.rate_of_penetration_m_per_s));
        rig.set_spin(speed);
        Self {
            rig,
            weight_N,
            speed_rad_per_s: speed,
            damping_N_m_s,
            dt,
            steps: 0,
            angle_rad: 0.0,
            lead_rad: steady.torque_N_m / STIFFNESS,
        }
    }

    fn step(&mut self) -> BitStep {
        let time = self.steps as f64 * self.dt;
        let spin = self.rig.spin();
        self.rig.push = Vector(0.0, 0.0, self.weight_N * MASS_KG / MASS);
        self.rig.turn = STIFFNESS * (self.speed_rad_per_s * time + self.lead_rad - self.angle_rad)
            + self.damping_N_m_s * (self.speed_rad_per_s - spin);
        let step = self.rig.step(self.dt);
        self.angle_rad += self.dt * self.rig.spin();
        self.steps += 1;
        step
    }
}

/// The scales of time and depth of the dimensionless form.
fn scales(law: RegenerativeLaw) -> (f64, f64) {
    let depth =
        2.0 * STIFFNESS / (law.cutters.intrinsic_specific_energy_Pa * law.cutters.radius_m.powi(2));
    ((POLAR / STIFFNESS).sqrt(), depth)
}

fn psi(law: RegenerativeLaw) -> f64 {
    law.stiffness_N_per_m() / f64::from(law.blades) * POLAR / (MASS * STIFFNESS)
}

/// By how much a small axial motion grows in a second.
fn growth_per_s(law: RegenerativeLaw, weight: f64, speed: f64, damping: f64, dt: f64) -> f64 {
    let mut string = Lumped::new(law, weight, speed, damping, dt);
    let steady = law.steady(weight, speed).rate_of_penetration_m_per_s;
    string.rig.chain.set_velocity(0, Vector(0.0, 0.0, steady + 1e-6));
    let mut largest = |seconds: f64| {
        let mut largest = 0.0f64;
        for _ in 0..(seconds / dt) as usize {
            string.step();
            largest = largest.max((string.rig.chain.velocity(0).2 - steady).abs());
        }
        largest
    };
    largest(4.0);
    let early = largest(2.0);
    largest(8.0);
    let late = largest(2.0);
    (late / early).ln() / 10.0
}

/// Steady drilling is stable above the speed given by the roots of the characteristic equation, and
/// unstable below, with three, four and six blades under three weights.
///
/// Expected to come later by `2 dt/τ`, `τ` the delay between blades, for the rock is met at the
/// step's end: 0.2 % at 0.1 ms, where 0.17 to 0.24 % were found; twice the step, twice the error.
#[test]
fn steady_drilling_is_stable_where_the_characteristic_roots_say() {
    for (blades, weight) in [(3, 30e3), (4, 60e3), (6, 100e3)] {
        let law = RegenerativeLaw { blades, ..LAW };
        let (time, depth) = scales(law);
        let damping = 0.02;
        let drilling = Drilling {
            blades: f64::from(blades),
            psi: psi(law),
            damping,
            pitch: law.steady(weight, 1.0).depth_of_cut_m / TAU / depth,
            speed: 0.0,
        };
        let axial = 2.0 * (2.0 * drilling.psi / drilling.blades).sqrt();
        let exact = drilling.threshold(0.7 * axial, 1.3 * axial) / time;
        // The torsion takes part: the mass alone would not do.
        assert!((exact * time / axial - 1.0).abs() > 0.01);
        let error = |dt: f64| {
            let (mut low, mut high) = (0.9 * exact, 1.1 * exact);
            let grows = |speed: f64| {
                let damping = damping * (POLAR * STIFFNESS).sqrt();
                growth_per_s(law, weight, speed, damping, dt) > 0.0
            };
            assert!(grows(low) && !grows(high));
            for _ in 0..9 {
                let middle = 0.5 * (low + high);
                if grows(middle) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            0.5 * (low + high) / exact - 1.0
        };
        let [fine, coarse] = [error(1e-4), error(2e-4)];
        verify("regenerative", format!("speed above which {blades} blades drill steadily, rad/s"))
            .relative(5e-3, "twice the shift 2 dt/τ of a step of 0.1 ms, and the bisection")
            .report(exact, exact * (1.0 + fine));
        assert!((1.7..2.3).contains(&(coarse / fine)), "{coarse:.2e} {fine:.2e}");
    }
}

/// A string that sticks and slips, and how it is run.
struct StickSlip {
    wear_flat_m: f64,
    /// Weight in excess of that on the wear flats, N.
    cutting_N: f64,
    friction: f64,
    rpm: f64,
    /// Time, and the part of it that is not looked at, in `√(I/C)`.
    time: f64,
    skipped: f64,
}

impl StickSlip {
    fn law(&self) -> RegenerativeLaw {
        RegenerativeLaw {
            cutters: Cutters {
                wear_flat_m: self.wear_flat_m,
                friction: self.friction,
                ..LAW.cutters
            },
            ..LAW
        }
    }

    fn weight_N(&self) -> f64 {
        self.law().cutters.wear_flat_weight_N() + self.cutting_N
    }

    fn speed_rad_per_s(&self) -> f64 {
        self.rpm * TAU / 60.0
    }

    /// Mean period, s, and largest spin, rad/s, by the integrator of the tests.
    fn expected(&self) -> (f64, f64) {
        let law = self.law();
        let (time, depth) = scales(law);
        let unit = law.stiffness_N_per_m() / f64::from(law.blades) * depth;
        let seen = System {
            blades: f64::from(law.blades),
            psi: psi(law),
            bearing: law.cutters.wear_flat_weight_N() / unit,
            beta: law.cutters.friction * law.cutters.bit_geometry * law.cutters.cutter_inclination,
            weight: self.weight_N() / unit,
            speed: self.speed_rad_per_s() * time,
        }
        .run(self.time, 0.1);
        assert_eq!(seen.off, 0.0, "the bit does not leave the rock in these cases");
        (period(&seen.sticks, self.skipped) * time, seen.fastest / time)
    }

    /// The same by the bit.
    fn found(&self, dt: f64) -> (f64, f64) {
        let law = self.law();
        let (time, _) = scales(law);
        let mut string = Lumped::new(law, self.weight_N(), self.speed_rad_per_s(), 0.0, dt);
        let spin = string.rig.spin();
        string.rig.set_spin(spin * 1.1);
        let (mut sticks, mut fastest, mut turned) = (Vec::new(), 0.0f64, true);
        for i in 0..(self.time * time / dt) as u32 {
            string.step();
            let spin = string.rig.spin();
            fastest = fastest.max(spin);
            if spin <= 0.0 && turned {
                sticks.push(f64::from(i) * dt);
            }
            turned = spin > 0.0;
        }
        (period(&sticks, self.skipped * time), fastest)
    }
}

/// Mean time between sticks after a time.
fn period(sticks: &[f64], after: f64) -> f64 {
    let late: Vec<f64> = sticks.iter().copied().filter(|t| *t > after).collect();
    (late[late.len() - 1] - late[0]) / (late.len() - 1) as f64
}

/// For a periodic cycle, period and largest spin are those of the independent integration.
///
/// Found at steps of 0.1 ms: periods of 2.1783, 2.3444 and 2.1971 s within 0.01, 0.06 and 0.03 %,
/// twice that at 0.2 ms; spins within 2 %. The spring of the string alone would swing in 2.2096 s.
#[test]
fn a_regular_stick_slip_has_the_period_of_an_independent_integration() {
    for (cutting_N, friction, rpm) in [(30e3, 0.6, 90.0), (30e3, 0.6, 60.0), (15e3, 0.3, 90.0)] {
        let case =
            StickSlip { wear_flat_m: 5e-3, cutting_N, friction, rpm, time: 200.0, skipped: 100.0 };
        let (period, fastest) = case.expected();
        let (found, found_fastest) = case.found(1e-4);
        let what = format!("stick-slip at {rpm} rev/min and {cutting_N:e} N");
        verify("regenerative", format!("period of regular {what}, s"))
            .relative(2e-3, "three times the error of a step of 0.1 ms, which halves with it")
            .report(period, found);
        verify("regenerative", format!("largest spin of regular {what}, rad/s"))
            .relative(0.03, "as above: it comes from the start")
            .report(fastest, found_fastest);
    }
}

/// A heavier and slower bit sticks longer, each time differently: its mean period over 500 cycles,
/// 2.80 s, is that of the independent integration within the required 2 %; 0.6 % apart at most with
/// three steps, for the means scatter by 0.5 %.
#[test]
fn an_irregular_stick_slip_has_its_mean_period() {
    let case = StickSlip {
        wear_flat_m: 11e-3,
        cutting_N: 60e3,
        friction: 0.6,
        rpm: 40.0,
        time: 3000.0,
        skipped: 100.0,
    };
    let ((period, _), (found, _)) = (case.expected(), case.found(2e-4));
    verify("regenerative", "mean period of irregular stick-slip at 40 rev/min, s")
        .relative(0.02, "means over 500 cycles scatter by 0.5 %")
        .report(period, found);
}

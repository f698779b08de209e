//! Stabilised collars against a solution of its own.

use std::f64::consts::{PI, TAU};

use nalgebra::{Const, DMatrix, Dyn, OMatrix, SMatrix};
use wholestring::{
    prelude::*,
    string::{Blades, ComponentLength, ComponentSpec},
};
use wholestring_vibration::modal::{Mode, SmallMotions, Whirl};

use crate::{
    common,
    common::{report_worst, verify},
    motions, rigid,
};

/// Length of the string, its inclination, deg, and where its blades are, m from the bit.
const LENGTH_M: f64 = 42.0;
const INCLINATION_DEG: f64 = 60.0;
const BLADES_M: [f64; 3] = [6.0, 17.0, 30.0];

/// Diameter of the hole, which the blades fill, and of the collars, m.
const HOLE_M: f64 = 0.3112;
const OD_M: f64 = 0.2032;
const ID_M: f64 = 0.0714;

fn collars(elements_m: f64, compression_N: f64) -> SmallMotions {
    let part = |length_m: f64| {
        let length = ComponentLength::Metres(length_m);
        ComponentSpec::uniform("collar", OD_M, ID_M, length, common::steel())
    };
    let (mut parts, mut to_m) = (Vec::new(), 0.0);
    for at_m in BLADES_M {
        parts.push(part(at_m - 0.05 - to_m));
        let blades = Blades { od_m: HOLE_M, length_m: 0.05 };
        parts.push(ComponentSpec { blades: Some(blades), ..part(0.1) });
        to_m = at_m + 0.05;
    }
    parts.push(part(LENGTH_M - to_m));
    let path = common::arcs(&[[0.0, INCLINATION_DEG, 0.0], [LENGTH_M, INCLINATION_DEG, 0.0]]);
    let hole = common::open_hole(HOLE_M, 0.0, LENGTH_M);
    let model = common::model(path, hole, parts, common::mud(0.0), LENGTH_M);
    let operation = Operation { weight_on_bit_N: compression_N, ..Operation::slide(LENGTH_M) };
    let found = motions(&model, &operation, &rigid(elements_m));
    // The blades are in contact with their hole, the collars between them do not touch it.
    assert_eq!((0..found.nodes()).filter(|node| found.touches(*node)).count(), BLADES_M.len());
    found
}

/// The same collars as a Timoshenko beam between pins that goes round as `exp(iωt)`, its state
/// carried from the bit up by Runge and Kutta's method: with `Q` across the undeformed axis, `T`
/// tension, `Ω` rotary speed,
///
/// ```text
/// y' = θ + V/κGA      V = Q − T y'       Q' = −m ω² y
/// M' = −V + (2ρI Ω ω − ρI ω²) θ          θ' = M/EI
/// ```
struct Beam {
    compression_N: f64,
    rotary_rad_per_s: f64,
}

/// `y, θ, M, Q`.
type Transfer = SMatrix<f64, 4, 4>;

impl Beam {
    fn slope(&self, from_bit_m: f64, omega: f64) -> Transfer {
        let steel = common::steel();
        let area = 0.25 * PI * (OD_M.powi(2) - ID_M.powi(2));
        let second = PI / 64.0 * (OD_M.powi(4) - ID_M.powi(4));
        let mass = steel.density_kg_per_m3 * area;
        let rotary = steel.density_kg_per_m3 * second;
        let kappa = wholestring::rod::element::shear_factor(steel.poisson_ratio(), ID_M / OD_M);
        let shear_N = kappa * steel.shear_modulus_Pa * area;
        let weight = mass * wholestring::GRAVITY_M_PER_S2 * INCLINATION_DEG.to_radians().cos();
        let tension_N = weight * from_bit_m - self.compression_N;
        // y' = (θ + Q/κGA)/(1 + T/κGA).
        let over = 1.0 / (1.0 + tension_N / shear_N);
        let turning = 2.0 * rotary * self.rotary_rad_per_s * omega - rotary * omega * omega;
        Transfer::from_row_slice(&[
            0.0,
            over,
            0.0,
            over / shear_N,
            0.0,
            0.0,
            1.0 / (steel.youngs_modulus_Pa * second),
            0.0,
            0.0,
            tension_N * over + turning,
            0.0,
            tension_N * over / shear_N - 1.0,
            -mass * omega * omega,
            0.0,
            0.0,
            0.0,
        ])
    }

    fn across(&self, from_m: f64, to_m: f64, omega: f64) -> Transfer {
        const STEPS: usize = 60;
        let step_m = (to_m - from_m) / STEPS as f64;
        let mut state = Transfer::identity();
        for step in 0..STEPS {
            let at_m = from_m + step_m * step as f64;
            let slope = |along: f64| self.slope(at_m + along * step_m, omega);
            let (a, b, c) = (slope(0.0), slope(0.5), slope(1.0));
            let k1 = a * state;
            let k2 = b * (state + k1 * (0.5 * step_m));
            let k3 = b * (state + k2 * (0.5 * step_m));
            let k4 = c * (state + k3 * step_m);
            state += (k1 + (k2 + k3) * 2.0 + k4) * (step_m / 6.0);
        }
        state
    }

    /// Zero at a natural frequency: pins at the bit, at the blades, whose forces are unknowns, and
    /// at the top.
    fn determinant(&self, omega: f64) -> f64 {
        let unknowns = BLADES_M.len() + 2;
        // Contribution of each unknown to the state: θ and Q at the bit, then the blades.
        let mut state = OMatrix::<f64, Const<4>, Dyn>::zeros(unknowns);
        (state[(1, 0)], state[(3, 1)]) = (1e-3, 1e5);
        let mut conditions = DMatrix::<f64>::zeros(unknowns, unknowns);
        let mut from_m = 0.0;
        for (row, to_m) in BLADES_M.into_iter().chain([LENGTH_M]).enumerate() {
            state = self.across(from_m, to_m, omega) * state;
            conditions.set_row(row, &state.row(0).into_owned());
            if row < BLADES_M.len() {
                state[(3, row + 2)] += 1e5;
            }
            from_m = to_m;
        }
        conditions.set_row(unknowns - 1, &(state.row(2) * 1e-8));
        conditions.determinant()
    }

    /// The first roots, rad/s, forward or backward.
    fn roots_rad_per_s(&self, count: usize, sign: f64) -> Vec<f64> {
        const STEP: f64 = 0.5;
        let mut found = Vec::new();
        let mut low = STEP;
        while found.len() < count {
            let (mut from, mut to) = (low, low + STEP);
            let before = self.determinant(sign * from);
            if before * self.determinant(sign * to) < 0.0 {
                for _ in 0..60 {
                    let middle = 0.5 * (from + to);
                    if self.determinant(sign * middle) * before > 0.0 {
                        from = middle;
                    } else {
                        to = middle;
                    }
                }
                found.push(0.5 * (from + to));
            }
            low += STEP;
        }
        found
    }
}

fn round_rad_per_s(modes: &[Mode], whirl: Whirl) -> Vec<f64> {
    let own = modes.iter().filter(|mode| mode.whirl() == Some(whirl));
    own.map(|mode| TAU * mode.frequency_Hz).collect()
}

/// Five modes forward and five backward of collars on three blades and two pins, in compression and
/// in tension, against roots of the transfer matrices. Elements of half a metre: the fifth mode
/// errs by 1e-3, four times as much with those of a metre.
#[test]
fn stabilised_collars_whirl_as_transfer_matrices_say() {
    const SPEED: f64 = 300.0;
    for compression_N in [100e3, -300e3] {
        let found = collars(0.5, compression_N);
        let modes = found.assembly(LENGTH_M).lateral(0.0, 10, SPEED).expect("modes");
        let beam = Beam { compression_N, rotary_rad_per_s: SPEED };
        let mut rows = Vec::new();
        for (whirl, sign) in [(Whirl::Forward, 1.0), (Whirl::Backward, -1.0)] {
            let found = round_rad_per_s(&modes, whirl);
            assert_eq!(found.len(), 5);
            for (number, (found, root)) in
                found.iter().zip(beam.roots_rad_per_s(5, sign)).enumerate()
            {
                let (name, mode, load_kN) = (whirl.name(), number + 1, compression_N / 1e3);
                let what = format!("{name} mode {mode} of collars under {load_kN:.0} kN, rad/s");
                rows.push(
                    verify("modes", what)
                        .relative(5e-3, "elements of 0.5 m leave 1e-3")
                        .row(root, *found),
                );
            }
        }
        report_worst(rows);
    }
}

/// The error of a mesh falls with the square of its elements: the order of its lumped rotary
/// inertia.
#[test]
fn frequencies_converge_with_the_square_of_the_elements() {
    let fifth = |elements_m: f64| {
        let found = collars(elements_m, 100e3);
        let modes = found.assembly(LENGTH_M).lateral(0.0, 10, 0.0).expect("modes");
        modes[9].frequency_Hz
    };
    let [coarse, middle, fine] = [1.0, 0.5, 0.25].map(fifth);
    let order = ((coarse - middle) / (middle - fine)).log2();
    assert!((1.8..2.4).contains(&order), "{order}");
}

/// Every mode is there: as many as the count of negative eigenvalues, at any rotary speed, up to
/// any frequency.
#[test]
fn no_mode_is_left_out() {
    let found = collars(1.0, 100e3);
    for count in [1, 2, 7, 30] {
        let modes = found.modes(0.0, count).expect("modes");
        assert_eq!(modes.len(), count);
        let last = modes[count - 1].frequency_Hz;
        assert!(found.count_below(last * (1.0 - 1e-6)) < count);
        assert!(found.count_below(last * (1.0 + 1e-6)) >= count);
        // The same from half-way on.
        let from_Hz = 0.5 * last;
        let first = found.count_below(from_Hz);
        let rest = found.modes(from_Hz, count - first).expect("modes");
        for (one, other) in rest.iter().zip(&modes[first..]) {
            common::assert_close("frequency", one.frequency_Hz, other.frequency_Hz, 1e-8);
        }
    }
}

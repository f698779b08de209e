//! Laws without a delay: the same string as a first-order system, by its eigenvalues.

use nalgebra::{Complex, ComplexField, DMatrix};
use wholestring::dynamics::{Autodriller, Gains, Shown};
use wholestring_vibration::torsional_stability::{
    LinearBit, LinearDrive, LinearHoist, LinearRock, LumpedChain, SteadyRotation,
};

use crate::band;

/// Numbers between zero and one, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }
}

const NODES: usize = 12;

fn chain(numbers: &mut Numbers, inertia: f64, stiffness: f64, drag: [f64; 2]) -> LumpedChain {
    LumpedChain {
        inertia: (0..NODES).map(|_| inertia * numbers.between(0.5, 1.5)).collect(),
        stiffness: (0..NODES - 1).map(|_| stiffness * numbers.between(0.5, 1.5)).collect(),
        drag: (0..NODES).map(|_| numbers.between(drag[0], drag[1])).collect(),
        stiffness_damping_s: numbers.between(0.0, 2e-3),
    }
}

fn string(numbers: &mut Numbers) -> SteadyRotation {
    let torsion = chain(numbers, 30.0, 8e3, [-2.0, 6.0]);
    let shown = (numbers.next() > 0.5).then(|| Shown {
        impedance_N_m_s: numbers.between(300.0, 700.0),
        corner_rad_per_s: numbers.between(0.1, 0.6),
    });
    SteadyRotation {
        drive: LinearDrive::Tuned {
            inertia_kg_m2: numbers.between(400.0, 2500.0),
            half_kg_m2: torsion.inertia[0],
            gains: Gains {
                proportional_N_m_s: numbers.between(300.0, 5e3),
                integral_N_m: numbers.between(100.0, 5e3),
                shown,
            },
        },
        torsion,
        axial: chain(numbers, 2e3, 6e6, [0.0, 4e3]),
        hoist: LinearHoist::Line {
            block_kg: numbers.between(0.0, 3e4),
            stiffness_N_per_m: 1e7,
            damping_N_s_per_m: numbers.between(1e3, 1e5),
            autodriller: Some(Autodriller {
                gain_m_per_s_per_N: numbers.between(1e-8, 1e-5),
                integral_time_s: numbers.between(2.0, 50.0),
                filter_s: numbers.between(0.1, 1.0),
                ..Autodriller::default()
            }),
        },
        bit: LinearBit {
            rock: LinearRock::Front {
                stiffness_N_per_m: numbers.between(1e6, 1e8),
                rate_per_weight_m_per_s_per_N: numbers.between(1e-8, 1e-6),
            },
            torque_per_weight_m: numbers.between(0.02, 0.1),
            torque_per_speed_N_m_s: numbers.between(-80.0, 30.0),
            advance_per_angle_m: numbers.between(1e-4, 2e-3),
            motor_droop_rad_per_s_per_N_m: 0.0,
            torque_N_m: 0.0,
            rate_m_per_s: 0.0,
        },
    }
}

/// The system `y' = A y` of angles, spins, depths, velocities, and the states of drive, hoist and
/// rock.
fn eigenvalues(rotation: &SteadyRotation) -> Vec<Complex<f64>> {
    let (
        LinearDrive::Tuned { inertia_kg_m2, gains, .. },
        LinearHoist::Line {
            block_kg,
            stiffness_N_per_m: kl,
            damping_N_s_per_m: cl,
            autodriller: Some(driller),
        },
    ) = (rotation.drive, rotation.hoist)
    else {
        panic!("a drive and a line");
    };
    let LinearRock::Front { stiffness_N_per_m: kr, rate_per_weight_m_per_s_per_N: rate } =
        rotation.bit.rock
    else {
        panic!("a front");
    };
    let n = NODES;
    let [angle, spin, depth, speed] = [0, n, 2 * n, 3 * n];
    let [missed, slow, front, heard, sum, block] =
        [4 * n, 4 * n + 1, 4 * n + 2, 4 * n + 3, 4 * n + 4, 4 * n + 5];
    let size = 4 * n + 6;
    let unit = |i: usize| DMatrix::from_fn(1, size, |_, j| f64::from(u8::from(i == j)));
    let zero = || DMatrix::<f64>::zeros(1, size);
    let spring = |chain: &LumpedChain, place: usize, rate: usize, i: usize| {
        let (k, beta) = (chain.stiffness[i], chain.stiffness_damping_s);
        (unit(place + i) - unit(place + i + 1)) * k
            + (unit(rate + i) - unit(rate + i + 1)) * (k * beta)
    };
    let mut rows = vec![zero(); size];
    let weight = (unit(depth + n - 1) - unit(front)) * kr;
    let torque = &weight * rotation.bit.torque_per_weight_m
        + unit(spin + n - 1) * rotation.bit.torque_per_speed_N_m_s;
    for i in 0..n {
        rows[angle + i] = unit(spin + i);
        rows[depth + i] = unit(speed + i);
        for (chain, place, rate) in
            [(&rotation.torsion, angle, spin), (&rotation.axial, depth, speed)]
        {
            let mut force = unit(rate + i) * -chain.drag[i];
            if i > 0 {
                force += spring(chain, place, rate, i - 1);
            }
            if i < n - 1 {
                force -= spring(chain, place, rate, i);
            }
            rows[rate + i] = force / chain.inertia[i];
        }
    }
    rows[spin + n - 1] -= torque / rotation.torsion.inertia[n - 1];
    rows[speed + n - 1] -= &weight / rotation.axial.inertia[n - 1];
    // The drive: M = M₀ + J_½ Ω', Ω_r = −(M − slow)/Z, T = K_p (Ω_r − Ω) + K_i ∫.
    let own = rotation.torsion.inertia[0];
    let felt = spring(&rotation.torsion, angle, spin, 0);
    let (kp, ki) = (gains.proportional_N_m_s, gains.integral_N_m);
    let (hears, corner) =
        gains.shown.map_or((0.0, 0.0), |s| (1.0 / s.impedance_N_m_s, s.corner_rad_per_s));
    let rubs = unit(spin) * rotation.torsion.drag[0];
    let push = ((&felt - unit(slow)) * -hears - unit(spin)) * kp + unit(missed) * ki - &felt - rubs;
    rows[spin] = push / (own + inertia_kg_m2 + kp * own * hears);
    let all = &felt + &rows[spin] * own;
    rows[missed] = (&all - unit(slow)) * -hears - unit(spin);
    rows[slow] = (all - unit(slow)) * corner;
    // The hoist.
    let drum = (unit(heard) + unit(sum) / driller.integral_time_s) * -driller.gain_m_per_s_per_N;
    let line = (unit(depth) - unit(block)) * kl + (unit(speed) - &drum) * cl;
    let mass = rotation.axial.inertia[0];
    rows[speed] = (&rows[speed] * mass - line) / (mass + block_kg);
    rows[block] = drum;
    rows[heard] = (&weight - unit(heard)) / driller.filter_s;
    rows[sum] = unit(heard);
    rows[front] = weight * rate + unit(spin + n - 1) * rotation.bit.advance_per_angle_m;
    DMatrix::from_fn(size, size, |i, j| rows[i][j]).complex_eigenvalues().iter().copied().collect()
}

/// Forty strings at random, some stable: as many growing roots in the band as eigenvalues, and the
/// same that grows most, to the rounding of a matrix whose numbers differ by 1e10.
#[test]
fn roots_are_the_eigenvalues_of_the_first_order_system() {
    let mut numbers = Numbers(7);
    let (mut stable, mut followed) = (0, 0);
    let band = band(0.2, 60.0);
    for _ in 0..40 {
        let string = string(&mut numbers);
        let within = |s: &&Complex<f64>| (0.2..=60.0).contains(&s.modulus());
        let all = eigenvalues(&string);
        let found = string.stability(band);
        let growing = all.iter().filter(within).filter(|s| s.re > 0.0).count();
        assert_eq!(found.unstable_roots, growing, "{found:?}");
        assert!(found.complete, "{found:?}");
        stable += usize::from(growing == 0);
        let first = all.iter().filter(within).max_by(|a, b| a.re.total_cmp(&b.re)).expect("roots");
        let root = found.worst.expect("a root");
        let s = Complex::new(root.growth_per_s, std::f64::consts::TAU * root.frequency_Hz);
        let apart = (s - Complex::new(first.re, first.im.abs())).modulus();
        assert!(growing == 0 || apart < 1e-5 * first.modulus(), "{s} {first}");
        followed += usize::from(apart < 1e-5 * first.modulus());
    }
    // Both kinds were among them; of a stable string a strongly damped root may be missed.
    assert!((5..36).contains(&stable), "{stable}");
    assert!(followed >= 38, "{followed}");
}

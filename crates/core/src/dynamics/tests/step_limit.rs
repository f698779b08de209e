//! The planned step: stable, and not much shorter than the one that is not.

use nalgebra::DMatrix;

use super::bench::{Bench, COLLAR_M, PIPE_M};
use crate::{
    dynamics::{kernel::chain::node, output::energy},
    rod::{
        element::react,
        stability::{self, SAFETY},
    },
    simd::vector::Vector,
};

/// Sections of a bottom-hole assembly, m, from the bit up; short ones among them.
const ASSEMBLY: [([f64; 2], f64); 8] = [
    ([0.2159, 0.06], 0.34),
    ([0.172, 0.057], 7.69),
    ([0.165, 0.0714], 0.5),
    ([0.206, 0.0714], 1.53),
    ([0.165, 0.0714], 9.09),
    ([0.1524, 0.0714], 0.6),
    (COLLAR_M, 9.47),
    ([0.1397, 0.0921], 84.53),
];

/// Highest angular frequency of the chain as assembled, rad/s: dense eigenvalues of bending and
/// stretch in a plane, and of torsion.
fn highest(rod: &Bench) -> f64 {
    let n = rod.chain.nodes();
    let mut k: DMatrix<f64> = DMatrix::zeros(3 * n, 3 * n);
    let mut torsion: DMatrix<f64> = DMatrix::zeros(n, n);
    for e in 0..n - 1 {
        let stiffness = rod.chain.stiffness(e);
        let rest = rod.chain.pose(e);
        let forces = |q: [f64; 6]| {
            let mut pose = rest;
            pose.displacement = pose.displacement + Vector(q[3] - q[0], 0.0, q[4] - q[1]);
            pose.d1 = Vector(q[2].sin(), 0.0, q[2].cos());
            pose.d2 = Vector(q[5].sin(), 0.0, q[5].cos());
            let r = react(&stiffness, &pose, 0.0, 0.0);
            [
                -r.force.0,
                -r.force.2,
                r.moment1(pose.d1).1,
                r.force.0,
                r.force.2,
                r.moment2(pose.d2).1,
            ]
        };
        for j in 0..6 {
            let h = 1e-6;
            let at = |h: f64| {
                let mut q = [0.0; 6];
                q[j] = h;
                forces(q)
            };
            let (plus, minus) = (at(h), at(-h));
            for i in 0..6 {
                k[(3 * e + i, 3 * e + j)] -= (plus[i] - minus[i]) / (2.0 * h);
            }
        }
        for (i, j, sign) in [(e, e, 1.0), (e + 1, e + 1, 1.0), (e, e + 1, -1.0), (e + 1, e, -1.0)] {
            torsion[(i, j)] += sign * stiffness.twist;
        }
    }
    let inertia = |i: usize| match i % 3 {
        0 => node!(rod.chain, i / 3, mass_lateral),
        1 => node!(rod.chain, i / 3, mass_axial),
        _ => rod.rotary_kg_m2(i / 3),
    };
    let plane = DMatrix::from_fn(3 * n, 3 * n, |i, j| {
        0.5 * (k[(i, j)] + k[(j, i)]) / (inertia(i) * inertia(j)).sqrt()
    });
    let twist = DMatrix::from_fn(n, n, |i, j| {
        torsion[(i, j)] / (node!(rod.chain, i, polar) * node!(rod.chain, j, polar)).sqrt()
    });
    let most = |matrix: DMatrix<f64>| matrix.symmetric_eigenvalues().max();
    f64::max(most(plane), most(twist)).sqrt()
}

/// Runs a disturbed rod for `steps` of `dt`: how much the kinetic energy has grown.
fn growth(rod: &mut Bench, dt: f64, steps: usize) -> f64 {
    rod.input.dt = dt;
    let mut state = 7u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        1e-6 * ((state >> 11) as f64 / (1u64 << 52) as f64 - 1.0)
    };
    for i in 0..rod.chain.nodes() {
        rod.chain.set_velocity(i, Vector(random(), random(), random()));
        rod.chain.set_turning(i, Vector(random(), random(), 0.0));
        node!(rod.chain, i, spin = random());
    }
    let before = energy::kinetic_J(&rod.chain);
    let mut most: f64 = 0.0;
    for _ in 0..steps {
        rod.step();
        let now = energy::kinetic_J(&rod.chain) / before;
        most = most.max(now);
        if now.is_nan() || now > 1e6 {
            return f64::INFINITY;
        }
    }
    most
}

/// The elements' own bound: no frequency of the whole exceeds it for any string, and the plan uses
/// a stated part of it. It is sharp for uniform pipe, whose shortest wave has both halves of every
/// node's mass in step.
#[test]
fn no_frequency_of_the_whole_exceeds_the_elements() {
    let pipe = [(PIPE_M, 100.0)];
    for (what, parts, element_length, sharp) in [
        ("pipe", &pipe[..], 3.2, true),
        ("pipe", &pipe[..], 0.4, false),
        ("assembly", &ASSEMBLY[..], 4.8, false),
        ("assembly", &ASSEMBLY[..], 3.2, false),
        ("assembly", &ASSEMBLY[..], 1.6, false),
        ("assembly", &ASSEMBLY[..], 0.5, false),
    ] {
        let rod = Bench::new(parts, element_length, 0.0);
        let used = 0.5 * rod.plan.dt_s * highest(&rod);
        assert!(used <= SAFETY * (1.0 + 1e-6), "{what} {element_length} m: {used}");
        assert!(!sharp || used > SAFETY * (1.0 - 1e-4), "{used}");
    }
}

/// Maximum variation of the kinetic energy of one frequency at the fraction `S` of its limit: `1/(1
/// − S²)`.
fn swing() -> f64 {
    1.0 / (1.0 - SAFETY * SAFETY)
}

/// Driven: at the planned step a disturbance keeps its size over 20000 steps, a tenth beyond the
/// limit of the assembled chain it explodes.
#[test]
fn the_planned_step_is_stable_and_a_tenth_beyond_the_limit_is_not() {
    for (parts, element_length) in
        [(&[(PIPE_M, 100.0)][..], 3.2), (&ASSEMBLY[..], 3.2), (&ASSEMBLY[..], 0.8)]
    {
        let rod = || Bench::new(parts, element_length, 0.0);
        let planned = rod().plan.dt_s;
        let planned_growth = growth(&mut rod(), planned, 20_000);
        let limit = 2.0 / highest(&rod());
        let lost = growth(&mut rod(), 1.1 * limit, 20_000);
        assert!(planned_growth < swing(), "{planned_growth}");
        assert!(lost.is_infinite(), "{lost}");
    }
}

/// Stiffness-proportional damping shortens the limit by `√(1 + ξ²) − ξ`, `ξ = βω/2`: a uniform pipe
/// has one `ω`, that of its undamped plan. Driven too.
#[test]
fn damping_shortens_the_step_as_its_formula_says() {
    let parts = [(PIPE_M, 100.0)];
    let undamped = Bench::new(&parts, 3.2, 0.0).plan.dt_s;
    let omega = 2.0 * SAFETY / undamped;
    for beta in [1e-5, 1e-4, 1e-3] {
        let rod = || Bench::new(&parts, 3.2, beta);
        let xi = 0.5 * beta * omega;
        let shorter = ((1.0 + xi * xi).sqrt() - xi) * undamped;
        let planned = rod().plan.dt_s;
        assert!((planned / shorter - 1.0).abs() < 1e-9, "{planned} {shorter}");
        assert!(growth(&mut rod(), planned, 20_000) < swing());
        assert!(growth(&mut rod(), 1.1 / SAFETY * planned, 20_000).is_infinite());
    }
}

/// Uniform pipe gets no added mass, an assembly up to 0.3 %, and the reported mass is the excess of
/// the nodes' mass over that of the steel.
#[test]
fn added_mass_is_small_and_reported() {
    for beta in [0.0, 1e-5] {
        let pipe = Bench::new(&[(PIPE_M, 100.0)], 3.2, beta);
        assert!(pipe.plan.added_axial_mass_fraction < 1e-9);
    }
    // A few longer elements do not make the others heavier.
    let mixed = Bench::new(&[(COLLAR_M, 7.4), (PIPE_M, 96.0)], 3.2, 1e-5);
    assert!(mixed.plan.added_axial_mass_fraction < 1e-9);
    for element_length in [0.8, 1.6, 3.2, 4.8] {
        let rod = Bench::new(&ASSEMBLY, element_length, 1e-5);
        let steel: f64 =
            rod.mesh.elements.iter().map(|e| e.section.steel_kg_per_m * e.length_m).sum();
        let nodes: f64 = (0..rod.chain.nodes()).map(|i| node!(rod.chain, i, mass_axial)).sum();
        let added = nodes / steel - 1.0;
        assert!((added - rod.plan.added_axial_mass_fraction).abs() < 1e-9);
        assert!(added <= 0.003 * (1.0 + 1e-9), "{added}");
        let lateral: f64 = (0..rod.chain.nodes()).map(|i| node!(rod.chain, i, mass_lateral)).sum();
        assert!(lateral >= nodes * (1.0 - 1e-12));
    }
}

/// The plan does not need a bar of any particular shape: a needle and a stub get a step.
#[test]
fn odd_rods_get_a_step() {
    for parts in
        [[([0.5, 0.0], 0.01), ([0.05, 0.049], 500.0)], [([0.05, 0.049], 0.001), ([0.5, 0.0], 20.0)]]
    {
        let rod = Bench::new(&parts, 3.2, 1e-5);
        assert!(rod.plan.dt_s > 1e-9 && rod.plan.dt_s < 1e-2, "{}", rod.plan.dt_s);
        assert!(rod.plan.inertia.iter().all(|i: &stability::ElementInertia| i.rotary_kg_m2 > 0.0));
    }
}

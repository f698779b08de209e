//! Record of a string whose state is known.

mod joints;

use std::f64::consts::{PI, TAU};

use super::{reservoir::Reservoir, *};
use crate::{
    common::{self, arcs, mud, open_hole, steel, verification},
    dynamics::{
        assemble::chain,
        kernel::chain::{Row, element, node},
    },
    rod::stability,
    simd::vector::Vector,
    string::{ComponentLength, ComponentSpec},
};

/// Pipe of 5 in over thicker pipe, 60 m each, straight down, in mud that carries all of its weight.
fn model() -> Model {
    let part = |od, id| ComponentSpec {
        yield_strength_Pa: Some(724e6),
        ..ComponentSpec::uniform("pipe", od, id, ComponentLength::Metres(60.0), steel())
    };
    let parts = vec![part(0.165, 0.0714), part(0.127, 0.1086)];
    let path = arcs(&[[0.0; 3], [120.0, 0.0, 0.0]]);
    let mud = mud(steel().density_kg_per_m3);
    common::model(path, open_hole(0.2159, 0.2, 120.0), parts, mud, 120.0)
}

/// The string at rest on the hole's axis, and the high side of a vertical hole: north.
fn string() -> (Model, Mesh, Chain, Vec<Rows<f64>>) {
    let model = model();
    let mesh = Mesh::uniform(&model.string, 3.0);
    let lateral = chain::lateral_mass_kg_per_m(&model, &mesh, 120.0);
    let plan = stability::plan(&mesh, &lateral, 0.0);
    let mut chain = chain::chain(&model, &mesh, &plan);
    for (index, element) in mesh.elements.iter().enumerate() {
        chain.set_anchor_chord(index, Vector(0.0, 0.0, element.length_m));
    }
    let north = [1.0, 0.0, 0.0].map(Row::filled);
    let high = vec![north; chain.layout().blocks()];
    (model, mesh, chain, high)
}

/// E03: a pipe of radius `r` that rolls without slip in a hole of radius `R` goes round at
/// `−Ω r/(R − r)`; a bent one that turns with itself at `Ω`; one that swings to and fro not at all.
/// Exact: the rate is read from velocities, so that no whirl is too fast for the samples.
#[test]
fn whirl_goes_round_at_its_rate() {
    let (model, mesh, mut chain, high) = string();
    let rows = verification("E03_whirl_in_clearance.json");
    for row in rows["rows"].as_array().unwrap() {
        let number = |key: &str| row[key].as_f64().unwrap();
        let [hole, pipe] = ["R_hole", "r_pipe"].map(number);
        let spin = number("rpm") * TAU / 60.0;
        let expected = row["expected"]["backward_whirl_rad_s"].as_f64().unwrap();
        let backward = -spin * pipe / (hole - pipe);
        assert!((backward / expected - 1.0).abs() < 1e-12);
        let mut record = Record::new(&model, &mesh, chain.layout(), 37);
        for sample in 0..37 {
            let time = f64::from(sample) * 0.01;
            // Nodes 1, 2 and 3; while they go round, the string slides along the hole.
            let motions = [backward, spin].map(|rate| {
                let (sin, cos) = (rate * time).sin_cos();
                let radius = hole - pipe;
                (
                    Vector(radius * cos, radius * sin, 0.01),
                    Vector(-radius * rate * sin, radius * rate * cos, 0.3),
                )
            });
            let swing = (TAU * f64::from(sample) / 37.0).sin_cos();
            let swings = (
                Vector(0.01 * swing.0, 0.02 * swing.0, 0.0),
                Vector(0.1 * swing.1, 0.2 * swing.1, 0.3),
            );
            for (index, (place, velocity)) in [motions[0], motions[1], swings].iter().enumerate() {
                chain.set_displacement(index + 1, *place);
                chain.set_velocity(index + 1, *velocity);
            }
            chain.close();
            record.sample(&chain, &high, &Body::default(), 1);
        }
        let [rolls, turns, swings] = [1, 2, 3].map(|i| record.circling(i));
        for (found, rate) in [(rolls, backward), (turns, spin)] {
            assert!((found.rate_rad_per_s / rate - 1.0).abs() < 1e-12, "{found:?}");
            assert!((found.coherence - 1.0).abs() < 1e-12, "{found:?}");
        }
        assert!(swings.coherence < 1e-20, "{swings:?}");
        let speed = (hole - pipe) * backward.abs();
        assert!((record.lateral_speed(1) / speed - 1.0).abs() < 1e-12);
    }
}

/// A string bent to a circle of 200 m, under tension and torque: the bending moment is, since the
/// forces that hold it act at the nodes, `x coth x EI/ρ` at them, `x = (L/2)√(T/EI)` (`T L²/12ρ`
/// more, where they are near to each other), and `x/sinh x EI/ρ` half-way; the stress is that of
/// the textbook. The element's moment is proportional to the sine of half its bend `L/ρ`: it is
/// less by `(L/ρ)²/24` = 1e-5.
#[test]
fn moment_and_stress_of_a_circle() {
    const RADIUS_M: f64 = 200.0;
    const TENSION_N: f64 = 4e5;
    const TORQUE_N_M: f64 = -2e4;
    let (model, mesh, mut chain, high) = string();
    for (index, node) in mesh.nodes.iter().enumerate() {
        let md = 120.0 - node.from_bit_m;
        let (sin, cos) = (md / RADIUS_M).sin_cos();
        let straight = Vector(0.0, 0.0, md);
        let bent = Vector(RADIUS_M * (1.0 - cos), 0.0, RADIUS_M * sin);
        chain.set_displacement(index, bent - straight);
        chain.set_director(index, Vector(sin, 0.0, cos));
    }
    for index in 0..chain.elements() {
        element!(chain, index, tension = TENSION_N);
        element!(chain, index, torque = TORQUE_N_M);
    }
    let mut record = Record::new(&model, &mesh, chain.layout(), 1);
    chain.close();
    record.sample(&chain, &high, &Body::default(), 1);
    let middle = |from_bit_m: f64| {
        let off = |i: &usize| (mesh.nodes[*i].from_bit_m - from_bit_m).abs();
        (0..mesh.nodes.len()).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap()
    };
    for (from_bit_m, od, id) in [(30.0, 0.165_f64, 0.0714_f64), (90.0, 0.127, 0.1086)] {
        let index = middle(from_bit_m);
        let second_moment = PI / 64.0 * (od.powi(4) - id.powi(4));
        let area = PI / 4.0 * (od * od - id * id);
        let stiffness = 210e9 * second_moment;
        let x = 0.5 * mesh.elements[index].length_m * (TENSION_N / stiffness).sqrt();
        let moment = stiffness / RADIUS_M * x / x.tanh();
        let bending_stress = moment * od / (2.0 * second_moment);
        let shear = TORQUE_N_M * od / (4.0 * second_moment);
        let stress = (TENSION_N / area + bending_stress).hypot(3.0_f64.sqrt() * shear);
        let close = |found: f64, expected: f64| {
            assert!((found / expected - 1.0).abs() < 5e-5, "{found} for {expected}");
        };
        close(record.bending(index), moment);
        close(record.bending_max(index), moment);
        close(record.between(index), stiffness / RADIUS_M * x / x.sinh());
        close(record.between_max(index), record.between(index));
        close(record.bending(index) * record.strength().per_modulus_m3(index), bending_stress);
        close(record.stress(index), stress);
        close(record.stress_max(index), stress);
    }
    // Where the two pipes meet, the weaker one governs.
    let joint = middle(60.0);
    let strength = record.strength();
    let thin = strength.per_modulus_m3(middle(90.0));
    assert_eq!(strength.per_modulus_m3(joint), thin);
    assert_eq!(strength.yield_Pa(joint), Some(724e6));
}

/// A tube under tension, bending, torque and different pressures inside and outside has von Mises'
/// stress of all six components, with Lamé's radial and hoop stresses and the real axial force, at
/// the surface with the greater stress: the outer one while the pressures are alike, the inner one
/// when it is about to burst.
#[test]
fn pressures_stress_the_tube_as_lame_has_it() {
    let (model, mesh, chain, _) = string();
    let mut strength = Strength::new(&model, &mesh, chain.layout());
    let (index, od, id) = (5, 0.127_f64, 0.1086_f64);
    let (outer, inner) = (PI / 4.0 * od * od, PI / 4.0 * id * id);
    let (area, second_moment) = (outer - inner, PI / 64.0 * (od.powi(4) - id.powi(4)));
    let (tension, bending, torque) = (8e5, 1e4, 2e4);
    let mut worst_inside = 0;
    for (p_o, p_i) in [(40e6, 40e6), (40e6, 47e6), (20e6, 110e6), (60e6, 10e6)] {
        let surface = |radius: f64| {
            let lame = (p_i * inner - p_o * outer) / area;
            let differs = (p_i - p_o) * inner * outer / (PI * radius * radius * area);
            let axial =
                (tension + p_i * inner - p_o * outer) / area + bending * radius / second_moment;
            let (hoop, radial) = (lame + differs, lame - differs);
            let shear = torque * radius / (2.0 * second_moment);
            (0.5 * ((axial - hoop).powi(2) + (hoop - radial).powi(2) + (radial - axial).powi(2))
                + 3.0 * shear * shear)
                .sqrt()
        };
        let (out, within) = (surface(0.5 * od), surface(0.5 * id));
        worst_inside += u8::from(within > out);
        strength.press(|_| p_i - p_o);
        let (block, lane) = chain.layout().place(index);
        let found = strength.block(block).stress_Pa(lane, tension, bending, torque);
        let error = found / out.max(within) - 1.0;
        assert!(error.abs() < 1e-12, "{p_o} {p_i}: {found}, {error:e} off");
    }
    assert!((1..4).contains(&worst_inside), "both surfaces are tried");
}

/// Contact quantities are averages over the steps since the last sample, signed by the side.
#[test]
fn contact_is_averaged_and_signed() {
    let (model, mesh, mut chain, high) = string();
    let mut record = Record::new(&model, &mesh, chain.layout(), 1);
    for (index, side) in [(1, 1.0), (2, -1.0)] {
        chain.set_displacement(index, Vector(side * 0.02, 0.01, 0.0));
    }
    for (sample, normal) in [600.0, 0.0, 200.0].into_iter().enumerate() {
        for index in [1, 2] {
            node!(chain, index, sum_normal = normal);
            node!(chain, index, sum_torque = 0.1 * normal);
        }
        chain.close();
        let totals = record.sample(&chain, &high, &Body::default(), 20);
        assert!((totals.normal_N - 2.0 * normal / 20.0).abs() < 1e-12, "{sample}");
    }
    for (index, sign) in [(1, 1.0), (2, -1.0)] {
        let close =
            |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12, "{found}");
        close(record.normal(index).mean, 40.0 / 3.0);
        close(record.normal_max(index), 30.0);
        close(record.touched(index), 2.0 / 3.0);
        close(record.signed(index), sign * 40.0 / 3.0);
        close(record.friction_torque(index), 4.0 / 3.0);
        assert_eq!(record.percentiles(Quantity::Contact)[index][1], 10.0, "the median");
        // Between nothing, 10 and 30 N a tenth of the way from either end.
        let expected = if sign > 0.0 { [1.0, 10.0, 28.0] } else { [-28.0, -10.0, -1.0] };
        for (found, expected) in record.percentiles(Quantity::Side)[index].into_iter().zip(expected)
        {
            // Kept in single precision.
            assert!((found - expected).abs() < 1e-5, "{found} for {expected}");
        }
    }
}

fn filled(samples: u32, value: impl Fn(u32) -> f64) -> Reservoir {
    let mut reservoir = Reservoir::new(1, 0);
    for sample in 0..samples {
        if let Some(mut row) = reservoir.next() {
            row.fill(value(sample) as f32);
        }
    }
    reservoir
}

/// While all samples are kept the percentiles are exact but for the rounding of single precision.
#[test]
fn percentiles_of_few_samples_are_exact() {
    let reservoir = filled(601, |sample| f64::from((sample * 123) % 601));
    let found = reservoir.percentiles(Quantity::Bending)[0][5];
    assert_eq!(found, [30.0, 300.0, 570.0]);
    assert_eq!(Reservoir::new(1, 0).percentiles(Quantity::Torque)[0][0], [0.0; 3]);
}

/// Whatever the length of a run, 320 to 640 samples of each node of a short string are kept. A
/// percentile `p` from `n` of them has the standard error `√(p(1 − p)/n)` in rank: 1.2 % at most
/// for the 5th, 2.8 % for the median. Three of these are allowed. The period of the sine is a
/// multiple of every stride: kept at even spacing, it would be met at one or two phases only.
#[test]
fn percentiles_of_many_samples_do_not_beat_with_a_period() {
    const SAMPLES: u32 = 100_000;
    let sine = |sample: u32| (TAU * f64::from(sample) / 64.0 + 0.3).sin();
    let found = filled(SAMPLES, sine).percentiles(Quantity::Tension)[0][0];
    for (value, part, error) in
        [(found[0], 0.05, 0.012), (found[1], 0.5, 0.028), (found[2], 0.95, 0.012)]
    {
        // Single precision may have moved it by a ten-millionth.
        let below = |value: f64| {
            let count = (0..SAMPLES).filter(|sample| sine(*sample) < value).count();
            count as f64 / f64::from(SAMPLES)
        };
        let ranks = below(value - 1e-7) - 3.0 * error..below(value + 1e-7) + 3.0 * error;
        assert!(ranks.contains(&part), "{value} has the ranks {ranks:?}");
    }
}

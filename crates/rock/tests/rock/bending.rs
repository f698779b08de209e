//! A beam of elements: deflection, and the stiffness of its hourglasses.

use wholestring_rock::{Block, BlockSpec, Edge, Rock, Stepper};
use wholestring_verification::verify;

use crate::setup::{elastic, step};

/// A cantilever of eight times its depth under a load at its end, so many elements deep: deflection
/// over the theory's, and the part of the energy that is in hourglasses.
fn cantilever(deep: usize) -> [f64; 2] {
    use Edge::{Free, Guided, Held};
    let rock = Rock { poisson_ratio: 0.0, ..elastic() };
    let size_m = 8e-3 / deep as f64;
    let (long, load_N) = (8 * deep, 10.0);
    let spec = BlockSpec {
        edges: [Held, Free, Guided, Free, Free, Free],
        ..BlockSpec::new(rock, [long, 1, deep], size_m)
    };
    let mut block = Block::new(&spec).expect("a sound block");
    let (grid, stepper) = (*block.grid(), Stepper::default());
    let (l, d): (f64, f64) = (8.0 * 8e-3, 8e-3);
    let (area, inertia) = (size_m * d, size_m * d * d * d / 12.0);
    let e = rock.youngs_modulus_Pa;
    let theory_m = load_N * l.powi(3) / (3.0 * e * inertia)
        + load_N * l / (5.0 / 6.0 * rock.shear_modulus_Pa() * area);
    // Damped near the critical of the first mode, for three of its periods.
    let frequency = 3.516 / (l * l) * (e * inertia / (rock.density_kg_per_m3 * area)).sqrt();
    let steps = (3.0 * std::f64::consts::TAU / frequency / block.dt_s()) as usize;
    let tip: Vec<usize> = (0..=deep)
        .flat_map(|k| (0..=1).map(move |j| [long, j, k]))
        .map(|node| grid.node(node))
        .collect();
    let nodes: Vec<usize> = grid.each_node().map(|node| grid.node(node)).collect();
    for n in 0..steps {
        step(&mut block, &stepper);
        for &index in nodes.iter().skip(n % 4).step_by(4) {
            // Each is braked in every fourth step, four times as hard.
            let factor = -8.0 * frequency * block.mass_kg(index);
            let force = block.velocity_m_per_s(index).map(|v| factor * v);
            block.push(index, force);
        }
        for &index in &tip {
            block.push(index, [0.0, 0.0, load_N / tip.len() as f64]);
        }
    }
    let deflection =
        tip.iter().map(|&i| block.displacement_m(i)[2]).sum::<f64>() / tip.len() as f64;
    let energies = block.energies();
    [deflection / theory_m, energies.hourglass_J / (energies.elastic_J + energies.hourglass_J)]
}

#[test]
fn a_beam_bends_as_timoshenkos() {
    let found = [4, 8].map(cantilever);
    for (deep, [deflection, hourglass]) in [4, 8].into_iter().zip(found) {
        verify(
            "rock",
            format!("deflection of a cantilever {deep} elements deep as a part of Timoshenko's"),
        )
        .relative(
            1.2 / (deep * deep) as f64,
            "one point of integration misses the bending within an element, the square of \
                 its part of the depth",
        )
        .report(1.0, deflection);
        verify(
            "rock",
            format!("energy in hourglasses of a cantilever {deep} elements deep as a part"),
        )
        .absolute(0.05, "required")
        .report(0.0, hourglass);
    }
    let [coarse, fine] = found.map(|[deflection, _]| deflection - 1.0);
    let order = (coarse / fine).log2();
    verify("rock", "order of convergence of the cantilever's deflection")
        .absolute(0.4, "two meshes, one of them coarse")
        .report(2.0, order);
}

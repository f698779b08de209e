//! A rigid sphere on the rock.

use wholestring_rock::{Block, BlockSpec, Edge, Rock, Stepper};
use wholestring_verification::{Tolerance, verify};

use crate::setup::{elastic, step};

/// Displacement of a half-space under a point load at the origin, m (Boussinesq).
fn far_m(rock: &Rock, load_N: f64, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let nu = rock.poisson_ratio;
    let r = (x * x + y * y + z * z).sqrt();
    let unit = load_N * (1.0 + nu) / (std::f64::consts::TAU * rock.youngs_modulus_Pa);
    let across = z / r.powi(3) - (1.0 - 2.0 * nu) / (r * (r + z));
    let down = 2.0 * (1.0 - nu) / r + z * z / r.powi(3);
    [unit * x * across, unit * y * across, unit * down]
}

/// A quarter of a sphere is pressed into a quarter of a block, its contact `elements` in radius;
/// force over Hertz'.
fn press(elements: f64, cells: usize) -> f64 {
    use Edge::{Free, Guided, Held};
    let (rock, size_m) = (elastic(), 1e-3);
    let spec = BlockSpec {
        edges: [Guided, Held, Guided, Held, Free, Held],
        ..BlockSpec::new(rock, [cells; 3], size_m)
    };
    let mut block = Block::new(&spec).expect("a sound block");
    let (grid, stepper, dt) = (*block.grid(), Stepper::default(), block.dt_s());
    let contact_m = elements * size_m;
    let radius_m = 20.0 * contact_m;
    let depth_m = contact_m * contact_m / radius_m;
    // The surface is pushed by a bed of springs four times as stiff as a layer of elements.
    let waves = rock.pressure_wave_m_per_s();
    let bed = 4.0 * rock.density_kg_per_m3 * waves * waves / size_m;
    let outer: Vec<_> = grid
        .each_node()
        .filter(|node| node.contains(&cells))
        .map(|node| (grid.node(node), node.map(|n| n as f64 * size_m)))
        .collect();
    let transit = cells as f64 * size_m / waves / dt;
    let (ramp, steps) = ((30.0 * transit) as usize, (40.0 * transit) as usize);
    let (mut load_N, mut mean_N, mut count) = (0.0, 0.0, 0.0);
    for n in 0..steps {
        let part = (n as f64 / ramp as f64).min(1.0);
        let depth = depth_m * (std::f64::consts::FRAC_PI_2 * part).sin().powi(2);
        step(&mut block, &stepper);
        let centre = [0.0, 0.0, depth - radius_m];
        let mut pushes = Vec::new();
        let mut sum_N = 0.0;
        for node in block.exposed() {
            let [x, y, z] = [0, 1, 2].map(|a| node.position_m[a] - centre[a]);
            let away = (x * x + y * y + z * z).sqrt();
            if away < radius_m {
                let push = bed * -node.area_m2[2] * (radius_m - away) / away;
                pushes.push((node.index, [push * x, push * y, push * z]));
                sum_N += push * z;
            }
        }
        for (index, force) in pushes {
            block.push(index, force);
        }
        // The outer faces go where those of a half-space would be.
        load_N += 0.05 * (4.0 * sum_N - load_N);
        for &(index, place) in &outer {
            let (goal, now) = (far_m(&rock, load_N, place), block.displacement_m(index));
            block.tell(index, [0, 1, 2].map(|a| (goal[a] - now[a]) / (20.0 * dt)));
        }
        if n > ramp + 2 * transit as usize {
            mean_N += 4.0 * sum_N;
            count += 1.0;
        }
    }
    let modulus = rock.youngs_modulus_Pa / (1.0 - rock.poisson_ratio.powi(2));
    mean_N / count / (4.0 / 3.0 * modulus * radius_m.sqrt() * depth_m.powf(1.5))
}

#[test]
fn a_sphere_is_borne_as_hertz_has_it() {
    for (elements, cells) in [(3.0, 12), (5.0, 20)] {
        let computed = press(elements, cells);
        verify(
            "rock",
            format!(
                "force of a sphere with a contact {elements} elements in radius as a part of Hertz'"
            ),
        )
        .within(
            if elements < 4.0 { Tolerance::Any } else { Tolerance::Relative(0.05) },
            "required; the bed of springs that the sphere rests on yields by a \
                 fourteenth of an element's part of the contact",
        )
        .report(1.0, computed);
    }
}

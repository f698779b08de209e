//! A rigid ball that is dragged through a block: failure, removal, and its use in other tests.

use wholestring_rock::{Block, BlockSpec, Executor, Rock, Stepper};

/// A block of weak sandstone under pressure, in slabs of two layers.
pub fn block() -> Block {
    let spec = BlockSpec {
        pressure_Pa: 5e6,
        confinement_Pa: 8e6,
        layers_per_slab: 2,
        ..BlockSpec::new(
            Rock { compressive_fracture_energy_J_per_m2: 2000.0, ..Rock::of_strength(30e6) },
            [21, 12, 8],
            1e-3,
        )
    };
    Block::new(&spec).expect("a sound block")
}

/// A ball of 6 mm that goes down and along.
pub struct Ball {
    centre_m: [f64; 3],
    velocity_m_per_s: [f64; 3],
}

impl Ball {
    pub fn new() -> Self {
        Self { centre_m: [5e-3, 6e-3, -6e-3], velocity_m_per_s: [8.0, 0.0, 4.0] }
    }

    /// A step of the block, and the ball's pushes after it; how many elements went.
    pub fn drag(
        &mut self,
        block: &mut Block,
        stepper: &Stepper,
        executor: &impl Executor,
    ) -> usize {
        let removed = block.step(stepper, executor);
        for (centre, v) in self.centre_m.iter_mut().zip(self.velocity_m_per_s) {
            *centre += block.dt_s() * v;
        }
        let rock = block.rock();
        let stiffness = rock.density_kg_per_m3 * rock.pressure_wave_m_per_s().powi(2) * 1e-3;
        let mut pushes = Vec::new();
        for node in block.exposed() {
            let [x, y, z] = [0, 1, 2].map(|a| node.position_m[a] - self.centre_m[a]);
            let away = (x * x + y * y + z * z).sqrt();
            if away < 6e-3 {
                let push = stiffness * (6e-3 - away) / away;
                pushes.push((node.index, [push * x, push * y, push * z]));
            }
        }
        for (index, force) in pushes {
            block.push(index, force);
        }
        removed
    }
}

//! What breaking a bar takes, for bricks of three sizes.

use wholestring::rock::{Block, BlockSpec, Edge, Rock, Stepper};

use crate::{
    common::{Row, Tolerance, report},
    setup::{step, tell_layer_down},
};

const LONG_M: f64 = 24e-3;
const WIDE_M: f64 = 4e-3;

/// How much of its strength the middle layer has.
const WEAK: f64 = 0.99;

/// Pulls or presses a bar of bricks until its middle layer is gone; the energy it took per area, J/m².
fn break_bar(rock: Rock, wide: usize, speed_m_per_s: f64) -> f64 {
    use Edge::{Free, Guided};
    let size_m = WIDE_M / wide as f64;
    let deep = (LONG_M / size_m).round() as usize;
    let spec = BlockSpec {
        edges: [Free, Free, Free, Free, Guided, Guided],
        ..BlockSpec::new(rock, [wide, wide, deep], size_m)
    };
    let mut block = Block::new(&spec).expect("a sound block");
    let stepper = Stepper::default();
    let layer = deep / 2;
    for i in 0..wide {
        for j in 0..wide {
            block.weaken([i, j, layer], WEAK);
        }
    }
    // Gently on.
    let begin_s = 5e-5;
    let mut time_s = 0.0;
    while block.spent(layer) < wide * wide {
        time_s += block.dt_s();
        assert!(time_s < 0.02, "the bar does not break");
        let speed = speed_m_per_s * (time_s / begin_s).min(1.0);
        tell_layer_down(&mut block, deep, speed);
        step(&mut block, &stepper);
    }
    let energies = block.energies();
    assert!(energies.residual_J().abs() < 0.01 * energies.given_J());
    energies.plastic_J / (WIDE_M * WIDE_M)
}

/// Bricks that a layer has lost.
trait Spent {
    fn spent(&self, layer: usize) -> usize;
}

impl Spent for Block {
    fn spent(&self, layer: usize) -> usize {
        let [nx, ny, _] = self.grid().cells;
        (0..nx)
            .flat_map(|i| (0..ny).map(move |j| [i, j, layer]))
            .filter(|&brick| self.intact(brick).is_none())
            .count()
    }
}

fn rock() -> Rock {
    let rock = Rock::of_strength(50e6);
    Rock {
        // What shears does not swell less than friction asks: plastic work is then work against cohesion alone.
        dilation_angle_rad: rock.friction_angle_rad,
        ..rock
    }
}

#[test]
fn a_pulled_bar_takes_the_fracture_energy_whatever_the_bricks() {
    let rock = rock();
    for wide in [1, 2, 4] {
        let computed = break_bar(rock, wide, 0.1);
        report(&Row {
            case: "rock",
            quantity: &format!("energy to tear a bar {wide} bricks wide, J/m2"),
            expected: WEAK * WEAK * rock.tensile_fracture_energy_J_per_m2,
            computed,
            tolerance: Tolerance::Relative(0.03),
            reason: "what neighbours of the crack flow besides",
        });
    }
}

#[test]
fn a_pressed_bar_takes_the_fracture_energy_whatever_the_bricks() {
    let rock = rock();
    for wide in [1, 2, 4] {
        let computed = break_bar(rock, wide, -1.0);
        report(&Row {
            case: "rock",
            quantity: &format!("energy to crush a bar {wide} bricks wide, J/m2"),
            expected: WEAK * WEAK * rock.compressive_fracture_energy_J_per_m2,
            computed,
            tolerance: Tolerance::Relative(0.05),
            reason: "what neighbours of the band flow besides",
        });
    }
}

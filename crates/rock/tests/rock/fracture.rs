//! Energy of breaking, for elements of three sizes.

use wholestring_rock::{Block, BlockSpec, Edge, Energies, Rock, Stepper};
use wholestring_verification::verify;

use crate::setup::{step, tell_layer_down};

const LONG_M: f64 = 24e-3;
const WIDE_M: f64 = 4e-3;

/// Relative strength of the middle layer.
const WEAK: f64 = 0.99;

/// Pulls a bar, guided along its sides so that a crack runs across it, until its middle layer is
/// gone; the energy it took per area, J/m².
fn tear(rock: Rock, wide: usize) -> f64 {
    let size_m = WIDE_M / wide as f64;
    let deep = (LONG_M / size_m).round() as usize;
    let spec =
        BlockSpec { edges: [Edge::Guided; 6], ..BlockSpec::new(rock, [wide, wide, deep], size_m) };
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
        let speed = 0.1 * (time_s / begin_s).min(1.0);
        tell_layer_down(&mut block, deep, speed);
        step(&mut block, &stepper);
    }
    let energies = block.energies();
    assert!(energies.residual_J().abs() < 0.01 * energies.given_J());
    energies.plastic_J / (WIDE_M * WIDE_M)
}

/// Elements that a layer has lost.
trait Spent {
    fn spent(&self, layer: usize) -> usize;
}

impl Spent for Block {
    fn spent(&self, layer: usize) -> usize {
        let [nx, ny, _] = self.grid().cells;
        (0..nx)
            .flat_map(|i| (0..ny).map(move |j| [i, j, layer]))
            .filter(|&element| self.intact(element).is_none())
            .count()
    }
}

/// Presses or pulls one element, free at its sides, until it fails; returns the energies.
fn fail(rock: Rock, size_m: f64, speed_m_per_s: f64) -> Energies {
    use Edge::{Free, Guided};
    let spec = BlockSpec {
        edges: [Guided, Free, Guided, Free, Guided, Guided],
        ..BlockSpec::new(rock, [1, 1, 1], size_m)
    };
    let mut block = Block::new(&spec).expect("a sound block");
    let stepper = Stepper::default();
    let begin_s = 1000.0 * block.dt_s();
    let mut time_s = 0.0;
    while block.spent(0) == 0 {
        time_s += block.dt_s();
        assert!(time_s < 1.0, "the element does not fail");
        tell_layer_down(&mut block, 1, speed_m_per_s * (time_s / begin_s).min(1.0));
        step(&mut block, &stepper);
    }
    block.energies()
}

const SIZES_MM: [f64; 3] = [1.0, 2.0, 4.0];

#[test]
fn a_element_takes_the_fracture_energies_whatever_its_size() {
    let rock = Rock::of_strength(50e6);
    for (name, speed, expected) in [
        ("tear", 0.02, rock.tensile_fracture_energy_J_per_m2),
        ("crush", -0.5, rock.compressive_fracture_energy_J_per_m2),
    ] {
        for size_mm in SIZES_MM {
            let size_m = 1e-3 * size_mm;
            let energies = fail(rock, size_m, speed);
            verify("rock", format!("energy to {name} an element of {size_mm} mm, J/m²"))
                .relative(0.02, "its area at rest; it swells, and rings as it softens")
                .report(expected, energies.plastic_J / (size_m * size_m));
        }
    }
}

#[test]
fn a_bar_takes_the_same_energy_to_tear_whatever_its_elements() {
    let rock = Rock::of_strength(50e6);
    for wide in [1, 2, 4] {
        verify("rock", format!("energy to tear a bar {wide} elements wide, J/m²"))
            .relative(0.05, "shear of the crack's faces as it opens")
            .report(WEAK * WEAK * rock.tensile_fracture_energy_J_per_m2, tear(rock, wide));
    }
}

#[test]
fn a_coarse_element_takes_the_crushing_energy_of_its_volume() {
    let rock = Rock::for_drilling(50e6);
    for (name, speed) in [("tear", 0.06), ("crush", -0.2)] {
        for size_mm in [3.0, 6.0] {
            let size_m = 1e-3 * size_mm;
            let energies = fail(rock, size_m, speed);
            verify("rock", format!("energy to {name} a coarse element of {size_mm} mm, J/m³"))
                .relative(0.02, "its volume at rest; it swells, and rings as it softens")
                .report(rock.crushing_energy_J_per_m3, energies.plastic_J / size_m.powi(3));
        }
    }
}

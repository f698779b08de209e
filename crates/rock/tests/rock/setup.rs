//! Blocks that several tests use.

use wholestring_rock::{
    Alone, BitShape, Block, BlockSpec, DrillingSpec, Edge, Rock, Stepper, bit_face::PdcBit,
};

/// A rock that never fails: 60 GPa, 0.25.
pub fn elastic() -> Rock {
    Rock {
        youngs_modulus_Pa: 60e9,
        cohesion_Pa: 1e15,
        tensile_strength_Pa: 1e14,
        tensile_fracture_energy_J_per_m2: 1e30,
        compressive_fracture_energy_J_per_m2: 1e30,
        ..Rock::of_strength(100e6)
    }
}

/// A rock that yields and does not soften.
pub fn ductile(rock: Rock) -> Rock {
    Rock {
        tensile_fracture_energy_J_per_m2: 1e30,
        compressive_fracture_energy_J_per_m2: 1e30,
        ..rock
    }
}

/// A bit of 60 mm on elements of a size, of rock 400 times as dense.
pub fn small_bit(rock: Rock, size_m: f64) -> DrillingSpec {
    let bit = BitShape::Pdc(PdcBit::for_diameter(0.06));
    let mut spec = DrillingSpec::new(rock, bit, size_m).expect("a sound face");
    spec.block.numerics.density_factor = 400.0;
    spec
}

/// One element of 1 mm with its faces −x, +x, −y, +y, −z, +z.
pub fn one_element(rock: Rock, edges: [Edge; 6], pressure_Pa: f64) -> Block {
    let spec = BlockSpec {
        edges,
        pressure_Pa,
        confinement_Pa: pressure_Pa,
        ..BlockSpec::new(rock, [1, 1, 1], 1e-3)
    };
    Block::new(&spec).expect("a sound block")
}

/// One element, guided at three faces and at the lower one, free at the others.
pub fn press(rock: Rock, pressure_Pa: f64) -> Block {
    use Edge::{Free, Guided};
    one_element(rock, [Guided, Free, Guided, Free, Guided, Guided], pressure_Pa)
}

/// A step with the best instructions, on this thread.
pub fn step(block: &mut Block, stepper: &Stepper) -> usize {
    block.step(stepper, &Alone)
}

/// Tells all nodes of a layer (along z) how to move.
pub fn tell_layer(block: &mut Block, layer: usize, velocity_m_per_s: [f64; 3]) {
    let grid = *block.grid();
    for node in grid.each_node().filter(|node| node[2] == layer) {
        block.tell(grid.node(node), velocity_m_per_s);
    }
}

/// Reports a layer (along z) while its other components are free.
pub fn tell_layer_down(block: &mut Block, layer: usize, velocity_m_per_s: f64) {
    let grid = *block.grid();
    for node in grid.each_node().filter(|node| node[2] == layer) {
        let index = grid.node(node);
        let [x, y, _] = block.velocity_m_per_s(index);
        block.tell(index, [x, y, velocity_m_per_s]);
    }
}

/// Stretches of an element along the axes.
pub fn stretches(block: &Block) -> [f64; 3] {
    let grid = block.grid();
    let far = block.displacement_m(grid.node([1, 1, 1]));
    let near = block.displacement_m(grid.node([0, 0, 0]));
    [0, 1, 2].map(|axis| 1.0 + (far[axis] - near[axis]) / grid.size_m[axis])
}

/// Cauchy's stress of the only element, Pa.
pub fn cauchy_Pa(block: &Block) -> [f64; 6] {
    let volume: f64 = stretches(block).iter().product();
    block.stress_Pa([0, 0, 0]).map(|stress| stress / volume)
}

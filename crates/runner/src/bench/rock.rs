//! Solid rock: a step of a block of hexahedra with a bit pressed into it.

use serde::Serialize;
use wholestring::rock::{
    Alone, Block, BlockSpec, Edge, Grid, Rock, Stepper,
    bit_face::{BitFace, ContactLaw, PdcBit, Pose},
};

use super::{
    clock::{Clock, Spread},
    session::Bench,
};
use crate::Error;

/// Diameter of the bit, m: 8½ in.
const BIT_M: f64 = 0.2159;

/// Hexahedra along x, y and z, and their edge, m: a live zone large enough for the bit.
const CELLS: [usize; 3] = [64, 64, 12];
const EDGE_M: f64 = 4e-3;

const STRENGTH_PA: f64 = 60e6;

/// Speed of the bit downwards, m/s, and of rotation, rad/s: faster than in any drilling, so that
/// the bit soon is in the rock.
const DOWN_M_PER_S: f64 = 20.0;
const TURN_RAD_PER_S: f64 = 100.0;

/// Steps until the bit is in the rock, and steps until all of the rock is squeezed beyond yield.
const CUTTING_STEPS: usize = 600;
const SQUEEZING_STEPS: usize = 200;

/// Rate at which all of the rock is squeezed, 1/s, and its fracture energy, J/m², which is high
/// enough that the rock does not fail.
const SQUEEZING_PER_S: f64 = 100.0;
const TOUGH_J_PER_M2: f64 = 1e6;

/// Warm-up steps for caches and branch prediction, and timed steps.
const WARM_STEPS: usize = 3;
const TIMED_STEPS: usize = 20;

/// Measured speed of the solid rock.
#[derive(Debug, Serialize)]
pub struct RockSpeed {
    /// Hexahedra of the block.
    pub hexahedra: usize,
    /// Hexahedra along x, y and z.
    #[serde(skip)]
    pub cells: [usize; 3],
    /// Their edge, m.
    #[serde(skip)]
    pub edge_m: f64,
    /// Diameter of the bit, m.
    #[serde(skip)]
    pub bit_m: f64,
    /// A row for each state of the rock and instruction set.
    pub rows: Vec<RockRow>,
}

/// The rock in one state with one instruction set.
#[derive(Debug, Serialize)]
pub struct RockRow {
    /// State of the rock.
    pub rock: &'static str,
    /// The instruction set.
    pub instructions: &'static str,
    /// Time of a step per hexahedron.
    pub ns_per_hexahedron_step: Spread,
    /// Part of it that finds the nodes at the bit and applies the contact forces.
    pub contact_ns_per_hexahedron_step: f64,
    /// Fraction of the hexahedra that yield in a step.
    pub yielding: f64,
    /// Nodes that touch the bit.
    pub touching_nodes: usize,
}

impl Bench<'_> {
    /// Measures the solid rock under a bit.
    ///
    /// # Errors
    /// As [`Self::kernel`].
    pub fn rock(&self) -> Result<RockSpeed, Error> {
        let steppers = Stepper::all();
        self.begin(2 * (1 + steppers.len()));
        let mut speed = RockSpeed {
            hexahedra: CELLS.iter().product(),
            cells: CELLS,
            edge_m: EDGE_M,
            bit_m: BIT_M,
            rows: Vec::new(),
        };
        for (name, set_up) in
            [("under a bit", cut as fn() -> Result<Scene, Error>), ("all of it yielding", squeezed)]
        {
            self.next(&format!("solid rock, {name}"))?;
            let scene = set_up()?;
            let yielding = scene.clone().yielding();
            for stepper in &steppers {
                self.next(&format!("solid rock, {name}, {}", stepper.instructions))?;
                let each_ns = 1e9 / (TIMED_STEPS * speed.hexahedra) as f64;
                let mut contact_s = Vec::new();
                let mut touching_nodes = 0;
                let time_s = self.repeat(|| {
                    let mut scene = scene.clone();
                    scene.go(stepper, WARM_STEPS);
                    let clock = Clock::begin();
                    contact_s.push(scene.go(stepper, TIMED_STEPS));
                    let time_s = clock.elapsed_s();
                    touching_nodes = scene.bit.touching;
                    Ok(time_s)
                })?;
                speed.rows.push(RockRow {
                    rock: name,
                    instructions: stepper.instructions,
                    ns_per_hexahedron_step: time_s.times(each_ns),
                    contact_ns_per_hexahedron_step: each_ns * Spread::of(contact_s).median,
                    yielding,
                    touching_nodes,
                });
            }
        }
        Ok(speed)
    }
}

/// A bit in a block.
#[derive(Clone)]
struct Scene {
    block: Block,
    bit: Bit,
}

/// A bit with prescribed motion, and the nodes in contact with it.
#[derive(Clone)]
struct Bit {
    face: BitFace,
    law: ContactLaw,
    pose: Pose,
    /// Number of nodes in contact in the last step.
    touching: usize,
}

/// Softening rock surrounded by more of it, with a bit that has cut into it.
fn cut() -> Result<Scene, Error> {
    let mut scene = Scene::new(Rock::of_strength(STRENGTH_PA), Edge::Open)?;
    scene.go(&Stepper::default(), CUTTING_STEPS);
    Ok(scene)
}

/// Rock that is squeezed along x and stretched along y throughout in every step, with the bit in
/// it.
fn squeezed() -> Result<Scene, Error> {
    let rock = Rock {
        tensile_fracture_energy_J_per_m2: TOUGH_J_PER_M2,
        compressive_fracture_energy_J_per_m2: TOUGH_J_PER_M2,
        ..Rock::of_strength(STRENGTH_PA)
    };
    let mut scene = Scene::new(rock, Edge::Held)?;
    let grid: Grid = *scene.block.grid();
    for node in grid.each_node() {
        let [x, y, _] = node.map(|n| n as f64 * EDGE_M * SQUEEZING_PER_S);
        scene.block.tell(grid.node(node), [-x, y, 0.0]);
    }
    scene.go(&Stepper::default(), SQUEEZING_STEPS);
    Ok(scene)
}

impl Scene {
    /// A block under a bit that touches it; `around` is the boundary condition of its other faces.
    fn new(rock: Rock, around: Edge) -> Result<Self, Error> {
        let mut spec = BlockSpec::new(rock, CELLS, EDGE_M);
        spec.edges = [around; 6];
        spec.edges[4] = Edge::Free;
        let middle_m = |cells: usize| 0.5 * cells as f64 * EDGE_M;
        let down = [0.0, 0.0, 1.0];
        let pose = Pose::new(
            [middle_m(CELLS[0]), middle_m(CELLS[1]), 0.0].into(),
            down.into(),
            [1.0, 0.0, 0.0].into(),
            0.0,
        );
        let face = PdcBit::for_diameter(BIT_M).face();
        Ok(Self {
            block: Block::new(&spec).map_err(Error::failed)?,
            bit: Bit {
                face: face.map_err(Error::failed)?,
                law: ContactLaw::for_rock(rock.ucs_Pa(), EDGE_M),
                pose: pose.moving(
                    down.map(|part| DOWN_M_PER_S * part).into(),
                    down.map(|part| TURN_RAD_PER_S * part).into(),
                ),
                touching: 0,
            },
        })
    }

    /// Runs steps of the rock with the bit's contact, and returns the time of the contact, s.
    fn go(&mut self, stepper: &Stepper, steps: usize) -> f64 {
        let mut contact_s = 0.0;
        for _ in 0..steps {
            self.block.step(stepper, &Alone);
            let clock = Clock::begin();
            self.bit.press(&mut self.block);
            contact_s += clock.elapsed_s();
        }
        contact_s
    }

    /// Fraction of the hexahedra that yield in the next step, found by the decrease of their intact
    /// part.
    fn yielding(mut self) -> f64 {
        let intact = |block: &Block| -> Vec<Option<f64>> {
            let elements = block.grid().each_element();
            elements.map(|element| block.intact(element)).collect()
        };
        let before = intact(&self.block);
        self.go(&Stepper::default(), 1);
        let after = intact(&self.block);
        let yielding = before.iter().zip(&after).filter(|(b, a)| a < b).count();
        yielding as f64 / before.len() as f64
    }
}

impl Bit {
    /// Pushes the nodes in contact and moves the bit.
    fn press(&mut self, block: &mut Block) {
        let pressed = block.press(&self.face, &self.pose, &self.law);
        self.touching = pressed.load.touching;
        self.pose = self.pose.after(block.dt_s());
    }
}

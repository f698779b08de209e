//! Solid rock under the bit's node: exchange of momentum and energy.

use nalgebra::{Matrix3, Vector3};

use super::{MASS_KG, OPERATION, POLAR_KG_M2};
use crate::{
    common::MOTOR,
    dynamics::{
        boundary::{
            anchor::Anchor,
            bit::{Bit, BitLaw, BitSettings, BitStep, Motor, RockLaw, RunIn, Standing, StepStart},
            executor::RockExecutor,
        },
        kernel::chain::{Chain, node},
        output::energy::kinetic_J,
    },
    rock::{
        BitShape, DrillingSpec, Edge, Rock,
        bit_face::{PdcBit, Pose},
    },
    simd::vector::Vector,
};

const ROTARY_KG_M2: f64 = 5.0;

/// A string's step, s.
const DT_S: f64 = 0.5e-3;

/// A bit of 60 mm on elements of 6 mm of intact rock, which does not break.
fn spec() -> DrillingSpec {
    let rock = Rock {
        cohesion_Pa: 1e9,
        tensile_strength_Pa: 1e9,
        tensile_fracture_energy_J_per_m2: 1e12,
        compressive_fracture_energy_J_per_m2: 1e12,
        ..Rock::of_strength(10e6)
    };
    let bit = BitShape::Pdc(PdcBit::for_diameter(0.06));
    let mut spec = DrillingSpec::new(rock, bit, 6e-3).expect("a sound face");
    spec.block.numerics.density_factor = 400.0;
    spec
}

/// A bit on its own in a hole that slants, on rock.
struct Slant {
    chain: Chain,
    bit: Bit,
    anchor: Anchor,
    /// High side, right, down the hole.
    frame: Matrix3<f64>,
    executor: RockExecutor,
}

impl Slant {
    fn new(drilling: DrillingSpec, motor: Motor) -> Self {
        let tangent = Vector3::new(0.6, 0.48, 0.64).normalize();
        let high_side = (tangent * tangent.z - Vector3::z()).normalize();
        let mut chain = Chain::new(1);
        node!(chain, 0, mass_axial = MASS_KG);
        node!(chain, 0, inv_mass_axial = 1.0 / MASS_KG);
        node!(chain, 0, mass_lateral = 2.0 * MASS_KG);
        node!(chain, 0, inv_mass_lateral = 0.5 / MASS_KG);
        node!(chain, 0, polar = POLAR_KG_M2);
        node!(chain, 0, inv_polar = 1.0 / POLAR_KG_M2);
        node!(chain, 0, inv_rotary = 1.0 / ROTARY_KG_M2);
        chain.set_tangent(0, tangent.into());
        chain.set_displacement(0, Vector::zero());
        let along = (tangent + 0.01 * high_side).normalize();
        chain.set_director(0, along.into());
        let settings = BitSettings {
            law: BitLaw::Rock(Box::new(RockLaw { drilling })),
            // The rock alone holds it.
            lateral_stiffness_N_per_m: 0.0,
            motor,
            ..BitSettings::default()
        };
        let anchor =
            Anchor { md_m: 100.0, position_m: Vector3::new(100.0, 200.0, 300.0), high_side };
        let executor = RockExecutor::default();
        let mut bit = Bit::new(&settings, &OPERATION, 100.0, 1);
        bit.set_flow(30e-3);
        let standing =
            Standing { weight_N: 0.0, rate_m_per_s: 0.0, string_rad_per_s: 0.0, mass_kg: MASS_KG };
        let run_in = RunIn::new(&settings, &OPERATION, standing, &executor).expect("a sound bit");
        bit.stand(run_in.expect("rock"), &chain, &anchor);
        Self {
            chain,
            bit,
            anchor,
            frame: Pose::new(Vector3::zeros(), along, high_side, 0.0).rotation,
            executor,
        }
    }

    /// A step in which a force along the hole pushes the node.
    fn step(&mut self, push_N: f64) -> BitStep {
        let step_start =
            StepStart { velocity: self.chain.velocity(0), spin: node!(self.chain, 0, spin) };
        let along = self.chain.tangent(0).scaled(DT_S * push_N / MASS_KG);
        self.chain.set_velocity(0, step_start.velocity + along);
        self.bit.act(&mut self.chain, &self.anchor, step_start, &self.executor, DT_S)
    }

    /// Momentum of the bit and of the rock, N·s.
    fn momentum(&self) -> [Vector3<f64>; 2] {
        let velocity: Vector3<f64> = self.chain.velocity(0).into();
        let along = Vector3::from(self.chain.tangent(0));
        let block = self.bit.drilling().expect("rock").block();
        let grid = block.grid();
        let nodes = grid.each_node().map(|node| grid.node(node));
        let rock: Vector3<f64> =
            nodes.map(|n| Vector3::from(block.velocity_m_per_s(n)) * block.mass_kg(n)).sum();
        [(velocity * 2.0 - along * along.dot(&velocity)) * MASS_KG, self.frame * rock]
    }
}

/// A bit that is thrown into a block which nothing holds, tilted, turning and tilting on: the
/// momentum that it loses the block gains, the rock's work on it is the change of its kinetic
/// energy, and its bending moment is that which tilts it. The string's part of the work of a bit
/// that a motor turns is the change of the string's energy.
#[test]
fn momentum_and_energy_pass_exactly() {
    let displacement = Motor::Displacement(MOTOR);
    for (spin, motor) in [
        (20.0, Motor::Speed(0.0)),
        (-8.0, Motor::Speed(0.0)),
        (3.0, Motor::Speed(10.0)),
        (3.0, displacement),
    ] {
        let mut spec = spec();
        spec.block.edges = [Edge::Free; 6];
        let mut slant = Slant::new(spec, motor);
        let thrown = slant.frame * Vector3::new(0.3, -0.2, 0.8);
        let tilting = slant.frame * Vector3::new(0.0, 0.6, 0.0);
        let across = Vector3::from(slant.chain.director(0)).cross(&tilting);
        slant.chain.set_velocity(0, thrown.into());
        slant.chain.set_turning(0, across.into());
        node!(slant.chain, 0, spin = spin);
        let [first, _] = slant.momentum();
        let all = first.norm();
        let start_J = kinetic_J(&slant.chain);
        let (mut passed, mut bent) = (0.0_f64, 0.0_f64);
        for _ in 0..40 {
            let before_J = kinetic_J(&slant.chain);
            let turning = Vector3::from(slant.chain.turning(0));
            let step = slant.step(0.0);
            let change_J = kinetic_J(&slant.chain) - before_J;
            assert!((change_J - step.work_J).abs() < 1e-11 * start_J, "{change_J} {step:?}");
            let turned = (Vector3::from(slant.chain.turning(0)) - turning).norm() * ROTARY_KG_M2;
            let moment = step.moment_N_m * DT_S;
            // The spin carries the moment round by a hundredth within the step, the director moves.
            assert!((turned - moment).abs() < 0.02 * moment + 1e-5, "{turned} {moment}");
            bent = bent.max(step.moment_N_m);
            let [bit, rock] = slant.momentum();
            passed = passed.max(rock.norm() / all);
            let off = (bit + rock - first).norm();
            assert!(off < 1e-10 * all, "{off}");
        }
        // The string's impulse is transmitted too, its even part and the rest.
        let before = slant.momentum().iter().sum::<Vector3<f64>>();
        for step in 0..20 {
            slant.step(1000.0 * f64::from(step % 7));
        }
        let impulse = Vector3::from(slant.chain.tangent(0)) * (DT_S * 1000.0 * 57.0);
        let gained = slant.momentum().iter().sum::<Vector3<f64>>() - before;
        assert!((gained - impulse).norm() < 1e-10 * all, "{gained} {impulse}");
        assert!(passed > 0.1 && bent > 10.0, "{passed} {bent}");
        // The node is where the bit is.
        let drilling = slant.bit.drilling().expect("rock");
        let axis = slant.frame * drilling.pose().axis();
        assert!((axis - Vector3::from(slant.chain.director(0))).norm() < 1e-12);
    }
}

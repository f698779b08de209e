//! The initial condition: position and motion of the string at time zero.
//!
//! A string that is dropped into its hole needs minutes to find its torque and its tension. The
//! prepared start takes both from the soft string, places the string on the side where it will
//! touch and lets it settle laterally, so that the run shows the operation and not the transient of
//! a fall.

mod guide;
pub mod scene;

use nalgebra::Vector3;

use super::{assemble::SetupError, body::Body, boundary::anchor, settings::Start};
use crate::{
    dynamics::{
        assemble::chain,
        boundary::{
            anchor::Anchor,
            hole::{self, Borehole},
        },
        initial_state::{guide::Guide, scene::Scene},
        kernel::{
            chain::{Chain, NO_WALL_M, element, node},
            step::{MassDamping, coupled_step},
        },
    },
    ends::{BitEnd, Ends, TopEnd},
    random::Random,
    rock::Executor,
    rod::{element::react, mesh::Mesh},
    simd::vector::Vector,
};

/// Lateral settling of a prepared start, s, and its damping, 1/s: near critical for a joint's span,
/// whose motion is gone after 0.7 s. The remaining creep, some mm/s at a few nodes with little
/// contact force, would last for minutes.
pub const SETTLING_S: f64 = 1.0;
const SETTLING_DAMPING_PER_S: f64 = 15.0;

/// Steps after which that damping acts.
const DAMPING_STEPS: usize = 4;

/// Amplitude of the seeded disturbance that breaks the symmetry of a start, m.
const DISTURBANCE_M: f64 = 1e-6;

/// Passes over the string that bring every element to its tension.
const PASSES: usize = 8;

/// Part of the settling in which bends grow.
const GROWING: f64 = 0.5;

/// Number of steps between checks for a stop request: some milliseconds.
const LOOK_STEPS: usize = 16;

/// The string at time zero.
#[derive(Debug)]
pub struct Initial {
    /// The chain.
    pub chain: Chain,
    /// Its anchors.
    pub anchors: Vec<Anchor>,
    /// Bends and eccentric masses, turned to their angles.
    pub body: Body,
    /// Load that carries it, N.
    pub hook_load_N: f64,
}

/// Initialises the string with its bit at `bit_md_m`.
///
/// # Errors
/// A soft string without solution, and an executor that requests a stop.
pub fn initialise(
    scene: &Scene<'_>,
    chain: Chain,
    body: Body,
    bit_md_m: f64,
) -> Result<Initial, SetupError> {
    let Scene { operation, settings, mesh, .. } = *scene;
    let guide = Guide::new(scene)?;
    let mut string = InitialString {
        anchors: vec![
            Anchor { md_m: 0.0, position_m: Vector3::zeros(), high_side: Vector3::x() };
            mesh.nodes.len()
        ],
        chain,
        body,
        borehole: scene.borehole,
        guide: &guide,
        mesh,
        ends: scene.model.ends,
    };
    string.place(bit_md_m, settings.start == Start::Prepared);
    string.body.orient(&string.chain, &string.anchors);
    anchor::add_lateral_forces(&mut string.chain, &string.anchors, scene.model, mesh);
    string.disturb(settings.seed);
    if settings.start == Start::Prepared {
        string.set_motion(0.0, operation.rotation_rad_per_s());
        string.settle(scene)?;
        string.stretch_in_place();
        string.set_motion(scene.velocity_m_per_s, operation.rotation_rad_per_s());
        for index in 0..mesh.elements.len() {
            element!(
                string.chain,
                index,
                twist = -guide.torque_N_m[index] / element!(string.chain, index, torsion)
            );
        }
    }
    string.chain.clear_sums();
    // The uppermost half element hangs on the top node.
    let hook_load_N = guide.tension_N[0] + chain::top_weight_N(&string.chain);
    Ok(Initial { chain: string.chain, anchors: string.anchors, body: string.body, hook_load_N })
}

/// A string being initialised.
struct InitialString<'a> {
    chain: Chain,
    anchors: Vec<Anchor>,
    body: Body,
    borehole: &'a Borehole,
    guide: &'a Guide,
    mesh: &'a Mesh,
    ends: Ends,
}

impl InitialString<'_> {
    /// Puts every node at its depth and on its side, from the bit up, every element at its tension.
    fn place(&mut self, bit_md_m: f64, lean: bool) {
        let nodes = self.mesh.nodes.len();
        // First guess: every element at its rest length.
        let mut md = vec![bit_md_m; nodes];
        for i in (0..nodes - 1).rev() {
            md[i] = md[i + 1] - self.mesh.elements[i].length_m;
        }
        for _ in 0..PASSES {
            for (i, depth) in md.iter().enumerate() {
                self.borehole.place(&mut self.chain, &mut self.anchors, i, *depth);
                let clearance = node!(self.chain, i, clearance);
                let off = if lean && clearance < NO_WALL_M {
                    self.guide.lean[i] * clearance
                } else {
                    Vector3::zeros()
                };
                self.chain.set_displacement(i, off.into());
            }
            self.span_all();
            self.point_directors();
            // The length missing in the elements below adds up towards the top.
            let mut shift = 0.0;
            for i in (0..nodes - 1).rev() {
                shift += self.shortfall_m(i);
                md[i] -= shift;
            }
        }
    }

    /// Length by which element `i` lacks its tension, m.
    fn shortfall_m(&self, i: usize) -> f64 {
        let k = self.chain.stiffness(i);
        let mut pose = self.body.pose(&self.chain, i);
        pose.velocity = Vector::zero();
        let tension = react(&k, &pose, 0.0, 0.0).tension;
        (self.guide.tension_N[i] - tension) / k.axial
    }

    fn span_all(&mut self) {
        for i in 0..self.mesh.elements.len() {
            hole::span(&mut self.chain, &self.anchors, i);
        }
    }

    /// Points each director along the string, the top's and that of a clamped bit along the hole.
    fn point_directors(&mut self) {
        let last = self.mesh.nodes.len() - 1;
        let at: Vec<Vector3<f64>> = (0..=last)
            .map(|i| self.anchors[i].position_m + Vector3::from(self.chain.displacement(i)))
            .collect();
        for i in 0..=last {
            // Central difference over the two elements at a node; a clamped end is clamped to the
            // hole.
            let clamped = i == 0 && self.ends.top == TopEnd::Clamped
                || i == last && self.ends.bit == BitEnd::Clamped;
            let direction = if clamped {
                self.chain.tangent(i).into()
            } else {
                (at[(i + 1).min(last)] - at[i.saturating_sub(1)]).normalize()
            };
            self.chain.set_director(i, direction.into());
        }
    }

    /// Moves every node sideways by a millionth of a metre, never the same way for two seeds.
    fn disturb(&mut self, seed: u64) {
        let mut random = Random::new(seed);
        for i in 1..self.mesh.nodes.len() - 1 {
            let tangent = self.chain.tangent(i);
            let kick = Vector(random.signed(), random.signed(), random.signed());
            let across = kick.minus(tangent, kick.dot(tangent));
            let moved = self.chain.displacement(i).plus(across, DISTURBANCE_M);
            self.chain.set_displacement(i, moved);
        }
    }

    /// Gives every node the same axial velocity and spin.
    fn set_motion(&mut self, axial_m_per_s: f64, spin_rad_per_s: f64) {
        for i in 0..self.mesh.nodes.len() {
            let velocity = self.chain.tangent(i).scaled(axial_m_per_s);
            self.chain.set_velocity(i, velocity);
            self.chain.set_turning(i, Vector::zero());
            node!(self.chain, i, spin = spin_rad_per_s);
        }
    }

    /// Lets the string find its place across the hole, axial motion and spin held, in the steps
    /// that the run takes.
    fn settle(&mut self, scene: &Scene<'_>) -> Result<(), SetupError> {
        let Scene { operation, input, border, .. } = *scene;
        let (mut stepper, body) = (scene.stepper.clone(), &mut self.body);
        let mut chain: Chain = self.chain.divided_at(border);
        let time_s = DAMPING_STEPS as f64 * input.dt;
        let mass_damping = MassDamping {
            time_s,
            dt: input.dt,
            left: libm::exp(-SETTLING_DAMPING_PER_S * time_s),
            rigid_velocity: 0.0,
            rigid_spin: operation.rotation_rad_per_s(),
        };
        chain::hold(&mut chain);
        if !operation.kind.rotates() {
            // A string that does not turn slides sideways freely while it slides along.
            for block in &mut chain.node_blocks {
                block.friction.0.fill(0.0);
                block.friction_rise.0.fill(0.0);
            }
        }
        if self.ends.bit != BitEnd::Free {
            // No wall holds the bit: its own hole does, whatever weighs on it or bends there.
            node!(chain, self.mesh.nodes.len() - 1, inv_mass_lateral = 0.0);
        }
        let steps = (SETTLING_S / input.dt).ceil() as usize;
        let (mut grown, growth) = (0.0, 1.0 / (GROWING * steps as f64 * f64::from(chain.parts())));
        for step in 0..steps {
            if step % LOOK_STEPS == 0 && scene.executor.stopped() {
                return Err(SetupError::Stopped);
            }
            coupled_step(&mut chain, input, |chain, region, input| {
                let lowest = region + 1 == chain.regions();
                if lowest {
                    // Bends grow in the first part, so that the rest damps the motion that this
                    // causes.
                    grown = f64::min(grown + growth, 1.0);
                    body.push(chain, input, grown);
                }
                let losses = stepper.step_region(chain.region(region), input);
                if lowest {
                    body.follow(chain, input);
                }
                losses
            });
            if step % DAMPING_STEPS == 0 {
                stepper.damp(&mut chain, &mass_damping);
                chain.find_drag(input.dt);
            }
        }
        self.chain = chain.divided_at(None);
        chain::release(&mut self.chain, self.ends);
        for i in 0..self.mesh.nodes.len() {
            let md = self.anchors[i].md_m;
            self.borehole.anchor(&mut self.chain, &mut self.anchors, i, md);
        }
        Ok(())
    }

    /// Brings every element back to its tension, the string keeping its place across the hole.
    fn stretch_in_place(&mut self) {
        for _ in 0..PASSES {
            // The node below has moved already: each shortfall knows of it.
            for i in (0..self.mesh.elements.len()).rev() {
                let shift = self.shortfall_m(i);
                let moved = self.chain.displacement(i).minus(self.chain.tangent(i), shift);
                self.chain.set_displacement(i, moved);
            }
        }
    }
}

//! The mud's drag along the hole and about the axis, in time.
//!
//! Each element has its annulus and the mean motion of its two nodes; [`Annulus::drag`] returns the
//! effect of the mud on it: a pull, a drag per velocity and a torque per spin, half of each for
//! either node. The kernel applies drag and torque at each step with the node's own velocity and
//! spin; they are recomputed when the motion has changed.
//!
//! Hoist and bit correct the two end nodes after the kernel, and the top's spin is prescribed: drag
//! booked there would be booked with velocities that the nodes do not keep. The parts of the end
//! nodes are therefore added to their neighbours.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::FlowPressures;
use crate::{
    damage::{Damaged, ensure},
    dynamics::{
        boundary::anchor::{Anchor, middle_m},
        kernel::chain::{Chain, node, upkeep::Motions},
    },
    model::Model,
    mud::{AnnulusDrag, Conduit, Hydraulics, Motion, Mud},
    operation::Operation,
    rod::mesh::Mesh,
    simd::number::Real,
    string::DrillString,
    well::Hole,
};

/// Change of an element's motion, as a part of all that shears the mud there, after which its drag
/// is found anew.
const STALE: f64 = 0.003;

/// The same part beyond which a sample does not follow the drag along its slope.
const FAR: f64 = 0.1;

/// Shear velocity of the mud in a string at rest, for that comparison, m/s.
const STILL_M_PER_S: f64 = 0.01;

/// Distance that an element slides until its hole is looked at again, m.
const REACH_M: f64 = 1.0;

/// Largest part γ of a node's velocity that drag takes in a step. Taken at the step's beginning, it
/// makes `(ω dt)² < 4 − 2γ` of the leapfrog's limit `(ω dt)² < 4`, and the step uses 0.99² of that:
/// 0.040 would be unstable. A mud below its yield point takes more: see [`Beyond`].
const STRONGEST: f64 = 0.025;

/// Largest part of a node's velocity along the hole that the drag beyond [`STRONGEST`] takes from
/// one update to the next.
const STRONGEST_BEYOND: f64 = 0.5;

/// The excess of a node's axial mud drag over the drag that is stable in a step: a constant pull
/// for a velocity that follows the node's own from update to update, slowly enough to be stable.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
struct Beyond {
    drag_N_s_per_m: f64,
    velocity_m_per_s: f64,
}

/// An element in its annulus.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Passage {
    length_m: f64,
    /// Its lower and upper end, from the bit, m.
    from_bit_m: [f64; 2],
    od_m: f64,
    /// Measured depth at which the hole was evaluated, m.
    md_m: f64,
    conduit: Conduit,
    /// Mean speed at which the pumps drive the mud up, m/s.
    rising_m_per_s: f64,
    bore_gradient_Pa_per_m: f64,
    /// The motion that the drag was found for.
    motion: Motion,
    drag: AnnulusDrag,
    /// Friction loss of the pressure in the annulus at the last sample, Pa.
    annulus_loss_Pa: f64,
}

/// The mud that drags on the whole string.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Viscous {
    /// Fluid in the string at the bit.
    mud: Mud,
    /// Largest density in the string, kg/m³, of which the momentum of the stream is.
    densest_kg_per_m3: f64,
    flow_m3_per_s: f64,
    bit_loss_Pa: f64,
    passages: Vec<Passage>,
    /// Weight of each node without the mud's pull, N.
    weight_N: Vec<[f64; 3]>,
    /// The mud's pull on each node, N.
    pull_N: Vec<[f64; 3]>,
    /// Excess drag of each node, beyond the drag that is stable in a step.
    beyond: Vec<Beyond>,
    /// Potential energy that the pulls lost when they changed, J.
    dropped_J: f64,
    /// Pressures added by the flow at each node, at the last sample.
    pressures: FlowPressures,
    sum: Hydraulics,
    sum_pressures: FlowPressures,
    samples: u32,
}

impl Viscous {
    /// Whether stored mud is that around this string.
    pub(in crate::dynamics) fn check(&self, mesh: &Mesh) -> Result<(), Damaged> {
        let nodes = mesh.nodes.len();
        let fits = self.passages.len() == mesh.elements.len()
            && self.passages.iter().all(|passage| passage.conduit.is_whole())
            && [&self.weight_N, &self.pull_N].iter().all(|each| each.len() == nodes)
            && self.beyond.len() == nodes
            && [&self.pressures, &self.sum_pressures].iter().all(|pressures| {
                pressures.outside_Pa.len() == nodes && pressures.inside_Pa.len() == nodes
            });
        ensure(fits, "the mud")
    }

    /// The mud around a string that moves as `operation` has it, its bit at `bit_md_m`; none
    /// without a rheology.
    pub fn new(
        model: &Model,
        mesh: &Mesh,
        operation: &Operation,
        axial_m_per_s: f64,
        bit_md_m: f64,
    ) -> Option<Self> {
        if !model.has_rheology() {
            return None;
        }
        let flow_m3_per_s = operation.flow_now_m3_per_s();
        let motion =
            Motion { axial_m_per_s, spin_rad_per_s: operation.rotation_rad_per_s(), flow_m3_per_s };
        let ends = mesh.nodes.windows(2).map(|pair| [pair[1].from_bit_m, pair[0].from_bit_m]);
        let passages = mesh.elements.iter().zip(ends).map(|(element, from_bit_m)| {
            let md_m = bit_md_m - from_bit_m[1] + 0.5 * element.length_m;
            let section = &element.section;
            let hole = &model.well.hole;
            let mut passage = Passage {
                length_m: element.length_m,
                from_bit_m,
                od_m: section.od_m,
                md_m,
                conduit: Conduit::uniform(section.od_m, section.bore_m2, hole.at(md_m).diameter_m),
                rising_m_per_s: 0.0,
                bore_gradient_Pa_per_m: 0.0,
                motion,
                drag: AnnulusDrag::default(),
                annulus_loss_Pa: 0.0,
            };
            passage.lie_at(&model.string, hole, md_m);
            passage.find(model, motion);
            passage
        });
        Some(Self {
            mud: model.fluids.inside_at(&model.mud, bit_md_m),
            densest_kg_per_m3: model.mud_column().inside.densest(),
            flow_m3_per_s,
            bit_loss_Pa: operation.bit_loss_Pa(flow_m3_per_s),
            passages: passages.collect(),
            weight_N: Vec::new(),
            pull_N: Vec::new(),
            beyond: Vec::new(),
            dropped_J: 0.0,
            pressures: FlowPressures::none(mesh.nodes.len()),
            sum: Hydraulics::default(),
            sum_pressures: FlowPressures::none(mesh.nodes.len()),
            samples: 0,
        })
    }

    /// Torque that the mud takes from an element, N·m, at its last known motion.
    pub fn torque_N_m(&self, element: usize) -> f64 {
        let passage = &self.passages[element];
        -passage.length_m * passage.drag.torque_N(passage.motion.spin_rad_per_s)
    }

    /// Takes hold of a chain that has been initialised.
    pub fn attach(&mut self, chain: &mut Chain<impl Real>, anchors: &[Anchor], dt: f64) {
        let nodes = 0..chain.nodes();
        self.weight_N = nodes.clone().map(|i| Vector3::from(chain.weight(i)).into()).collect();
        self.pull_N = vec![[0.0; 3]; chain.nodes()];
        let along = |i: usize| chain.tangent(i).dot(chain.velocity(i));
        let moving = |i| Beyond { velocity_m_per_s: along(i), ..Beyond::default() };
        self.beyond = nodes.clone().map(moving).collect();
        for index in nodes {
            self.load(chain, anchors, index, dt);
        }
    }

    /// Sets the flow rate of the pumps, m³/s, from the next update on, and with it the bit's
    /// pressure drop, Pa.
    pub fn set_flow(&mut self, flow_m3_per_s: f64, bit_loss_Pa: f64) {
        (self.flow_m3_per_s, self.bit_loss_Pa) = (flow_m3_per_s, bit_loss_Pa);
    }

    /// Finds the drag of elements anew whose motion has changed or that have slid on; `every_s`
    /// after the last time.
    pub fn update(
        &mut self,
        chain: &mut Chain<impl Real>,
        anchors: &[Anchor],
        model: &Model,
        dt: f64,
        every_s: f64,
    ) {
        let Motions { axial_m_per_s, spin_rad_per_s } = chain.motions();
        let mean = |values: &[f64], index: usize| 0.5 * (values[index] + values[index + 1]);
        let mut changed_above = false;
        for index in 0..self.passages.len() {
            let motion = Motion {
                axial_m_per_s: mean(&axial_m_per_s, index),
                spin_rad_per_s: mean(&spin_rad_per_s, index),
                flow_m3_per_s: self.flow_m3_per_s,
            };
            let passage = &mut self.passages[index];
            let md_m = 0.5 * (anchors[index].md_m + anchors[index + 1].md_m);
            let changed = passage.is_stale(&motion, md_m);
            if changed {
                passage.lie_at(&model.string, &model.well.hole, md_m);
                passage.find(model, motion);
            }
            if changed || changed_above {
                self.load(chain, anchors, index, dt);
            }
            changed_above = changed;
        }
        // The ends' neighbours have the ends' shares too.
        let last = self.passages.len();
        if changed_above {
            self.load(chain, anchors, last - 1, dt);
            self.load(chain, anchors, last, dt);
        }
        for (index, axial) in axial_m_per_s.into_iter().enumerate() {
            let taken = self.beyond[index].drag_N_s_per_m * every_s;
            if taken > 0.0 {
                let part = (STRONGEST_BEYOND * node!(chain, index, mass_axial) / taken).min(1.0);
                let held = &mut self.beyond[index].velocity_m_per_s;
                *held += part * (axial - *held);
                self.load(chain, anchors, index, dt);
            }
        }
    }

    /// Applies the mud forces of the elements above and below to a node.
    fn load(&mut self, chain: &mut Chain<impl Real>, anchors: &[Anchor], index: usize, dt: f64) {
        let (mut pull, mut drag, mut spin_drag) = (0.0, 0.0, 0.0);
        let last = self.passages.len();
        for (above, passage) in
            self.passages.iter().enumerate().take(index + 2).skip(index.saturating_sub(2))
        {
            let half = 0.5 * passage.length_m;
            for end in [above, above + 1] {
                // The two end nodes hand their shares to their neighbours.
                if end.clamp(1, (last - 1).max(1)) == index {
                    pull += half * passage.drag.pull_N_per_m;
                    drag += half * passage.drag.drag_Pa_s;
                    spin_drag += half * passage.drag.spin_drag_N_s;
                }
            }
        }
        let tangent = chain.tangent(index);
        let step_s = chain.step_s(index, dt);
        let strongest = STRONGEST * node!(chain, index, mass_axial) / step_s;
        let beyond = &mut self.beyond[index];
        beyond.drag_N_s_per_m = (drag - strongest).max(0.0);
        if beyond.drag_N_s_per_m > 0.0 {
            pull -= beyond.drag_N_s_per_m * beyond.velocity_m_per_s;
            drag = strongest;
        } else {
            beyond.velocity_m_per_s = tangent.dot(chain.velocity(index));
        }
        let strongest = STRONGEST * node!(chain, index, polar) / step_s;
        node!(chain, index, mud_axial = drag);
        node!(chain, index, mud_spin = spin_drag.min(strongest));
        // The jets lift the bit.
        if index == self.passages.len() {
            pull -= self.mud.jet_thrust_N(self.flow_m3_per_s, self.bit_loss_Pa);
        }
        let pull_N = pull * Vector3::from(tangent);
        // A constant pull has a potential, whose loss as the pull changes is work.
        let place = middle_m(chain, anchors, index, dt);
        self.dropped_J += (Vector3::from(self.pull_N[index]) - pull_N).dot(&place);
        self.pull_N[index] = pull_N.into();
        chain.set_weight(index, (Vector3::from(self.weight_N[index]) + pull_N).into());
    }

    /// Work of the pulls on the way from the origin to the string's position, J: the negative of
    /// the potential that they add to that of the weights.
    pub fn pull_potential_J(&self, chain: &Chain<impl Real>, anchors: &[Anchor], dt: f64) -> f64 {
        let nodes = self.pull_N.iter().enumerate();
        nodes.map(|(i, pull)| Vector3::from(*pull).dot(&middle_m(chain, anchors, i, dt))).sum()
    }

    /// Work that the pulls have done since some time, J: only its differences mean something.
    pub fn pull_work_J(&self, chain: &Chain<impl Real>, anchors: &[Anchor], dt: f64) -> f64 {
        self.pull_potential_J(chain, anchors, dt) + self.dropped_J
    }

    /// Discards the samples at the beginning of a window.
    pub fn open_window(&mut self) {
        (self.sum, self.samples) = (Hydraulics::default(), 0);
        self.sum_pressures.clear();
    }

    /// Samples forces and pressures; `motor_loss_Pa` is the pressure drop of a mud motor.
    pub fn sample(&mut self, chain: &Chain<impl Real>, model: &Model, motor_loss_Pa: f64) {
        let mut now = Hydraulics {
            jet_thrust_N: self.mud.jet_thrust_N(self.flow_m3_per_s, self.bit_loss_Pa),
            bit_loss_Pa: self.bit_loss_Pa,
            motor_loss_Pa,
            ..Hydraulics::default()
        };
        let Motions { axial_m_per_s, spin_rad_per_s } = chain.motions();
        let of_elements = axial_m_per_s.windows(2).zip(spin_rad_per_s.windows(2));
        for (passage, (axial, spin)) in self.passages.iter_mut().zip(of_elements) {
            let velocity = 0.5 * (axial[0] + axial[1]);
            let spin = 0.5 * (spin[0] + spin[1]);
            let motion = Motion {
                axial_m_per_s: velocity,
                spin_rad_per_s: spin,
                flow_m3_per_s: self.flow_m3_per_s,
            };
            let (drag, gradient_Pa_per_m) = passage.sampled(model, &motion);
            passage.annulus_loss_Pa = passage.length_m * gradient_Pa_per_m;
            now.mud_drag_N += passage.length_m * drag.axial_N_per_m(velocity);
            now.mud_torque_N_m -= passage.length_m * drag.torque_N(spin);
            now.annulus_loss_Pa += passage.annulus_loss_Pa;
            now.bore_loss_Pa += passage.length_m * passage.bore_gradient_Pa_per_m;
        }
        let below_Pa = now.bit_loss_Pa + motor_loss_Pa;
        now.pump_pressure_Pa = now.bore_loss_Pa + below_Pa + now.annulus_loss_Pa;
        self.sum = self.sum + now;
        let losses = |p: &Passage| (p.annulus_loss_Pa, p.length_m * p.bore_gradient_Pa_per_m);
        let stream_N_m2 = self.densest_kg_per_m3 * self.flow_m3_per_s * self.flow_m3_per_s;
        self.pressures.find(below_Pa, stream_N_m2, self.passages.iter().map(losses));
        self.sum_pressures.add(&self.pressures);
        self.samples += 1;
    }

    /// Means of the samples.
    pub fn mean(&self) -> Hydraulics {
        self.sum * (1.0 / f64::from(self.samples.max(1)))
    }

    /// Pressures added by the flow at the last sample.
    pub fn pressures(&self) -> &FlowPressures {
        &self.pressures
    }

    /// Means of the added pressures.
    pub fn mean_pressures(&self) -> FlowPressures {
        self.sum_pressures.scaled(1.0 / f64::from(self.samples.max(1)))
    }

    /// Elongation of the string by the pressures that the flow added at the last sample, m.
    pub fn stretch_m(&self, mesh: &Mesh) -> f64 {
        Self::stretches_m(mesh, &self.pressures).sum()
    }

    /// Mean elongation of each element by the pressures that the flow added, m.
    pub fn mean_stretches_m(&self, mesh: &Mesh) -> Vec<f64> {
        Self::stretches_m(mesh, &self.mean_pressures()).collect()
    }

    fn stretches_m<'a>(
        mesh: &'a Mesh,
        pressures: &'a FlowPressures,
    ) -> impl Iterator<Item = f64> + 'a {
        let FlowPressures { outside_Pa, inside_Pa, .. } = pressures;
        let middle = |values: &[f64], i: usize| 0.5 * (values[i] + values[i + 1]);
        mesh.elements.iter().enumerate().map(move |(i, element)| {
            let (outside_Pa, inside_Pa) = (middle(outside_Pa, i), middle(inside_Pa, i));
            element.length_m * element.section.free_strain().by_pressures(outside_Pa, inside_Pa)
        })
    }
}

impl Passage {
    /// Drag and gradient of the annulus's pressure by friction at a motion: near the one that the
    /// drag was found for along its slope, farther off found anew. A mud at its yield point has a
    /// slope there that is ten thousand times its own, and no motion of a string in vibration stays
    /// on it.
    fn sampled(&self, model: &Model, motion: &Motion) -> (AnnulusDrag, f64) {
        if self.has_changed(motion, FAR) {
            let annulus = model.fluids.annulus_at(&model.mud, self.md_m);
            let drag = self.conduit.drag(&annulus, motion);
            return (drag, drag.gradient_Pa_per_m);
        }
        let since = motion.axial_m_per_s - self.motion.axial_m_per_s;
        (self.drag, self.drag.gradient_Pa_per_m + self.drag.surge_Pa_s_per_m2 * since)
    }

    fn is_stale(&self, motion: &Motion, md_m: f64) -> bool {
        self.has_changed(motion, STALE)
            || motion.flow_m3_per_s != self.motion.flow_m3_per_s
            || (md_m - self.md_m).abs() > REACH_M
    }

    /// Whether a motion differs from the known one by more than such a part of all that shears the
    /// mud.
    fn has_changed(&self, motion: &Motion, part: f64) -> bool {
        let radius = 0.5 * self.od_m;
        let known = &self.motion;
        // Speeds of the pipe's surface, which shear the mud.
        let change = (motion.axial_m_per_s - known.axial_m_per_s).abs()
            + radius * (motion.spin_rad_per_s - known.spin_rad_per_s).abs();
        let shear = known.axial_m_per_s.abs()
            + radius * known.spin_rad_per_s.abs()
            + self.rising_m_per_s
            + STILL_M_PER_S;
        change > part * shear
    }

    /// Looks at the hole around it with its middle at a measured depth, m.
    fn lie_at(&mut self, string: &DrillString, hole: &Hole, md_m: f64) {
        self.md_m = md_m;
        let half_m = 0.5 * self.length_m;
        self.conduit =
            Conduit::between(string, hole, self.from_bit_m, [md_m + half_m, md_m - half_m]);
    }

    /// Computes the effect of the fluids at its middle at a motion.
    fn find(&mut self, model: &Model, motion: Motion) {
        let Model { fluids, mud, .. } = model;
        self.motion = motion;
        self.drag = self.conduit.drag(&fluids.annulus_at(mud, self.md_m), &motion);
        self.rising_m_per_s = self.conduit.rising_m_per_s(motion.flow_m3_per_s);
        let inside = fluids.inside_at(mud, self.md_m);
        self.bore_gradient_Pa_per_m =
            self.conduit.bore_gradient_Pa_per_m(&inside, motion.flow_m3_per_s);
    }
}

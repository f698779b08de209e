//! A run: the string in time, from its start to its outcome, in either kind of number.

use std::sync::Arc;

use nalgebra::Vector3;

use super::{diverged::Diverged, settling::Settling, state::State};
use crate::{
    dynamics::{
        assemble::{basis::Basis, foreseen},
        boundary::{
            executor::{RockExecutor, SharedExecutor},
            hole::Borehole,
            mud::Squeezed,
            top_drive::{Gains, TorsionalString},
        },
        kernel::{
            chain::{Chain, node},
            step::{Abilities, MassDamping, StepInput, Stepper},
        },
        output::{frame::Frame, scene::Scene},
        settings::{
            DynamicsSettings, HoistControl, SpeedController, Start, TopDriveSettings,
            schedule::ScheduleStep,
        },
    },
    ends::{BitEnd, TopEnd},
    model::Model,
    mud::MudColumn,
    operation::Operation,
    outcome::{TimeSeries, samples::mean},
    rock::{Drilling, Executor, bit_face::BottomHole},
    rod::{
        buckled_element::BuckledElement,
        mesh::{Mesh, MeshNode},
        stability::StepPlan,
    },
    simd::{number::Real, vector::Vector},
};

/// Extra damping of the first seconds of a prepared start, relative to the rigid motion, 1/s.
const FADING_DAMPING_PER_S: f64 = 4.0;

/// Steps after which anchors follow their nodes, the mud's lateral drag is found anew and
/// mass-proportional damping acts: at 3.2 m elements some 10 ms, a fifth of the shortest period
/// that they have across the hole.
const FOLLOW_STEPS: u64 = 16;

/// Steps after which directors are renormalised.
const RENORMALISE_STEPS: u64 = 128;

/// A drill string in time, in one kind of number.
#[derive(Debug, Clone)]
pub struct Run<R: Real> {
    pub(super) model: Model,
    pub(super) mud: MudColumn,
    pub(super) operation: Operation,
    pub(super) settings: DynamicsSettings,
    pub(super) mesh: Mesh,
    pub(super) settling: Settling,
    pub(super) plan: StepPlan,
    pub(super) borehole: Borehole,
    pub(super) abilities: Abilities,
    pub(super) stepper: Stepper<R>,
    pub(super) steps_per_sample: u64,
    pub(super) chain: Chain<R>,
    pub(super) state: State,
    pub(super) executor: RockExecutor,
}

impl<R: Real> Run<R> {
    /// The run, from the data that follow from its input and from its state.
    pub(super) fn of(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        basis: Basis<R>,
        chain: Chain<R>,
        state: State,
    ) -> Self {
        let Basis { mesh, settling, plan, borehole, abilities, stepper, steps_per_sample } = basis;
        Self {
            model: model.clone(),
            mud: model.mud_column(),
            operation: *operation,
            settings: settings.clone(),
            mesh,
            settling,
            plan,
            borehole,
            abilities,
            stepper,
            steps_per_sample,
            chain,
            state,
            executor: RockExecutor::default(),
        }
    }

    /// Time since the start, s.
    pub fn time_s(&self) -> f64 {
        self.state.steps as f64 * self.plan.dt_s
    }

    /// Time at which the window ends, s; at the latest, as long as the run settles until it is
    /// steady.
    pub fn end_time_s(&self) -> f64 {
        let settle_s = match self.state.settled {
            Some(settled) => settled.settle_s,
            None => self.settling.max_s(),
        };
        settle_s + self.settings.duration_s
    }

    /// Whether more torque was required than the top drive can supply.
    pub fn is_top_drive_stalled(&self) -> bool {
        self.state.top_drive.is_stalled()
    }

    /// Whether the window is yet to begin.
    pub fn is_settling(&self) -> bool {
        !self.state.window_open
    }

    /// Step, s.
    pub fn time_step_s(&self) -> f64 {
        self.plan.dt_s
    }

    /// Whether a product is added to before it is rounded.
    pub fn is_fused(&self) -> bool {
        self.stepper.is_fused
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.mesh.elements.len()
    }

    /// Elements times the steps that each takes for a simulated second.
    pub fn element_steps_per_s(&self) -> f64 {
        self.plan.element_steps() / self.plan.dt_s
    }

    /// The nodes and elements of the string.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Sets the executor of the solid rock under the bit; the answer does not depend on it.
    pub fn set_executor(&mut self, executor: Arc<dyn Executor + Send + Sync>) {
        self.executor.shared = SharedExecutor::new(executor);
    }

    /// The pattern that the bit has left on the bottom of the hole; none without solid rock.
    pub fn bottom_hole(&self) -> Option<BottomHole> {
        self.state.bit.drilling().map(Drilling::bottom_hole)
    }

    /// Whether the bit drills solid rock.
    pub fn is_on_rock(&self) -> bool {
        self.state.bit.drilling().is_some()
    }

    /// Changes the hoist from now on: a connection, a stop, a lift.
    pub fn set_hoist(&mut self, control: HoistControl) {
        if let HoistControl::BlockVelocity(velocity) = control {
            self.state.rigid_velocity_m_per_s = velocity;
        }
        self.state.hoist.set_control(control);
    }

    /// Gives the top drive another controller from now on; false where it has none of ours.
    pub fn set_speed_controller(&mut self, controller: SpeedController) -> bool {
        let TopDriveSettings::Driven { inertia_kg_m2, .. } = self.settings.top_drive else {
            return false;
        };
        let gains = Gains::of(controller, inertia_kg_m2, TorsionalString::of(&self.mesh));
        let set_rad_per_s = self.state.set_points.rotary_speed_rad_per_s(self.time_s());
        self.state.top_drive.change(gains, &self.chain, set_rad_per_s);
        true
    }

    /// Sets the flow rate of the pumps from now on, m³/s; the pressure drop of the bit and the
    /// speed of a mud motor follow. Without a rheology the mud's flow has no effect on the string.
    pub fn set_flow_rate(&mut self, flow_m3_per_s: f64) {
        self.state.flow_m3_per_s = flow_m3_per_s;
        self.state.bit.set_flow(flow_m3_per_s);
        if let Some(mud) = &mut self.state.viscous {
            mud.set_flow(flow_m3_per_s, self.operation.bit_loss_Pa(flow_m3_per_s));
        }
    }

    /// The lines of the schedule, those that were added too.
    pub fn schedule(&self) -> &[ScheduleStep] {
        self.state.set_points.lines()
    }

    /// Gives every node an additional velocity, m/s, and an additional spin, rad/s: a blow.
    /// `impulse` is called for each node but the top, which is clamped.
    pub fn apply_impulse(&mut self, impulse: impl Fn(&MeshNode) -> (Vector3<f64>, f64)) {
        for (index, node) in self.mesh.nodes.iter().enumerate().skip(1) {
            let (velocity, spin) = impulse(node);
            let before = self.chain.velocity(index);
            self.chain.set_velocity(index, before + velocity.into());
            node!(self.chain, index, spin += spin);
        }
    }

    /// Advances by `seconds`, to the nearest sample; the remainder is carried over to the next
    /// call. On solid rock, where one may take a long time, it ends between two steps if the
    /// executor requests a stop; the next call continues with that sample.
    ///
    /// # Errors
    /// A run that diverged; its earlier samples remain available.
    pub fn advance(&mut self, seconds: f64) -> Result<(), Diverged> {
        let requested_s = std::mem::take(&mut self.state.remainder_s) + seconds;
        let samples = (requested_s / self.sample_interval_s()).round().max(0.0) as u64;
        for _ in 0..samples {
            if self.steps_of_sample() == 0 {
                // Up to this point they are the values of the last sample.
                if let Some(friction) = &mut self.state.friction {
                    friction.sums_are_cleared(&self.chain);
                }
                self.chain.clear_sums();
            }
            loop {
                self.step();
                if self.state.steps.is_multiple_of(FOLLOW_STEPS) {
                    // Nothing follows a node to where no number is.
                    self.check_numbers()?;
                    self.damp(FOLLOW_STEPS);
                    self.follow();
                    self.reach_friction();
                }
                if self.state.steps.is_multiple_of(RENORMALISE_STEPS) {
                    self.chain.renormalise();
                }
                if self.steps_of_sample() == 0 {
                    break;
                }
                if self.is_stopped() {
                    self.chain.close();
                    return self.check_numbers();
                }
            }
            if !self.state.steps.is_multiple_of(FOLLOW_STEPS) {
                self.check_numbers()?;
            }
            self.sample();
            if self.is_stopped() {
                return Ok(());
            }
        }
        let remainder_s = requested_s - samples as f64 * self.sample_interval_s();
        self.state.remainder_s = if remainder_s.is_finite() { remainder_s } else { 0.0 };
        Ok(())
    }

    /// Whether a run on rock is to stop.
    fn is_stopped(&self) -> bool {
        self.is_on_rock() && self.executor.shared.stopped()
    }

    /// Steps since the last sample; none at a sample.
    fn steps_of_sample(&self) -> u64 {
        self.state.steps % self.steps_per_sample
    }

    /// Takes the hole and the mud along to where the nodes have slid.
    fn follow(&mut self) {
        let (chain, anchors) = (&mut self.chain, &mut self.state.anchors);
        if self.borehole.follow(chain, anchors, &mut self.state.high) {
            self.state.squeezed = Squeezed::of(&self.model, &self.mesh, &self.mud, anchors);
        }
        chain.find_drag(self.plan.dt_s);
        if let Some(mud) = &mut self.state.viscous {
            let every_s = FOLLOW_STEPS as f64 * self.plan.dt_s;
            mud.update(chain, anchors, &self.model, self.plan.dt_s, every_s);
        }
    }

    /// Keeps the top on the hole's axis, and a clamped one along it, wherever it has slid to.
    pub(super) fn clamp_top(&mut self) {
        let (along, z) = self.hole_at(0);
        let chain = &mut self.chain;
        let (tangent, curvature) = (chain.tangent(0), chain.curvature(0));
        let speed = chain.velocity(0).dot(along);
        chain.set_velocity(0, along.scaled(speed));
        chain.set_displacement(0, tangent.scaled(z).plus(curvature, 0.5 * z * z));
        if self.model.ends.top == TopEnd::Clamped {
            chain.set_director(0, along);
        }
    }

    /// Keeps a clamped bit along the hole.
    pub(super) fn clamp_bit(&mut self) {
        if self.model.ends.bit == BitEnd::Clamped {
            let last = self.chain.nodes() - 1;
            let (along, _) = self.hole_at(last);
            self.chain.set_director(last, along);
        }
    }

    /// The hole's direction where a node has slid to, and how far along the hole that is from its
    /// anchor, m.
    fn hole_at(&self, index: usize) -> (Vector<f64>, f64) {
        let (tangent, curvature) = (self.chain.tangent(index), self.chain.curvature(index));
        let z = self.chain.displacement(index).dot(tangent);
        let along = tangent.plus(curvature, z);
        (along.scaled(1.0 / along.dot(along).sqrt()), z)
    }

    /// Applies mass-proportional damping for `steps`.
    fn damp(&mut self, steps: u64) {
        let time = self.time_s();
        let fading = match self.settings.start {
            Start::Prepared if time < self.state.fading_s => {
                FADING_DAMPING_PER_S * (1.0 - time / self.state.fading_s).powi(2)
            }
            _ => 0.0,
        };
        let rate_per_s = self.settings.damping.mass_per_s + fading;
        let rotation =
            self.settings.start_ramp(time) * self.state.set_points.rotary_speed_rad_per_s(time);
        let time_s = steps as f64 * self.plan.dt_s;
        let mass_damping = MassDamping {
            time_s,
            dt: self.plan.dt_s,
            left: libm::exp(-rate_per_s * time_s),
            rigid_velocity: self.state.rigid_velocity_m_per_s,
            rigid_spin: self.state.top_drive.rigid_spin(&self.chain, rotation),
        };
        let taken = self.stepper.damp(&mut self.chain, &mass_damping);
        self.state.ledger.book_mass_damping(taken);
    }

    pub(super) fn step_input(&self) -> StepInput {
        StepInput {
            dt: self.plan.dt_s,
            stiffness_damping: self.settings.damping.stiffness_s,
            dissipation: self.settings.contact_law.dissipation_s_per_m(),
            stribeck_speed: self.settings.stribeck_speed_m_per_s,
        }
    }

    /// The whole string as it is now: after [`advance`](Self::advance), at the end of a sample.
    pub fn frame(&self) -> Frame {
        self.scene().frame()
    }

    pub(super) fn scene(&self) -> Scene<'_, R> {
        Scene {
            chain: &self.chain,
            anchors: &self.state.anchors,
            high: &self.state.high,
            body: &self.state.body,
            strength: self.state.record.strength(),
            shapes: self.state.record.shapes(),
            time_s: self.time_s(),
            summed_steps: match self.steps_of_sample() {
                0 => self.steps_per_sample,
                some => some,
            },
        }
    }

    /// Whole samples since the start.
    pub fn samples(&self) -> u64 {
        self.state.steps / self.steps_per_sample
    }

    /// Time between two samples, s: the setting, which the time step divides.
    pub fn sample_interval_s(&self) -> f64 {
        self.steps_per_sample as f64 * self.plan.dt_s
    }

    /// The samples so far.
    pub fn series(&self) -> &TimeSeries {
        &self.state.record.series
    }

    /// Mean weight on bit of [`outcome`](Self::outcome), N.
    pub fn mean_weight_on_bit_N(&self) -> f64 {
        let record = &self.state.record;
        mean(&record.series.weight_on_bit_N[record.window_row_in_memory()..])
    }

    /// The element that buckled most beyond its own load between its nodes, at any time since the
    /// start.
    pub fn buckled_element(&self) -> Option<BuckledElement> {
        let anchors = &self.state.anchors;
        self.state.record.buckled_element(&self.mesh, |index| anchors[index].md_m)
    }

    /// The element that a weight on bit would load most beyond its own buckling load, by the soft
    /// string.
    pub fn buckled_element_under(&self, weight_on_bit_N: f64) -> Option<BuckledElement> {
        let rotation = self.state.set_points.rotary_speed_rad_per_s(self.time_s());
        let mut operation = Operation { weight_on_bit_N, ..self.operation };
        if rotation > 0.0 {
            operation.rotary_speed_rad_per_s = rotation;
        } else {
            operation.kind = operation.kind.without_rotation();
        }
        foreseen::buckled_element(&self.model, &operation, &self.mesh)
    }
}

#[cfg(test)]
mod tests;

//! A step of a run: of the string and its boundary conditions.

use super::run::Run;
use crate::{
    dynamics::{
        boundary::{
            bit::StepStart,
            hoist::Target,
            hole_friction::{FrictionFault, HoleFriction},
            wall_friction::Placement,
        },
        kernel::{
            border::Coupled,
            chain::node,
            step::{StepInput, StepLosses},
        },
        output::energy::StepWork,
        settings::{
            HoistControl,
            schedule::{HoistNow, HoistSetPoint},
        },
    },
    simd::{number::Real, vector::Vector},
};

impl<R: Real> Run<R> {
    /// Takes a step.
    pub(super) fn step(&mut self) {
        let time = self.time_s();
        let input = self.step_input();
        let ramp = self.settings.start_ramp(time);
        let rotation = ramp * self.follow_schedule(time);
        self.state.top_drive.prescribe(&mut self.chain, rotation);
        let top_before = self.chain.velocity(0).dot(self.chain.tangent(0));

        let coupled = self.step_upper(&input);
        let parts = self.chain.parts();
        let own = StepInput { dt: input.dt / f64::from(parts), ..input };
        let mut weight = 0.0;
        for part in 0..parts {
            let ramp = self.settings.start_ramp(time + f64::from(part) * own.dt);
            weight += self.step_lowest(&own, ramp) / f64::from(parts);
            if let (0, Some(coupled)) = (part, &coupled) {
                coupled.lead(&mut self.chain, own.dt);
            }
        }
        let hoist = self.state.hoist.act(
            &mut self.chain,
            self.state.anchors[0].md_m,
            top_before,
            weight,
            input.dt,
        );
        self.clamp_top();
        let drive = self.state.top_drive.act(&mut self.chain, rotation, input.dt);
        let work = StepWork { top_drive: drive.work_J, hoist: hoist.work_J, ..StepWork::default() };
        self.state.ledger.book(&work, &StepLosses::default());
        let sum = &mut self.state.since_sample;
        sum.steps += 1;
        sum.hook_load += hoist.hook_load_N;
        sum.surface_torque += drive.string_torque_N_m;
        self.state.steps += 1;
    }

    /// Takes the step of the upper region, where the lower one has steps of its own.
    fn step_upper(&mut self, input: &StepInput) -> Option<Coupled> {
        let coupled = Coupled::begin(&mut self.chain, input.dt, input.stiffness_damping)?;
        self.ask_friction(0, input.dt);
        let mut losses = self.stepper.step_region(self.chain.region(0), input);
        losses.damping -= coupled.damping_W * input.dt;
        self.state.ledger.book(&StepWork::default(), &losses);
        Some(coupled)
    }

    /// Takes a step of the lowest region, or of the whole string, with the loads at the bit and on
    /// the body; returns the weight on bit, N. Bends act with the fraction `ramp`.
    fn step_lowest(&mut self, input: &StepInput, ramp: f64) -> f64 {
        let (dt, last) = (input.dt, self.chain.nodes() - 1);
        let step_start =
            StepStart { velocity: self.chain.velocity(last), spin: node!(self.chain, last, spin) };
        let region = self.chain.regions() - 1;
        self.ask_friction(region, dt);
        let before = self.state.body.push(&mut self.chain, input, ramp);
        let mut losses = self.stepper.step_region(self.chain.region(region), input);
        let bit = self.state.bit.act(
            &mut self.chain,
            &self.state.anchors[last],
            step_start,
            &self.executor,
            dt,
        );
        let after = self.state.body.follow(&mut self.chain, input);
        self.clamp_bit();
        losses.damping += before.damping_loss_J;
        losses.mud += after.mud_loss_J;
        let work = StepWork { bit: bit.work_J, body: before.work_J, ..StepWork::default() };
        self.state.ledger.book(&work, &losses);
        let high = Vector::from(self.state.anchors[last].high_side);
        let right = self.chain.tangent(last).cross(high);
        let part = 1.0 / f64::from(self.chain.parts());
        self.state.since_sample.add_bit(&bit, high, right, part);
        bit.weight_on_bit_N
    }

    /// Gives the nodes of a region the caller's coefficients of friction, if there are any.
    fn ask_friction(&mut self, region: usize, dt: f64) {
        if let Some(friction) = &mut self.state.friction {
            let (borehole, anchors, mesh) = (&self.borehole, &self.state.anchors, &self.mesh);
            let around = Placement { borehole, anchors, mesh };
            friction.set_coefficients(&mut self.chain, region, around, dt);
        }
    }

    /// Brings the set points to where they are at `time`; the rotary speed, rad/s.
    fn follow_schedule(&mut self, time: f64) -> f64 {
        let hoist = &self.state.hoist;
        self.state.set_points.reach(time, || HoistNow {
            block_velocity_m_per_s: hoist.velocity_m_per_s(),
            weight_on_bit_N: hoist.filtered_N(),
        });
        if let Some(flow) = self.state.set_points.flow_rate_m3_per_s(time) {
            self.set_flow_rate(flow);
        }
        let rotation = self.state.set_points.rotary_speed_rad_per_s(time);
        match self.state.set_points.hoist_at(time) {
            None => {}
            Some(HoistSetPoint::BlockVelocity(velocity)) => {
                self.set_hoist(HoistControl::BlockVelocity(velocity));
            }
            Some(HoistSetPoint::WeightOnBit(weight_N)) => {
                let bit = &self.settings.bit;
                let velocity_m_per_s =
                    bit.axial_velocity_m_per_s(&self.operation, weight_N, rotation);
                self.state.rigid_velocity_m_per_s = velocity_m_per_s;
                self.state.hoist.set_target(Target { weight_N, velocity_m_per_s });
                self.state.hoist.set_control(HoistControl::Autodriller);
            }
        }
        rotation
    }
}

// The hole's friction, changed as the run goes.

impl<R: Real> Run<R> {
    /// Sets the kinetic coefficient of friction of each section of the hole, which it reaches in
    /// proportion to time within `ramp_s`; those at rest and around the hole keep their ratios.
    ///
    /// # Errors
    /// A count that is not the sections', a coefficient or a time that there is not.
    pub fn set_friction(&mut self, kinetic: &[f64], ramp_s: f64) -> Result<(), FrictionFault> {
        let (hole, time_s) = (&self.model.well.hole, self.time_s());
        let mut friction =
            self.state.hole_friction.take().unwrap_or_else(|| HoleFriction::of(hole));
        let changed = friction.change(hole, kinetic, time_s, ramp_s);
        self.state.hole_friction = Some(friction);
        changed?;
        self.reach_friction();
        Ok(())
    }

    /// The kinetic coefficient of friction of each section of the hole now.
    pub fn friction(&self) -> Vec<f64> {
        match &self.state.hole_friction {
            Some(friction) => friction.kinetic().to_vec(),
            None => HoleFriction::of(&self.model.well.hole).kinetic().to_vec(),
        }
    }

    /// Gives the nodes the friction of now, where it is on its way.
    pub(super) fn reach_friction(&mut self) {
        let time_s = self.time_s();
        if let Some(friction) = &mut self.state.hole_friction
            && friction.moves()
            && let Ok(hole) = friction.reach(&self.model.well.hole, time_s)
        {
            self.borehole.set_friction_of(hole, &mut self.chain, &self.state.anchors);
        }
    }
}

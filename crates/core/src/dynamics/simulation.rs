//! A run: the string in time, from its start to its outcome.

use nalgebra::Vector3;

use super::{
    assembly::{self, Anchor, Surroundings},
    bit::Bit,
    chain::{Chain, element, node},
    hoist::Hoist,
    outcome::DynamicOutcome,
    record::Record,
    settings::{ContactLaw, DynamicsSettings, FrictionLaw, HoistControl, Start},
    setup::{self, SetupError},
    start::{self, Scene},
    step::{Abilities, StepInput, Stepper},
    summary,
};
use crate::{
    model::{Model, MudColumn},
    operation::Operation,
    rod::{
        mesh::{Mesh, MeshNode},
        stability::StepPlan,
    },
    wall::friction::STRIBECK_SPEED_M_PER_S,
};

/// Extra damping of the first seconds of a prepared start, relative to the rigid motion, 1/s.
const FADING_DAMPING_PER_S: f64 = 4.0;

/// Time over which it fades, s.
const FADING_S: f64 = 5.0;

/// Time in which a centred start brings the top to its speed, s.
const RAMP_S: f64 = 1.0;

/// Steps after which anchors follow their nodes: at 3.2 m elements some 10 ms.
const FOLLOW_STEPS: u64 = 16;

/// Steps after which the numbers are looked at.
const CHECK_STEPS: u64 = 128;

/// Speed beyond which a run has diverged, m/s: no drill string moves at that of a bullet.
const DIVERGED_M_PER_S: f64 = 1e3;

/// A run that left the range of numbers that mean anything.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "the run diverged {time_s:.3} s after its start, at {md_m:.1} m measured depth: {quantity} is {value:e}"
)]
pub struct Diverged {
    /// When, s.
    pub time_s: f64,
    /// Where: measured depth of the worst node, m.
    pub md_m: f64,
    /// Which quantity.
    pub quantity: &'static str,
    /// Its value.
    pub value: f64,
}

/// Work and losses since the window began, J.
#[derive(Debug, Clone, Copy, Default)]
struct Ledger {
    energy_at_start: f64,
    work: f64,
    losses: f64,
}

/// A drill string in time.
#[derive(Debug, Clone)]
pub struct Simulation {
    model: Model,
    mud: MudColumn,
    operation: Operation,
    settings: DynamicsSettings,
    mesh: Mesh,
    plan: StepPlan,
    chain: Chain,
    anchors: Vec<Anchor>,
    surroundings: Surroundings,
    abilities: Abilities,
    stepper: Stepper,
    hoist: Hoist,
    bit: Bit,
    rigid_velocity_m_per_s: f64,
    steps: u64,
    steps_per_sample: u64,
    since_sample: SinceSample,
    record: Record,
    /// High side at each node, as plain numbers for the sampling loop.
    high: Vec<[f64; 3]>,
    ledger: Ledger,
    window_open: bool,
}

/// Scalars summed since the last sample.
#[derive(Debug, Clone, Copy, Default)]
struct SinceSample {
    steps: u64,
    hook_load: f64,
    surface_torque: f64,
    weight_on_bit: f64,
    bit_torque: f64,
}

impl Simulation {
    /// Lays the string in its hole, ready to run.
    ///
    /// The bit is placed so that it passes the operation's depth in the middle of the window: a string
    /// that trips at 0.3 m/s for a minute is then, on average, where a static calculation has it.
    ///
    /// # Errors
    /// A setting out of range, or a soft string without solution.
    pub fn new(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
    ) -> Result<Self, SetupError> {
        setup::check(settings)?;
        let (control, velocity) = setup::hoisting(operation, settings);
        let bit_md_m = setup::first_bit_md_m(operation, settings);
        let (mesh, plan) = setup::mesh_and_plan(model, bit_md_m, settings);
        let chain = assembly::chain(model, &mesh, &plan);
        let surroundings = Surroundings::new(model, &mesh, settings.contact_law);
        let sections = model.well.hole.sections();
        let abilities = Abilities {
            hertz: matches!(settings.contact_law, ContactLaw::Hertz { .. }),
            vector: settings.friction_law == FrictionLaw::Vector,
            full: sections
                .iter()
                .any(|s| s.friction.at_rest > s.friction.kinetic),
        };
        let stepper = Stepper::new(abilities);
        let input = StepInput {
            dt: plan.dt_s,
            stiffness_damping: settings.damping.stiffness_s,
            mass_damping: settings.damping.mass_per_s,
            rigid_velocity: velocity,
            rigid_spin: operation.rotation_rad_per_s(),
            dissipation: match settings.contact_law {
                ContactLaw::Hertz {
                    dissipation_s_per_m,
                } => dissipation_s_per_m,
                ContactLaw::Linear { .. } => 0.0,
            },
            stribeck_speed: STRIBECK_SPEED_M_PER_S,
        };
        let scene = Scene {
            model,
            operation,
            settings,
            mesh: &mesh,
            surroundings: &surroundings,
            stepper: &stepper,
            input: &input,
        };
        let initial = start::lay(&scene, chain, bit_md_m)?;
        let (chain, anchors) = (initial.chain, initial.anchors);
        let last = anchors.len() - 1;
        let top = anchors[0].md_m + chain.displacement(0).dot(chain.tangent(0));
        let bottom = anchors[last].md_m + chain.displacement(last).dot(chain.tangent(last));
        let hoist = Hoist::new(
            settings.hoist_line,
            control,
            operation.weight_on_bit_now_N(),
            velocity,
            top,
            initial.hook_load_N,
        );
        let record = Record::new(&chain);
        let high = anchors.iter().map(|a| a.high_side.into()).collect();
        let steps_per_sample = (settings.sample_interval_s / plan.dt_s).round().max(1.0) as u64;
        Ok(Self {
            model: model.clone(),
            mud: model.mud_column(),
            operation: *operation,
            settings: *settings,
            mesh,
            plan,
            chain,
            anchors,
            surroundings,
            abilities,
            stepper,
            hoist,
            bit: Bit::new(settings.bit, operation, bottom),
            rigid_velocity_m_per_s: velocity,
            steps: 0,
            steps_per_sample,
            since_sample: SinceSample::default(),
            record,
            high,
            ledger: Ledger::default(),
            window_open: false,
        })
    }

    /// Time since the start, s.
    pub fn time_s(&self) -> f64 {
        self.steps as f64 * self.plan.dt_s
    }

    /// Time at which the window ends, s.
    pub fn end_time_s(&self) -> f64 {
        self.settings.settle_s + self.settings.duration_s
    }

    /// Step, s.
    pub fn time_step_s(&self) -> f64 {
        self.plan.dt_s
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.mesh.elements.len()
    }

    /// The nodes and elements of the string.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Changes the hoist from now on: a connection, a stop, a lift.
    pub fn set_hoist(&mut self, control: HoistControl) {
        if let HoistControl::BlockVelocity(velocity) = control {
            self.rigid_velocity_m_per_s = velocity;
        }
        self.hoist.set_control(control);
    }

    /// Gives every node an additional velocity, m/s, and an additional spin, rad/s: a blow. `blow` is
    /// asked for each node but the top, which is clamped.
    pub fn strike(&mut self, blow: impl Fn(&MeshNode) -> (Vector3<f64>, f64)) {
        for (index, node) in self.mesh.nodes.iter().enumerate().skip(1) {
            let (velocity, spin) = blow(node);
            let before = self.chain.velocity(index);
            self.chain.set_velocity(index, before + velocity.into());
            node!(self.chain, index, spin += spin);
        }
    }

    /// Names of the instruction sets that this processor can run, the fastest first.
    pub fn instruction_sets() -> Vec<&'static str> {
        let any = Abilities {
            hertz: true,
            vector: true,
            full: false,
        };
        let all: Vec<Stepper> = Stepper::all(any);
        all.iter().map(|stepper| stepper.instructions).collect()
    }

    /// Goes on with one of [`Self::instruction_sets`]; with what it has if there is none of that name.
    pub fn use_instructions(&mut self, name: &str) {
        let mut all = Stepper::all(self.abilities).into_iter();
        if let Some(stepper) = all.find(|stepper| stepper.instructions == name) {
            self.stepper = stepper;
        }
    }

    /// Takes `steps` steps of the inner loop alone, the top held where it is: a measure of speed. The
    /// simulation is no more than that afterwards.
    pub fn step_kernel(&mut self, steps: usize) {
        let input = self.step_input(self.time_s());
        node!(self.chain, 0, inv_mass_axial = 0.0);
        for _ in 0..steps {
            self.stepper.step(&mut self.chain, &input);
        }
    }

    /// Goes on for `seconds`, to the nearest sample.
    ///
    /// # Errors
    /// A run that diverged; what it had sampled before stays available.
    pub fn advance(&mut self, seconds: f64) -> Result<(), Diverged> {
        let interval = self.steps_per_sample as f64 * self.plan.dt_s;
        let samples = (seconds / interval).round().max(1.0) as u64;
        for _ in 0..samples {
            for _ in 0..self.steps_per_sample {
                self.step();
                if self.steps.is_multiple_of(FOLLOW_STEPS) {
                    let (chain, anchors) = (&mut self.chain, &mut self.anchors);
                    self.surroundings.follow(chain, anchors, &mut self.high);
                }
                if self.steps.is_multiple_of(CHECK_STEPS) {
                    self.check_numbers()?;
                    self.chain.square_up();
                }
            }
            self.check_numbers()?;
            self.sample();
        }
        Ok(())
    }

    fn step(&mut self) {
        let time = self.time_s();
        let dt = self.plan.dt_s;
        let input = self.step_input(time);
        let rotation = self.operation.rotation_rad_per_s();
        node!(
            self.chain,
            0,
            spin = match self.settings.start {
                Start::Prepared => rotation,
                Start::Centred => rotation * (time / RAMP_S).min(1.0),
            }
        );
        let last = self.chain.nodes() - 1;
        let top_before = self.chain.velocity(0).dot(self.chain.tangent(0));
        let bit_before = self.chain.velocity(last);
        let bit_spin_before = node!(self.chain, last, spin);

        let losses = self.stepper.step(&mut self.chain, &input);

        let bit = self.bit.act(
            &mut self.chain,
            self.anchors[last].md_m,
            bit_before,
            bit_spin_before,
            dt,
        );
        let weight = bit.weight_on_bit_N;
        let hoist = self.hoist.act(
            &mut self.chain,
            self.anchors[0].md_m,
            top_before,
            weight,
            dt,
        );
        self.clamp_top();
        let surface_torque = -element!(self.chain, 0, torque);
        let drive = surface_torque * node!(self.chain, 0, spin) * dt;
        self.ledger.work += bit.work_J + hoist.work_J + drive;
        self.ledger.losses += losses.total();

        let sum = &mut self.since_sample;
        sum.steps += 1;
        sum.hook_load += hoist.hook_load_N;
        sum.surface_torque += surface_torque;
        sum.weight_on_bit += bit.weight_on_bit_N;
        sum.bit_torque += bit.torque_N_m;
        self.steps += 1;
    }

    /// Keeps the top on the hole's axis and along it, wherever it has slid to.
    fn clamp_top(&mut self) {
        let chain = &mut self.chain;
        let (tangent, curvature) = (chain.tangent(0), chain.curvature(0));
        let z = chain.displacement(0).dot(tangent);
        let along = tangent.plus(curvature, z);
        let along = along.scaled(1.0 / along.dot(along).sqrt());
        let speed = chain.velocity(0).dot(along);
        chain.set_velocity(0, along.scaled(speed));
        chain.set_displacement(0, tangent.scaled(z).plus(curvature, 0.5 * z * z));
        chain.set_director(0, along);
    }

    fn step_input(&self, time: f64) -> StepInput {
        let fading = match self.settings.start {
            Start::Prepared if time < FADING_S => {
                FADING_DAMPING_PER_S * (1.0 - time / FADING_S).powi(2)
            }
            _ => 0.0,
        };
        StepInput {
            dt: self.plan.dt_s,
            stiffness_damping: self.settings.damping.stiffness_s,
            mass_damping: self.settings.damping.mass_per_s + fading,
            rigid_velocity: self.rigid_velocity_m_per_s,
            rigid_spin: node!(self.chain, 0, spin),
            dissipation: match self.settings.contact_law {
                ContactLaw::Hertz {
                    dissipation_s_per_m,
                } => dissipation_s_per_m,
                ContactLaw::Linear { .. } => 0.0,
            },
            stribeck_speed: STRIBECK_SPEED_M_PER_S,
        }
    }

    fn check_numbers(&self) -> Result<(), Diverged> {
        // Not a number is too fast, too.
        let fast = |x: f64| x.is_nan() || x.abs() >= DIVERGED_M_PER_S;
        let sound = self.chain.states.iter().all(|state| {
            !state.v.iter().any(|axis| axis.0.iter().any(|v| fast(*v)))
                && state.spin.0.iter().all(|s| s.is_finite())
        });
        if sound {
            return Ok(());
        }
        let speed = |i: usize| {
            let v = self.chain.velocity(i);
            v.dot(v).sqrt()
        };
        let worst = (0..self.chain.nodes())
            .find(|i| !speed(*i).is_finite() || !node!(self.chain, *i, spin).is_finite())
            .unwrap_or_else(|| {
                (0..self.chain.nodes())
                    .max_by(|a, b| speed(*a).total_cmp(&speed(*b)))
                    .unwrap_or(0)
            });
        let spin = node!(self.chain, worst, spin);
        let (quantity, value) = if spin.is_finite() {
            ("velocity (m/s)", speed(worst))
        } else {
            ("spin (rad/s)", spin)
        };
        Err(Diverged {
            time_s: self.time_s(),
            md_m: self.anchors[worst].md_m,
            quantity,
            value,
        })
    }

    fn sample(&mut self) {
        let time = self.time_s();
        if !self.window_open && time >= self.settings.settle_s {
            self.window_open = true;
            self.record.open_window();
            self.ledger = Ledger {
                energy_at_start: self.energy_J(),
                ..Ledger::default()
            };
        }
        let sums = std::mem::take(&mut self.since_sample);
        let totals = self.record.sample(&mut self.chain, &self.high, sums.steps);
        let n = sums.steps as f64;
        let last = self.chain.nodes() - 1;
        let elongation = self.elongation_m();
        let twist = -(0..self.chain.elements())
            .map(|i| element!(self.chain, i, twist))
            .sum::<f64>();
        let series = &mut self.record.series;
        series.time_s.push(time);
        series.bit_depth_m.push(
            self.anchors[last].md_m + self.chain.displacement(last).dot(self.chain.tangent(last)),
        );
        series.hook_load_N.push(sums.hook_load / n);
        series.surface_torque_N_m.push(sums.surface_torque / n);
        series.friction_torque_N_m.push(totals.torque_N_m);
        series.axial_friction_N.push(-totals.axial_N);
        series.side_force_total_N.push(totals.normal_N);
        series.weight_on_bit_N.push(sums.weight_on_bit / n);
        series.bit_torque_N_m.push(sums.bit_torque / n);
        series.twist_rad.push(twist);
        series.stretch_m.push(elongation);
        series
            .block_velocity_m_per_s
            .push(self.hoist.velocity_m_per_s());
        series
            .bit_rotary_speed_rad_per_s
            .push(node!(self.chain, last, spin));
    }

    /// Elongation against the unloaded string, m: by effective tension, less what the mud's pressure
    /// takes, `(1 − 2ν)p/E`.
    fn elongation_m(&self) -> f64 {
        let mud = self.mud;
        let mut sum = 0.0;
        for (i, e) in self.mesh.elements.iter().enumerate() {
            let tvd = 0.5 * (self.anchors[i].position_m.z + self.anchors[i + 1].position_m.z);
            let section = &e.section;
            let squeeze = section.pressure_strain_per_Pa * mud.pressure_Pa(tvd);
            sum += e.length_m
                * (element!(self.chain, i, tension) / section.axial_stiffness_N - squeeze);
        }
        sum
    }

    /// Kinetic, elastic and potential energy of the string, J: second-order accurate in the step.
    pub fn energy_J(&self) -> f64 {
        assembly::energy_J(&self.chain, &self.anchors, self.plan.dt_s)
    }

    /// Kinetic energy of the string, J.
    pub fn kinetic_energy_J(&self) -> f64 {
        assembly::kinetic_energy_J(&self.chain)
    }

    /// What the integration itself gained or lost since the window began, over the largest of the
    /// work put in, the losses, the change of energy and the kinetic energy.
    fn energy_residual(&self) -> f64 {
        if !self.window_open {
            return 0.0;
        }
        let Ledger {
            energy_at_start,
            work,
            losses,
        } = self.ledger;
        let change = self.energy_J() - energy_at_start;
        let largest = change
            .abs()
            .max(work.abs())
            .max(losses.abs())
            .max(self.kinetic_energy_J());
        if largest > 0.0 {
            (work - losses - change) / largest
        } else {
            0.0
        }
    }

    /// The answer so far: over the window if it has begun, over everything sampled otherwise.
    pub fn outcome(&self) -> DynamicOutcome {
        summary::outcome(&summary::Sources {
            model: &self.model,
            mesh: &self.mesh,
            plan: &self.plan,
            anchors: &self.anchors,
            record: &self.record,
            steps: self.steps,
            energy_residual: self.energy_residual(),
            instructions: self.stepper.instructions,
        })
    }
}

#[cfg(test)]
mod tests;

//! A run: the string in time, from its start to its outcome, in either kind of number.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::{
    assembly::{self, Anchor, Surroundings},
    bit::Bit,
    body::Body,
    chain::{Chain, Row, Rows, element, node},
    energy::{self, Energies, EnergyBalance, Ledger, StepWork},
    frame::{self, Frame},
    hoist::{Hoist, Target},
    outcome::DynamicOutcome,
    record::{self, Record},
    schedule::{HoistNow, HoistSetPoint, SetPoints},
    settings::{ContactLaw, DynamicsSettings, HoistControl, Start},
    setup::{self, Basis, SetupError},
    signal::Probed,
    start::{self, Scene},
    step::{Abilities, StepInput, Stepper},
    summary,
    top_drive::{StringSeen, TopDrive},
    viscous::Viscous,
    wear::Wear,
};
use crate::{
    model::{Model, MudColumn},
    operation::Operation,
    rod::{
        mesh::{Mesh, MeshNode},
        number::Real,
        stability::StepPlan,
        torsion,
    },
};

mod checkpoint;

pub use checkpoint::{Checkpoint, ResumeError};

/// Extra damping of the first seconds of a prepared start, relative to the rigid motion, 1/s.
const FADING_DAMPING_PER_S: f64 = 4.0;

/// Time over which it fades, s; a schedule that changes something before has nothing of it against itself.
const FADING_S: f64 = 5.0;

/// Time in which a centred start brings the top to its speed, s.
const RAMP_S: f64 = 1.0;

/// Steps after which anchors follow their nodes: at 3.2 m elements some 10 ms.
const FOLLOW_STEPS: u64 = 16;

/// Steps after which directors are squared up.
const SQUARE_UP_STEPS: u64 = 128;

/// Speed beyond which a run has diverged, m/s: no drill string moves at that of a bullet.
const DIVERGED_M_PER_S: f64 = 1e3;

/// Spin beyond which a run has diverged, rad/s: a million revolutions a minute.
const DIVERGED_RAD_PER_S: f64 = 1e5;

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

/// A drill string in time, in one kind of number.
#[derive(Debug, Clone)]
pub struct Run<R: Real> {
    model: Model,
    mud: MudColumn,
    operation: Operation,
    settings: DynamicsSettings,
    mesh: Mesh,
    plan: StepPlan,
    chain: Chain<R>,
    anchors: Vec<Anchor>,
    surroundings: Surroundings,
    abilities: Abilities,
    stepper: Stepper<R>,
    set_points: SetPoints,
    top_drive: TopDrive,
    hoist: Hoist,
    body: Body,
    bit: Bit,
    viscous: Option<Viscous>,
    /// What the pumps deliver, m³/s.
    flow_m3_per_s: f64,
    rigid_velocity_m_per_s: f64,
    /// Time over which the extra damping of the start fades, s.
    fading_s: f64,
    steps: u64,
    steps_per_sample: u64,
    since_sample: SinceSample,
    record: Record,
    wear: Wear,
    /// High side at each node, block by block.
    high: Vec<Rows<f64>>,
    ledger: Ledger,
    window_open: bool,
}

/// Scalars summed since the last sample.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
struct SinceSample {
    steps: u64,
    hook_load: f64,
    surface_torque: f64,
    weight_on_bit: f64,
    bit_torque: f64,
    depth_of_cut: f64,
}

impl<R: Real> Run<R> {
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
        let Basis {
            mesh,
            plan,
            surroundings,
            abilities,
            stepper,
            steps_per_sample,
        } = Basis::new(model, operation, settings)?;
        let (control, velocity) = setup::hoisting(operation, settings);
        let first = settings.schedule.at_time_zero(operation);
        let bit_md_m = setup::first_bit_md_m(operation, settings);
        let chain = assembly::chain(model, &mesh, &plan);
        let mut viscous = Viscous::new(model, &mesh, &first, velocity, bit_md_m);
        let input = StepInput {
            dt: plan.dt_s,
            stiffness_damping: settings.damping.stiffness_s,
            mass_damping: settings.damping.mass_per_s,
            rigid_velocity: velocity,
            rigid_spin: first.rotation_rad_per_s(),
            dissipation: match settings.contact_law {
                ContactLaw::Hertz {
                    dissipation_s_per_m,
                } => dissipation_s_per_m,
                ContactLaw::Linear { .. } => 0.0,
            },
            stribeck_speed: settings.stribeck_speed_m_per_s,
        };
        let (moving, at_rest) = start::motion(&first, velocity, settings);
        // Whatever the run is made with, the string is laid in double precision.
        let laying = Stepper::new(abilities);
        let scene = Scene {
            model,
            operation: &moving,
            at_rest,
            settings,
            mesh: &mesh,
            surroundings: &surroundings,
            viscous: viscous.as_ref(),
            stepper: &laying,
            input: &input,
        };
        let initial = start::lay(&scene, chain, Body::new(model, &mesh), bit_md_m)?;
        let (mut chain, anchors) = (initial.chain.converted(), initial.anchors);
        if let Some(mud) = &mut viscous {
            mud.attach(&mut chain, &anchors, plan.dt_s);
            mud.update(&mut chain, &anchors, &surroundings, plan.dt_s);
        }
        let last = anchors.len() - 1;
        let top = anchors[0].md_m + chain.displacement(0).dot(chain.tangent(0));
        let bottom = anchors[last].md_m + chain.displacement(last).dot(chain.tangent(last));
        let hoist = Hoist::new(
            settings.hoist_line,
            control,
            settings.autodriller,
            Target {
                weight_N: first.weight_on_bit_now_N(),
                velocity_m_per_s: velocity,
            },
            top,
            initial.hook_load_N,
        );
        let string = StringSeen {
            impedance_N_m_s: torsion::impedance_N_m_s(&mesh.elements[0].section),
            frequency_Hz: torsion::lowest_frequency_Hz(&mesh),
        };
        let top_drive = TopDrive::new(&settings.top_drive, string, &mut chain);
        // The front on which the bit stands with its first weight.
        let lighter_N = operation.weight_on_bit_now_N() - first.weight_on_bit_now_N();
        let bottom = bottom + lighter_N / settings.bit.law.stiffness_N_per_m();
        let hole_end_m = model.well.hole.sections().last().map_or(0.0, |s| s.to_md_m);
        let wear = Wear::new(chain.nodes(), hole_end_m, bottom);
        let layout = chain.layout();
        let mut record = Record::new(model, &mesh, layout);
        let probes = settings.probes.iter().map(|probe| Probed {
            node: mesh.nearest_node(operation.bit_depth_m - probe.md_m),
            signal: probe.signal,
            samples: Vec::new(),
        });
        record.series.probes = probes.collect();
        let mut high = vec![[Row::filled(0.0); 3]; layout.blocks()];
        for (index, anchor) in anchors.iter().enumerate() {
            assembly::note_high_side(&mut high, layout.place(index), anchor);
        }
        Ok(Self {
            model: model.clone(),
            mud: model.mud_column(),
            operation: *operation,
            settings: settings.clone(),
            mesh,
            plan,
            chain,
            anchors,
            surroundings,
            abilities,
            stepper,
            set_points: SetPoints::new(&first, &settings.schedule),
            top_drive,
            hoist,
            body: initial.body,
            bit: Bit::new(settings.bit, operation, bottom, settings.seed),
            viscous,
            flow_m3_per_s: first.flow_now_m3_per_s(),
            rigid_velocity_m_per_s: velocity,
            fading_s: settings
                .schedule
                .first_change_s()
                .map_or(FADING_S, |change_s| change_s.min(FADING_S)),
            steps: 0,
            steps_per_sample,
            since_sample: SinceSample::default(),
            record,
            wear,
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

    /// Name of the instruction set that the time loop was compiled for.
    pub fn instructions(&self) -> &'static str {
        self.stepper.instructions
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

    /// Changes what the pumps deliver from now on, m³/s; the pressure drop of the bit follows. Without a rheology
    /// the mud does nothing to the string, however it flows.
    pub fn set_flow_rate(&mut self, flow_m3_per_s: f64) {
        self.flow_m3_per_s = flow_m3_per_s;
        if let Some(mud) = &mut self.viscous {
            mud.set_flow(flow_m3_per_s, self.operation.bit_loss_Pa(flow_m3_per_s));
        }
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

    /// Goes on with one of the instruction sets; with what it has if there is none of that name.
    pub fn use_instructions(&mut self, name: &str) {
        let mut all = Stepper::all(self.abilities).into_iter();
        if let Some(stepper) = all.find(|stepper| stepper.instructions == name) {
            self.stepper = stepper;
        }
    }

    /// Takes `steps` steps of the inner loop alone, the top held where it is: a measure of speed. The
    /// simulation is no more than that afterwards.
    pub fn step_kernel(&mut self, steps: usize) {
        let spin = node!(self.chain, 0, spin);
        let input = self.step_input(self.time_s(), spin);
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
        let samples = (seconds / self.sample_interval_s()).round().max(1.0) as u64;
        for _ in 0..samples {
            // Until here they are what the last sample saw.
            self.chain.clear_sums();
            for _ in 0..self.steps_per_sample {
                self.step();
                if self.steps.is_multiple_of(FOLLOW_STEPS) {
                    // Nothing follows a node to where no number is.
                    self.check_numbers()?;
                    self.follow();
                }
                if self.steps.is_multiple_of(SQUARE_UP_STEPS) {
                    self.chain.square_up();
                }
            }
            self.check_numbers()?;
            self.sample();
        }
        Ok(())
    }

    /// Takes the hole and the mud along to where the nodes have slid.
    fn follow(&mut self) {
        let (chain, anchors) = (&mut self.chain, &mut self.anchors);
        self.surroundings.follow(chain, anchors, &mut self.high);
        if let Some(mud) = &mut self.viscous {
            mud.update(chain, anchors, &self.surroundings, self.plan.dt_s);
        }
    }

    fn step(&mut self) {
        let time = self.time_s();
        let dt = self.plan.dt_s;
        let ramp = match self.settings.start {
            Start::Prepared => 1.0,
            Start::Centred => (time / RAMP_S).min(1.0),
        };
        let rotation = ramp * self.follow_schedule(time);
        let input = self.step_input(time, rotation);
        self.top_drive.prescribe(&mut self.chain, rotation);
        let last = self.chain.nodes() - 1;
        let top_before = self.chain.velocity(0).dot(self.chain.tangent(0));
        let bit_before = self.chain.velocity(last);
        let bit_spin_before = node!(self.chain, last, spin);

        let before = self.body.push(&mut self.chain, &input, ramp);
        let mut losses = self.stepper.step(&mut self.chain, &input);

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
        let after = self.body.follow(&mut self.chain, dt);
        let drive = self.top_drive.act(&mut self.chain, rotation, dt);
        let work = StepWork {
            top_drive: drive.work_J,
            hoist: hoist.work_J,
            bit: bit.work_J,
            body: before.work_J,
        };
        losses.damping += before.loss_J + after.loss_J;
        self.ledger.book(&work, &losses);

        let sum = &mut self.since_sample;
        sum.steps += 1;
        sum.hook_load += hoist.hook_load_N;
        sum.surface_torque += drive.string_torque_N_m;
        sum.weight_on_bit += bit.weight_on_bit_N;
        sum.bit_torque += bit.torque_N_m;
        sum.depth_of_cut += bit.depth_of_cut_m;
        self.steps += 1;
    }

    /// Brings the set points to where they are at `time`; the rotary speed, rad/s.
    fn follow_schedule(&mut self, time: f64) -> f64 {
        let hoist = &self.hoist;
        self.set_points.reach(time, || HoistNow {
            block_velocity_m_per_s: hoist.velocity_m_per_s(),
            weight_on_bit_N: hoist.filtered_N(),
        });
        if let Some(flow) = self.set_points.flow_rate_m3_per_s(time) {
            self.set_flow_rate(flow);
        }
        let rotation = self.set_points.rotary_speed_rad_per_s(time);
        match self.set_points.hoist_at(time) {
            None => {}
            Some(HoistSetPoint::BlockVelocity(velocity)) => {
                self.set_hoist(HoistControl::BlockVelocity(velocity));
            }
            Some(HoistSetPoint::WeightOnBit(weight_N)) => {
                let velocity_m_per_s = self.operation.axial_velocity_at_m_per_s(weight_N, rotation);
                self.rigid_velocity_m_per_s = velocity_m_per_s;
                self.hoist.set_target(Target {
                    weight_N,
                    velocity_m_per_s,
                });
                self.hoist.set_control(HoistControl::Autodriller);
            }
        }
        rotation
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

    fn step_input(&self, time: f64, rotation: f64) -> StepInput {
        let fading = match self.settings.start {
            Start::Prepared if time < self.fading_s => {
                FADING_DAMPING_PER_S * (1.0 - time / self.fading_s).powi(2)
            }
            _ => 0.0,
        };
        StepInput {
            dt: self.plan.dt_s,
            stiffness_damping: self.settings.damping.stiffness_s,
            mass_damping: self.settings.damping.mass_per_s + fading,
            rigid_velocity: self.rigid_velocity_m_per_s,
            rigid_spin: self.top_drive.rigid_spin(&self.chain, rotation),
            dissipation: match self.settings.contact_law {
                ContactLaw::Hertz {
                    dissipation_s_per_m,
                } => dissipation_s_per_m,
                ContactLaw::Linear { .. } => 0.0,
            },
            stribeck_speed: self.settings.stribeck_speed_m_per_s,
        }
    }

    fn check_numbers(&self) -> Result<(), Diverged> {
        // Not a number is too fast, too.
        let fast = |x: f64, limit: f64| x.is_nan() || x.abs() >= limit;
        // Every number is looked at: a loop that ends early is none that looks at eight at once.
        let mut sound = true;
        for state in &self.chain.states {
            for axis in &state.v {
                for v in axis.0.as_ref() {
                    sound &= v.to_f64().abs() < DIVERGED_M_PER_S;
                }
            }
            for spin in state.spin.0.as_ref() {
                sound &= spin.to_f64().abs() < DIVERGED_RAD_PER_S;
            }
        }
        if sound {
            return Ok(());
        }
        let speed = |i: usize| {
            let v = self.chain.velocity(i);
            v.dot(v).sqrt()
        };
        let worst = (0..self.chain.nodes())
            .find(|i| {
                !speed(*i).is_finite() || fast(node!(self.chain, *i, spin), DIVERGED_RAD_PER_S)
            })
            .unwrap_or_else(|| {
                (0..self.chain.nodes())
                    .max_by(|a, b| speed(*a).total_cmp(&speed(*b)))
                    .unwrap_or(0)
            });
        let spin = node!(self.chain, worst, spin);
        let (quantity, value) = if !fast(spin, DIVERGED_RAD_PER_S) {
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
            self.wear.restart(self.anchors[self.anchors.len() - 1].md_m);
            self.ledger = Ledger::open(self.energies(), self.flow_work_J());
            if let Some(mud) = &mut self.viscous {
                mud.open_window();
            }
        }
        if let Some(mud) = &mut self.viscous {
            mud.sample(&self.chain);
            let pressures = mud.pressures();
            self.record.press(|node| pressures.difference_Pa(node));
        }
        self.wear.sample(&self.chain, |i| self.anchors[i].md_m);
        let sums = std::mem::take(&mut self.since_sample);
        let totals = self
            .record
            .sample(&self.chain, &self.high, &self.body, sums.steps);
        let n = sums.steps as f64;
        let last = self.chain.nodes() - 1;
        let elongation = self.elongation_m();
        let twist = -(0..self.chain.elements())
            .map(|i| element!(self.chain, i, twist))
            .sum::<f64>();
        let neutral_point_m = record::neutral_point_m(&self.chain, &self.anchors, totals.tension_N);
        let interval_s = self.sample_interval_s();
        let path = &self.model.well.path;
        let cutoff_depth_m =
            self.record
                .cutoff_depth_m(&self.mesh, path, &self.anchors, interval_s);
        let scene = self.scene();
        let probes = self.record.series.probes.iter();
        let probed: Vec<f64> = probes.map(|p| scene.signal(p.node, p.signal)).collect();
        let series = &mut self.record.series;
        for (probe, value) in series.probes.iter_mut().zip(probed) {
            probe.samples.push(value);
        }
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
        series.depth_of_cut_m.push(sums.depth_of_cut / n);
        series.twist_rad.push(twist);
        series.stretch_m.push(elongation);
        series
            .block_velocity_m_per_s
            .push(self.hoist.velocity_m_per_s());
        series
            .bit_rotary_speed_rad_per_s
            .push(node!(self.chain, last, spin));
        let (block, weight) = match self.hoist.control() {
            HoistControl::BlockVelocity(velocity) => (Some(velocity), None),
            HoistControl::Autodriller => (None, Some(self.hoist.target_N())),
            HoistControl::HookLoad(_) => (None, None),
        };
        let rotation = self.set_points.rotary_speed_rad_per_s(time);
        series
            .rotary_speed_rad_per_s
            .push(node!(self.chain, 0, spin));
        series.rotary_speed_set_rad_per_s.push(rotation);
        series.block_velocity_set_m_per_s.push(block);
        series.weight_on_bit_set_N.push(weight);
        series.flow_rate_m3_per_s.push(self.flow_m3_per_s);
        let viscous = self.viscous.as_ref();
        series
            .pump_pressure_Pa
            .push(viscous.map(|mud| mud.pressures().pump_Pa()));
        series.schedule_line.push(self.set_points.line());
        series.neutral_point_m.push(neutral_point_m);
        series.cutoff_depth_m.push(cutoff_depth_m);
    }

    /// The whole string as it is now, at the end of a sample: after [`advance`](Self::advance).
    pub fn frame(&self) -> Frame {
        self.scene().frame()
    }

    fn scene(&self) -> frame::Scene<'_, R> {
        frame::Scene {
            chain: &self.chain,
            anchors: &self.anchors,
            high: &self.high,
            body: &self.body,
            strength: self.record.strength(),
            time_s: self.time_s(),
            summed_steps: self.steps_per_sample,
        }
    }

    /// Time between two samples, s: the setting, rounded to whole steps.
    pub fn sample_interval_s(&self) -> f64 {
        self.steps_per_sample as f64 * self.plan.dt_s
    }

    /// Elongation against the unloaded string, m: by effective tension, less what the mud's pressure
    /// takes, `(1 − 2ν)p/E`, and by what its flow adds to the pressure.
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
        sum + self.viscous.as_ref().map_or(0.0, Viscous::stretch_m)
    }

    /// Kinetic, elastic and potential energy of the string, J: second-order accurate in the step.
    pub fn energy_J(&self) -> f64 {
        self.energies().total()
    }

    /// Kinetic energy of the string, J.
    pub fn kinetic_energy_J(&self) -> f64 {
        energy::kinetic_J(&self.chain)
    }

    fn energies(&self) -> Energies {
        let viscous = self.viscous.as_ref();
        Energies::of(
            &self.chain,
            &self.anchors,
            &self.body,
            viscous,
            self.plan.dt_s,
        )
    }

    fn flow_work_J(&self) -> f64 {
        let (chain, anchors) = (&self.chain, &self.anchors);
        let work = |mud: &Viscous| mud.pull_work_J(chain, anchors, self.plan.dt_s);
        self.viscous.as_ref().map_or(0.0, work)
    }

    /// Where energy came from and went since the window began, and the relative residual; none before it does, and
    /// none of a run that diverged.
    fn energy_balance(&self) -> Option<(EnergyBalance, f64)> {
        self.window_open
            .then(|| self.ledger.balance(&self.energies(), self.flow_work_J()))
            .flatten()
    }

    /// The answer so far: over the window if it has begun, over everything sampled otherwise.
    pub fn outcome(&self) -> DynamicOutcome {
        let diverged = self.check_numbers().is_err();
        summary::outcome(&summary::Sources {
            model: &self.model,
            operation: &self.operation,
            mesh: &self.mesh,
            plan: &self.plan,
            anchors: &self.anchors,
            record: &self.record,
            wear: &self.wear,
            steps: self.steps,
            energy: self.energy_balance().filter(|_| !diverged),
            diverged,
            hydraulics: self.viscous.as_ref().map(Viscous::mean),
            pressures: self.viscous.as_ref().map(Viscous::mean_pressures),
            instructions: self.stepper.instructions,
        })
    }
}

#[cfg(test)]
mod tests;

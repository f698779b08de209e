//! The beginning of a run.

use super::{
    run::Run,
    settling::FADING_S,
    state::{SinceSample, State},
};
use crate::{
    dynamics::{
        assemble::{
            self, SetupError,
            basis::{self, Basis},
            chain,
        },
        body::Body,
        boundary::{
            bit::{Bit, RunIn, Standing},
            executor::RockExecutor,
            hoist::{Hoist, Target},
            hole,
            mud::{Squeezed, viscous::Viscous},
            top_drive::{TopDrive, TorsionalString},
            wall_friction::WallFriction,
        },
        initial_state::{self, scene::Scene},
        kernel::{
            chain::{Row, node},
            step::{StepInput, Stepper},
        },
        output::{energy::Ledger, probe::Probed, record::Record, wear::Wear},
        settings::{DynamicsSettings, Start, schedule::SetPoints},
    },
    model::Model,
    operation::Operation,
    simd::wide::Registers,
};

impl<R: Registers> Run<R> {
    /// Initialises the string in its hole, ready to run.
    ///
    /// The bit is placed so that it passes the operation's depth in the middle of the window: a
    /// string that trips at 0.3 m/s for a minute is then, on average, where a static calculation
    /// has it.
    ///
    /// `executor` is polled for a stop request meanwhile. It runs the bit in, where there is solid
    /// rock, and works on it from then on.
    ///
    /// # Errors
    /// A setting out of range, a soft string without solution, or an executor that requests a stop.
    pub fn new(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        executor: RockExecutor,
    ) -> Result<Self, SetupError> {
        let basis = Basis::new(model, operation, settings)?;
        Self::begin(model, operation, settings, executor, basis)
    }

    /// The same, from the data that follow from its input.
    pub(super) fn begin(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        executor: RockExecutor,
        basis: Basis<R>,
    ) -> Result<Self, SetupError> {
        let (mesh, dt) = (&basis.mesh, basis.plan.dt_s);
        let (control, velocity) = chain::hoisting(operation, settings);
        let mut first = settings.schedule.at_time_zero(operation);
        let bit_md_m = basis::first_bit_md_m(operation, settings, &basis.settling);
        let chain = assemble::chain::chain(model, mesh, &basis.plan);
        let mut viscous = Viscous::new(model, mesh, &first, velocity, bit_md_m);
        let input = StepInput {
            dt,
            stiffness_damping: settings.damping.stiffness_s,
            dissipation: settings.contact_law.dissipation_s_per_m(),
            stribeck_speed: settings.stribeck_speed_m_per_s,
        };
        let pressed_N = if settings.starts_cold() { 0.0 } else { first.weight_on_bit_now_N() };
        let last = mesh.nodes.len() - 1;
        // A string that starts centred is at rest.
        let turns = settings.start == Start::Prepared;
        let standing = Standing {
            weight_N: pressed_N,
            rate_m_per_s: if pressed_N > 0.0 { velocity } else { 0.0 },
            string_rad_per_s: if turns { first.rotation_rad_per_s() } else { 0.0 },
            mass_kg: node!(chain, last, mass_axial),
        };
        let run_in = if operation.weight_on_bit_now_N() > 0.0 {
            RunIn::new(&settings.bit, &first, standing, &executor)?
        } else {
            None
        };
        if let Some(run_in) = &run_in {
            first.bit_torque_N_m = run_in.torque_N_m();
        }
        let (moving, at_rest) = initial_state::scene::motion(&first, velocity, settings);
        // Whatever the run is made with, the string is initialised in double precision.
        let initial_stepper = Stepper::new(basis.abilities);
        let scene = Scene {
            model,
            operation: &moving,
            at_rest,
            settings,
            mesh,
            borehole: &basis.borehole,
            viscous: viscous.as_ref(),
            stepper: &initial_stepper,
            border: basis.border(),
            input: &input,
            velocity_m_per_s: velocity,
            executor: &executor.shared,
        };
        let initial = initial_state::initialise(&scene, chain, Body::new(model, mesh), bit_md_m)?;
        let (mut chain, anchors) = (initial.chain.divided_at(basis.border()), initial.anchors);
        chain.find_drag(dt);
        if let Some(mud) = &mut viscous {
            mud.attach(&mut chain, &anchors, dt);
            mud.update(&mut chain, &anchors, model, dt, dt);
        }
        let top = anchors[0].md_m + chain.displacement(0).dot(chain.tangent(0));
        let bottom = anchors[last].md_m + chain.displacement(last).dot(chain.tangent(last));
        let hoist = Hoist::new(
            settings.hoist_line,
            control,
            settings.autodriller,
            Target { weight_N: first.weight_on_bit_now_N(), velocity_m_per_s: velocity },
            top,
            initial.hook_load_N,
        )
        .pushing(model.rig.push_N());
        let string = TorsionalString::of(mesh);
        let top_drive = TopDrive::new(&settings.top_drive, string, &mut chain);
        // The rock front under the bit with its first weight.
        let lighter_N = operation.weight_on_bit_now_N() - pressed_N;
        let bottom = bottom + lighter_N / settings.bit.law.stiffness_N_per_m();
        let hole_end_m = model.well.hole.sections().last().map_or(0.0, |s| s.to_md_m);
        let mut bit =
            Bit::new(&settings.bit, operation, bottom, settings.seed).ending(model.ends.bit);
        bit.set_flow(first.flow_now_m3_per_s());
        if let Some(run_in) = run_in {
            bit.stand(run_in, &chain, &anchors[last]);
        }
        chain.close();
        let wear = Wear::new(chain.nodes(), hole_end_m, bottom);
        let layout = chain.layout();
        let interval_s = basis.steps_per_sample as f64 * basis.plan.dt_s;
        let samples = (settings.duration_s / interval_s).ceil() as u64;
        let mut record = Record::new(model, mesh, layout, samples);
        let probes = settings.probes.iter().map(|probe| Probed {
            node: mesh.nearest_node(operation.bit_depth_m - probe.md_m),
            signal: probe.signal,
            samples: Vec::new(),
        });
        record.series.probes = probes.collect();
        record.look_at_shapes(&chain, &initial.body);
        let mut high = vec![[Row::filled(0.0); 3]; layout.blocks()];
        for (index, anchor) in anchors.iter().enumerate() {
            hole::note_high_side(&mut high, layout.place(index), anchor);
        }
        let state = State {
            squeezed: Squeezed::of(model, mesh, &model.mud_column(), &anchors),
            anchors,
            set_points: SetPoints::new(&first, &settings.schedule),
            top_drive,
            hoist,
            body: initial.body,
            bit,
            viscous,
            flow_m3_per_s: first.flow_now_m3_per_s(),
            rigid_velocity_m_per_s: velocity,
            // A schedule that changes something before has nothing of it against itself.
            fading_s: settings
                .schedule
                .first_change_s()
                .map_or(FADING_S, |change_s| change_s.min(FADING_S)),
            steps: 0,
            remainder_s: 0.0,
            since_sample: SinceSample::default(),
            record,
            wear,
            high,
            ledger: Ledger::default(),
            window_open: false,
            settled: None,
            friction: settings
                .friction_coefficient
                .as_ref()
                .map(|law| WallFriction::new(law, &chain)),
            hole_friction: None,
        };
        Ok(Self { executor, ..Self::of(model, operation, settings, basis, chain, state) })
    }
}

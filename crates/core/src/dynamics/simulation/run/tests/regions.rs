//! Whole runs of strings in two regions with steps of their own, against one step for all.

use super::*;
use crate::{
    common::np13::drill_pipe,
    dynamics::{
        Band, BitLaw, CustomFriction, Excitation, FrictionCoefficient, RateLaw, ResumeError,
        SlidingContact,
        assemble::{basis::Basis, chain},
        kernel::chain::element,
        settings::mesh::{MeshSettings, Regions},
    },
    rod::{
        mesh::{MeshElement, MeshNode},
        regions,
        section::Section,
    },
    simd::wide::Registers,
    sizing::SizeReason,
    string::{BodyBend, Cavity, ComponentSpec, Eccentricity, StringSpec},
};

const PIPE_M: f64 = 9.6;

/// Length of the assembly, m.
const ASSEMBLY_M: f64 = 57.6;

/// Depth of the bit under so many joints of pipe, m.
fn depth_m(joints: usize) -> f64 {
    joints as f64 * PIPE_M + ASSEMBLY_M
}

/// A string of `joints` of drill pipe on an assembly of collars in a straight hole of an
/// inclination.
fn slant(joints: usize, inclination_deg: f64, friction: f64) -> Model {
    let depth_m = depth_m(joints);
    let inclination = inclination_deg.to_radians();
    let friction = Friction { kinetic: friction, at_rest: friction, around: 1.0 };
    common::model(
        path_in_rad(&[[0.0, inclination, 0.0], [depth_m, inclination, 0.0]], Interpolation::Spline),
        article_hole(0.2159, friction, depth_m + 20.0),
        vec![tool("collar", ComponentLength::Metres(ASSEMBLY_M), 0.165, 0.0714), drill_pipe()],
        mud_with_drag(),
        depth_m,
    )
}

/// The string's mesh: an element for each joint of pipe, each of those of the assembly in `parts`.
fn refined(model: &Model, joints: usize, parts: usize) -> Mesh {
    let mut ends: Vec<f64> = Vec::new();
    let short_m = PIPE_M / parts as f64;
    let shorts = (ASSEMBLY_M / short_m).round() as usize;
    ends.extend((0..shorts).map(|i| i as f64 * short_m));
    ends.extend((0..=joints).map(|i| ASSEMBLY_M + i as f64 * PIPE_M));
    ends.reverse();
    let node = |from_bit_m: &f64| {
        let (_, component) = model.string.component_at(*from_bit_m);
        MeshNode { from_bit_m: *from_bit_m, contact_radius_m: component.contact_radius_m() }
    };
    let element = |pair: &[f64]| MeshElement {
        length_m: pair[0] - pair[1],
        section: Section::between(&model.string, pair[1], pair[0]),
        reason: SizeReason::Given,
    };
    Mesh {
        nodes: ends.iter().map(node).collect(),
        elements: ends.windows(2).map(element).collect(),
    }
}

/// Basis of a run on the refined mesh, with the steps and the inertia of the plan in regions;
/// `divided`, or with the shorter step for all.
fn basis<R: Registers>(case: &Case, divided: bool) -> Basis<R> {
    let Case { model, operation, settings, mesh } = case;
    let settling = Settling::of(model, operation, settings, mesh);
    let lateral = chain::lateral_mass_kg_per_m(model, mesh, operation.bit_depth_m);
    let mut plan = regions::plan(mesh, &lateral, settings.damping.stiffness_s, usize::MAX);
    assert!(plan.subcycling.is_some(), "regions pay here");
    if !divided {
        plan.dt_s = plan.shortest_s();
        plan.subcycling = None;
    }
    Basis::on(model, settings, mesh.clone(), settling, plan).expect("a valid case")
}

/// A string on a refined mesh.
struct Case {
    model: Model,
    operation: Operation,
    settings: DynamicsSettings,
    mesh: Mesh,
}

impl Case {
    fn begin<R: Registers>(&self, divided: bool) -> Run<R> {
        let Self { model, operation, settings, .. } = self;
        let basis = basis(self, divided);
        Run::begin(model, operation, settings, RockExecutor::default(), basis)
            .expect("a valid case")
    }
}

const JOINTS: usize = 200;

/// The string that is tripped in at 0.2 m/s, without rotation, at 65 deg.
fn tripping() -> Case {
    let model = slant(JOINTS, 65.0, 0.3);
    let operation = Operation {
        trip_speed_m_per_s: 0.2,
        rotary_speed_rad_per_s: 0.0,
        ..operation(OperationKind::TripIn, depth_m(JOINTS))
    };
    let settings =
        DynamicsSettings { settle_s: 1.0, duration_s: 100.0, ..DynamicsSettings::default() };
    let mesh = refined(&model, JOINTS, 3);
    Case { model, operation, settings, mesh }
}

/// Hook load of the last sample, N.
fn hook_load_N(run: &Run<f64>) -> f64 {
    *run.series().hook_load_N.last().expect("a sample")
}

/// Measured depth of a node, m.
fn md_m(run: &Run<f64>, i: usize) -> f64 {
    run.state.anchors[i].md_m + run.chain.displacement(i).dot(run.chain.tangent(i))
}

/// A string that was lowered and stopped is held by friction: no part of it creeps, not even at the
/// border, and its hook load is that with one step for the whole string, within 1e-4 (7e-5 was
/// found). It is stopped in ten seconds: a stop at once sends waves down that depend on the step in
/// the whole pipe, and they decide where friction then holds it, to 2e-3 by the step of a string
/// with but one.
#[test]
fn a_string_that_was_stopped_does_not_creep() {
    let case = tripping();
    let [one_N, two_N] = [false, true].map(|divided| {
        let mut run: Run<f64> = case.begin(divided);
        run.advance(10.0).unwrap();
        let lowered_N = hook_load_N(&run);
        for hundredth in (0..100).rev() {
            run.set_hoist(HoistControl::BlockVelocity(0.002 * f64::from(hundredth)));
            run.advance(0.1).unwrap();
        }
        run.advance(50.0).unwrap();
        let before: Vec<f64> = (0..run.chain.nodes()).map(|i| md_m(&run, i)).collect();
        run.advance(10.0).unwrap();
        for (i, before) in before.into_iter().enumerate() {
            let crept_m = md_m(&run, i) - before;
            // Only the node above the collars is off the wall, and still swings by 1e-11 m.
            assert!(crept_m.abs() < 1e-9, "node {i}: {crept_m:e} m");
        }
        [lowered_N, hook_load_N(&run)]
    });
    for (one, two) in one_N.into_iter().zip(two_N) {
        assert!((two / one - 1.0).abs() < 1e-4, "{one} N {two} N");
    }
}

/// The string that drills, its bit shaken by a rough bottom.
fn shaken() -> Case {
    let model = slant(JOINTS, 30.0, 0.2);
    let operation = Operation {
        rate_of_penetration_m_per_s: 0.003,
        bit_torque_N_m: 2e3,
        ..common::pressing(OperationKind::Drill, depth_m(JOINTS), 60e3)
    };
    let excitation = Excitation { roughness_m: 1e-3, band: Band::PerSecond(5.0), ..common::SMOOTH };
    let law = RateLaw { rock_stiffness_N_per_m: 3e7, excitation: Some(excitation) };
    let mut settings =
        DynamicsSettings { settle_s: 10.0, duration_s: 60.0, ..DynamicsSettings::default() };
    settings.bit.law = BitLaw::Rate(law);
    settings.hoist_line.stiffness_N_per_m = 1e5;
    let mesh = refined(&model, JOINTS, 3);
    Case { model, operation, settings, mesh }
}

/// The excitation of the bit has the same effect as with one step for the whole string: weight on
/// bit, hook load and torque have the same means, within 1e-4, and spread within 0.5 %. The line of
/// the hoist is soft: evaluated at the step's end it damps by its stiffness times half a step,
/// which the longer step of the pipe would change.
#[test]
fn the_bit_shakes_the_string_alike() {
    let case = shaken();
    let [one, two] = [false, true].map(|divided| {
        let mut run: Run<f64> = case.begin(divided);
        run.advance(70.0).unwrap();
        let residual = run.outcome().numerics.energy_residual;
        assert!(residual.abs() < 1e-5, "{residual:e}");
        run.outcome()
    });
    for name in ["weight_on_bit_N", "hook_load_N", "surface_torque_N_m", "bit_torque_N_m"] {
        let [one, two] = [&one, &two].map(|o| *o.statistic(name).expect("a statistic"));
        let (mean, spread) = (two.mean / one.mean - 1.0, two.std / one.std - 1.0);
        assert!(mean.abs() < 1e-4, "{name}: {mean:e}");
        assert!(spread.abs() < 5e-3, "{name}: {spread:e}");
    }
}

/// The start lets the string settle across the hole in the steps that the run takes: its position
/// is the same as with one step for the whole string, within 10 µm (1.2 µm was found, of a
/// clearance of 19 mm; the seed moves every node by one), and either region has the correct twist.
#[test]
fn a_string_in_regions_is_laid_alike() {
    for case in [tripping(), shaken()] {
        let [one, two] = [false, true].map(|divided| case.begin::<f64>(divided));
        let mut worst = 0.0_f64;
        for i in 1..two.chain.nodes() {
            let across = |run: &Run<f64>| {
                let (u, tangent) = (run.chain.displacement(i), run.chain.tangent(i));
                u.minus(tangent, u.dot(tangent))
            };
            let apart = across(&one) - across(&two);
            worst = worst.max(apart.dot(apart).sqrt());
        }
        let border = two.plan.subcycling.expect("regions").border_node;
        let twist_rad = element!(one.chain, border, twist);
        assert_eq!(twist_rad, element!(two.chain, border, twist));
        assert_eq!(twist_rad, two.chain.lower_twist(border));
        assert!(worst < 1e-5, "{worst:e} m");
    }
}

/// Contact and friction are averages over the steps of each node, of which those of the lower
/// region take more: of a string that slides on a straight hole they are those of a string with one
/// step, the friction `μ` of the contact, and over the pipe the weight across the hole.
#[test]
fn contact_is_averaged_over_the_steps_of_each_region() {
    let case = tripping();
    let [one, two] = [false, true].map(|divided| {
        let mut run: Run<f64> = case.begin(divided);
        run.advance(12.0).unwrap();
        run
    });
    let border = two.plan.subcycling.expect("regions").border_node;
    let (mut normal, mut across) = (0.0, 0.0);
    for i in 1..two.chain.nodes() {
        let [expected, found] = [&one, &two].map(|run| run.state.record.normal(i).mean);
        assert!((found - expected).abs() < 1e-3 * expected + 1.0, "{i}: {found} {expected}");
        let axial = two.state.record.axial(i);
        assert!((axial - 0.3 * found).abs() <= 1e-6 * found, "{i}: {axial} {found}");
        if (100..border - 10).contains(&i) {
            normal += found;
            let (weight, tangent) = (two.chain.weight(i), two.chain.tangent(i));
            let side = weight.minus(tangent, weight.dot(tangent));
            across += side.dot(side).sqrt();
        }
    }
    assert!((normal / across - 1.0).abs() < 1e-6, "{normal} {across}");
}

/// A string whose stabilisers divide its assembly into short elements is stepped in regions where
/// the settings leave that to the plan, in a quarter of the steps or fewer, and gives the same
/// results as with one step for the whole string: a hook load within 1e-3 while it is reamed, the
/// friction torque within 1 %, because it whirls freely between its stabilisers. Its bend is below
/// the border; its eccentric masses are above and below it.
#[test]
fn the_plan_divides_a_string_where_that_is_asked_for() {
    let stabiliser = || tool("stabiliser", ComponentLength::Metres(0.3), 0.21, 0.0714);
    let collar = || tool("collar", ComponentLength::Metres(2.5), 0.165, 0.0714);
    let mut components = vec![tool("bit", ComponentLength::Metres(0.3), 0.2159, 0.06)];
    components.extend((0..12).flat_map(|_| [collar(), stabiliser()]));
    components[1].bend =
        Some(BodyBend { angle_rad: 0.02, from_lower_end_m: 1.9, toolface_rad: 1.0 });
    let eccentricity =
        |offset_m| Some(Eccentricity { offset_m, phase_rad: 0.3, cavity: Cavity::Mud });
    components[3].eccentricity = eccentricity(2e-3);
    components.push(ComponentSpec { eccentricity: eccentricity(5e-4), ..drill_pipe() });
    let mut model = slant(JOINTS, 40.0, 0.25);
    model.string = StringSpec { components }.assemble(depth_m(JOINTS)).expect("a sound string");
    let operation =
        Operation { trip_speed_m_per_s: 0.1, ..operation(OperationKind::Ream, depth_m(JOINTS)) };
    let [one, two] = [Regions::One, Regions::Auto].map(|regions| {
        let settings = DynamicsSettings {
            mesh: MeshSettings { regions, ..MeshSettings::uniform(PIPE_M) },
            settle_s: 5.0,
            duration_s: 10.0,
            ..DynamicsSettings::default()
        };
        let mut run = new_run(&model, &operation, &settings);
        if let Some(planned) = run.plan.subcycling {
            assert!(planned.border_node + 2 <= run.state.body.highest(), "{planned:?}");
        }
        run.advance(15.0).unwrap();
        run.outcome()
    });
    assert!(4 * two.numerics.steps < one.numerics.steps + 4);
    for (name, within) in [("hook_load_N", 1e-3), ("friction_torque_N_m", 0.01)] {
        let [one, two] = [&one, &two].map(|o| o.statistic(name).expect("a statistic").mean);
        assert!((two / one - 1.0).abs() < within, "{name}: {one} {two}");
    }
    assert!(two.numerics.energy_residual.abs() < 1e-3, "{:?}", two.numerics);
}

fn assert_same<R: Registers>(one: &Run<R>, other: &Run<R>) {
    let bits = |run: &Run<R>| format!("{:?}{:?}", run.series(), run.frame());
    assert!(bits(one) == bits(other));
}

/// The same bits on every run, and after a checkpoint in the middle of one; a checkpoint of a
/// string in regions is none of a string without.
fn a_run_is_repeated_and_resumed<R: Registers>() {
    let case = shaken();
    let mut straight: Run<R> = case.begin(true);
    let sample_s = straight.sample_interval_s();
    straight.advance(200.0 * sample_s).unwrap();
    let mut again: Run<R> = case.begin(true);
    again.advance(117.0 * sample_s).unwrap();
    let checkpoint = again.checkpoint().into_owned();
    let Case { model, operation, settings, .. } = &case;
    let resume = |divided: bool| {
        let basis = basis(&case, divided);
        Run::<R>::continued(model, operation, settings, basis, checkpoint.clone())
    };
    let mut resumed = resume(true).expect("the same string");
    assert!(matches!(resume(false), Err(ResumeError::Damaged(_))));
    for run in [&mut again, &mut resumed] {
        run.advance(83.0 * sample_s).unwrap();
        assert_same(&straight, run);
    }
}

#[test]
fn a_run_in_double_precision_is_repeated_and_resumed() {
    a_run_is_repeated_and_resumed::<f64>();
}

#[test]
fn a_run_in_single_precision_is_repeated_and_resumed() {
    a_run_is_repeated_and_resumed::<f32>();
}

/// A user-defined coefficient of friction equal to that of the hole changes no bit: each region
/// evaluates it at its own steps.
#[test]
fn the_callers_friction_is_asked_for_in_both_regions() {
    let case = tripping();
    let mut plain: Run<f64> = case.begin(true);
    let mut own = tripping();
    own.settings.friction_coefficient = Some(CustomFriction::new(Own));
    let mut with_law: Run<f64> = own.begin(true);
    for run in [&mut plain, &mut with_law] {
        run.advance(0.5).unwrap();
    }
    assert_same(&plain, &with_law);
}

/// Friction of 0.3, on whatever touches with the force that its weight gives it.
#[derive(Debug)]
struct Own;

impl FrictionCoefficient for Own {
    fn name(&self) -> &str {
        "own"
    }

    fn coefficient(&self, _: &mut [f64], contact: &SlidingContact) -> f64 {
        // Nodes and steps that were taken for others would have forces of nothing that weighs.
        if (0.0..20e3).contains(&contact.normal_force_N) { 0.3 } else { f64::NAN }
    }
}

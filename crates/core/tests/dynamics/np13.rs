//! The NP13-like well at its total depth.

use wholestring::{
    dynamics::{Accuracy, ContactLaw, DynamicOutcome, FrictionLaw, MeshSettings, Regions},
    outcome::Scalars,
};

use crate::{
    common::relative_error,
    wells::{Case, NP13_BUILD_M, each, np13},
};

#[track_caller]
fn assert_agree(what: &str, a: &Scalars, b: &Scalars, tolerance: f64) {
    for (quantity, a, b) in [
        ("hook load", a.hook_load_N, b.hook_load_N),
        ("friction torque", a.friction_torque_N_m, b.friction_torque_N_m),
    ] {
        let apart = relative_error(a, b);
        assert!(apart < tolerance, "{what}: {quantity} {a} for {b}, {apart:.2e} apart");
    }
}

/// Hook load and friction torque do not depend on the mesh: elements of 1.6, 3.2 and 4.8 m agree
/// within 0.1 %, a third of the change that a driller could notice; those that choose their length,
/// from joint to joint but for the assembly, too, and from joint to joint everywhere within 0.2 %.
/// Found: 1e-5 and 4e-4; 2e-5 with the assembly at 3 m, 1.1e-3 without, for a bit, a motor and
/// collars of one element each bend otherwise.
#[test]
fn element_length_does_not_matter() {
    let uniform = [3.2, 1.6, 4.8].map(MeshSettings::uniform);
    let auto = [Accuracy::Coarse, Accuracy::Standard].map(MeshSettings::auto);
    let meshes: Vec<MeshSettings> = uniform.into_iter().chain(auto).collect();
    let found = each(&meshes, |mesh| {
        let mut case = np13(0.3);
        case.settings.mesh = *mesh;
        case.run().scalars
    });
    for (mesh, scalars) in meshes.iter().zip(&found).skip(1) {
        let tolerance = if *mesh == MeshSettings::auto(Accuracy::Coarse) { 2e-3 } else { 1e-3 };
        assert_agree(&format!("{mesh:?}"), scalars, &found[0], tolerance);
    }
    assert_agree("longest against shortest", &found[2], &found[1], 1e-3);
}

/// Nor on whether the assembly, at 3 m, has steps of its own. Found: 5e-7 for the hook load, 3e-7
/// for the torque, the remainder of the start's waves after 10 s; the tolerance is 1e-5, the last
/// digit shown; without any added mass, where one step takes 0.3 % of the string's.
#[test]
fn steps_of_its_own_do_not_matter_to_the_assembly() {
    let found = each(&[Regions::One, Regions::Auto], |regions| {
        let mut case = np13(0.3);
        case.settings.mesh = MeshSettings { regions: *regions, ..MeshSettings::default() };
        case.run()
    });
    let [one, two] = [&found[0], &found[1]];
    assert_agree("two regions", &two.scalars, &one.scalars, 1e-5);
    let [one, two] = [&one.numerics, &two.numerics];
    assert_eq!((one.assembly_steps, two.assembly_steps), (None, Some(4)));
    assert!(two.time_step_s > 1.9e-3 && two.added_axial_mass_fraction < 1e-4, "{two:?}");
    assert!(one.time_step_s < 0.7e-3 && one.added_axial_mass_fraction > 2.9e-3, "{one:?}");
}

/// Nor on the stiffness of the wall: linear contact of 2e7, 2e9 and 2e11 N/m agree within 2e-4. The
/// softest wall gives way by 0.15 mm under a joint of 3 kN, a hundredth of the clearance of 20 mm;
/// only where the string bridges its change of sides does that count. Found: 1e-6 for the hook
/// load, 5e-5 for the torque.
#[test]
fn wall_stiffness_does_not_matter() {
    let stiffnesses = [2e9, 2e7, 2e11];
    let found = each(&stiffnesses, |stiffness_N_per_m| {
        let mut case = np13(0.3);
        case.settings.contact_law =
            ContactLaw::Linear { stiffness_N_per_m: *stiffness_N_per_m, damping_ratio: 0.05 };
        case.run().scalars
    });
    for (stiffness, scalars) in stiffnesses.iter().zip(&found).skip(1) {
        assert_agree(&format!("a wall of {stiffness:e} N/m"), scalars, &found[0], 2e-4);
    }
}

/// A quiet string carries the loads of the soft string: its hook load within 0.1 %; its friction
/// torque, lowered by the climb of a turning pipe, within 0.6 % of `1/√(1 + μ²)` of the soft
/// string's.
///
/// Found: the hook load 0.02 to 0.04 % higher, the torque 0.41 to 0.42 % lower, whatever the
/// friction factor. Of the torque, 0.35 % are missing within 30 m of the end of the build and 0.08
/// % at the kick-off, where the string's stiffness bridges a change of load that is sudden for a
/// soft string; 0.17 % at the bottom-hole assembly, where the bit, held by its hole without
/// friction, carries the motor up to the stabiliser; 0.16 % are gained in the build, where bending
/// adds to the load. Along the tangent the two agree to 0.02 %. The hook load gains from the
/// stretch, which leaves 0.9 m more of the string above the build, in steeper hole (150 N), and
/// from the axial part of the missing friction (60 N).
#[test]
fn quiet_rotation_agrees_with_the_soft_string() {
    let frictions = [0.1, 0.2, 0.3, 0.4];
    let found = each(&frictions, |mu| np13(*mu).run().scalars);
    for (mu, scalars) in frictions.iter().zip(found) {
        let soft = np13(*mu).soft().scalars;
        let hook = relative_error(scalars.hook_load_N, soft.hook_load_N);
        let climbed = soft.friction_torque_N_m / (1.0 + mu * mu).sqrt();
        let torque = relative_error(scalars.friction_torque_N_m, climbed);
        assert!(hook < 1e-3, "friction {mu}: hook load {} N, {hook:.2e} off", scalars.hook_load_N);
        assert!(
            torque < 6e-3,
            "friction {mu}: friction torque {} N·m for {climbed}, {torque:.2e} off",
            scalars.friction_torque_N_m
        );
    }
}

/// Above the kick-off the string hangs free but for the last 30 m; in the build it is on the high
/// side above the cut-off and on the low side below it.
#[test]
fn it_touches_where_it_must() {
    let case = np13(0.3);
    let outcome = case.run();
    let nodes = &outcome.nodes;
    let [kick_off, build_end] = NP13_BUILD_M;
    let cutoff = outcome.scalars.cutoff_depth_m.expect("a cut-off");
    let soft = case.soft().scalars.cutoff_depth_m.expect("a cut-off");
    // One spacing of tool joints: the string touches nowhere between.
    assert!((cutoff - soft).abs() < 10.0, "cut-off at {cutoff} m, soft string {soft} m");
    for (i, md) in nodes.md_m.iter().enumerate() {
        if *md < kick_off - 30.0 {
            assert_eq!(nodes.contact_fraction[i], 0.0, "contact at {md} m, above the kick-off");
        }
        // The side flips where the load across the pipe vanishes: half a joint's spacing to either
        // side belongs to both.
        let force = nodes.side_force_N_per_m[i];
        if (kick_off..cutoff - 10.0).contains(md) {
            assert!(force >= 0.0, "low side at {md} m, above the cut-off: {force} N/m");
        }
        if (cutoff + 10.0..build_end + 100.0).contains(md) {
            assert!(force <= 0.0, "high side at {md} m, below the cut-off: {force} N/m");
        }
    }
    let touched = |from: f64, to: f64| {
        nodes
            .md_m
            .iter()
            .zip(&nodes.side_force_N_per_m)
            .any(|(md, f)| (from..to).contains(md) && f.abs() > 100.0)
    };
    assert!(touched(kick_off, cutoff) && touched(build_end, build_end + 100.0));
}

/// While it turns, vector friction leaves the axial drag next to nothing whatever the friction
/// factor: from 0.1 to 0.3 the hook load falls by less than 0.5 % (the share of the speed of
/// drilling in that of the surface is 1/230, and so is that of the drag: 1 kN). The article's
/// independent law drags in full: the hook load falls by more than 30 % (188 kN of 538 kN found),
/// as that of a sliding string does.
#[test]
fn hook_load_spreads_with_friction_only_in_the_independent_law() {
    let laws = [FrictionLaw::Vector, FrictionLaw::Independent];
    let cases: Vec<(FrictionLaw, f64)> =
        laws.iter().flat_map(|law| [0.1, 0.3].map(|mu| (*law, mu))).collect();
    let found: Vec<DynamicOutcome> = each(&cases, |(law, mu)| {
        let mut case: Case = np13(*mu);
        case.settings.friction_law = *law;
        case.run()
    });
    let hook = |i: usize| found[i].scalars.hook_load_N;
    let spread = |a: usize, b: usize| (hook(b) - hook(a)) / hook(a);
    assert!(spread(0, 1).abs() < 5e-3, "vector law: {} to {} N", hook(0), hook(1));
    assert!(spread(2, 3) < -0.3, "independent law: {} to {} N", hook(2), hook(3));
}

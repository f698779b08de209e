//! What stops a string: rig, connections, strength, a dogleg, lock-up.

use wholestring_verification::{file, verify};

use super::*;

/// A string that is nearly locked up transmits little of its push, a straight one in a straight
/// hole all of it, and one in a build the fraction of the capstan equation.
#[test]
fn what_arrives_of_a_push() {
    let file = file("S5_reach.json");
    let mu = 0.3_f64;
    let setup = setup(&file["inputs"], &[[0.0, 90.0], [100.0, 90.0]], mu);
    let arrives = |length_m: f64, wob_N: f64| {
        let slide = Operation::slide(length_m).weight_on_bit_N(wob_N);
        let all = margins(&setup, &slide, &of_soft(HELIX)).expect("margins");
        let margin =
            all.iter().find(|margin| margin.limit == DepthLimit::PushAbsorbed).expect("a margin");
        let forces = solve(&setup.at(length_m).unwrap(), &slide, &HELIX).unwrap().scalars;
        (margin.margin, -forces.hook_load_N)
    };
    assert!((arrives(1000.0, 1e4).0 - 1.0).abs() < 1e-9);
    // Beyond the helix `dF/dx = μ (w + b F²)`: pushes at both ends grow in the ratio of their
    // rates.
    let place = wholestring::statics::buckling::Place::of(&setup.at(3e3).unwrap(), 3e3, 1e3);
    let rate = |push_N: f64| place.weight_N_per_m + place.helix_load_N_per_m(push_N);
    let (wob_N, length_m) = (300e3, 500.0);
    let (share, top_N) = arrives(length_m, wob_N);
    let expected = rate(wob_N) / rate(top_N);
    // A difference over 1e-3 of the weight, 1.1e2 N: half of it times the second derivative.
    assert!((share / expected - 1.0).abs() < 1e-3, "{share} {expected}");
}

#[test]
fn depths_must_grow() {
    let file = file("S5_reach.json");
    let setup = setup(&file["inputs"], &[[0.0, 0.0], [100.0, 0.0]], 0.3);
    let settings = ReachSettings { to_m: 900.0, ..ReachSettings::from_depth(1000.0) };
    let refused = reach(&setup, &Operation::trip_in(0.0), &settings).unwrap_err();
    assert_eq!(refused, ReachError::Depths { from_m: 1000.0, to_m: 900.0 });
    assert_eq!(
        refused.to_string(),
        "the reach is requested from 1000 m to 900 m, which is not deeper"
    );
}

/// A reach that is stopped ends at the next depth, without a result.
#[test]
fn a_reach_that_is_stopped_ends_at_the_next_depth() {
    let file = file("S5_reach.json");
    let setup = setup(&file["inputs"], &[[0.0, 0.0], [1000.0, 0.0]], 0.3);
    let settings = ReachSettings { to_m: 5000.0, ..ReachSettings::from_depth(1000.0) };
    let calls = std::cell::Cell::new(0);
    let after_three = || {
        calls.set(calls.get() + 1);
        calls.get() > 3
    };
    let stopped = reach_unless(&setup, &Operation::trip_in(0.0), &settings, &after_three);
    assert_eq!(stopped, Err(ReachError::Stopped));
    assert_eq!(calls.get(), 4);
}

/// A string that hangs in a vertical well stops where its weight and the block equal the capacity
/// of the hoist, and where its weight yields its uppermost section.
#[test]
fn a_hanging_string_stops_at_hoist_and_yield() {
    let file = file("S5_reach.json");
    let inputs = &file["inputs"];
    let mut setup = setup(inputs, &[[0.0, 0.0], [1000.0, 0.0]], 0.3);
    let (block_N, capacity_N, yields_Pa) = (200e3, 1500e3, 500e6);
    setup.rig.hoist_capacity_N = Some(capacity_N);
    setup.string.components[0].yield_strength_Pa = Some(yields_Pa);
    let (weight_N_per_m, area_m2) = (number(&inputs["pipe"]["w"]), number(&inputs["pipe"]["A"]));
    let settings =
        ReachSettings { to_m: 12e3, depths: 12, factors: ONE, ..ReachSettings::from_depth(1000.0) };
    let pick_up = reach(&setup, &Operation::trip_out(0.0), &settings).expect("a reach");
    let depth_m = |limit| {
        let curve = pick_up.curves.iter().find(|curve| curve.limit == limit).expect("a limit");
        (curve.end.depth_m().expect("a depth"), curve.there)
    };
    let rounding = "the weight from mass and area";
    let (hoist_m, there) = depth_m(DepthLimit::Hoist);
    verify("reach", "depth at which the hoist carries no more, m")
        .relative(1e-6, rounding)
        .report((capacity_N - block_N) / weight_N_per_m, hoist_m);
    assert!((there.load / capacity_N - 1.0).abs() < 1e-5 && there.at_md_m.is_none());
    let (yields_m, there) = depth_m(DepthLimit::Yield);
    verify("reach", "depth at which the pipe's own weight yields it, m")
        .relative(1e-6, rounding)
        .report(yields_Pa * area_m2 / weight_N_per_m, yields_m);
    assert_eq!(there.at_md_m, Some(0.0));
    let first = [pick_up];
    let (_, first) = first_stop(&first).expect("a stop");
    assert_eq!(first.limit, DepthLimit::Hoist);
}

/// The torque at the surface meets the make-up torque of the topmost connection at the depth at
/// which it meets an equal rating of the top drive, and the torsional yield with a required factor
/// of two where it meets half of the yield.
#[test]
fn a_string_that_turns_stops_at_its_connections() {
    let file = file("S5_reach.json");
    let inputs = &file["inputs"];
    let mut setup = setup(inputs, &[[0.0, 0.0], [1000.0, 0.0], [1500.0, 75.0]], 0.3);
    let turn = Operation::rotate_off_bottom(0.0).rotary_speed_rad_per_s(10.0);
    let capacity_N_m = 15e3;
    setup.rig.top_drive_torque_N_m = Some(capacity_N_m);
    let connection = &mut setup.string.components[0].connection;
    connection.make_up_torque_N_m = Some(capacity_N_m);
    connection.torsional_yield_N_m = Some(2.0 * capacity_N_m);
    let factors = DesignFactors { torsion: 2.0, ..ONE };
    let settings =
        ReachSettings { to_m: 12e3, depths: 12, factors, ..ReachSettings::from_depth(1600.0) };
    let found = reach(&setup, &turn, &settings).expect("a reach");
    let depth_m = |limit| {
        let curve = found.curves.iter().find(|curve| curve.limit == limit).expect("a limit");
        (curve.end.depth_m().expect("a depth"), curve.there)
    };
    let (expected_m, _) = depth_m(DepthLimit::TopDrive);
    for limit in [DepthLimit::MakeUp, DepthLimit::Torsion] {
        let (found_m, there) = depth_m(limit);
        assert!((found_m - expected_m).abs() < 1e-6 * expected_m, "{limit:?} {found_m}");
        assert!((there.load - capacity_N_m).abs() < 1e-5 * capacity_N_m, "{there:?}");
        assert_eq!(there.at_md_m, Some(0.0));
    }
}

/// Hoist and make-up torque that are exceeded by exactly the same part at the first depth already:
/// the headline names the limit that the verdict of the operation names.
#[test]
fn an_equal_tie_has_one_limit() {
    let file = file("S5_reach.json");
    let inputs = &file["inputs"];
    let mut setup = setup(inputs, &[[0.0, 0.0], [1000.0, 0.0], [1500.0, 75.0]], 0.3);
    let turn = Operation::rotate_off_bottom(0.0).rotary_speed_rad_per_s(10.0);
    let pick_up = Operation::trip_out(0.0);
    let settings =
        ReachSettings { to_m: 4e3, depths: 4, factors: ONE, ..ReachSettings::from_depth(1600.0) };
    let with = |setup: &mut Setup, hoist_N: f64, make_up_N_m: f64| {
        setup.rig.hoist_capacity_N = Some(hoist_N);
        setup.string.components[0].connection.make_up_torque_N_m = Some(make_up_N_m);
        [&pick_up, &turn].map(|operation| reach(setup, operation, &settings).expect("a reach"))
    };
    let [_, turned] = with(&mut setup, 1e9, 1e9);
    let load = |limit| {
        let curve = turned.curves.iter().find(|curve| curve.limit == limit).expect("it concerns");
        curve.margins[0].load
    };
    // Half of a number is exact, so that both margins are -1.
    let (hoist_N, make_up_N_m) = (0.5 * load(DepthLimit::Hoist), 0.5 * load(DepthLimit::MakeUp));
    let [_, tied] = with(&mut setup, hoist_N, make_up_N_m);
    let equal = tied.curves.iter().filter(|curve| {
        curve.stops && curve.end == End::Already(1600.0) && curve.there.margin == -1.0
    });
    let equal: Vec<DepthLimit> = equal.map(|curve| curve.limit).collect();
    assert_eq!(equal.len(), 2, "{:?}", tied.curves);
    let (_, verdict) = tied.stop().expect("a stop");
    assert!(equal.contains(&verdict.limit));
    let alone = [tied.clone()];
    let (_, headline) = first_stop(&alone).expect("a stop");
    assert_eq!(headline.limit, verdict.limit);
    // Of two operations of the same limits, too, the headline is the verdict of the one it names.
    let reaches = [tied.clone(), tied];
    let (reach, headline) = first_stop(&reaches).expect("a stop");
    let (_, verdict) = reach.stop().expect("a stop");
    assert_eq!(headline.limit, verdict.limit);
}

/// A well with a dogleg of 24 deg/30 m in its build, and pipe with 300 m of heavy-weight pipe in it.
fn dogleg() -> Setup {
    let stations = [
        [0.0, 0.0],
        [600.0, 0.0],
        [1200.0, 30.0],
        [2500.0, 30.0],
        [2515.0, 42.0],
        [2900.0, 85.0],
        [3100.0, 85.0],
    ];
    let stations: Vec<Station> =
        stations.iter().map(|[md_m, inc]| Station::from_degrees(*md_m, *inc, 0.0)).collect();
    let path = Path::minimum_curvature(&stations).expect("a path");
    let hole = Hole::new(vec![
        HoleSection::casing(0.0..2500.0, 0.2205, 0.22),
        HoleSection::open(2500.0..100e3, 0.2159, 0.3),
    ]);
    let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.25))
        .catalogue("5 in 19.50 lb/ft G-105", Metres(620.0))
        .and_then(|string| string.catalogue("HWDP 5 in 49.3 lb/ft", Metres(300.0)))
        .and_then(|string| string.catalogue("5 in 19.50 lb/ft S-135", ToSurface));
    Setup {
        well: Well::new(path, hole.expect("a hole")),
        string: string.expect("a string"),
        mud: Mud::of_density(1200.0),
        fluids: Default::default(),
        rig: Rig::default(),
        ends: Default::default(),
        buckling: Default::default(),
    }
}

/// A stiff component that passes a dogleg between two depths of the grid stops the string there:
/// a scan in steps of 5 m finds no stress above the limit before the reach does.
#[test]
fn a_stiff_component_in_a_dogleg_is_not_stepped_over() {
    let setup = dogleg();
    let mut passed = 0;
    for from_m in [3110.0, 3200.0, 3270.0, 3330.0, 3400.0] {
        let settings = ReachSettings { factors: ONE, ..ReachSettings::from_depth(from_m) };
        let step_m = settings.grid_m()[1] - from_m;
        let at = |bit_depth_m: f64, von_mises: f64| {
            let factors = DesignFactors { von_mises, ..ONE };
            let settings = ReachSettings { factors, ..settings };
            let all = margins(&setup, &Operation::trip_out(bit_depth_m), &settings);
            let all = all.expect("margins");
            all.iter().find(|margin| margin.limit == DepthLimit::Yield).expect("a yield").margin
        };
        // A factor between the largest stresses at two depths of the grid and those between them.
        let scan_m: Vec<f64> = (1..)
            .map(|step| from_m + 5.0 * f64::from(step))
            .take_while(|m| *m < from_m + step_m)
            .collect();
        let ends = at(from_m, 1.0).min(at(from_m + step_m, 1.0));
        let least = scan_m.iter().map(|depth_m| at(*depth_m, 1.0)).fold(1.0, f64::min);
        if least > ends - 0.005 {
            continue;
        }
        passed += 1;
        let von_mises = 1.0 / (1.0 - 0.5 * (ends + least));
        let factors = DesignFactors { von_mises, ..ONE };
        let found =
            reach(&setup, &Operation::trip_out(0.0), &ReachSettings { factors, ..settings });
        let found = found.expect("a reach");
        let (stop_m, curve) = found.stop().expect("a stop");
        assert_eq!(curve.limit, DepthLimit::Yield);
        assert!(stop_m < from_m + step_m, "{from_m}: {stop_m}");
        let first_m = scan_m.iter().find(|depth_m| at(**depth_m, von_mises) <= 0.0);
        assert!(Some(&stop_m) <= first_m, "{from_m}: {stop_m} {first_m:?}");
    }
    assert!(passed >= 2, "{passed}");
}

/// A string that is locked up at its first depth is stopped because any push is absorbed; of the
/// other limits nothing is known.
#[test]
fn a_string_that_is_locked_up_has_no_other_limits() {
    let file = file("S5_reach.json");
    let mut level = setup(&file["inputs"], &[[0.0, 90.0], [100.0, 90.0]], 0.3);
    level.string.components[0].yield_strength_Pa = Some(900e6);
    let settings = ReachSettings { to_m: 30e3, depths: 3, ..ReachSettings::from_depth(20e3) };
    let slide = Operation::slide(0.0).weight_on_bit_N(50e3);
    let found = reach(&level, &slide, &settings).expect("a reach");
    assert!(found.curves.len() > 4);
    for curve in &found.curves {
        match curve.limit {
            DepthLimit::PushAbsorbed => assert_eq!(curve.end, End::Already(20e3)),
            _ => assert_eq!(curve.end, End::LockedUp(20e3), "{:?}", curve.limit),
        }
    }
    let (_, stop) = found.stop().expect("a stop");
    assert_eq!(stop.limit, DepthLimit::PushAbsorbed);
}

/// Every operation loads the hoist, the pump delivers, and a string at rest is started: a reach
/// stops where run and plan find a limit exceeded, and names what was not checked.
#[test]
fn limits_of_the_rig_stop_every_operation() {
    let mut setup = dogleg();
    for section in [0.25, 0.4] {
        let friction = Friction { at_rest: 1.5 * section, ..Friction::uniform(section) };
        setup = setup.with_friction_of(|_| friction).expect("a setup");
    }
    setup.mud.rheology = Some(Rheology::Newtonian { viscosity_Pa_s: 0.03 });
    setup.rig = Rig {
        hoist_capacity_N: Some(600e3),
        pump_pressure_limit_Pa: Some(5e6),
        top_drive_peak_torque_N_m: Some(8e3),
        ..Rig::default()
    };
    let settings = ReachSettings { depths: 9, ..ReachSettings::from_depth(3110.0) };
    let drill = Operation::drill(0.0)
        .weight_on_bit_N(50e3)
        .bit_torque_N_m(1e3)
        .rotary_speed_rad_per_s(10.0)
        .rate_of_penetration_m_per_s(3e-3)
        .flow_rate_m3_per_s(0.035);
    let turn = Operation::rotate_off_bottom(0.0).rotary_speed_rad_per_s(10.0);
    for (operation, limits) in [
        (
            drill,
            &[
                DepthLimit::Hoist,
                DepthLimit::PumpPressure,
                DepthLimit::TopDrive,
                DepthLimit::Strength,
            ][..],
        ),
        (turn, &[DepthLimit::Hoist, DepthLimit::Breakaway][..]),
    ] {
        let found = reach(&setup, &operation, &settings).expect("a reach");
        for limit in limits {
            let curve = found.curves.iter().find(|curve| curve.limit == *limit);
            let depth_m = curve.expect("it concerns").end.depth_m();
            assert!(depth_m.is_some() || *limit == DepthLimit::Strength, "{limit:?}");
        }
        let lacks = found.unchecked.iter().map(|unchecked| unchecked.kind);
        assert!(lacks.into_iter().any(|kind| kind == CheckKind::TopDrive));
    }
}

/// A string that locks up on the way down reaches no other limit there: its margins are finite to
/// that depth, and nothing is known of them below.
#[test]
fn lock_up_on_the_way_down_is_no_other_limit() {
    let file = file("S5_reach.json");
    let mut level = setup(&file["inputs"], &[[0.0, 90.0], [100.0, 90.0]], 0.3);
    level.string.components[0].yield_strength_Pa = Some(900e6);
    level.rig.hoist_capacity_N = Some(1.5e6);
    let settings = ReachSettings { to_m: 30e3, depths: 12, ..ReachSettings::from_depth(1000.0) };
    let slide = Operation::slide(0.0).weight_on_bit_N(50e3);
    let found = reach(&level, &slide, &settings).expect("a reach");
    let end = |limit| found.curves.iter().find(|curve| curve.limit == limit).expect("a limit");
    let End::At(lock_m) = end(DepthLimit::PushAbsorbed).end else { panic!("locks up") };
    assert!((1e3..20e3).contains(&lock_m), "{lock_m}");
    let hoist = end(DepthLimit::Hoist);
    let End::LockedUp(hoist_m) = hoist.end else { panic!("{:?}", hoist.end) };
    assert!((hoist_m - lock_m).abs() <= 2.0 * settings.tolerance_m, "{hoist_m} {lock_m}");
    // The block pushes: it hangs on the hoist less and less.
    assert_eq!(hoist.there.margin, 1.0);
    assert!(found.curves.iter().all(|curve| curve.there.margin.is_finite()));
}

/// A pipe that tension leaves no capacity has the least margin: the string is not locked up, and
/// the limit stops it before.
#[test]
fn a_pipe_without_capacity_is_not_locked_up() {
    let file = file("S5_reach.json");
    let mut inclined = setup(&file["inputs"], &[[0.0, 45.0], [1000.0, 45.0]], 0.3);
    inclined.string.components[0].yield_strength_Pa = Some(400e6);
    let settings = ReachSettings { to_m: 30e3, depths: 12, ..ReachSettings::from_depth(1000.0) };
    let found =
        reach(&inclined, &Operation::rotate_off_bottom(0.0).rotary_speed_rad_per_s(6.0), &settings);
    let found = found.expect("a reach");
    let strength = found.curves.iter().find(|curve| curve.limit == DepthLimit::Strength);
    let strength = strength.expect("a limit of the strength");
    assert!(matches!(strength.end, End::At(_)), "{:?}", strength.end);
    let least = strength.margins.last().expect("a margin").margin;
    assert_eq!(least, LEAST_MARGIN);
}

/// A string that lies level hangs with nothing: its margin is no quotient of rounding.
#[test]
fn a_level_string_has_margins_of_sense() {
    let file = file("S5_reach.json");
    let level = setup(&file["inputs"], &[[0.0, 90.0], [1000.0, 90.0]], 0.3);
    let settings = ReachSettings { to_m: 3e3, depths: 6, ..ReachSettings::from_depth(500.0) };
    let found = reach(&level, &Operation::trip_in(0.0), &settings).expect("a reach");
    let margins = found.curves.iter().flat_map(|curve| &curve.margins);
    for margin in margins.filter(|margin| margin.margin.is_finite()) {
        assert!((LEAST_MARGIN..=1.0).contains(&margin.margin), "{margin:?}");
    }
    let hangs = found.curves.iter().find(|curve| curve.limit == DepthLimit::HookLoadZero);
    let hangs = hangs.expect("a limit of the hook load");
    assert!(
        hangs.margins.iter().all(|margin| margin.margin == -1.0 || margin.margin.is_infinite())
    );
}

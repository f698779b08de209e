//! Broomsticks against the soft string called directly, an independent integration, closed forms,
//! and effects of friction that hold in any well.

use std::{f64::consts::FRAC_PI_3, fs, path::Path as FilePath};

use wholestring::{
    ends::Ends,
    prelude::*,
    statics::{soft::soft_string, stiff},
    string::{ComponentLength, Material},
};
use wholestring_judge::Check;
use wholestring_plan::{
    Broomstick, BroomstickPoint, FrictionLevel, Frictions, KindFriction, LevelFriction,
    PointAnswer, Setup, Statics, bit_depths_m,
};
use wholestring_verification::verify;

const G: f64 = 9.80665;
const STEEL: f64 = 7850.0;
const MUD: f64 = 1200.0;
const OD_M: f64 = 0.1397;
const ID_M: f64 = 0.1186;

fn pipe() -> ComponentSpec {
    let material = Material { density_kg_per_m3: STEEL, ..Material::STEEL };
    ComponentSpec::uniform("drill pipe", OD_M, ID_M, ComponentLength::ToSurface, material)
}

fn setup(stations: &[[f64; 3]], string: StringSpec, hole_m: f64) -> Setup {
    let stations: Vec<Station> =
        stations.iter().map(|[md, inc, azi]| Station::from_degrees(*md, *inc, *azi)).collect();
    let depth_m = stations.last().expect("stations").md_m;
    let sections = vec![
        HoleSection::casing(0.0..0.3 * depth_m, hole_m, 0.2),
        HoleSection::open(0.3 * depth_m..depth_m, hole_m, 0.2),
    ];
    Setup {
        well: Well {
            path: Path::minimum_curvature(&stations).expect("a path"),
            hole: Hole::new(sections).expect("a hole"),
        },
        string,
        mud: Mud::of_density(MUD),
        fluids: Default::default(),
        rig: Rig::default(),
        ends: Ends::default(),
        buckling: Default::default(),
    }
}

/// The well of A06: vertical, a build to 65°, a tangent.
fn common() -> Setup {
    let stations =
        [[0.0, 0.0, 45.0], [322.9, 0.0, 45.0], [1075.0, 65.0, 45.0], [4305.0, 65.0, 45.0]];
    setup(&stations, StringSpec::from_bit(pipe()), 0.2159)
}

fn levels(coefficients: [f64; 3]) -> Frictions {
    let [low, expected, high] = coefficients.map(LevelFriction::uniform);
    Frictions { low, expected, high }
}

fn operations() -> Vec<Operation> {
    vec![
        Operation::trip_out(1.0),
        Operation::trip_in(1.0),
        Operation::rotate_off_bottom(1.0).rotary_speed_rad_per_s(7.0),
        Operation::drill(1.0)
            .rotary_speed_rad_per_s(7.0)
            .weight_on_bit_N(60e3)
            .bit_torque_N_m(5e3)
            .rate_of_penetration_m_per_s(1e-9),
        Operation::slide(1.0).weight_on_bit_N(60e3).rate_of_penetration_m_per_s(1e-3),
    ]
}

fn broomstick(setup: &Setup, frictions: Frictions, depths_m: Vec<f64>, by: Statics) -> Broomstick {
    Broomstick::new(setup, &frictions, operations(), depths_m, vec![by]).expect("sound frictions")
}

fn solved(broomstick: &Broomstick) -> Vec<BroomstickPoint> {
    broomstick.tasks().iter().flat_map(|task| broomstick.solve(task)).collect()
}

fn hook_load_N(point: &BroomstickPoint) -> f64 {
    point.outcome.as_ref().expect("an answer").scalars.hook_load_N
}

/// At the well's depth a broomstick ends where an integration of its own to 1e-11 does, at three of
/// its frictions.
#[test]
fn a_broomstick_ends_where_an_independent_integration_does() {
    let file = FilePath::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../verification/A06_common_case_soft_string.json");
    let data: serde_json::Value =
        serde_json::from_slice(&fs::read(file).expect("the file")).expect("JSON");
    let broomstick = broomstick(&common(), levels([0.1, 0.2, 0.3]), vec![4305.0], Statics::Soft);
    let keys = ["pu_offbottom", "so_offbottom", "rot_offbottom", "rotary_drilling_WOB60_TOB5_hook"];
    for point in solved(&broomstick) {
        let Some(place) = operations().iter().position(|own| own.kind == point.operation) else {
            continue;
        };
        let Some(key) = keys.get(place) else { continue };
        let row = match point.friction {
            FrictionLevel::Low => "A_mu0.1",
            FrictionLevel::Expected => "A_mu0.2",
            FrictionLevel::High => "A_mu0.3",
        };
        let expected = 1e3 * data["results"][row][key].as_f64().expect(key);
        let level = point.friction.name();
        verify("A06", format!("broomstick at {level} friction: {}", key.replace('_', " ")))
            .relative(
                1e-6 + 0.05 / expected,
                "the default step, and half of the last printed digit",
            )
            .report(expected, hook_load_N(&point));
    }
}

/// Every point is the soft string's own result at that depth, to the last digit; and with rotation
/// the hook load is its weight over the true vertical depth, whatever the friction: to 1e-6, the
/// error of the default step of 1 m.
#[test]
fn points_are_the_soft_string_s_own() {
    let setup = common();
    let depths_m = bit_depths_m(&setup, Some(300.0), 4305.0, 6);
    // Even depths, and the shoe.
    assert_eq!(depths_m.len(), 7);
    assert!(depths_m.contains(&(0.3 * 4305.0)) && depths_m.contains(&300.0));
    let broomstick = broomstick(&setup, levels([0.15, 0.25, 0.4]), depths_m.clone(), Statics::Soft);
    let weight_N_per_m =
        G * (STEEL - MUD) * std::f64::consts::FRAC_PI_4 * (OD_M * OD_M - ID_M * ID_M);
    let points = solved(&broomstick);
    assert_eq!(points.len(), depths_m.len() * operations().len() * 3);
    for point in &points {
        let own = operations().into_iter().find(|own| own.kind == point.operation);
        let operation = Operation { bit_depth_m: point.bit_depth_m, ..own.expect("it") };
        let model = broomstick.setup(point.friction).at(point.bit_depth_m).expect("a model");
        let alone = soft_string(&model, &operation).expect("an answer");
        assert_eq!(point.outcome.as_ref().expect("an answer").scalars, alone.scalars);
        if point.operation == OperationKind::RotateOffBottom {
            let hangs_N = weight_N_per_m * setup.well.path.at(point.bit_depth_m).position_m.z;
            assert!((hook_load_N(point) / hangs_N - 1.0).abs() < 1e-6, "{hangs_N}");
        }
    }
}

/// The loads equal those of the whole point, of either model, to the last digit; a depth that is
/// impossible for the string has none.
#[test]
fn expected_loads_are_those_of_the_point() {
    for by in Statics::ALL {
        let broomstick = broomstick(&common(), levels([0.1, 0.2, 0.3]), vec![900.0], by);
        let found = broomstick.expected_loads(by, 900.0, &operations());
        assert_eq!(found.len(), broomstick.tasks().len());
        for (task, found) in broomstick.tasks().iter().zip(found) {
            let whole = &broomstick.solve(task)[FrictionLevel::Expected as usize];
            let answer = whole.outcome.as_ref().expect("an answer");
            let found = found.expect("an answer");
            let PointAnswer { scalars, .. } = answer;
            assert_eq!(found.hook_load_N, scalars.hook_load_N, "{by:?}");
            assert_eq!(found.surface_torque_N_m, scalars.surface_torque_N_m, "{by:?}");
            let limits: Vec<&Check> = found.limits.limits().collect();
            let of_point: Vec<&Check> = whole.checks.limits().collect();
            assert_eq!(limits, of_point, "{by:?}");
        }
        let none = broomstick.expected_loads(by, -1.0, &operations());
        assert!(none.len() == operations().len() && none.iter().all(Result::is_err));
    }
    let broomstick = broomstick(&common(), levels([0.1, 0.2, 0.3]), vec![900.0], Statics::Soft);
    let expected = broomstick.expected_weights_to_buckle(900.0);
    let all = broomstick.weights_to_buckle(900.0);
    let of_level = all.into_iter().filter(|weight| weight.friction == FrictionLevel::Expected);
    assert_eq!(expected, of_level.collect::<Vec<_>>());
}

/// In a straight hole at 60° from the vertical the string is pulled by `w L (cos θ + μ sin θ)`,
/// lowered by `w L (cos θ − μ sin θ)` and turned by `μ w sin θ r L`, at every depth: to rounding,
/// because nothing varies along it.
#[test]
fn a_slanted_hole_has_straight_broomsticks() {
    let setup =
        setup(&[[0.0, 60.0, 0.0], [2000.0, 60.0, 0.0]], StringSpec::from_bit(pipe()), 0.2159);
    let broomstick =
        broomstick(&setup, levels([0.1, 0.2, 0.35]), vec![250.0, 900.0, 2000.0], Statics::Soft);
    let weight_N_per_m =
        G * (STEEL - MUD) * std::f64::consts::FRAC_PI_4 * (OD_M * OD_M - ID_M * ID_M);
    for point in solved(&broomstick) {
        let friction = [0.1, 0.2, 0.35][point.friction as usize];
        let weight_N = weight_N_per_m * point.bit_depth_m;
        let drag = friction * FRAC_PI_3.sin();
        let scalars = point.outcome.as_ref().expect("an answer").scalars;
        let (hangs, turns_N_m) = match point.operation {
            OperationKind::TripOut => (FRAC_PI_3.cos() + drag, 0.0),
            OperationKind::TripIn => (FRAC_PI_3.cos() - drag, 0.0),
            OperationKind::RotateOffBottom => (FRAC_PI_3.cos(), drag * weight_N * 0.5 * OD_M),
            _ => continue,
        };
        assert!((scalars.hook_load_N / (weight_N * hangs) - 1.0).abs() < 1e-9);
        assert!((scalars.surface_torque_N_m - turns_N_m).abs() <= 1e-9 * turns_N_m);
    }
}

/// More friction: more to pull, less to lower, more to turn. Without any, all levels and all
/// operations off bottom coincide.
#[test]
fn friction_parts_what_it_must() {
    let depths_m = vec![500.0, 1500.0, 4305.0];
    let solver = broomstick(&common(), Frictions::default(), depths_m.clone(), Statics::Soft);
    for three in solved(&solver).chunks(3) {
        let [low, expected, high] =
            [0, 1, 2].map(|level| three[level].outcome.as_ref().expect("an answer").scalars);
        match three[0].operation {
            OperationKind::TripOut => {
                assert!(low.hook_load_N < expected.hook_load_N);
                assert!(expected.hook_load_N < high.hook_load_N);
            }
            OperationKind::TripIn | OperationKind::Slide => {
                assert!(low.hook_load_N > expected.hook_load_N);
                assert!(expected.hook_load_N > high.hook_load_N);
            }
            _ => {
                assert!(low.surface_torque_N_m < expected.surface_torque_N_m);
                assert!(expected.surface_torque_N_m < high.surface_torque_N_m);
            }
        }
    }
    let smooth = broomstick(&common(), levels([0.0; 3]), depths_m, Statics::Soft);
    for three in solved(&smooth).chunks(3) {
        assert_eq!(hook_load_N(&three[0]), hook_load_N(&three[2]));
        let scalars = three[0].outcome.as_ref().expect("an answer").scalars;
        if !three[0].operation.on_bottom() {
            let hangs_N = hook_load_N(&solved(&smooth)[0]);
            assert!(scalars.hook_load_N > 0.0 && hangs_N > 0.0);
            assert_eq!(scalars.surface_torque_N_m, 0.0);
        }
    }
}

/// Low and high friction: the section's own, less and more, never below the lower limit.
#[test]
fn frictions_that_are_not_given_are_the_section_s_own() {
    let own = |kinetic: f64| Friction { kinetic, at_rest: 1.5 * kinetic, around: 0.5 };
    let shifted = |shift: f64, kinetic: f64| KindFriction::Shifted(shift).of(&own(kinetic));
    assert_eq!(shifted(0.0, 0.3), own(0.3));
    assert!((shifted(0.1, 0.3).kinetic - 0.4).abs() < 1e-12);
    assert!((shifted(0.1, 0.3).at_rest - 0.6).abs() < 1e-12);
    assert_eq!(shifted(0.1, 0.3).around, 0.5);
    assert_eq!(shifted(-0.1, 0.12).kinetic, KindFriction::LEAST);
    // A smooth hole does not become rough by a negative shift.
    assert_eq!(shifted(-0.1, 0.02).kinetic, 0.02);
    assert_eq!(shifted(0.1, 0.0).kinetic, 0.1);
}

/// In a straight hole at 60° with a friction of 0.8 the compression of a sliding string grows with
/// the distance from the bit, by `w (μ sin θ − cos θ)` a metre: it buckles at its top, under a
/// weight that is lower by that amount. A rotating one buckles at the bit, under `2 √(EI w sin θ /
/// r)`, and a helix begins under `√2` times that. To 2e-4: the search's 1e-4, and the share of the
/// torque for the advance of the bit.
#[test]
fn weights_to_buckle_are_those_of_a_straight_hole() {
    let hole_m = 0.2159;
    let stations = [[0.0, 60.0, 0.0], [600.0, 60.0, 0.0]];
    let setup = setup(&stations, StringSpec::from_bit(pipe()), hole_m);
    let broomstick = broomstick(&setup, levels([0.0, 0.4, 0.8]), vec![600.0], Statics::Soft);
    let bending = Material::STEEL.youngs_modulus_Pa * std::f64::consts::PI / 64.0
        * (OD_M.powi(4) - ID_M.powi(4));
    let weight_N_per_m =
        G * (STEEL - MUD) * std::f64::consts::FRAC_PI_4 * (OD_M * OD_M - ID_M * ID_M);
    let clearance_m = 0.5 * (hole_m - OD_M);
    let sinusoidal_N = 2.0 * (bending * weight_N_per_m * FRAC_PI_3.sin() / clearance_m).sqrt();
    let found = broomstick.weights_to_buckle(600.0);
    assert_eq!(found.len(), 6);
    for one in found {
        let [sinusoidal, helical] =
            one.weights_N.expect("an answer").map(|weight_N| weight_N.expect("it buckles"));
        let friction = [0.0, 0.4, 0.8][one.friction as usize];
        let grows = match one.operation {
            OperationKind::Slide => friction * FRAC_PI_3.sin() - FRAC_PI_3.cos(),
            _ => 0.0,
        };
        let less_N = (grows * weight_N_per_m * 600.0).max(0.0);
        for (found_N, expected_N) in
            [(sinusoidal, sinusoidal_N - less_N), (helical, 2f64.sqrt() * sinusoidal_N - less_N)]
        {
            assert!(
                (found_N / expected_N - 1.0).abs() < 2e-4,
                "{:?} {:?}: {found_N} N, expected {expected_N} N",
                one.operation,
                one.friction
            );
        }
    }
}

/// Just below the weight to buckle the profile is straight, just above it is not, in a well that
/// builds and turns and with an assembly below the pipe.
#[test]
fn the_soft_string_buckles_at_its_weight_to_buckle() {
    let stations = [[0.0, 0.0, 0.0], [500.0, 0.0, 0.0], [1400.0, 60.0, 40.0], [2500.0, 60.0, 60.0]];
    let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3))
        .catalogue("6-1/2 in x 2-13/16 in collar", ComponentLength::Metres(100.0))
        .and_then(|string| {
            string.catalogue("5 in 19.50 lb/ft S-135", ComponentLength::Metres(2300.0))
        })
        .expect("a string");
    let setup = setup(&stations, string, 0.2224);
    let broomstick = broomstick(&setup, Frictions::default(), vec![2500.0], Statics::Soft);
    let model = |level| broomstick.setup(level).at(2500.0).expect("a model");
    for one in broomstick.weights_to_buckle(2500.0) {
        let own = operations().into_iter().find(|own| own.kind == one.operation).expect("it");
        let [sinusoidal, helical] =
            one.weights_N.expect("an answer").map(|weight_N| weight_N.expect("it buckles"));
        assert!(0.0 < sinusoidal && sinusoidal < helical);
        for (weight_N, shape) in [(sinusoidal, 0), (helical, 1)] {
            let buckles = |weight_N: f64| {
                let operation = Operation { bit_depth_m: 2500.0, ..own }.weight_on_bit_N(weight_N);
                let solved = soft_string(&model(one.friction), &operation).expect("an answer");
                let loads = [&solved.sinusoidal_load_N, &solved.helical_load_N][shape];
                (0..loads.len())
                    .any(|row| loads[row].is_some_and(|load| -solved.tension_N[row] > load))
            };
            assert!(!buckles(0.999 * weight_N - 1.0) && buckles(1.001 * weight_N + 1.0));
        }
    }
}

/// A tapered string has a broomstick above its lower pipe: at every depth the points are those of a
/// string whose lower pipe runs to the surface, until its upper pipe is in the hole.
#[test]
fn a_tapered_string_is_cut_at_the_surface() {
    let pipe = |name: &str| ComponentSpec { name: name.to_owned(), ..pipe() };
    let upper = ComponentSpec { od_m: 0.1492, ..pipe("upper pipe") };
    let lower = ComponentSpec { length: ComponentLength::Metres(3000.0), ..pipe("lower pipe") };
    let tapered =
        StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3)).component(lower).component(upper);
    let plain = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3)).component(pipe("lower pipe"));
    let stations =
        [[0.0, 0.0, 45.0], [322.9, 0.0, 45.0], [1075.0, 65.0, 45.0], [4305.0, 65.0, 45.0]];
    let [tapered, plain] = [tapered, plain].map(|string| setup(&stations, string, 0.2159));
    let depths_m = bit_depths_m(&tapered, None, 4305.0, 5);
    assert!((depths_m[0] - 1.3).abs() < 1e-9, "{depths_m:?}");
    let points = |setup: &Setup| {
        solved(&broomstick(setup, Frictions::default(), depths_m.clone(), Statics::Soft))
    };
    for (point, other) in points(&tapered).iter().zip(points(&plain)) {
        let [load_N, expected_N] = [point, &other].map(hook_load_N);
        assert_eq!(load_N == expected_N, point.bit_depth_m < 3000.0, "{}", point.bit_depth_m);
    }
}

/// Stiff points are the stiff string's own, also with a bit within the assembly; a string that
/// cannot be assembled or solved is a row with a reason.
#[test]
fn a_point_without_an_answer_says_why() {
    let stations = [[0.0, 0.0, 0.0], [300.0, 0.0, 0.0], [600.0, 20.0, 0.0], [800.0, 20.0, 0.0]];
    let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3))
        .catalogue("6-1/2 in x 2-13/16 in collar", ComponentLength::Metres(100.0))
        .and_then(|string| {
            string.catalogue("5 in 19.50 lb/ft S-135", ComponentLength::Metres(2300.0))
        })
        .expect("a string");
    let setup = setup(&stations, string, 0.2224);
    let broomstick = Broomstick::new(
        &setup,
        &Frictions::default(),
        vec![Operation::trip_out(1.0)],
        vec![-50.0, 50.0, 800.0],
        vec![Statics::Soft, Statics::Stiff],
    )
    .expect("sound frictions");
    let points = solved(&broomstick);
    assert_eq!(points.len(), 2 * 3 * 3);
    for point in &points {
        match &point.outcome {
            Ok(_) => assert!(point.bit_depth_m > 0.0),
            Err(why) => {
                assert_eq!(point.bit_depth_m, -50.0);
                assert!(why.to_string().contains("50"), "{why}");
            }
        }
    }
    let stiff = points.iter().find(|point| {
        point.model == Statics::Stiff
            && point.bit_depth_m == 800.0
            && point.friction == FrictionLevel::Expected
    });
    let model = broomstick.setup(FrictionLevel::Expected).at(800.0).expect("a model");
    let alone = stiff::solve(&model, &Operation::trip_out(800.0), &Default::default());
    assert_eq!(hook_load_N(stiff.expect("a point")), alone.expect("an answer").scalars.hook_load_N);
}

/// A stiff string that locks up under the expected friction does so under the high one too: at its
/// own depth, that of a search under that friction alone.
#[test]
fn a_lock_up_is_where_its_own_friction_has_it() {
    let thin =
        ComponentSpec::uniform("coil", 0.0508, 0.0429, ComponentLength::ToSurface, Material::STEEL);
    let stations = [[0.0, 0.0, 0.0], [900.0, 0.0, 0.0], [1300.0, 90.0, 0.0], [3400.0, 90.0, 0.0]];
    let setup = setup(&stations, StringSpec::from_bit(thin), 0.1214);
    let broomstick = Broomstick::new(
        &setup,
        &levels([0.3, 0.4, 0.6]),
        vec![Operation::trip_in(3400.0)],
        vec![3400.0],
        vec![Statics::Stiff],
    );
    let broomstick = broomstick.expect("sound frictions");
    let task = broomstick.tasks()[0];
    let place_m = |points: &[BroomstickPoint]| {
        let point = points.iter().find(|point| point.friction == FrictionLevel::High);
        let check = point.expect("a point").checks.checks.first().cloned();
        assert!(point.expect("a point").outcome.is_err());
        check.expect("a check").md_m.expect("a place")
    };
    let all = broomstick.solve(&task);
    let (together_m, alone_m) =
        (place_m(&all), place_m(&broomstick.solve_at(&task, &[FrictionLevel::High])));
    assert!((together_m - alone_m).abs() < 1.0, "{together_m} {alone_m}");
    let expected = all.iter().find(|point| point.friction == FrictionLevel::Expected);
    let expected = expected.expect("a point").checks.checks[0].clone();
    assert!(expected.md_m.expect("a place") < together_m - 50.0, "{expected:?} {together_m}");
}

/// A station of the string has its depth and its tension: in vertical hole the buoyant weight below
/// it, in a tangent less the friction of that weight (closed forms, exact but for rounding).
#[test]
fn stations_along_the_string() {
    let area = std::f64::consts::FRAC_PI_4 * (OD_M * OD_M - ID_M * ID_M);
    let weight_N_per_m = (STEEL - MUD) * area * G;
    for inclination in [0.0_f64, 50.0] {
        let stations = [[0.0, inclination, 45.0], [1000.0, inclination, 45.0]];
        let setup = setup(&stations, StringSpec::from_bit(pipe()), 0.2159);
        let depths_m = vec![1000.0];
        let broomstick = broomstick(&setup, levels([0.1, 0.2, 0.3]), depths_m, Statics::Soft);
        let trip = Operation::trip_out(1000.0);
        let found = broomstick.along(&trip, 30.0).expect("an answer");
        let depths: Vec<f64> = found.iter().map(|station| station.md_m).collect();
        assert_eq!(depths.len(), 35);
        assert_eq!([depths[0], depths[1], depths[33], depths[34]], [0.0, 30.0, 990.0, 1000.0]);
        let (sin, cos) = inclination.to_radians().sin_cos();
        for station in &found {
            let below_m = 1000.0 - station.md_m;
            let tension_N = weight_N_per_m * below_m * (cos + 0.2 * sin);
            assert!((station.tension_N - tension_N).abs() < 1e-6, "{station:?}");
            assert!((station.tvd_m - station.md_m * cos).abs() < 1e-9);
            assert!((station.side_force_N_per_m + weight_N_per_m * sin).abs() < 1e-9);
            assert_eq!(station.component, "drill pipe");
            assert_eq!(station.yield_use, None, "the material has no strength");
        }
    }
}

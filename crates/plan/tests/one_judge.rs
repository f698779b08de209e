//! One state has one verdict: a run, a plan, the app's limits and a reach judge 200 random strings
//! alike, word for word.

use wholestring::{
    prelude::*,
    rig::Rig,
    statics::soft::{SoftSettings, SoftString},
    string::Material,
};
use wholestring_judge::{Check, CheckKind, DepthLimit, Judge, LimitSettings, Severity};
use wholestring_plan::{
    Broomstick, FrictionLevel, Frictions, LevelFriction, Setup, Statics,
    reach::{ReachSettings, margins},
};
use wholestring_units::UnitSet;

/// A linear congruential generator: the same strings on every machine.
struct Random(u64);

impl Random {
    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn is(&mut self, part: f64) -> bool {
        self.between(0.0, 1.0) < part
    }
}

/// A well with a build and a tangent, a tapered string, a rig with or without a block and a push.
fn setup(random: &mut Random) -> (Setup, f64) {
    let (kick_off_m, inc_deg) = (random.between(100.0, 800.0), random.between(35.0, 95.0));
    let build_m = kick_off_m + inc_deg / random.between(1.5, 4.0) * 30.0;
    let depth_m = build_m + random.between(300.0, 3500.0);
    let stations = [[0.0, 0.0], [kick_off_m, 0.0], [build_m, inc_deg], [depth_m, inc_deg]];
    let stations: Vec<Station> =
        stations.iter().map(|&[md, inc]| Station::from_degrees(md, inc, 30.0)).collect();
    let path = Path::minimum_curvature(&stations).expect("a sound survey");
    let shoe_m = random.between(0.2, 0.8) * depth_m;
    let hole = Hole::new(vec![
        HoleSection::casing(0.0..shoe_m, 0.2224, random.between(0.1, 0.35)),
        HoleSection::open(shoe_m..depth_m, 0.2159, random.between(0.15, 0.5)),
    ]);
    let pipe = |name: &str, length| {
        let pipe = ComponentSpec::uniform(name, 0.127, 0.1086, length, Material::STEEL);
        ComponentSpec { yield_strength_Pa: Some(931e6), ..pipe }
    };
    let heavy = ComponentSpec::uniform("collar", 0.1651, 0.0714, Metres(60.0), Material::STEEL);
    let string = StringSpec {
        components: vec![ComponentSpec::bit(0.2159, 0.3), heavy, pipe("pipe", ToSurface)],
    };
    let maybe = |random: &mut Random, part: f64, value: [f64; 2]| {
        random.is(part).then(|| random.between(value[0], value[1]))
    };
    let rig = Rig {
        block_weight_N: maybe(random, 0.5, [50e3, 400e3]),
        hoist_capacity_N: maybe(random, 0.7, [500e3, 3e6]),
        snubbing_force_N: maybe(random, 0.2, [50e3, 300e3]),
        top_drive_torque_N_m: maybe(random, 0.7, [5e3, 60e3]),
        top_drive_peak_torque_N_m: maybe(random, 0.4, [20e3, 80e3]),
        ..Rig::default()
    };
    let mud = Mud::of_density(random.between(1000.0, 1900.0));
    let setup = Setup {
        well: Well::new(path, hole.expect("a hole")),
        string,
        mud,
        fluids: Default::default(),
        rig,
        ends: Default::default(),
        buckling: Default::default(),
    };
    (setup, depth_m)
}

fn operations(random: &mut Random, bit_depth_m: f64) -> Vec<Operation> {
    let weight_N = random.between(5e3, 150e3);
    let drill = |operation: Operation| {
        operation.weight_on_bit_N(weight_N).bit_torque_N_m(3e3).rate_of_penetration_m_per_s(3e-3)
    };
    vec![
        Operation::trip_out(bit_depth_m),
        Operation::trip_in(bit_depth_m),
        Operation::rotate_off_bottom(bit_depth_m).rotary_speed_rad_per_s(10.0),
        drill(Operation::drill(bit_depth_m)).rotary_speed_rad_per_s(10.0),
        drill(Operation::slide(bit_depth_m)),
    ]
}

/// Returns the limits of the checks, without those that only a whole result has.
fn limits(checks: &[Check]) -> Vec<&Check> {
    checks.iter().filter(|check| check.factor.is_some()).collect()
}

#[test]
fn two_hundred_strings_are_judged_alike() {
    let mut random = Random(7);
    let (mut lock_ups, mut pushed, mut wrong) = (0, 0, 0);
    for case in 0..200 {
        let (setup, depth_m) = setup(&mut random);
        let operations = operations(&mut random, depth_m);
        let judge = Judge::new(LimitSettings::default(), UnitSet::ALL[case % 3]);
        let own = LevelFriction::shifted(0.0);
        let frictions = Frictions { low: own, expected: own, high: own };
        let plan =
            Broomstick::new(&setup, &frictions, operations, vec![depth_m], vec![Statics::Soft]);
        let plan = plan.expect("a plan").with_judge(judge);
        let model = setup.at(depth_m).expect("a string that reaches the bit");
        for task in plan.tasks() {
            let operation = task.operation;
            let solved = soft_string(&model, &operation).expect("an answer");
            let run = judge.soft(&model, &operation, &solved);
            let [point] = &plan.solve_at(&task, &[FrictionLevel::Expected])[..] else {
                panic!("one level");
            };
            assert_eq!(run, point.checks, "{case}: run and plan");
            // The app has the loads only.
            let string =
                SoftString::new(&model, depth_m, &SoftSettings::default()).expect("a string");
            let app =
                judge.soft_limits(&model, &operation, &string.loads(&operation).expect("loads"));
            let sentences = |checks: &[Check]| -> Vec<(CheckKind, String)> {
                limits(checks).iter().map(|check| (check.kind, check.sentence.clone())).collect()
            };
            assert_eq!(sentences(&run.checks), sentences(&app.checks), "{case}: run and app");
            // A reach that counts no helix stops where block and rig do not push the string down.
            let of_kind = |kind| run.checks.iter().find(|check| check.kind == kind);
            let settings = ReachSettings {
                soft: SoftSettings::default(),
                ..ReachSettings::from_depth(depth_m)
            };
            let margins = margins(&setup, &operation, &settings).expect("margins");
            // A limit below its required factor in run and plan stops a reach, and no other does.
            let judged = limits(&run.checks).into_iter().filter(|check| check.kind.stops());
            let judged = judged.filter(|check| check.kind != CheckKind::LockUp);
            let short = judged.filter(|check| check.kind != CheckKind::Overpull);
            let least = short.map(Check::reserve).fold(f64::INFINITY, f64::min);
            let pushes =
                [DepthLimit::HookLoadZero, DepthLimit::PushSpent, DepthLimit::PushAbsorbed];
            let stopped = margins.iter().filter(|margin| margin.limit.stops());
            let stopped = stopped.filter(|margin| !pushes.contains(&margin.limit));
            let most = stopped.map(|margin| margin.margin).fold(1.0, f64::min);
            assert_eq!(least < 1.0, most < 0.0, "{case}: {least} {most}");
            let spent = margins.iter().find(|margin| margin.limit == DepthLimit::PushSpent);
            let hangs = margins.iter().find(|margin| margin.limit == DepthLimit::HookLoadZero);
            let down = of_kind(CheckKind::GoesDown);
            if let (Some(down), Some(hangs)) = (down, hangs.filter(|_| !operation.kind.on_bottom()))
            {
                let is_near = hangs.load.abs() < 2e-3 * hangs.load.abs().max(1e6);
                let by_weight = down.severity == Severity::Ok;
                if model.rig.snubbing_force_N.is_none() && by_weight {
                    assert!(hangs.margin > 0.0 || is_near, "{case}: {down:?} {hangs:?}");
                }
            }
            // By its weight by run and plan: by a reach, which counts the drag of the helix, too.
            let drags = SoftSettings { helix_side_force: true, ..SoftSettings::default() };
            let settings = ReachSettings { soft: drags, ..settings };
            if let Some(down) = down.filter(|_| operation.slides_down()) {
                let dragged = wholestring_plan::reach::margins(&setup, &operation, &settings);
                let dragged = dragged.expect("margins");
                let dragged =
                    dragged.iter().find(|margin| margin.limit == DepthLimit::HookLoadZero);
                let dragged = dragged.expect("a limit of every descent");
                let is_near = dragged.margin.abs() < 5e-3;
                let by_weight = down.sentence.contains("goes down by its weight");
                assert!(
                    is_near || by_weight == (dragged.margin > 0.0),
                    "{case}: {down:?} {dragged:?}"
                );
            }
            let lock_up = of_kind(CheckKind::LockUp);
            if let (Some(lock_up), Some(spent)) = (lock_up, spent) {
                if spent.margin < -0.01 {
                    assert_eq!(lock_up.severity, Severity::Error, "{case}: {lock_up:?} {spent:?}");
                }
                lock_ups += usize::from(lock_up.severity == Severity::Error);
                pushed += usize::from(down.is_some_and(|down| down.severity == Severity::Warning));
            }
            wrong += usize::from(run.checks.iter().any(|check| check.severity == Severity::Error));
            // A string that no force moves down is never marginal, and vice versa.
            if let (Some(lock_up), Some(down)) = (lock_up, down) {
                let errors = [lock_up, down].map(|check| check.severity == Severity::Error);
                assert_eq!(errors[0], errors[1], "{case}: {lock_up:?} {down:?}");
            }
        }
    }
    // The strings are of every kind.
    assert!(lock_ups >= 10 && pushed >= 10 && wrong > 50, "{lock_ups} {pushed} {wrong}");
}

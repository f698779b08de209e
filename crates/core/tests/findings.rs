//! What is reported of an answer: every kind where it must be, and not where it must not.

mod common;

use common::*;
use wholestring::{
    dynamics::{
        DynamicOutcome, DynamicsSettings, HoistControl, SpeedController, Statistic, StickSlip,
        TableUse, TopDriveSettings, Whirl,
    },
    findings::{Finding, Kind, Level, of_dynamic, of_soft},
    model::Model,
    operation::{Operation, OperationKind, OperationKind::*},
    rig::Rig,
    statics::soft::{self, SoftSettings},
    string::{ComponentLength, ComponentSpec},
};

/// A horizontal well: vertical to 500 m, a quarter circle to 1400 m, and on to `to_m`.
fn lateral(to_m: f64, mu: f64) -> Model {
    let stations = [
        [0.0, 0.0, 0.0],
        [500.0, 0.0, 0.0],
        [1400.0, 90.0, 0.0],
        [to_m, 90.0, 0.0],
    ];
    five_inch(&stations, 0.2159, mu, 260.0)
}

/// Plain 5 in pipe of a weight per metre in air, in air, with the bit at the last station.
fn five_inch(stations: &[[f64; 3]], hole_m: f64, mu: f64, weight_N_per_m: f64) -> Model {
    let path = arcs(stations);
    let bit_depth_m = path.last_md_m();
    let hole = open_hole(hole_m, mu, bit_depth_m);
    let pipe = ComponentSpec {
        mass_per_length_kg_per_m: weight_N_per_m / wholestring::GRAVITY_M_PER_S2,
        ..ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, steel())
    };
    model(path, hole, vec![pipe], mud(0.0), bit_depth_m)
}

fn soft_findings(model: &Model, operation: &Operation) -> Vec<Finding> {
    let profile = soft::solve(model, operation, &SoftSettings::default()).expect("a sound model");
    of_soft(model, operation, &profile)
}

fn pressing(kind: OperationKind, model: &Model, weight_on_bit_N: f64) -> Operation {
    Operation {
        weight_on_bit_N,
        ..operation(kind, model.string.length_m())
    }
}

fn only(found: &[Finding], kind: Kind) -> Option<Finding> {
    let mut all = found.iter().filter(|of| of.kind == kind);
    let first = all.next().copied();
    assert!(all.next().is_none(), "{kind:?} twice: {found:?}");
    first
}

#[track_caller]
fn none(found: &[Finding], kind: Kind) {
    assert_eq!(found.iter().find(|of| of.kind == kind), None);
}

#[test]
fn words_of_kinds_are_their_own() {
    let mut words: Vec<&str> = Kind::ALL.iter().map(|kind| kind.name()).collect();
    words.sort_unstable();
    words.dedup();
    assert_eq!(words.len(), Kind::ALL.len());
    let plain = |word: &str| {
        word.bytes()
            .all(|byte| byte == b'_' || byte.is_ascii_lowercase())
    };
    assert!(words.iter().all(|word| plain(word)), "{words:?}");
    assert!(Level::Error > Level::Warning && Level::Warning > Level::Note);
}

/// A string in a slant slides down as long as `cot i` exceeds the friction: just below and just
/// above `μ = 1/tan 60°`.
#[test]
fn a_hook_load_below_zero_is_told() {
    let slant = |mu| five_inch(&[[0.0, 60.0, 0.0], [1000.0, 60.0, 0.0]], 0.2159, mu, 260.0);
    let critical = 1.0 / 60.0_f64.to_radians().tan();
    let goes = slant(0.99 * critical);
    none(
        &soft_findings(&goes, &operation(TripIn, 1000.0)),
        Kind::HookLoadNegative,
    );
    let mut stands = slant(1.01 * critical);
    let found = soft_findings(&stands, &operation(TripIn, 1000.0));
    let of = only(&found, Kind::HookLoadNegative).expect("a finding");
    // 1 % of the weight along the hole.
    assert_close("hook load", of.value.unwrap(), -0.01 * 260e3 * 0.5, 1e-6);
    assert_eq!((of.level, of.limit), (Level::Error, Some(0.0)));
    // Less than what an indicator shows is none.
    let barely = slant(0.9999 * critical);
    let found = soft_findings(&barely, &operation(TripIn, 1000.0));
    assert!(only(&found, Kind::HookLoadNegative).is_some());
    // A block that pushes harder makes it a warning, one that does not leaves it an error.
    for (block_N, level) in [(5e3, Level::Warning), (1e3, Level::Error)] {
        stands.rig.block_weight_N = Some(block_N);
        let found = soft_findings(&stands, &operation(TripIn, 1000.0));
        assert_eq!(only(&found, Kind::HookLoadNegative).unwrap().level, level);
    }
}

/// In a straight slant without helix what is missing at the bit is what is missing at the hook.
#[test]
fn lock_up_is_what_does_not_arrive() {
    let stations = [[0.0, 60.0, 0.0], [1000.0, 60.0, 0.0]];
    let mut slant = five_inch(&stations, 0.2159, 0.5, 260.0);
    let push_N = 260e3 * (60.0_f64.to_radians().cos() - 0.5 * 60.0_f64.to_radians().sin());
    let slide =
        |model: &Model, part: f64| soft_findings(model, &pressing(Slide, model, part * push_N));
    none(&slide(&slant, 0.98), Kind::LockUp);
    let of = only(&slide(&slant, 1.5), Kind::LockUp).expect("a finding");
    assert_eq!((of.level, of.from_md_m), (Level::Error, None));
    assert_close("asked", of.value.unwrap(), 1.5 * push_N, 1e-12);
    assert_close("arrives", of.limit.unwrap(), push_N, 1e-9);
    slant.rig.block_weight_N = Some(0.6 * push_N);
    none(&slide(&slant, 1.5), Kind::LockUp);
    // A string that turns has its friction around it.
    slant.rig.block_weight_N = None;
    let drill = pressing(Drill, &slant, 1.5 * push_N);
    none(&soft_findings(&slant, &drill), Kind::LockUp);
}

/// In a long lateral the helix takes all push: as far above the bit as in `S2b`'s closed form,
/// which has no build.
#[test]
fn a_helix_that_takes_all_push_is_placed() {
    let stations = [[0.0, 90.0, 0.0], [8000.0, 90.0, 0.0]];
    let lateral = five_inch(&stations, 0.2159, 0.3, 222.036_979_824_722_35);
    // The pipe of `S2b` pressed by 120 kN locks up within 3010 m, of 210 GPa as here.
    let found = soft_findings(&lateral, &pressing(Slide, &lateral, 120e3));
    let of = only(&found, Kind::LockUp).expect("a finding");
    let file = verification("S2b_lockup_horizontal.json");
    let row = &file["cases"][4];
    assert_eq!(row["inputs"]["F_at_bit_N"], 120e3);
    let length_m = row["expected"]["closed_form_m"].as_f64().unwrap();
    assert_close("place", 8000.0 - of.from_md_m.unwrap(), length_m, 1e-6);
}

/// The two profiles of `S2a`: 100 kN on the bit buckle nothing, 150 kN the lower 250 m of the
/// tangent below the drop.
#[test]
fn s2a_buckled_stretches() {
    let file = verification("S2a_buckling_along_string.json");
    let stations = [
        [0.0, 0.0, 0.0],
        [1000.0, 0.0, 0.0],
        [1900.0, 60.0, 0.0],
        [3000.0, 60.0, 0.0],
        [3900.0, 30.0, 0.0],
        [4500.0, 30.0, 0.0],
    ];
    let weight = file["inputs"]["pipe"]["w"].as_f64().unwrap();
    for row in file["profiles"].as_array().unwrap() {
        let [weight_on_bit_N, mu] = ["WOB_N", "mu"].map(|key| row["inputs"][key].as_f64().unwrap());
        let model = five_inch(&stations, 0.2159, mu, weight);
        let found = soft_findings(&model, &pressing(Slide, &model, weight_on_bit_N));
        none(&found, Kind::HelicalBuckling);
        let changes = row["expected"]["state_changes_0none_1sin_2hel"]
            .as_array()
            .unwrap();
        let Some(change) = changes.first() else {
            none(&found, Kind::SinusoidalBuckling);
            continue;
        };
        let of = only(&found, Kind::SinusoidalBuckling).expect("a stretch");
        report(&Row {
            case: "S2a",
            quantity: "depth from which a string that slides down is buckled, m",
            expected: change["md_m"].as_f64().unwrap(),
            computed: of.from_md_m.unwrap(),
            tolerance: Tolerance::Absolute(1.0),
            reason: "the spacing of its nodes, by its source",
        });
        assert_eq!(of.to_md_m, Some(4500.0));
        assert_eq!((of.level, of.value), (Level::Warning, Some(150e3)));
        // The tangent of 30°: the load of Dawson and Paslay there.
        assert_close("load", of.limit.unwrap(), 111_651.265_330_979_6, 1e-6);
    }
}

/// A vertical string is held by its own weight: Lubinski's load below 10 m above the bit, and
/// nothing of it a tenth less.
#[test]
fn a_vertical_hole_has_a_scale_of_its_own() {
    let vertical = five_inch(&[[0.0, 0.0, 0.0], [2000.0, 0.0, 0.0]], 0.2159, 0.3, 260.0);
    let stiffness = vertical.string.components()[0].bending_stiffness_N_m2();
    let scale_N = (stiffness * 260.0 * 260.0).cbrt();
    let drill = |weight_N| soft_findings(&vertical, &pressing(Drill, &vertical, weight_N));
    none(&drill(1.93 * scale_N), Kind::SinusoidalBuckling);
    let bowed = drill(1.94 * scale_N + 50.0 * 260.0);
    let of = only(&bowed, Kind::SinusoidalBuckling).expect("a stretch");
    // Every hole that is drilled with its collars in compression has it.
    assert_eq!(of.level, Level::Note);
    assert_close("from", of.from_md_m.unwrap(), 1950.0, 1e-6);
    assert_close("load", of.limit.unwrap(), 1.94 * scale_N, 1e-6);
    none(&bowed, Kind::HelicalBuckling);
    let helical = drill(5.55 * scale_N + 50.0 * 260.0);
    let of = only(&helical, Kind::HelicalBuckling).expect("a stretch");
    assert_eq!(of.level, Level::Warning);
    assert_close("from", of.from_md_m.unwrap(), 1950.0, 1e-6);
    // A helix is more than a bow.
    none(&helical, Kind::SinusoidalBuckling);
    // Less than a joint of it is not told.
    none(&drill(5.55 * scale_N + 9.0 * 260.0), Kind::HelicalBuckling);
}

/// A lateral of which the driller gets nothing to the bit has all three, the gravest first.
#[test]
fn a_lateral_that_cannot_be_drilled() {
    let model = lateral(4500.0, 0.35);
    let found = soft_findings(&model, &pressing(Slide, &model, 49e3));
    let kinds: Vec<Kind> = found.iter().map(|of| of.kind).collect();
    assert_eq!(
        kinds[..2],
        [Kind::HookLoadNegative, Kind::LockUp],
        "{found:?}"
    );
    assert!(found.windows(2).all(|pair| pair[0].level >= pair[1].level));
    let helical: Vec<&Finding> = found
        .iter()
        .filter(|of| of.kind == Kind::HelicalBuckling)
        .collect();
    assert!(!helical.is_empty());
    for of in helical {
        assert!(of.value > of.limit && of.from_md_m < of.to_md_m, "{of:?}");
    }
}

#[test]
fn rig_limits() {
    let mut model = five_inch(&[[0.0, 60.0, 0.0], [1000.0, 60.0, 0.0]], 0.2159, 0.3, 260.0);
    let turning = operation(RotateOffBottom, 1000.0);
    let profile = soft::solve(&model, &turning, &SoftSettings::default()).unwrap();
    let (hook_N, torque_N_m) = (
        profile.scalars.hook_load_N,
        profile.scalars.surface_torque_N_m,
    );
    let block_N = 200e3;
    let mut levels = |part: f64, block: Option<f64>| {
        model.rig = Rig {
            block_weight_N: block,
            hoist_capacity_N: Some((hook_N + block_N) / part),
            top_drive_torque_N_m: Some(torque_N_m / part),
        };
        let found = soft_findings(&model, &turning);
        [Kind::HoistOverloaded, Kind::TopDriveOverloaded]
            .map(|kind| only(&found, kind).map(|of| of.level))
    };
    use Level::*;
    assert_eq!(levels(1.01, Some(block_N)), [Some(Error); 2]);
    assert_eq!(levels(0.99, Some(block_N)), [Some(Warning), Some(Note)]);
    assert_eq!(levels(0.85, Some(block_N)), [None, Some(Note)]);
    assert_eq!(levels(0.79, Some(block_N)), [None; 2]);
    // Without the block the hoist has less to carry.
    assert_eq!(levels(1.01, None), [None, Some(Error)]);
}

/// A short run whose numbers are then set as they are to be judged.
struct Ran {
    model: Model,
    operation: Operation,
    settings: DynamicsSettings,
    outcome: DynamicOutcome,
}

impl Ran {
    fn new(kind: OperationKind) -> Self {
        let model = five_inch(&[[0.0, 60.0, 0.0], [100.0, 60.0, 0.0]], 0.2159, 0.3, 260.0);
        let operation = Operation {
            rate_of_penetration_m_per_s: 1e-3,
            ..pressing(kind, &model, 2e3)
        };
        let settings = DynamicsSettings {
            settle_s: 5.0,
            duration_s: 0.2,
            ..DynamicsSettings::default()
        };
        let mut simulation =
            wholestring::dynamics::Simulation::new(&model, &operation, &settings).unwrap();
        simulation.advance(5.2).unwrap();
        let outcome = simulation.outcome();
        Self {
            model,
            operation,
            settings,
            outcome,
        }
    }

    fn found(&self) -> Vec<Finding> {
        let Self {
            model,
            operation,
            settings,
            outcome,
        } = self;
        of_dynamic(model, operation, settings, outcome)
    }

    fn has(&self, kind: Kind) -> Option<Finding> {
        only(&self.found(), kind)
    }

    fn level(&self, kind: Kind) -> Option<Level> {
        self.has(kind).map(|of| of.level)
    }

    fn statistic(&mut self, name: &str) -> &mut Statistic {
        let mut all = self.outcome.statistics.iter_mut();
        &mut all.find(|(of, _)| *of == name).expect("a quantity").1
    }

    /// A quantity that has this mean and varies by this much.
    fn set(&mut self, name: &str, mean: f64, by: f64) {
        *self.statistic(name) = Statistic {
            mean,
            std: by,
            min: mean - by,
            max: mean + by,
            p05: mean - by,
            p95: mean + by,
            std_error: 0.01 * by,
            drift: 0.0,
            drifts: false,
        };
    }
}

#[test]
fn a_quiet_run_has_nothing_to_tell() {
    for kind in OperationKind::ALL {
        assert_eq!(Ran::new(kind).found(), [], "{kind:?}");
    }
}

#[test]
fn a_slack_hook() {
    let mut ran = Ran::new(TripOut);
    ran.set("hook_load_N", 10e3, 9e3);
    assert_eq!(ran.level(Kind::HookLoadNegative), None);
    ran.set("hook_load_N", 10e3, 10e3);
    assert_eq!(ran.level(Kind::HookLoadNegative), Some(Level::Warning));
    ran.set("hook_load_N", 0.0, 0.0);
    assert_eq!(ran.level(Kind::HookLoadNegative), Some(Level::Error));
}

#[test]
fn a_string_that_stands_has_locked_up() {
    let mut ran = Ran::new(Slide);
    ran.set("hook_load_N", 0.0, 0.0);
    ran.set("weight_on_bit_N", 1.5e3, 0.0);
    let of = ran.has(Kind::LockUp).expect("a finding");
    assert_eq!((of.value, of.limit), (Some(2e3), Some(1.5e3)));
    ran.set("weight_on_bit_N", 1.9e3, 0.0);
    assert_eq!(ran.has(Kind::LockUp), None);
    let mut ran = Ran::new(TripIn);
    ran.set("hook_load_N", 0.0, 0.0);
    assert_eq!(ran.has(Kind::LockUp), None, "it follows the block");
    ran.outcome.series.bit_depth_m.fill(100.0);
    assert!(ran.has(Kind::LockUp).is_some());
}

#[test]
fn weight_on_bit_against_its_target() {
    use Kind::*;
    let mut ran = Ran::new(Drill);
    for (part, below, above) in [
        (0.96, None, None),
        (0.94, Some(Level::Warning), None),
        (0.79, Some(Level::Error), None),
        (1.04, None, None),
        (1.06, None, Some(Level::Warning)),
        (1.21, None, Some(Level::Error)),
    ] {
        ran.set("weight_on_bit_N", part * 2e3, 0.0);
        assert_eq!(ran.level(WeightOnBitNotReached), below, "{part}");
        assert_eq!(ran.level(WeightOnBitExceeded), above, "{part}");
    }
    // A lift that is given holds nothing: it is what the user requested.
    ran.outcome.series.weight_on_bit_set_N.fill(None);
    assert_eq!(ran.level(WeightOnBitExceeded), None);
    ran.settings.hoist_control = Some(HoistControl::HookLoad(1e3));
    assert_eq!(ran.level(WeightOnBitExceeded), Some(Level::Warning));

    ran.set("weight_on_bit_N", 2e3, 0.49e3);
    assert_eq!(ran.level(WeightOnBitUnsteady), None);
    ran.set("weight_on_bit_N", 2e3, 0.51e3);
    assert_eq!(ran.level(WeightOnBitUnsteady), Some(Level::Warning));

    assert_eq!(ran.level(BitBounce), None);
    let weights = &mut ran.outcome.series.weight_on_bit_N;
    let last = weights.len() - 1;
    weights[last] = 0.0;
    let of = ran.has(BitBounce).expect("a finding");
    // One sample of the twenty or so of the window.
    assert!((of.value.unwrap() - 0.05).abs() < 0.005, "{of:?}");
}

#[test]
fn compression_of_nodes_buckles_too() {
    let mut ran = Ran::new(Slide);
    // Dawson and Paslay's load of the straight slant.
    let place = wholestring::statics::buckling::Place::of(&ran.model, 100.0, 50.0);
    let load = |part: f64| {
        -part * place.critical_loads_N(wholestring::statics::buckling::Criterion::Sinusoidal)[0]
    };
    ran.outcome.nodes.tension_N.fill(load(0.99));
    assert_eq!(ran.has(Kind::SinusoidalBuckling), None);
    ran.outcome.nodes.tension_N.fill(load(1.01));
    let of = ran.has(Kind::SinusoidalBuckling).expect("a stretch");
    assert!(of.to_md_m.unwrap() - of.from_md_m.unwrap() > 99.0, "{of:?}");
    assert_eq!(ran.has(Kind::HelicalBuckling), None);
    ran.outcome.nodes.tension_N.fill(load(1.42));
    assert!(ran.has(Kind::HelicalBuckling).is_some());
}

#[test]
fn stress_near_and_beyond_yield() {
    let mut ran = Ran::new(RotateOffBottom);
    let place = ran.outcome.nodes.md_m.len() / 2;
    for (part, level) in [
        (0.79, None),
        (0.81, Some(Level::Warning)),
        (1.0, Some(Level::Warning)),
        (1.01, Some(Level::Error)),
    ] {
        ran.outcome.nodes.yield_use[place] = Some(part);
        assert_eq!(ran.level(Kind::YieldUse), level, "{part}");
    }
    let of = ran.has(Kind::YieldUse).expect("a finding");
    let md_m = ran.outcome.nodes.md_m[place];
    assert!(of.from_md_m.unwrap() < md_m && of.to_md_m.unwrap() > md_m);
    assert_eq!((of.value, of.limit), (Some(1.01), Some(1.0)));
}

fn driven(torque_limit_N_m: Option<f64>) -> TopDriveSettings {
    TopDriveSettings::Driven {
        inertia_kg_m2: 1000.0,
        controller: SpeedController::Pi {
            proportional_N_m_s: 1e4,
            integral_N_m: 1e4,
        },
        torque_limit_N_m,
    }
}

/// A stall is a stall, whatever severity of stick-slip its speeds amount to.
#[test]
fn a_stalled_top_drive() {
    let mut ran = Ran::new(RotateOffBottom);
    let stick_slip = StickSlip {
        severity: Some(12.6),
        torque_severity: None,
        period_s: None,
        stuck_fraction: 0.9,
        bit_speed_max_rad_per_s: 3.0,
    };
    ran.outcome.indicators.stick_slip = Some(stick_slip);
    ran.outcome.series.rotary_speed_rad_per_s.fill(0.0);
    ran.outcome.series.surface_torque_N_m.fill(30e3);
    assert_eq!(ran.level(Kind::StickSlip), Some(Level::Warning));
    ran.settings.top_drive = driven(Some(30e3));
    let of = ran.has(Kind::TopDriveStalled).expect("a finding");
    assert_eq!((of.level, of.limit), (Level::Error, Some(30e3)));
    assert_eq!(ran.has(Kind::StickSlip), None);
    assert_eq!(ran.has(Kind::TopDriveAtLimit), None);
    // One that turns, if slowly, works at its limit.
    for (part, level) in [(0.5, Level::Error), (0.95, Level::Warning)] {
        let set = ran.outcome.series.rotary_speed_set_rad_per_s.clone();
        ran.outcome.series.rotary_speed_rad_per_s = set.iter().map(|set| part * set).collect();
        assert_eq!(ran.level(Kind::TopDriveAtLimit), Some(level));
        assert_eq!(ran.has(Kind::TopDriveStalled), None);
    }
    for limit in [Some(31e3), None] {
        ran.settings.top_drive = driven(limit);
        assert_eq!(ran.has(Kind::TopDriveAtLimit), None);
    }
}

#[test]
fn stick_slip_and_whirl() {
    let mut ran = Ran::new(RotateOffBottom);
    let stick_slip = |severity, stuck_fraction| StickSlip {
        severity,
        torque_severity: None,
        period_s: None,
        stuck_fraction,
        bit_speed_max_rad_per_s: 3.0,
    };
    for (of, level) in [
        (stick_slip(Some(0.49), 0.0), None),
        (stick_slip(Some(0.51), 0.0), Some(Level::Note)),
        (stick_slip(Some(1.01), 0.2), Some(Level::Warning)),
        (stick_slip(None, 0.9), None),
        (stick_slip(None, 1.0), Some(Level::Warning)),
    ] {
        ran.outcome.indicators.stick_slip = Some(of);
        assert_eq!(ran.level(Kind::StickSlip), level, "{of:?}");
    }
    assert_eq!(ran.has(Kind::BackwardWhirl), None);
    let whirl = Whirl {
        md_m: 90.0,
        rate_rad_per_s: -20.0,
        ratio: -2.7,
        length_fraction: 0.1,
    };
    ran.outcome.indicators.backward_whirl = Some(whirl);
    let of = ran.has(Kind::BackwardWhirl).expect("a finding");
    assert_eq!((of.level, of.from_md_m), (Level::Warning, Some(90.0)));
    assert_eq!(ran.has(Kind::ForwardWhirl), None);
    ran.outcome.indicators.forward_whirl = Some(whirl);
    assert_eq!(ran.level(Kind::ForwardWhirl), Some(Level::Note));
}

/// The clearance of 5 in pipe in an 8-1/2 in hole is 44.45 mm.
#[test]
fn numbers_that_are_not_to_be_trusted() {
    let mut ran = Ran::new(RotateOffBottom);
    for (penetration_m, level) in [
        (4.4e-3, None),
        (4.5e-3, Some(Level::Warning)),
        (44.4e-3, Some(Level::Warning)),
        (1.44, Some(Level::Error)),
    ] {
        ran.outcome.numerics.max_penetration_m = penetration_m;
        assert_eq!(ran.level(Kind::WallPenetration), level, "{penetration_m}");
    }
    for (residual, level) in [
        (-0.05, None),
        (0.051, Some(Level::Warning)),
        (-0.45, Some(Level::Error)),
        (f64::NAN, Some(Level::Error)),
    ] {
        ran.outcome.numerics.energy_residual = residual;
        assert_eq!(ran.level(Kind::EnergyResidual), level, "{residual}");
    }
    let of = |outside_fraction| TableUse {
        outside_fraction,
        weights_N: [0.0, 1e4],
        table_weights_N: [1e3, 9e3],
        speeds_rad_per_s: [1.0, 2.0],
        table_speeds_rad_per_s: [1.0, 2.0],
    };
    for (fraction, level) in [(0.0, None), (0.01, Some(Level::Warning))] {
        ran.outcome.bit_table = Some(of(fraction));
        assert_eq!(ran.level(Kind::BitTableLeft), level);
    }
}

#[test]
fn a_node_that_never_settled() {
    let mut ran = Ran::new(RotateOffBottom);
    let nodes = &mut ran.outcome.nodes;
    nodes.tension_std_N.fill(10.0);
    let largest_N = nodes
        .tension_N
        .iter()
        .fold(0.0, |of: f64, t| of.max(t.abs()));
    let place = nodes.md_m.len() / 2;
    let md_m = nodes.md_m[place];
    nodes.tension_std_N[place] = 0.019 * largest_N;
    assert_eq!(ran.has(Kind::NodeUnsettled), None);
    ran.outcome.nodes.tension_std_N[place] = 0.021 * largest_N;
    let of = ran.has(Kind::NodeUnsettled).expect("a finding");
    assert_eq!((of.level, of.from_md_m), (Level::Warning, Some(md_m)));
    // A string that swings as a whole is another matter.
    ran.outcome.nodes.tension_std_N.fill(0.021 * largest_N);
    assert_eq!(ran.has(Kind::NodeUnsettled), None);
}

/// A mean that moves is a warning, and no more than a note where the bit moves, too.
#[test]
fn means_that_drift_and_settling_without_end_are_told() {
    let mut ran = Ran::new(OperationKind::TripIn);
    ran.outcome.numerics.bit_travel_m = 0.9;
    assert_eq!(ran.level(Kind::WindowDrifts), None);
    ran.statistic("hook_load_N").drifts = true;
    assert_eq!(ran.level(Kind::WindowDrifts), Some(Level::Warning));
    ran.outcome.numerics.bit_travel_m = -1.1;
    assert_eq!(ran.level(Kind::WindowDrifts), Some(Level::Note));

    assert_eq!(ran.level(Kind::NeverSteady), None);
    ran.outcome.numerics.settled = Some(false);
    let found = ran.has(Kind::NeverSteady).expect("a finding");
    assert_eq!(found.level, Level::Warning);
    assert_eq!(found.value, Some(ran.outcome.numerics.settle_s));
}

/// Settling that takes longer than foreseen moves the bit on; a time that is given is meant so.
#[test]
fn a_bit_that_has_gone_on_is_told() {
    let mut ran = Ran::new(OperationKind::TripIn);
    let asked_m = ran.operation.bit_depth_m;
    for (settled, off_m, told) in [
        (None, 27.0, false),
        (Some(true), 0.9, false),
        (Some(true), 1.1, true),
        (Some(false), -1.1, true),
    ] {
        ran.outcome.numerics.settled = settled;
        ran.outcome.numerics.mean_bit_depth_m = asked_m + off_m;
        let found = ran.has(Kind::BitElsewhere);
        assert_eq!(found.is_some(), told, "{settled:?} {off_m}");
        assert!(found.is_none_or(|of| of.limit == Some(asked_m) && of.level == Level::Note));
    }
}

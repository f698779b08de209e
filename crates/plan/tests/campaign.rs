//! A campaign of a plan, against its stages one by one.

mod common;

use std::f64::consts::PI;

use common::*;
use wholestring::{
    prelude::*,
    string::ToolJoints,
    well::{CasingPipe, HoleSection},
};
use wholestring_judge::{CheckKind, Judge, strength::PSI_PA};
use wholestring_plan::{
    Broomstick, Campaign, CampaignSettings, FrictionLevel, Frictions, Setup, Share, Stage, Statics,
    fatigue::Damage,
    lengths_m,
    wear::{CasingWear, WearFactors},
};

const DEPTHS_M: [f64; 4] = [400.0, 900.0, 1200.0, 1500.0];

fn setup() -> Setup {
    let path = Path::minimum_curvature(&[
        Station::from_degrees(0.0, 0.0, 0.0),
        Station::from_degrees(300.0, 0.0, 0.0),
        Station::from_degrees(900.0, 60.0, 0.0),
        Station::from_degrees(1500.0, 60.0, 0.0),
    ])
    .expect("a path");
    let casing = Some(CasingPipe { od_m: 0.244475, yield_strength_Pa: Some(80e3 * PSI_PA) });
    let hole = Hole::new(vec![
        HoleSection { casing, ..HoleSection::casing(0.0..1000.0, 0.220498, 0.2) },
        HoleSection::open(1000.0..1500.0, 0.2159, 0.3),
    ])
    .expect("a hole");
    let joints = Some(ToolJoints { od_m: 0.1683, spacing_m: 9.6 });
    let pipe = ComponentSpec {
        joints,
        yield_strength_Pa: Some(135e3 * PSI_PA),
        ..ComponentSpec::uniform("pipe", 0.127, 0.1086, ToSurface, steel())
    };
    let collar = ComponentSpec::uniform("collar", 0.165, 0.0714, Metres(60.0), steel());
    let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3));
    Setup {
        well: Well { path, hole },
        string: string.component(collar).component(pipe),
        mud: Mud::of_density(1200.0),
        fluids: Default::default(),
        rig: Default::default(),
        ends: Default::default(),
        buckling: Default::default(),
    }
}

fn operations() -> Vec<Operation> {
    let turn = 4.0 * PI;
    vec![
        Operation::trip_out(1500.0),
        Operation::trip_in(1500.0),
        Operation::rotate_off_bottom(1500.0).rotary_speed_rad_per_s(turn),
        Operation::slide(1500.0)
            .weight_on_bit_N(3e4)
            .bit_torque_N_m(2e3)
            .rate_of_penetration_m_per_s(3e-3),
        Operation::drill(1500.0)
            .rotary_speed_rad_per_s(turn)
            .weight_on_bit_N(5e4)
            .bit_torque_N_m(3e3)
            .rate_of_penetration_m_per_s(5e-3),
    ]
}

/// Drilled from the shoe, tripped twice, turned for an hour at the end: the shares of the points
/// add up to the stages by hand, and those of frictions other than the expected one are not
/// counted. Limits are those of each solution.
#[test]
fn shares_add_up_to_the_campaign() {
    let (setup, operations) = (setup(), operations());
    let settings =
        CampaignSettings { round_trips: 2.0, off_bottom_s: 3600.0, ..CampaignSettings::default() };
    let broomstick = Broomstick::new(
        &setup,
        &Frictions::default(),
        operations.clone(),
        DEPTHS_M.to_vec(),
        vec![Statics::Soft],
    )
    .expect("a broomstick")
    .with_campaign(&settings)
    .expect("casing");
    let own = broomstick.campaign_tasks();
    let mut points: Vec<_> =
        own.iter().flat_map(|task| broomstick.solve_at(task, &[FrictionLevel::Expected])).collect();
    points.extend(broomstick.tasks().iter().flat_map(|task| broomstick.solve(task)));
    let mut answers =
        points.iter().map(|point| (point, point.outcome.as_ref().expect("an answer")));
    let shares: Vec<_> = answers
        .clone()
        .filter_map(|(point, answer)| Some((point.friction, answer.share.clone()?)))
        .collect();
    assert!(shares.iter().all(|(friction, _)| *friction == FrictionLevel::Expected));
    // From where the assembly is in the hole the campaign has depths of its own, a twentieth of the
    // way apart at most.
    let trips = own.iter().filter(|task| task.operation.kind == OperationKind::TripIn);
    let mut depths_m: Vec<f64> = trips.map(|task| task.operation.bit_depth_m).collect();
    depths_m.extend(DEPTHS_M);
    depths_m.sort_by(f64::total_cmp);
    assert_eq!((depths_m.len(), depths_m[0]), (5 + 7 + 4 + 4 + 1, 61.3));
    assert!(depths_m.windows(2).all(|pair| pair[1] - pair[0] <= 1500.0 / 20.0 + 1e-9));
    // Drilling from 1000 m: of 971 m on; all depths of two trips, and once off bottom.
    let drilled_m = lengths_m(&depths_m, 1000.0);
    let drilled = drilled_m.iter().filter(|length_m| **length_m > 0.0).count();
    assert_eq!(shares.len(), drilled + 2 * depths_m.len() + 1);
    assert!((drilled_m.iter().sum::<f64>() - 500.0).abs() < 1e-9);
    let mut all = shares[0].1.clone();
    for (_, share) in &shares[1..] {
        all.merge(share);
    }

    let mut wear = CasingWear::new(&setup.well.hole, &WearFactors::default()).expect("casing");
    let mut damage = Damage::default();
    let mut stage = |operation: &Operation, bit_depth_m: f64, duration_s: f64| {
        let model = setup.at(bit_depth_m).expect("a model");
        let operation = Operation { bit_depth_m, ..*operation };
        let solved = soft_string(&model, &operation).expect("an answer");
        let solution = (&solved).into();
        let stage = Stage { model: &model, operation: &operation, solution, duration_s };
        wear.add(&stage);
        damage.add(&stage, &settings.fatigue);
    };
    for (bit_depth_m, length_m) in depths_m.iter().zip(&drilled_m) {
        stage(&operations[4], *bit_depth_m, length_m / 5e-3);
    }
    let lengths_m = lengths_m(&depths_m, 0.0);
    assert!((lengths_m.iter().sum::<f64>() - 1500.0).abs() < 1e-9);
    for (bit_depth_m, length_m) in depths_m.iter().zip(lengths_m) {
        for trip in &operations[..2] {
            stage(trip, *bit_depth_m, 2.0 * length_m / 0.3);
        }
    }
    stage(&operations[2], 1500.0, 3600.0);
    let casings = broomstick.campaign().expect("a campaign").casings(&all);
    assert_eq!(casings.len(), 200);
    for (found, expected) in casings.iter().zip(wear.rows()) {
        let [found, expected] = [found, &expected].map(|row| row.worn_m3_per_m);
        assert!((found - expected).abs() <= 1e-12 * expected, "{found} for {expected}");
    }
    assert!(all.damage.rows().count() > 100);
    for (found, expected) in all.damage.rows().zip(damage.rows()) {
        assert_eq!(
            (found.component, found.from_lower_end_m),
            (expected.component, expected.from_lower_end_m)
        );
        let [found, expected] = [found.damage, expected.damage];
        assert!((found - expected).abs() <= 1e-12 * expected, "{found} for {expected}");
    }

    // The damage per hour at the end: the worst place of the pipe, by the same curve as the damage.
    let [rate] = &all.rates[..] else { panic!("the pipe alone has a grade: {:?}", all.rates) };
    assert_eq!(rate.component, 2);
    let hours = drilled_m[depths_m.len() - 1] / 5e-3 / 3600.0;
    let worst = shares.iter().filter(|(_, share)| !share.rates.is_empty());
    let worst =
        worst.map(|(_, share)| share.damage.worst(2).expect("the pipe").damage).sum::<f64>();
    assert!((rate.damage_per_hour * hours - worst).abs() <= 1e-12 * worst);

    let (point, _) = answers.next_back().expect("a point");
    let model = broomstick.setup(point.friction).at(1500.0).expect("a model");
    let solved = soft_string(&model, &operations[4]).expect("an answer");
    let expected = Judge::default().soft(&model, &operations[4], &solved);
    assert_eq!(point.checks, expected);
    assert!(expected.worst(CheckKind::VonMises).is_some());
}

/// A section that is drilled from a given depth, by sliding where nothing turns.
#[test]
fn a_campaign_from_a_depth() {
    let setup = setup();
    let operations = operations()[..4].to_vec();
    let settings = CampaignSettings {
        drilled_from_m: Some(1400.0),
        round_trips: 0.0,
        ..CampaignSettings::default()
    };
    let frictions = Frictions::default();
    let with_campaign =
        Broomstick::new(&setup, &frictions, operations, DEPTHS_M.to_vec(), vec![Statics::Soft])
            .expect("a broomstick")
            .with_campaign(&settings)
            .expect("casing");
    let tasks = with_campaign.tasks();
    let solved = tasks.iter().flat_map(|task| with_campaign.solve(task));
    let shares: Vec<_> = solved
        .filter_map(|point| Some((point.operation, point.bit_depth_m, point.outcome.ok()?.share?)))
        .collect();
    let [(kind, depth_m, share)] = &shares[..] else { panic!("one share: {}", shares.len()) };
    assert_eq!((*kind, *depth_m), (OperationKind::Slide, 1500.0));
    // It slides by 38 m there without rotation.
    assert!(share.damage.rows().all(|row| row.damage == 0.0));
    let casings = with_campaign.campaign().expect("a campaign").casings(share);
    assert!(casings.iter().any(|casing| casing.worn_m3_per_m > 0.0));
}

/// Returns the whole of a campaign: the shares of its points and of its other tasks.
fn whole(operations: &[Operation], depths_m: &[f64], settings: &CampaignSettings) -> Share {
    let frictions = Frictions::default();
    let (operations, models) = (operations.to_vec(), vec![Statics::Soft]);
    let with_campaign =
        Broomstick::new(&setup(), &frictions, operations, depths_m.to_vec(), models)
            .expect("a broomstick")
            .with_campaign(settings)
            .expect("casing");
    let mut all = Share::default();
    for task in with_campaign.tasks().iter().chain(&with_campaign.campaign_tasks()) {
        for point in with_campaign.solve_at(task, &[FrictionLevel::Expected]) {
            let Some(share) = point.outcome.expect("an answer").share else { continue };
            if all == Share::default() {
                all = share;
            } else {
                all.merge(&share);
            }
        }
    }
    all
}

/// Returns the deepest groove of a campaign, m.
fn groove_m(share: &Share) -> f64 {
    let wear = CasingWear::new(&setup().well.hole, &WearFactors::default()).expect("casing");
    let rows = wear.with(&share.worn).rows();
    rows.iter().map(|row| row.groove_m.expect("a groove")).fold(0.0, f64::max)
}

/// Returns the worn volume of a campaign, m³.
fn volume_m3(share: &Share) -> f64 {
    let wear = CasingWear::new(&setup().well.hole, &WearFactors::default()).expect("casing");
    wear.with(&share.worn).rows().iter().map(|row| 5.0 * row.worn_m3_per_m).sum()
}

/// The hole above the shallowest depth of a plan is drilled and tripped through too: a plan of one
/// depth has the wear and damage of a plan of forty, to 2 % of the volume and 5 % of the sum of
/// damage; the deepest groove, a local value, to 10 %.
#[test]
fn the_hole_above_the_shallowest_depth_counts() {
    let settings = CampaignSettings {
        drilled_from_m: Some(300.0),
        round_trips: 5.0,
        off_bottom_s: 3600.0,
        ..CampaignSettings::default()
    };
    let all: Vec<f64> = (1..=40).map(|step| 300.0 + 30.0 * f64::from(step)).collect();
    let fine = whole(&operations(), &all, &settings);
    for depths_m in [&[1500.0][..], &[1400.0, 1500.0], &[700.0, 1500.0]] {
        let coarse = whole(&operations(), depths_m, &settings);
        let damage = |share: &Share| share.damage.rows().map(|row| row.damage).sum::<f64>();
        let numbers = |share: &Share| [volume_m3(share), groove_m(share), damage(share)];
        let pairs = numbers(&coarse).into_iter().zip(numbers(&fine)).zip([0.02, 0.1, 0.05]);
        for ((found, expected), tolerance) in pairs {
            let apart = found / expected - 1.0;
            assert!(apart.abs() < tolerance, "{depths_m:?}: {found} for {expected}");
        }
    }
}

/// A campaign includes an operation that its plan does not list, with the given set points.
#[test]
fn an_operation_that_the_plan_does_not_list_counts() {
    let settings = |operations: Vec<Operation>| CampaignSettings {
        off_bottom_s: 7200.0,
        operations,
        ..CampaignSettings::default()
    };
    let listed = whole(&operations(), &DEPTHS_M, &settings(Vec::new()));
    let expected = groove_m(&listed);
    assert!(expected > 0.0);
    for some in [&operations()[4..], &operations()[..1]] {
        let found = whole(some, &DEPTHS_M, &settings(operations()));
        assert!((groove_m(&found) / expected - 1.0).abs() < 1e-9);
        // Without them it is less, and the campaign names the parts that it does not count.
        let without = groove_m(&whole(some, &DEPTHS_M, &settings(Vec::new())));
        assert!(without < 0.99 * expected, "{without} for {expected}");
    }
    let parts = |operations: Vec<Operation>, settings: &CampaignSettings| {
        Campaign::new(settings, &setup(), &operations, &DEPTHS_M).expect("casing").parts()
    };
    let all = parts(operations(), &settings(Vec::new()));
    let hours = all.iter().map(|part| part.duration_s.expect("counted") / 3600.0);
    let expected = [500.0 / 5e-3, 1500.0 / 0.3, 1500.0 / 0.3, 7200.0].map(|time_s| time_s / 3600.0);
    assert!(hours.zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-9));
    let some = parts(vec![Operation::trip_in(1500.0)], &settings(Vec::new()));
    let counted: Vec<bool> = some.iter().map(|part| part.duration_s.is_some()).collect();
    assert_eq!(counted, [false, true, false, false]);
    // Neither is an operation without a speed.
    let still = Operation { rate_of_penetration_m_per_s: 0.0, ..operations()[4] };
    let some = parts(vec![still], &settings(operations()[..3].to_vec()));
    let counted: Vec<bool> = some.iter().map(|part| part.duration_s.is_some()).collect();
    assert_eq!(counted, [false, true, true, true]);
}

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
    Broomstick, CampaignSettings, FrictionLevel, Frictions, Setup, Stage, Statics,
    fatigue::Damage,
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

/// Drilled from the shoe, tripped twice, turned for an hour at the end: the shares of the points add up to the
/// stages by hand, and those of the frictions that are not expected count nothing. Limits are those of each
/// solution.
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
    let points: Vec<_> =
        broomstick.tasks().iter().flat_map(|task| broomstick.solve(task)).collect();
    let mut answers = points.iter().map(|of| (of, of.outcome.as_ref().expect("an answer")));
    let shares: Vec<_> = answers
        .clone()
        .filter_map(|(of, answer)| Some((of.friction, answer.share.clone()?)))
        .collect();
    assert!(shares.iter().all(|(friction, _)| *friction == FrictionLevel::Expected));
    // Drilling from 1000 m: of the depth of 900 m to 1050 m, and of the two below it; four depths of two trips,
    // and once off bottom.
    assert_eq!(shares.len(), 3 + 2 * 4 + 1);
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
    for (bit_depth_m, length_m) in [(900.0, 50.0), (1200.0, 300.0), (1500.0, 150.0)] {
        stage(&operations[4], bit_depth_m, length_m / 5e-3);
    }
    for (bit_depth_m, length_m) in
        [(400.0, 250.0), (900.0, 400.0), (1200.0, 300.0), (1500.0, 150.0)]
    {
        for trip in &operations[..2] {
            stage(trip, bit_depth_m, 2.0 * length_m / 0.3);
        }
    }
    stage(&operations[2], 1500.0, 3600.0);
    let casings = broomstick.campaign().expect("a campaign").casings(&all);
    assert_eq!(casings.len(), 200);
    for (found, expected) in casings.iter().zip(wear.rows()) {
        let [found, expected] = [found, &expected].map(|of| of.worn_m3_per_m);
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

    // What an hour costs at the end: the worst place of the pipe, of the same curve as the damage.
    let [rate] = &all.rates[..] else { panic!("the pipe alone has a grade: {:?}", all.rates) };
    assert_eq!(rate.component, 2);
    let hours = 150.0 / 5e-3 / 3600.0;
    let worst = shares.iter().filter(|(_, of)| !of.rates.is_empty());
    let worst = worst.map(|(_, of)| of.damage.worst(2).expect("the pipe").damage).sum::<f64>();
    assert!((rate.damage_per_hour * hours - worst).abs() <= 1e-12 * worst);

    let (point, _) = answers.next_back().expect("a point");
    let model = broomstick.setup(point.friction).at(1500.0).expect("a model");
    let solved = soft_string(&model, &operations[4]).expect("an answer");
    let expected = Judge::default().soft(&model, &operations[4], &solved);
    assert_eq!(point.checks, expected);
    assert!(expected.worst(CheckKind::VonMises).is_some());
}

/// A section that is drilled from a depth of the case's own, by sliding where nothing turns.
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
    let of =
        Broomstick::new(&setup, &frictions, operations, DEPTHS_M.to_vec(), vec![Statics::Soft])
            .expect("a broomstick")
            .with_campaign(&settings)
            .expect("casing");
    let tasks = of.tasks();
    let solved = tasks.iter().flat_map(|task| of.solve(task));
    let shares: Vec<_> = solved
        .filter_map(|of| Some((of.operation, of.bit_depth_m, of.outcome.ok()?.share?)))
        .collect();
    let [(kind, depth_m, share)] = &shares[..] else { panic!("one share: {}", shares.len()) };
    assert_eq!((*kind, *depth_m), (OperationKind::Slide, 1500.0));
    // It slides by 100 m and turns not at all.
    assert!(share.damage.rows().all(|of| of.damage == 0.0));
    let casings = of.campaign().expect("a campaign").casings(share);
    assert!(casings.iter().any(|of| of.worn_m3_per_m > 0.0));
}

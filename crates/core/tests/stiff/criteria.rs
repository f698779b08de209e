//! Predictions of the buckling criteria compared with the shape of the stiff string. It prints the
//! table of `docs/src/theory/stiff-string.md`:
//! `cargo test -p wholestring --test stiff criteria -- --nocapture`.

use std::f64::consts::{PI, TAU};

use wholestring::{
    prelude::*,
    statics::{
        buckling::{Criterion, Place},
        stiff::StiffProfile,
    },
    string::{ComponentLength, ComponentSpec},
    well::Interpolation,
};

use crate::{common, nearest, pressed, settings, solve};

const LENGTH_M: f64 = 600.0;

/// Compression half-way down over Dawson and Paslay's load of a straight hole.
const PARTS: [f64; 7] = [0.8, 1.1, 1.4, 1.8, 2.2, 3.0, 4.0];

const CRITERIA: [Criterion; 3] =
    [Criterion::HeKyllingstad, Criterion::ChenLinCheatham, Criterion::WuJuvkamWold];

/// A climb beyond which the pipe snakes, and one beyond which it is a helix, rad.
const SNAKES: f64 = 0.1;
const ROUND: f64 = TAU;

/// Shape of a pipe, by a criterion or by the stiff string.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shape {
    Straight,
    Snake,
    Helix,
}

impl Shape {
    /// By a criterion.
    fn by(criterion: Criterion, place: &Place, compression_N: f64) -> Self {
        let [sinusoidal_N, helical_N] =
            place.loads_N(criterion, compression_N).expect("a clearance");
        match compression_N {
            force_N if force_N >= helical_N => Self::Helix,
            force_N if force_N >= sinusoidal_N => Self::Snake,
            _ => Self::Straight,
        }
    }

    /// By the range of the middle fifth around the hole, rad.
    fn of(goes_rad: f64) -> Self {
        match goes_rad {
            round if round > ROUND => Self::Helix,
            round if round > SNAKES => Self::Snake,
            _ => Self::Straight,
        }
    }
}

/// A hole of 8-1/2 in from one inclination to another, deg, without friction, with 5 in pipe in it.
fn pipe_in(from_deg: f64, to_deg: f64) -> Model {
    let stations = [[0.0, from_deg, 0.0], [LENGTH_M, to_deg, 0.0]];
    let path = common::path(&stations, Interpolation::MinimumCurvature);
    let pipe =
        ComponentSpec::uniform("pipe", 0.127, 0.1086, ComponentLength::ToSurface, common::steel());
    let hole = common::open_hole(0.2159, 0.0, LENGTH_M);
    common::model(path, hole, vec![pipe], common::mud(1200.0), LENGTH_M)
}

/// Range of the middle fifth around the hole, from one extreme to the other, rad.
fn goes_rad(profile: &StiffProfile) -> f64 {
    let middle = (0..profile.md_m.len())
        .filter(|node| (0.4..0.6).contains(&(profile.md_m[*node] / LENGTH_M)));
    let (mut at, mut last) = (0.0, None::<f64>);
    let [mut low, mut high] = [0.0_f64; 2];
    for climb in middle.filter_map(|node| profile.climb_rad[node]) {
        if let Some(last) = last {
            at += (climb - last + PI).rem_euclid(TAU) - PI;
        }
        last = Some(climb);
        (low, high) = (low.min(at), high.max(at));
    }
    high - low
}

/// Below the sinusoidal load of He and Kyllingstad, which includes the hole's curvature, the pipe
/// is straight in every hole; beyond it, it is not; at four times the load of a straight hole it is
/// a helix. In between, snake and helix are both stable: the state that is found is printed, and
/// not checked.
#[test]
fn criteria_beside_the_shape() {
    let holes = [
        ("level", [90.0, 90.0]),
        ("45 deg", [45.0, 45.0]),
        ("builds 2 deg/30 m", [60.0, 100.0]),
        ("drops 2 deg/30 m", [100.0, 60.0]),
    ];
    println!(
        "hole | F/Fs | He-Kyllingstad | Chen-Lin-Cheatham | Wu-Juvkam-Wold | found | goes, deg"
    );
    for (name, [from_deg, to_deg]) in holes {
        let model = pipe_in(from_deg, to_deg);
        let place = Place::above(&model, LENGTH_M, 0.5 * LENGTH_M);
        let [load_N, _] = place.loads_N(Criterion::ChenLinCheatham, 1.0).expect("a clearance");
        let middle_N = |profile: &StiffProfile| profile.tension_N[nearest(profile, 0.5 * LENGTH_M)];
        let hangs_N = middle_N(&solve(&model, &pressed(LENGTH_M, 0.0), &settings(1.5)));
        for part in PARTS {
            let operation = pressed(LENGTH_M, part * load_N + hangs_N);
            let found = solve(&model, &operation, &settings(1.5));
            let compression_N = -middle_N(&found);
            let predicted = CRITERIA.map(|by| Shape::by(by, &place, compression_N));
            let goes = goes_rad(&found);
            let shape = Shape::of(goes);
            let [hk, clc, wjw] = predicted;
            println!(
                "{name} | {part} | {hk:?} | {clc:?} | {wjw:?} | {shape:?} | {:.0}",
                goes.to_degrees()
            );
            assert_eq!(shape == Shape::Straight, hk == Shape::Straight, "{name} at {part}");
            assert!(part < 4.0 || shape == Shape::Helix, "{name} at {part}: {goes}");
        }
    }
}

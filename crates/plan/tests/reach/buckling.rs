//! Buckling along a reach: sinusoid and helix of vertical and of level holes.

use wholestring_verification::file;

use super::*;

/// A level hole is not vertical, locked up or not; one that begins vertical is there. The wall of
/// the level hole holds the pipe by 2.83 sqrt(EI w/r), the weight in a vertical one by 5.55 (EI
/// w²)^(1/3).
#[test]
fn a_level_hole_has_no_vertical_stretch() {
    let file = file("S5_reach.json");
    let level = setup(&file["inputs"], &[[0.0, 90.0], [100.0, 90.0]], 0.3);
    let turned = setup(&file["inputs"], &[[0.0, 0.0], [300.0, 0.0], [900.0, 90.0]], 0.3);
    let named = |setup: &Setup, depth_m: f64| {
        let slide = Operation::slide(depth_m).weight_on_bit_N(50e3);
        let all = margins(setup, &slide, &of_soft(HELIX)).expect("margins");
        all.iter().map(|margin| margin.limit).collect::<Vec<DepthLimit>>()
    };
    for depth_m in [1000.0, 20_000.0] {
        let limits = named(&level, depth_m);
        assert!(limits.contains(&DepthLimit::Helix), "{limits:?}");
        assert!(!limits.contains(&DepthLimit::VerticalHelix), "{limits:?}");
        assert!(named(&turned, depth_m).contains(&DepthLimit::VerticalHelix));
    }
}

/// In a vertical well the sinusoid of a pushed string is that of the vertical hole, which `run` and
/// `plan` report too; the one of an inclined hole is not met.
#[test]
fn a_vertical_hole_has_a_sinusoid_of_its_own() {
    let file = file("S5_reach.json");
    let vertical = setup(&file["inputs"], &[[0.0, 0.0], [1500.0, 0.0]], 0.3);
    let slide = Operation::slide(1500.0).weight_on_bit_N(50e3);
    let all = margins(&vertical, &slide, &of_soft(HELIX)).expect("margins");
    let margin = |limit| all.iter().find(|margin| margin.limit == limit).expect("it concerns");
    assert!(margin(DepthLimit::VerticalSinusoid).margin < 0.0, "{all:?}");
    assert_eq!(margin(DepthLimit::Sinusoid).margin, 1.0, "{all:?}");
}

/// The helix of no hole begins before its sinusoid: places are vertical or inclined for both shapes
/// alike, also in a hole that is nearly vertical.
#[test]
fn a_helix_begins_after_its_sinusoid() {
    let file = file("S5_reach.json");
    let (mut buckled, mut both) = (0, 0);
    let holes = [0.0, 0.3, 0.6, 1.0, 2.0, 4.0].map(|inclination| [inclination; 2]);
    // A curve holds the pipe of a hole that is nearly vertical.
    let curved = [[0.0, 2.0], [0.0, 5.0], [0.0, 10.0], [0.0, 20.0], [0.0, 40.0], [3.0, 0.0]];
    for inclination in holes.into_iter().chain(curved) {
        let [above, below] = inclination;
        let well = setup(&file["inputs"], &[[0.0, above], [1500.0, below]], 0.3);
        for weight_kN in (5..60).step_by(5).chain([80, 120, 200]) {
            let slide = Operation::slide(1500.0).weight_on_bit_N(1e3 * f64::from(weight_kN));
            let all = margins(&well, &slide, &of_soft(PLAIN)).expect("margins");
            let margin =
                |limit| all.iter().find(|margin| margin.limit == limit).map(|margin| margin.margin);
            for (sinusoid, helix) in [
                (DepthLimit::VerticalSinusoid, DepthLimit::VerticalHelix),
                (DepthLimit::Sinusoid, DepthLimit::Helix),
            ] {
                let (Some(first), Some(then)) = (margin(sinusoid), margin(helix)) else { continue };
                assert!(first <= then, "{inclination:?} deg, {weight_kN} kN: {first} {then}");
                buckled += usize::from(then < 0.0);
                both += usize::from(first < 0.0);
            }
        }
    }
    assert!(buckled > 20 && both > buckled, "{buckled} {both}");
}

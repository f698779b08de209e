//! Pictures and page of a bit test.

use std::f64::consts::{PI, TAU};

use super::*;
use crate::{DisplayUnit, Fact, Plot};
use crate::{
    bit_test_html,
    figure::{Mark, Sample},
};

const RADIUS_M: f64 = 0.1;

/// A bottom with a spiral of grooves.
fn bottom() -> Option<BottomPicture> {
    let radii: Vec<f64> = (0..20).map(|ring| 0.005 * (f64::from(ring) + 0.5)).collect();
    let angles: Vec<f64> = (0..72).map(|index| TAU * (f64::from(index) + 0.5) / 72.0).collect();
    let depth = |radius: f64, angle: f64| 0.03 - 0.2 * radius + 0.002 * (5.0 * angle).sin();
    let depths: Vec<f64> =
        radii.iter().flat_map(|radius| angles.iter().map(|angle| depth(*radius, *angle))).collect();
    BottomPicture::new(&radii, &angles, &depths)
}

/// Torque with a slope of 0.6 of the radius and an offset of 50 N·m, at two speeds and three
/// weights.
fn test() -> BitTest {
    let unit = |symbol: &str, factor| DisplayUnit { symbol: symbol.into(), factor };
    let alike = |symbol: &str, factor: f64| [(); 3].map(|()| unit(symbol, factor));
    let dimensions = [
        ("force", [unit("kN", 1e3), unit("t", 9806.65), unit("klbf", 4448.2216)]),
        ("torque", alike("kN·m", 1e3)),
        ("diameter", alike("mm", 1e-3)),
        ("rate of penetration", alike("m/h", 1.0 / 3600.0)),
        ("rotary speed", alike("rpm", PI / 30.0)),
        ("specific energy", alike("MPa", 1e6)),
    ];
    let mut points = Vec::new();
    // Unsorted: the pictures sort the points.
    for rotary_rad_per_s in [4.0 * PI, 2.0 * PI] {
        for weight_N in [30e3, 10e3, 20e3] {
            let depth_of_cut_m = 1e-3 * (weight_N / 10e3);
            points.push(BitTestPoint {
                weight_N,
                weight_std_N: 1e3,
                rotary_rad_per_s,
                rate_m_per_s: depth_of_cut_m * rotary_rad_per_s / TAU,
                torque_N_m: 50.0 + 0.6 * RADIUS_M * weight_N,
                torque_std_N_m: 100.0,
                depth_of_cut_m,
                specific_energy_Pa: 30e6,
                bottom: bottom(),
            });
        }
    }
    BitTest {
        head: PageHead {
            program: "wholestring".into(),
            title: "A </script> bit".into(),
            units: "si".into(),
            dimensions: dimensions.map(|(name, units)| (name.to_owned(), units)).into(),
            facts: vec![Fact {
                label: "Rock".into(),
                value: Cell::quantity(60e6, "specific energy"),
            }],
        },
        strength_Pa: 60e6,
        radius_m: RADIUS_M,
        torque_by_weight: Some([0.6 * RADIUS_M, 50.0]),
        points,
        message: Some("5 of 6 <points>".into()),
        page_tables: Vec::new(),
    }
}

fn plot(test: &BitTest, name: &str, units: &str) -> Plot {
    let mut plots = bit_test_plots(test, units).into_iter();
    plots.find(|plot| plot.name == name).expect("a picture")
}

#[test]
fn a_speed_is_a_curve_in_the_order_of_weight() {
    let figure = plot(&test(), "drill-off", "field").figure;
    assert_eq!(figure.shared.label, "Weight on bit, klbf");
    assert_eq!(figure.keys[0].name, "60 rpm");
    let curves: Vec<&Vec<(f64, f64)>> = figure.panels[0]
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Curve { points, .. } => Some(points),
            _ => None,
        })
        .collect();
    assert_eq!(curves.len(), 2);
    for (curve, turns_per_s) in curves.iter().zip([1.0, 2.0]) {
        for ((weight, rate), thousands) in curve.iter().zip([10.0, 20.0, 30.0]) {
            assert!((weight * 4448.2216 / (thousands * 1e3) - 1.0).abs() < 1e-12);
            let expected = thousands / 10.0 * 1e-3 * turns_per_s * 3600.0;
            assert!((rate / expected - 1.0).abs() < 1e-9, "{rate} m/h");
        }
    }
}

#[test]
fn the_line_of_torque_is_drawn_where_there_is_one() {
    let mut test = test();
    let keys = plot(&test, "drill-off", "si").figure.keys;
    let [.., fit, spread] = &keys[..] else {
        panic!("a legend");
    };
    assert!(matches!(spread.sample, Sample::Spread(_)));
    assert_eq!(fit.name, "torque by weight: 0.60 of the bit's radius");
    assert!(matches!(fit.sample, Sample::Line(..)));
    // One weight has no slope.
    test.torque_by_weight = None;
    assert_eq!(plot(&test, "drill-off", "si").figure.keys.len(), 3);
    test.points.clear();
    assert!(bit_test_plots(&test, "si").is_empty());
}

/// A torque of 1 kN·m spreads by 0.1 kN·m to either side.
#[test]
fn spreads_are_as_wide_as_they_are() {
    let figure = plot(&test(), "drill-off", "si").figure;
    let Mark::Bars { bars, .. } = &figure.panels[1].marks[1] else {
        panic!("the fit lies below, then bars");
    };
    // Each point has one along weight and one along torque.
    let [across, up] = [bars[0], bars[1]];
    assert!((across[1].0 - across[0].0 - 2.0).abs() < 1e-9 && across[0].1 == across[1].1);
    assert!((up[1].1 - up[0].1 - 0.2).abs() < 1e-9 && up[0].0 == up[1].0);
}

/// The corners of the square around a bottom contain colours alone, and every picture is complete.
#[test]
fn pictures_are_drawn() {
    let test = test();
    for plot in bit_test_plots(&test, "metric") {
        let svg = plot.figure.drawing().svg();
        let text = svg.split("base64,").next().unwrap_or_default();
        assert!(svg.ends_with("</svg>\n") && !text.contains("NaN"), "{}", plot.name);
    }
    let bottoms = plot(&test, "bottom-hole", "si").figure;
    assert_eq!(bottoms.panels.len(), 6);
    let first = &bottoms.panels[0];
    assert_eq!(first.axis.label, "Across, mm");
    assert_eq!(first.keys[0].name, "10 kN at 60 rpm");
    let Mark::Map(map) = &bottoms.panels[0].marks[0] else {
        panic!("a bottom is a map");
    };
    assert!(map.values[0].is_nan(), "a corner");
    let side = map.middles.len();
    let middle = map.values[side * side / 2 + side / 2];
    // 29.5 mm within the grooves' 2 mm, below a rim that is within the two outermost rings, 8.5 to
    // 13.5 mm.
    assert!((14.0..23.0).contains(&middle), "{middle} mm at the nose");
    let energy = plot(&test, "specific-energy", "si").figure;
    let strength = energy.panels[0].marks.last();
    assert!(
        matches!(strength, Some(Mark::OwnRule { at, .. }) if (at - 60.0).abs() < 1e-9),
        "{strength:?}"
    );
}

#[test]
fn the_page_holds_all_of_it_and_no_name_ends_its_element() {
    let test = test();
    let page = bit_test_html(&test);
    for units in ["si", "metric", "field"] {
        for name in ["drill-off", "specific-energy"] {
            assert_eq!(page.matches(&format!("id=\"{name}-{units}\"")).count(), 1);
        }
    }
    assert_eq!(page.matches("\"rotary_rad_per_s\":").count(), 6);
    assert!(!page.contains("<points>") && !page.contains("A </script>"));
    assert_eq!(page.matches("</script").count(), 2);
}

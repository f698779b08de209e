//! Pictures and page of a bit test.

use std::f64::consts::{PI, TAU};

use serde_json::json;
use wholestring::rock::DrillingResponse;
use wholestring_results::{BIT_TEST_VERSION, BitTestPoint};

use super::*;
use crate::{
    Plot, bit_test_html,
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
/// weights; a point is missing.
fn summary() -> BitTestSummary {
    let point = |outcome: Option<TrialOutcome>| BitTestPoint {
        point: "a <point>".into(),
        status: if outcome.is_some() { Status::Complete } else { Status::Interrupted },
        weight_on_bit_N: 1e4,
        rotary_speed_rad_per_s: TAU,
        outcome,
    };
    let mut points = vec![point(None)];
    // Unsorted: the pictures sort the points.
    for rotary_rad_per_s in [4.0 * PI, 2.0 * PI] {
        for weight_N in [30e3, 10e3, 20e3] {
            let depth_of_cut_m = 1e-3 * (weight_N / 10e3);
            points.push(point(Some(TrialOutcome {
                weight_on_bit_N: weight_N,
                rotary_speed_rad_per_s: rotary_rad_per_s,
                rate_of_penetration_m_per_s: depth_of_cut_m * rotary_rad_per_s / TAU,
                rate_of_penetration_error_m_per_s: None,
                depth_of_cut_m,
                torque_N_m: 50.0 + 0.6 * RADIUS_M * weight_N,
                torque_error_N_m: None,
                torque_std_N_m: 100.0,
                weight_borne_N: weight_N,
                weight_on_bit_std_N: 1e3,
                specific_energy_Pa: Some(30e6),
                mechanical_specific_energy_Pa: None,
                bricks_broken: 100,
                kinetic_fraction: 0.01,
                revolutions: 4.0,
                time_s: 4.0,
                averaging_time_s: 0.1,
            })));
        }
    }
    BitTestSummary {
        schema_version: BIT_TEST_VERSION,
        case: "A </script> bit".into(),
        settings: json!({
            "units": "si",
            "bit_test": {"mass_kg": 1e3, "revolutions": 4, "settle_revolutions": 1},
            "rock": {"name": "a </script>"},
        }),
        rock_strength_Pa: 60e6,
        bit_radius_m: RADIUS_M,
        response: DrillingResponse {
            torque_over_weight_m: Some(0.6 * RADIUS_M),
            torque_over_weight_and_radius: Some(0.6),
            torque_at_no_weight_N_m: Some(50.0),
            bottom_stiffness_N_per_m: None,
            specific_energy_Pa: None,
            specific_energy_over_strength: None,
        },
        checks: Vec::new(),
        points,
    }
}

fn test_of(summary: BitTestSummary) -> BitTest {
    let bottoms = summary.points.iter().map(|_| bottom()).collect();
    BitTest::new(summary, bottoms, None)
}

fn test() -> BitTest {
    test_of(summary())
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
            assert!((weight * 4_448.221_615_260_5 / (thousands * 1e3) - 1.0).abs() < 1e-12);
            let expected = thousands / 10.0 * 1e-3 * turns_per_s * 3600.0 / 0.3048;
            assert!((rate / expected - 1.0).abs() < 1e-9, "{rate} ft/h");
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
    test.summary.response.torque_over_weight_m = None;
    assert_eq!(plot(&test, "drill-off", "si").figure.keys.len(), 3);
    test.summary.points.clear();
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
    assert!(
        page.contains("1 of 7 points are missing")
            && !page.contains("<point>")
            && !page.contains("A </script>")
    );
    assert_eq!(page.matches("</script").count(), 2);
}

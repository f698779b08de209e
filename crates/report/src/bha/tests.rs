//! Pictures and page of a static BHA analysis.

use serde_json::json;
use wholestring::{
    operation::OperationKind,
    statics::assembly::{Contact, Largest, Sag, Touching},
};
use wholestring_results::{
    BHA, BHA_VERSION, BhaFound, BhaPart, BhaPoint, BhaState, BhaSummary, BhaVaried, Table,
};

use super::*;
use crate::{
    Plot, bha_html,
    figure::{Mark, Range},
};

/// Ten metres of assembly with a bend and blades, and pipe above.
fn summary() -> BhaSummary {
    let part = |name: &str, from_bit_m: f64, to_bit_m: f64, od_m: f64| BhaPart {
        name: name.into(),
        from_bit_m,
        to_bit_m,
        od_m,
        blades_m: None,
        joint_od_m: (name == "pipe").then_some(0.168),
        bend_m: None,
    };
    let contact = |at_m: f64, force_N| Contact {
        touching: Touching::Body,
        component: 0,
        name: "a </script> body".into(),
        md_m: 1000.0 - at_m,
        from_bit_m: [at_m, at_m],
        force_N,
        side_rad: 0.0,
    };
    let point = |inclination_rad: f64, sign: f64| BhaPoint {
        varied: BhaVaried::Inclination,
        toolface_rad: None,
        weight_on_bit_N: 1e5,
        inclination_rad,
        message: String::new(),
        found: Some(BhaFound {
            side_force_N: [sign * 1e3, 0.0],
            tilt_rad: [sign * 0.01, 0.0],
            largest_bending_moment_N_m: 5e3,
            largest_von_mises_stress_Pa: 9e7,
            sag_inclination_rad: None,
            sag_azimuth_rad: None,
        }),
    };
    let largest = |value| Largest { value, from_bit_m: 5.0 };
    BhaSummary {
        schema_version: BHA_VERSION,
        case: "A </script> bit".into(),
        settings: json!({"units": "si", "name": "a </script>"}),
        operation: OperationKind::Drill,
        bit_depth_m: 1000.0,
        weight_on_bit_N: 1e5,
        toolface_rad: None,
        inclination_rad: 0.5,
        azimuth_rad: 0.0,
        checks: Vec::new(),
        unchecked: Vec::new(),
        state: BhaState {
            side_force_N: [12e3, 500.0],
            tilt_rad: [0.01, 0.0],
            length_m: 10.0,
            solved_m: 30.0,
            largest_bending_moment_N_m: largest(5e3),
            largest_bending_stress_Pa: largest(5e7),
            largest_von_mises_stress_Pa: largest(9e7),
            contacts: vec![contact(0.0, [12e3, 500.0]), contact(9.0, [-8e3, 2e3])],
            sag: vec![Sag {
                component: 1,
                name: "motor".into(),
                from_bit_m: 9.5,
                md_m: 990.5,
                hole_inclination_rad: 0.5,
                inclination_rad: 0.001,
                azimuth_rad: None,
            }],
            errors: None,
            elements: 60,
            residual: 0.0,
            stable: false,
        },
        parts: vec![
            part("bit", 0.0, 0.3, 0.2159),
            BhaPart { bend_m: Some(1.8), ..part("motor", 0.3, 8.0, 0.17) },
            BhaPart { blades_m: Some([0.21, 0.4]), ..part("stabiliser", 8.0, 10.0, 0.17) },
            part("pipe", 10.0, 30.0, 0.127),
        ],
        build_rate_rad_per_m: 0.0,
        mean_side_force_N: None,
        holding_inclinations_rad: vec![0.55],
        holding_weights_N: Vec::new(),
        sweep: vec![point(0.1, 1.0), point(1.0, -1.0)],
        missing: 0,
    }
}

/// Nodes every half metre.
fn nodes() -> Table {
    let mut table = Table::with_columns(BHA);
    for node in 0..=60 {
        table.append(
            &[("component", &["a <point>"])],
            &[
                ("from_bit_m", &[0.5 * f64::from(node)]),
                ("hole_radius_m", &[0.108]),
                ("offset_high_m", &[-0.01]),
                ("offset_right_m", &[0.002]),
                ("bending_moment_high_N_m", &[3e3]),
                ("bending_moment_right_N_m", &[4e3]),
                ("bending_stress_Pa", &[5e7]),
                ("von_mises_stress_Pa", &[9e7]),
            ],
        );
    }
    table
}

fn bha_of(nodes: &Table) -> Bha {
    Bha::new(summary(), nodes, None)
}

fn bha() -> Bha {
    bha_of(&nodes())
}

fn plot(name: &str, units: &str) -> Plot {
    let mut plots = bha_plots(&bha(), units).into_iter();
    plots.find(|plot| plot.name == name).expect("a picture")
}

/// The hole is drawn to scale in its unit; blades extend over their body; forces appear on the side
/// that they press.
#[test]
fn views_are_to_scale() {
    let figure = plot("views", "field").figure;
    let Range::Fixed(_, to) = figure.shared.range else { panic!("an extent") };
    assert!((to * 0.3048 - 11.0).abs() < 1e-9);
    // 160 mm for 11 m, 46 mm for 2.7 radii.
    let says = figure.keys.last().expect("keys").name.as_str();
    assert_eq!(says, "drawn 11 times as wide as long");
    let bands = |marks: &[Mark]| -> Vec<f64> {
        marks
            .iter()
            .filter_map(|mark| match mark {
                Mark::Band { points, .. } => Some(0.0254 * (points[0].2 - points[0].1)),
                _ => None,
            })
            .collect()
    };
    let side = bands(&figure.panels[0].marks);
    for od_m in [0.2159, 0.17, 0.21, 0.127] {
        assert!(side.iter().any(|wide| (wide - od_m).abs() < 1e-9), "{od_m} in {side:?}");
    }
    let names = |panel: usize| -> Vec<(String, f64)> {
        let marks = figure.panels[panel].marks.iter();
        marks
            .filter_map(|mark| match mark {
                Mark::Name { at, text } => Some((text.clone(), at.1)),
                _ => None,
            })
            .collect()
    };
    let [bit, blades] = &names(0)[..] else { panic!("two forces: {:?}", names(0)) };
    assert!(bit.0 == "2.7 klbf" && bit.1 > 0.0, "{bit:?}");
    assert!(blades.1 < 0.0, "{blades:?}");
    // The bit hardly presses to the right.
    assert_eq!(names(1).len(), 1);
}

#[test]
fn pictures_are_drawn() {
    for units in ["si", "metric", "field"] {
        for plot in bha_plots(&bha(), units) {
            let svg = plot.figure.drawing().svg();
            assert!(svg.ends_with("</svg>\n") && !svg.contains("NaN"), "{}", plot.name);
        }
    }
    let keys = plot("inclination", "si").figure.keys;
    assert!(keys.iter().any(|key| key.name == "holds at 31.5 °"), "{keys:?}");
    let empty = bha_of(&Table::with_columns(BHA));
    assert!(bha_plots(&empty, "si").is_empty());
}

#[test]
fn the_page_holds_all_of_it_and_no_name_ends_its_element() {
    let page = bha_html(&bha());
    for units in ["si", "metric", "field"] {
        for name in ["views", "bending", "inclination"] {
            assert_eq!(page.matches(&format!("id=\"{name}-{units}\"")).count(), 1);
        }
    }
    assert!(!page.contains("<point>") && !page.contains("A </script>"));
    assert_eq!(page.matches("</script").count(), 2);
}

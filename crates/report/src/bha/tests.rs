//! Pictures and page of a static BHA analysis.

use super::*;
use crate::{
    Cell, DisplayUnit, Fact, Place, Plot, bha_html,
    figure::{Mark, Range},
};

/// Ten metres of assembly with a bend and blades, and pipe above.
fn bha() -> Bha {
    let unit = |symbol: &str, factor| DisplayUnit { symbol: symbol.into(), factor };
    let alike = |symbol: &str, factor: f64| [(); 3].map(|()| unit(symbol, factor));
    let dimensions = [
        ("force", [unit("kN", 1e3), unit("t", 9806.65), unit("klbf", 4448.2216)]),
        ("torque", alike("kN·m", 1e3)),
        ("diameter", [unit("mm", 1e-3), unit("mm", 1e-3), unit("in", 0.0254)]),
        ("length", [unit("m", 1.0), unit("m", 1.0), unit("ft", 0.3048)]),
        ("angle", alike("°", std::f64::consts::PI / 180.0)),
        ("pressure", alike("MPa", 1e6)),
    ];
    let from_bit_m: Vec<f64> = (0..=60).map(|node| 0.5 * f64::from(node)).collect();
    let flat = |value: f64| vec![value; from_bit_m.len()];
    let part = |name: &str, from_bit_m: f64, to_bit_m: f64, od_m: f64| BhaPart {
        name: name.into(),
        from_bit_m,
        to_bit_m,
        od_m,
        blades_m: None,
        is_jointed: name == "pipe",
        bend_m: None,
    };
    Bha {
        head: PageHead {
            program: "wholestring".into(),
            title: "A </script> bit".into(),
            units: "si".into(),
            dimensions: dimensions.map(|(name, units)| (name.to_owned(), units)).into(),
            facts: vec![Fact {
                label: "Weight on bit".into(),
                value: Cell::quantity(1e5, "force"),
            }],
        },
        tendency: ["si", "metric", "field"].map(|units| vec![format!("It drops, in {units}")]),
        message: Some("a <point> lacks".into()),
        parts: vec![
            part("bit", 0.0, 0.3, 0.2159),
            BhaPart { bend_m: Some(1.8), ..part("motor", 0.3, 8.0, 0.17) },
            BhaPart { blades_m: Some([0.21, 0.4]), ..part("stabiliser", 8.0, 10.0, 0.17) },
            part("pipe", 10.0, 30.0, 0.127),
        ],
        length_m: 10.0,
        hole_radius_m: flat(0.108),
        offset_m: [flat(-0.01), flat(0.002)],
        moment_N_m: [flat(3e3), flat(4e3)],
        bending_stress_Pa: flat(5e7),
        von_mises_stress_Pa: flat(9e7),
        contacts: vec![
            BhaContact { at_m: 0.0, force_N: [12e3, 500.0] },
            BhaContact { at_m: 9.0, force_N: [-8e3, 2e3] },
        ],
        sensors_m: vec![9.5],
        sweeps: vec![BhaSweep {
            name: "inclination".into(),
            title: "Inclination".into(),
            dimension: "angle".into(),
            points: [(0.1, 1.0), (1.0, -1.0)]
                .map(|(value, sign)| BhaSweepPoint {
                    value,
                    side_force_N: [sign * 1e3, 0.0],
                    tilt_rad: [sign * 0.01, 0.0],
                })
                .to_vec(),
            now: None,
            zeros: vec![0.55],
        }],
        from_bit_m,
        page_tables: vec![PageTable {
            place: Place::Results,
            title: "Contacts".into(),
            heads: vec!["Component".into(), "Force".into()],
            rows: vec![vec![Cell::Text("bit".into()), Cell::quantity(12e3, "force")]],
        }],
    }
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
    let empty = Bha { from_bit_m: Vec::new(), ..bha() };
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

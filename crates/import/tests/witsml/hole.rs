//! Geometry of the hole, the runs in it and its mud.

use crate::{component, geometry, one_series, refusal, section, station, text_of, values};

#[test]
fn the_hole_is_the_innermost_wall_at_each_depth() {
    let inside = |inches: f64| format!("<idSection uom='in'>{inches}</idSection>");
    // A liner hangs in the casing; the open hole is listed from the surface.
    let sections = section("open hole", 0.0, 4000.0, &inside(6.0))
        + &section("liner", 1900.0, 3000.0, &inside(6.276))
        + &section("casing", 0.0, 2000.0, &inside(8.681))
        + &section("riser", 0.0, 100.0, &inside(19.0));
    let text = text_of(&geometry(&sections));
    assert_eq!(values(&text, "kind")[..3], ["\"casing\"", "\"casing\"", "\"open\""]);
    assert_eq!(values(&text, "to"), ["\"1900 m\"", "\"3000 m\"", "\"4000 m\""]);
    assert_eq!(values(&text, "diameter"), ["\"8.681 in\"", "\"6.276 in\"", "\"6 in\""]);
    assert!(
        text.contains("the riser in line 1 from 0 m to 100 m: hidden behind other sections"),
        "{text}"
    );
    // Casing without an inside diameter, by its size and weight.
    let casing = section(
        "casing",
        0.0,
        900.0,
        "<odSection uom='in'>9.625</odSection>\
                         <wtPerLen uom='lbm/ft'>40</wtPerLen>",
    );
    assert_eq!(values(&text_of(&geometry(&casing)), "casing"), ["\"9-5/8 in 40.0 lb/ft\""]);
    let unknown = text_of(&geometry(&casing.replace(">40<", ">41<")));
    assert!(
        unknown.contains("no casing of API Spec 5CT has its odSection of 9.625 in"),
        "{unknown}"
    );
    let blow_out = section("blow out preventer", 0.0, 20.0, &inside(18.75))
        + &section("casing", 0.0, 900.0, &inside(8.681));
    assert!(text_of(&geometry(&blow_out)).contains("the section of 'blow out preventer'"));
}

#[test]
fn a_gap_in_the_hole_makes_no_green_case() {
    let inside = "<idSection uom='in'>8.5</idSection>";
    let sections =
        section("casing", 0.0, 900.0, inside) + &section("open hole", 950.0, 1800.0, inside);
    let text = text_of(&geometry(&sections));
    assert!(text.contains("the hole above 950 m"), "{text}");
    assert_eq!(values(&text, "from"), ["\"950 m\""]);
    let below = text_of(&geometry(&section("open hole", 950.0, 1800.0, inside)));
    assert_eq!(values(&below, "from"), ["\"950 m\""]);
    // Rounded to the centimetre, they meet.
    let met = section("casing", 0.0, 900.0, inside) + &section("open hole", 900.01, 1800.0, inside);
    assert!(values(&text_of(&geometry(&met)), "from").is_empty());
    for (sections, reason) in [
        (
            section("casing", 900.0, 900.0, inside),
            "the mdBottom 900 m is out of range; expected more",
        ),
        (section("", 0.0, 900.0, inside), "typeHoleCasing of this section is missing"),
        (section("tubing", 0.0, 900.0, inside), "in which a string moves is missing"),
        (
            section("casing", 0.0, 900.0, "<factFric>30</factFric>"),
            "the factFric 30 is out of range; expected 0 to 2",
        ),
    ] {
        let message = refusal(&geometry(&sections));
        assert!(message.contains(reason), "{message}");
    }
}

#[test]
fn a_run_gives_what_can_be_believed() {
    let run = |more: &str| {
        let object = format!(
            "<bhaRun uid='1'><name>7</name><drillingParams uid='1'><mdHoleStop uom='m'>2000\
             </mdHoleStop>{more}</drillingParams></bhaRun>"
        );
        text_of(&one_series("bhaRun", &object))
    };
    let text = run("<rpmAv uom='rpm'>100</rpmAv><wtMud uom='lbm/ft3'>0.14</wtMud>");
    assert!(
        text.contains(
            "the wtMud of 0.14 lbm/ft3 in line 1: 0.002 sg is outside the range of \
         muds"
        ),
        "{text}"
    );
    assert_eq!(values(&text, "kind"), [r#"["trip_out", "trip_in", "rotate_off_bottom"]"#]);
    let loads = |up: f64, down: f64| {
        run(&format!(
            "<hkldRot uom='klbf'>150</hkldRot><hkldUp uom='klbf'>{up}</hkldUp>\
             <hkldDn uom='klbf'>{down}</hkldDn>"
        ))
    };
    assert!(loads(200.0, 200.0).contains("do not decrease in this order, as friction requires"));
    assert!(loads(200.0, 120.0).contains("were read with the bit at its mdHoleStop, 2000 m"));
    let none = run("<hkldRot uom='kN'>0</hkldRot><tqOffBotAv uom='kN.m'>-2</tqOffBotAv>");
    for note in
        ["the hkldRot of 0 kN in line 1: a reading is more", "the tqOffBotAv of -2 kN.m in line 1:"]
    {
        assert!(none.contains(note), "{none}");
    }
    let unknown = run("<wobAv uom='bananas'>100</wobAv>");
    assert!(unknown.contains("wobAv in line 1: 'bananas' is not a unit of force"), "{unknown}");
}

#[test]
fn the_last_fluid_of_a_report_is_the_mud() {
    let fluid = |density: &str, more: &str| {
        format!("<fluid uid='1'><density uom='g/cm3'>{density}</density>{more}</fluid>")
    };
    let rheology = "<pv uom='cP'>20</pv><yp uom='lbf/100ft2'>15</yp>";
    let report = |fluids: &str| {
        one_series("mudReport", &format!("<mudReport uid='1'><name>M</name>{fluids}</mudReport>"))
    };
    let text = text_of(&report(&(fluid("1.2", "") + &fluid("1.3", rheology))));
    assert_eq!(values(&text, "density"), ["\"1.3 g/cm3\""]);
    assert_eq!(values(&text, "rheology"), ["\"bingham\""]);
    assert!(text.contains("of 2 fluids of mudReport 'M' the mud is the last"));
    let none = text_of(&report(&fluid("0", rheology)));
    assert!(
        none.contains("none of its fluids has a density")
            && none.contains("# Missing: the density")
    );
}

#[test]
fn wells_that_differ_are_named() {
    let mixed = "<all xmlns='http://www.witsml.org/schemas/1series' version='1.4.1.1'><trajectory>\
                 <nameWell>A</nameWell><name>T</name>"
        .to_owned()
        + &station("0", "0", "0")
        + &station("100", "0", "0")
        + "</trajectory><tubular><nameWell>B</nameWell><name>S</name>"
        + &component("bit", "", "")
        + "</tubular></all>";
    let text = text_of(&mixed);
    assert!(text.contains("tubular 'S' is of the well 'B', others of 'A'"), "{text}");
    assert_eq!(values(&text, "name"), ["\"A\""]);
}

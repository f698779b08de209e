//! Objects in a file and their combination.

use wholestring_import::{Choices, Input, contents};

use crate::{
    WELL, WELL_21, assert_solvable, component, imported, of_samples, one_series, refusal, sample,
    station, text_of, trajectory, tubular,
};

#[test]
fn four_objects_of_1_4_1_1_make_a_case() {
    let text = of_samples("own", &WELL);
    insta::assert_snapshot!("well", text);
    assert_solvable(&text);
}

#[test]
fn five_objects_of_2_1_make_a_case() {
    let text = of_samples("own", &WELL_21);
    insta::assert_snapshot!("well_21", text);
    assert_solvable(&text);
}

#[test]
fn published_samples() {
    for name in [
        "equinor-bhaRun",
        "equinor-trajectory",
        "equinor-tubular",
        "hashmap-trajectory",
        "welleng-tubular",
    ] {
        insta::assert_snapshot!(name, of_samples("witsml-1.4.1.1", &[&format!("{name}.xml")]));
    }
    let two = of_samples("witsml-2.0", &["hashmap-trajectory20.xml"]);
    insta::assert_snapshot!("hashmap-trajectory20", two);
}

#[test]
fn check_says_what_a_file_holds() {
    let mut text = String::new();
    for (folder, name) in [
        ("own", "witsml-trajectory.xml"),
        ("own", "witsml-bharun.xml"),
        ("own", "witsml21-tubular.xml"),
        ("own", "witsml21-fluids.xml"),
        ("witsml-1.4.1.1", "equinor-tubular.xml"),
        ("witsml-2.0", "hashmap-trajectory20.xml"),
    ] {
        let bytes = sample(&format!("{folder}/{name}"));
        let found = contents(Input::of_bytes(name, &bytes)).unwrap();
        text.push_str(&format!("{name}: {}\n  {}\n", found.what, found.lines.join("\n  ")));
    }
    insta::assert_snapshot!("contents", text);
}

#[test]
fn other_objects_are_refused_by_their_names() {
    let wells = one_series("well", "<well uid='1'/><well uid='2'/>");
    assert_eq!(
        refusal(&wells),
        "a.xml: it is WITSML 1.4.1.1 and holds <well>; expected one of: trajectory, wbGeometry, \
         mudReport, tubular, bhaRun, log"
    );
    let well = "<Well xmlns='http://www.energistics.org/energyml/data/witsmlv2' schemaVersion='2.1'>\
                <a/></Well>";
    assert!(refusal(well).contains("WITSML 2.1 and holds <Well>"));
    assert!(refusal("<gpx><a/></gpx>").contains("XML with the root element <gpx>"));
    let empty = one_series("trajectory", "");
    assert!(refusal(&empty).contains("holds nothing"));
    let mixed = one_series("trajectory", "<trajectory uid='1'/><target uid='1'/>");
    assert!(refusal(&mixed).contains("has no station"));
}

#[test]
fn versions_are_told_by_the_root_or_its_namespace() {
    let stations = station("0", "0", "0") + &station("100", "0", "0");
    let version = |head: &str| {
        let file = format!(
            "<{head}><trajectory uid='1'><name>T</name>{stations}</trajectory></trajectorys>"
        );
        contents(Input::of_bytes("a.xml", file.as_bytes())).unwrap().what
    };
    assert_eq!(version("trajectorys xmlns='http://www.witsml.org/schemas/131'"), "WITSML 1.3.1.1");
    assert_eq!(version("trajectorys version='1.3.1.1'"), "WITSML 1.3.1.1");
    assert_eq!(version("trajectorys"), "WITSML of no version");
}

#[test]
fn units_are_those_of_each_number() {
    let mixed = "<trajectoryStation><md uom='ft'>1000</md><incl uom='rad'>0.1</incl>\
                 <azi uom='dega'>45</azi></trajectoryStation>";
    let text = text_of(&trajectory(&(station("0", "0", "0") + mixed)));
    assert!(text.contains("[\"1000 ft\", 5.72957795131, 45],"), "{text}");
    assert!(text.contains("of the stations are in ft and m, deg and rad, deg"), "{text}");
    let wrong = trajectory(&mixed.replace("'rad'", "'m'"));
    assert!(refusal(&wrong).contains("line 1: 'm' is not a unit of angle; expected deg"));
    let weight = tubular(&component("drill pipe", "", "<wtPerLen uom='N/m'>300</wtPerLen>"));
    assert!(refusal(&weight).contains("'N/m' is not a unit of mass per length"));
}

#[test]
fn a_missing_unit_is_asked_for() {
    let file = trajectory(&(station("0", "0", "0") + &station("1000", "3", "45")));
    let file = file.replace("<md uom='m'>", "<md>");
    assert_eq!(
        refusal(&file).split(", or one of").next().unwrap(),
        "a.xml, line 1: the md has no unit; give it with --unit md=m"
    );
    let files = [("a.xml", file.as_bytes())];
    let text = imported(&files, &Choices::default().unit("md", "ft")).unwrap().text;
    assert!(text.contains("[\"1000 ft\", 3, 45],"));
    // The datum is noted for depths that have a unit; no choice is required.
    let complete = trajectory(&(station("0", "0", "0") + &station("1000", "3", "45")));
    let files = [("a.xml", complete.as_bytes())];
    let unused = imported(&files, &Choices::default().unit("md", "ft")).unwrap_err();
    assert!(unused.contains("--unit md"), "{unused}");
}

#[test]
fn one_of_several_objects_is_picked_by_name_or_uid() {
    let object = |uid: &str, name: &str, depth: &str| {
        let stations = station("0", "0", "0") + &station(depth, "3", "45");
        format!("<trajectory uid='{uid}'><name>{name}</name>{stations}</trajectory>")
    };
    let one_series = |objects: &[String]| one_series("trajectory", &objects.concat());
    let file = one_series(&[object("1", "Plan", "1000"), object("2", "Actual", "1500")]);
    assert_eq!(
        refusal(&file),
        "a.xml: it holds 2 of the kind 'trajectory': 'Plan', 'Actual'; pick one: --pick \
         trajectory=NAME"
    );
    let pick = |file: &str, name: &str| {
        imported(&[("a.xml", file.as_bytes())], &Choices::default().pick("trajectory", name))
    };
    for name in ["Actual", "2"] {
        assert!(pick(&file, name).unwrap().text.contains("[1500, 3, 45],"), "{name}");
    }
    assert_eq!(
        pick(&file, "Other").unwrap_err(),
        "a.xml: there is no trajectory 'Other'; it holds: 'Plan', 'Actual'"
    );
    let alike = one_series(&[object("1", "Plan", "1000"), object("2", "Plan", "1500")]);
    assert!(refusal(&alike).contains("'1', '2'"));
    assert!(pick(&alike, "2").unwrap().text.contains("[1500, 3, 45],"));
}

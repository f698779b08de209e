//! WITSML: whole outputs of samples, and each trap by itself.

use std::{collections::BTreeMap, path::Path};

use proptest::prelude::*;
use wholestring_case::Template;
use wholestring_import::{Choices, Imported, Input, contents, import};

fn sample(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/samples").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn imported(files: &[(&str, &[u8])], choices: &Choices) -> Result<Imported, String> {
    let inputs = files.iter().map(|&(name, bytes)| Input::of_bytes(name, bytes)).collect();
    import(inputs, choices).map_err(|error| error.to_string())
}

/// The case of a text, and what is said of it; or the refusal.
fn whole(files: &[(&str, &[u8])], choices: &Choices) -> String {
    match imported(files, choices) {
        Ok(imported) => imported.text,
        Err(refusal) => refusal,
    }
}

/// The output of samples of one folder.
fn of_samples(folder: &str, names: &[&str]) -> String {
    let bytes: Vec<Vec<u8>> =
        names.iter().map(|name| sample(&format!("{folder}/{name}"))).collect();
    let files: Vec<(&str, &[u8])> =
        names.iter().zip(&bytes).map(|(name, bytes)| (*name, bytes.as_slice())).collect();
    whole(&files, &Choices::default())
}

/// Whether the case that was written is one that can be solved.
fn assert_solvable(text: &str) {
    let template = Template::in_memory("case.toml", text, BTreeMap::new());
    if let Err(report) = template.case(&[]) {
        panic!("{report:?}\n{text}");
    }
}

/// An object of WITSML 1.4.1.1 in its plural.
fn one_series(name: &str, objects: &str) -> String {
    format!(
        "<{name}s xmlns='http://www.witsml.org/schemas/1series' version='1.4.1.1'>{objects}</{name}s>"
    )
}

fn station(md: &str, incl: &str, azi: &str) -> String {
    format!(
        "<trajectoryStation><md uom='m'>{md}</md><incl uom='dega'>{incl}</incl>\
         <azi uom='dega'>{azi}</azi></trajectoryStation>"
    )
}

fn trajectory(stations: &str) -> String {
    one_series("trajectory", &format!("<trajectory uid='1'><name>T</name>{stations}</trajectory>"))
}

fn component(kind: &str, sequence: &str, more: &str) -> String {
    format!(
        "<tubularComponent><typeTubularComp>{kind}</typeTubularComp>{sequence}\
         <id uom='in'>3</id><od uom='in'>5</od><len uom='m'>10</len>{more}</tubularComponent>"
    )
}

fn numbered(kind: &str, sequence: usize) -> String {
    component(kind, &format!("<sequence>{sequence}</sequence>"), "")
}

fn tubular(components: &str) -> String {
    one_series("tubular", &format!("<tubular uid='1'><name>S</name>{components}</tubular>"))
}

fn section(kind: &str, top: f64, bottom: f64, more: &str) -> String {
    format!(
        "<wbGeometrySection><typeHoleCasing>{kind}</typeHoleCasing><mdTop uom='m'>{top}</mdTop>\
         <mdBottom uom='m'>{bottom}</mdBottom>{more}</wbGeometrySection>"
    )
}

fn geometry(sections: &str) -> String {
    one_series("wbGeometry", &format!("<wbGeometry uid='1'><name>G</name>{sections}</wbGeometry>"))
}

fn text_of(file: &str) -> String {
    let imported = imported(&[("a.xml", file.as_bytes())], &Choices::default());
    imported.unwrap_or_else(|refusal| panic!("{refusal}")).text
}

fn refusal(file: &str) -> String {
    imported(&[("a.xml", file.as_bytes())], &Choices::default()).unwrap_err()
}

/// The values of a key, in the order of the case.
fn values<'a>(text: &'a str, key: &str) -> Vec<&'a str> {
    let pairs = text.lines().filter_map(|line| line.split_once(" = "));
    let of_key = pairs.filter(|(own, _)| *own == key);
    of_key.map(|(_, rest)| rest.split(" #").next().unwrap_or(rest).trim()).collect()
}

const WELL: [&str; 4] =
    ["witsml-trajectory.xml", "witsml-wbgeometry.xml", "witsml-tubular.xml", "witsml-bharun.xml"];

const WELL_21: [&str; 5] = [
    "witsml21-trajectory.xml",
    "witsml21-geometry.xml",
    "witsml21-fluids.xml",
    "witsml21-tubular.xml",
    "witsml21-bharun.xml",
];

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
    let mut told = String::new();
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
        told.push_str(&format!("{name}: {}\n  {}\n", found.what, found.lines.join("\n  ")));
    }
    insta::assert_snapshot!("contents", told);
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
    let of = |head: &str| {
        let file = format!(
            "<{head}><trajectory uid='1'><name>T</name>{stations}</trajectory></trajectorys>"
        );
        contents(Input::of_bytes("a.xml", file.as_bytes())).unwrap().what
    };
    assert_eq!(of("trajectorys xmlns='http://www.witsml.org/schemas/131'"), "WITSML 1.3.1.1");
    assert_eq!(of("trajectorys version='1.3.1.1'"), "WITSML 1.3.1.1");
    assert_eq!(of("trajectorys"), "WITSML of no version");
}

#[test]
fn units_are_those_of_each_number() {
    let mixed = "<trajectoryStation><md uom='ft'>1000</md><incl uom='rad'>0.1</incl>\
                 <azi uom='dega'>45</azi></trajectoryStation>";
    let text = text_of(&trajectory(&(station("0", "0", "0") + mixed)));
    assert!(text.contains("[\"1000 ft\", 5.72957795131, 45],"), "{text}");
    assert!(text.contains("of the stations stand in ft and m, deg and rad, deg"), "{text}");
    let wrong = trajectory(&mixed.replace("'rad'", "'m'"));
    assert!(refusal(&wrong).contains("line 1: 'm' is no unit of angle; expected deg"));
    let weight = tubular(&component("drill pipe", "", "<wtPerLen uom='N/m'>300</wtPerLen>"));
    assert!(refusal(&weight).contains("'N/m' is no unit of mass per length"));
}

#[test]
fn a_missing_unit_is_asked_for() {
    let file = trajectory(&(station("0", "0", "0") + &station("1000", "3", "45")));
    let file = file.replace("<md uom='m'>", "<md>");
    assert_eq!(
        refusal(&file).split(", or one of").next().unwrap(),
        "a.xml, line 1: the md has no unit; say it: --unit md=m"
    );
    let files = [("a.xml", file.as_bytes())];
    let text = imported(&files, &Choices::default().unit("md", "ft")).unwrap().text;
    assert!(text.contains("[\"1000 ft\", 3, 45],"));
    // It is said of what has a unit: nothing asks for it.
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
    let of = |objects: &[String]| one_series("trajectory", &objects.concat());
    let file = of(&[object("1", "Plan", "1000"), object("2", "Actual", "1500")]);
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
    let alike = of(&[object("1", "Plan", "1000"), object("2", "Plan", "1500")]);
    assert!(refusal(&alike).contains("'1', '2'"));
    assert!(pick(&alike, "2").unwrap().text.contains("[1500, 3, 45],"));
}

#[test]
fn stations_are_ordered_by_depth_and_stand_once() {
    let twice = |extra: &str, other: &str| {
        let one = station("1000", "3", "45").replace("</traj", &format!("{extra}</traj"));
        let two = station("1000", "4", "45").replace("</traj", &format!("{other}</traj"));
        trajectory(&(station("2000", "5", "45") + &one + &two + &station("0", "0", "0")))
    };
    let early = "<dTimStn>2024-01-01T00:00:00Z</dTimStn>";
    let late = "<dTimStn>2024-01-02T00:00:00Z</dTimStn>";
    let in_use = "<statusTrajStation>position</statusTrajStation>";
    for (one, two, kept) in [(early, late, 4), (late, early, 3), (in_use, late, 3)] {
        let text = text_of(&twice(one, two));
        assert!(text.contains(&format!("[1000, {kept}, 45],\n    [2000, 5, 45],")), "{text}");
        assert!(text.contains("of two stations at 1000 m that in line 1: the other, in line 1,"));
    }
    let told = refusal(&twice(early, early));
    assert!(told.contains("two stations at 1000 m differ"), "{told}");
    let same = station("1000", "3", "45");
    let text = text_of(&trajectory(&(station("0", "0", "0") + &same + &same)));
    assert!(text.contains("1 station of a depth that another has, alike"), "{text}");
}

#[test]
fn what_is_no_station_is_left_out_or_refused() {
    let good = station("0", "0", "0") + &station("1000", "3", "45");
    let marker = "<trajectoryStation><md uom='m'>500</md></trajectoryStation>";
    let text = text_of(&trajectory(&(good.clone() + marker)));
    assert!(text.contains("1 station without inclination and azimuth, of no survey"));
    let vertical = station("0", "0", "").replace("<azi uom='dega'></azi>", "");
    let text = text_of(&trajectory(&(vertical + &station("1000", "3", "45"))));
    assert!(text.contains("the azi of 1 station, vertical and without one: 0"), "{text}");
    for (stations, reason) in [
        (station("0", "0", "0"), "has 1 station with inclination and azimuth"),
        (good.clone() + &station("2000", "3", ""), "the azi of this station is missing"),
        (good.clone() + &station("", "3", "4"), "the md of this station is missing"),
        (good.clone() + &station("-999.25", "3", "4"), "the md -999.25 m is out of range"),
        (good.clone() + &station("2000", "-999.25", "4"), "the incl -999.25 dega is out of range"),
        (good.clone() + &station("2000", "3", "1e9"), "the azi 1e9 dega is out of range"),
        (good.clone() + &station("NaN", "3", "4"), "'NaN' is not a number; the md"),
        (good.clone() + &station("INF", "3", "4"), "'INF' is not a number"),
        (good.clone() + &station("1e400", "3", "4"), "'1e400' is not a number"),
        (good.clone() + &station("1,000", "3", "4"), "'1,000' is not a number"),
        (good.clone() + &station("1001", "177", "225"), "its stations make no path"),
    ] {
        let told = refusal(&trajectory(&stations));
        assert!(told.contains(reason), "{told}");
    }
}

#[test]
fn the_first_station_says_where_it_lies() {
    let tied = "<trajectoryStation><md uom='ft'>1000</md><tvd uom='ft'>990</tvd>\
                <incl uom='dega'>5</incl><azi uom='dega'>45</azi><dispNs uom='ft'>10</dispNs>\
                <dispEw uom='ft'>-20</dispEw></trajectoryStation>";
    let text = text_of(&trajectory(&(tied.to_owned() + &station("1000", "5", "45"))));
    assert_eq!(values(&text, "tvd"), ["\"301.752 m\""]);
    assert_eq!(values(&text, "east"), ["\"-6.096 m\""]);
    let untied = trajectory(&(station("500", "0", "0") + &station("1000", "5", "45")));
    assert!(text_of(&untied).contains("the first station, at 500 m, does not say its tvd"));
    // What stations say is held against the path.
    let deep = station("1000", "0", "0").replace("<incl", "<tvd uom='m'>900</tvd><incl");
    let text = text_of(&trajectory(&(station("0", "0", "0") + &deep)));
    assert!(text.contains("off the path by minimum curvature: by 100 m at 1000 m"), "{text}");
}

#[test]
fn components_are_ordered_by_sequence_from_the_bit_up() {
    let names = |text: &str| -> Vec<String> {
        values(text, "component").into_iter().map(str::to_owned).collect()
    };
    let parts = ["drill pipe", "drill collar", "bit"];
    let expected = ["\"bit\"", "\"drill collar\"", "\"drill pipe\""];
    let up: String =
        parts.iter().rev().enumerate().map(|(at, kind)| numbered(kind, at + 1)).collect();
    let text = text_of(&tubular(&up));
    assert_eq!(names(&text), expected);
    assert!(text.contains("the order is from the bit up: component 1 (bit) first"));
    let down: String = parts.iter().enumerate().map(|(at, kind)| numbered(kind, at + 1)).collect();
    let text = text_of(&tubular(&down));
    assert_eq!(names(&text), expected);
    assert!(text.contains("the order is turned: component 3 (bit) comes last"), "{text}");
    let none: String = parts.iter().rev().map(|kind| component(kind, "", "")).collect();
    let text = text_of(&tubular(&none));
    assert_eq!(names(&text), expected);
    assert!(text.contains("no component has a sequence: in the order of the file"));
    let casing = numbered("drill collar", 1) + &numbered("drill pipe", 2);
    assert!(text_of(&tubular(&casing)).contains("no component is a bit: component 1"));
    for (parts, reason) in [
        (numbered("bit", 1) + &numbered("jar", 1), "has the same sequence as that in line 1"),
        (
            numbered("bit", 1) + &component("jar", "", ""),
            "the sequence of the jar in line 1, which",
        ),
        (
            numbered("jar", 1) + &numbered("bit", 2) + &numbered("drill pipe", 3),
            "is neither the first nor the last of 3 components",
        ),
        (component("jar", "<sequence>1.5</sequence>", ""), "'1.5' is not a number; the sequence"),
        (String::new(), "a tubularComponent of tubular 'S' is missing"),
    ] {
        let told = refusal(&tubular(&parts));
        assert!(told.contains(reason), "{told}");
    }
    // As large as numbers may be.
    let huge = component("bit", "<sequence>1e300</sequence>", "") + &numbered("jar", 2);
    assert_eq!(names(&text_of(&tubular(&huge))), ["\"bit\"", "\"jar\""]);
}

#[test]
fn components_have_the_fields_names() {
    for (kind, name) in [
        ("bit", "bit"),
        ("bit PDC fixed cutter", "PDC fixed cutter bit"),
        ("bit hole opener", "hole opener"),
        ("sub-bent", "bent sub"),
        ("heavy weight drill pipe LH", "heavy-weight drill pipe"),
        ("MWD pulser", "MWD pulser"),
        ("rotary steering tool", "rotary steerable"),
        ("stabilizer near bit", "near bit stabilizer"),
        ("motor steerable", "steerable motor"),
    ] {
        let text = text_of(&tubular(&component(kind, "", "")));
        assert_eq!(values(&text, "component"), [format!("\"{name}\"")], "{kind}");
    }
    let other =
        component("other", "", "<description>float\n[mud]\ndensity = 0 \"sub\"</description>");
    let text = text_of(&tubular(&other));
    assert_eq!(values(&text, "component"), [r#""float [mud] density = 0 \"sub\"""#]);
    assert!(!text.contains("\n[mud]"), "{text}");
}

#[test]
fn parts_of_a_component_become_its_keys_where_they_can() {
    let of = |kind: &str, more: &str| text_of(&tubular(&component(kind, "", more)));
    let blades = "<stabilizer><lenBlade uom='m'>0.6</lenBlade><odBladeMx uom='in'>8.5</odBladeMx>\
                  <distBladeBot uom='m'>1</distBladeBot></stabilizer>";
    let text = of("stabilizer", blades);
    assert_eq!(values(&text, "blade_od"), ["\"8.5 in\""]);
    assert_eq!(values(&text, "blade_length"), ["\"0.6 m\""]);
    assert!(text.contains("by distBladeBot they are 3.7 m below it"), "{text}");
    let long = of("stabilizer", &blades.replace("0.6", "60"));
    assert!(values(&long, "blade_length").is_empty() && long.contains("blades all along it"));
    let thin = of("stabilizer", &blades.replace("8.5", "4.5"));
    assert!(values(&thin, "blade_od").is_empty() && thin.contains("no wider than its od"));

    let motor = "<bend><angle uom='dega'>1.15</angle><distBendBot uom='ft'>6</distBendBot></bend>";
    let text = of("motor", motor);
    assert_eq!(
        (values(&text, "bend"), values(&text, "bend_at")),
        (vec!["\"1.15 deg\""], vec!["\"6 ft\""])
    );
    let outside = tubular(&component("motor", "", &motor.replace(">6<", ">60<")));
    assert!(refusal(&outside).contains("the distBendBot 60 ft is out of range"));
    let set = of("motor", "<motor><bendSettingsMx uom='dega'>3</bendSettingsMx></motor>");
    assert!(set.contains("it can be set up to 3, but not how it is set is told"), "{set}");

    let sensor = "<mwdTool><sensor><typeMeasurement>gamma ray</typeMeasurement><offsetBot uom='m'>2\
                  </offsetBot></sensor><sensor><typeMeasurement>deviation</typeMeasurement>\
                  <offsetBot uom='m'>4</offsetBot></sensor></mwdTool>";
    assert_eq!(values(&of("MWD", sensor), "survey_sensor"), ["\"4 m\""]);
    let outside = of("MWD", &sensor.replace(">4<", ">40<"));
    assert!(values(&outside, "survey_sensor").is_empty() && outside.contains("outside it"));
    let around = sensor.replace("deviation", "azimuthal gamma ray");
    assert!(values(&of("MWD", &around), "survey_sensor").is_empty());
    let two = tubular(&(component("bit", "", "") + &component("MWD", "", sensor).repeat(2)));
    let text = text_of(&two);
    assert_eq!(values(&text, "survey_sensor").len(), 1);
    assert!(text.contains("of 2 directional sensors all but the lowest"));

    let joints = "<lenJointAv uom='m'>9.5</lenJointAv><grade>S135</grade><connection>\
                  <od uom='in'>6.625</od><tqMakeup uom='ft.lbf'>30000</tqMakeup></connection>";
    let text = of("drill pipe", joints);
    assert_eq!(values(&text, "joint_od"), ["\"6.625 in\""]);
    assert_eq!(values(&text, "joint_spacing"), ["\"9.5 m\""]);
    assert_eq!(values(&text, "yield_strength"), ["\"135000 psi\""]);
    assert_eq!(values(&text, "make_up_torque"), ["\"30000 ft-lbf\""]);
    let slick = of("drill pipe", "<grade>Q-1</grade>");
    assert!(
        slick.contains("its body touches the wall") && slick.contains("no grade of the catalogue")
    );

    // Nominal weights leave out the tool joints.
    let nominal = of("drill pipe", "<wtPerLen uom='lbm/ft'>19.5</wtPerLen>");
    assert!(
        nominal.contains("is the nominal weight of such pipe: with its tool joints"),
        "{nominal}"
    );
    let adjusted = of("drill pipe", "<wtPerLen uom='lbm/ft'>22.1</wtPerLen>");
    assert!(!adjusted.contains("nominal"));

    let bit = "<bitRecord><diaBit uom='in'>8.5</diaBit></bitRecord>";
    let text = of("bit", bit);
    assert_eq!(values(&text, "od"), ["\"8.5 in\""]);
    assert!(text.contains("its diaBit is 8.5 in, which is what fills the hole"));
    let hole = tubular(&component("bit", "", "").replace("<od uom='in'>5</od>", ""));
    let hole = hole.replace("<name>", "<diaHoleAssy uom='in'>12.25</diaHoleAssy><name>");
    assert_eq!(values(&text_of(&hole), "od"), ["\"12.25 in\""]);
}

#[test]
fn what_a_component_lacks_is_said_and_the_case_is_not_green() {
    let parts = numbered("bit", 1)
        + &numbered("drill pipe", 2).replace("<id uom='in'>3</id>", "").replace(">10<", ">0<");
    let text = text_of(&tubular(&parts));
    assert!(text.contains("the id of component 2 (drill pipe), which the file does not tell"));
    assert!(text.contains("the len of component 2 (drill pipe), which is 0: not known"), "{text}");
    let template = Template::in_memory("case.toml", &text, BTreeMap::new());
    assert!(template.case(&[]).is_err());
    let negative = tubular(&numbered("jar", 1).replace(">5<", ">-5<"));
    assert!(refusal(&negative).contains("the od -5 in is out of range; expected more than 0"));
}

#[test]
fn the_hole_is_the_innermost_wall_at_each_depth() {
    let inside = |inches: f64| format!("<idSection uom='in'>{inches}</idSection>");
    // A liner hangs in the casing; the open hole was listed from the surface.
    let sections = section("open hole", 0.0, 4000.0, &inside(6.0))
        + &section("liner", 1900.0, 3000.0, &inside(6.276))
        + &section("casing", 0.0, 2000.0, &inside(8.681))
        + &section("riser", 0.0, 100.0, &inside(19.0));
    let text = text_of(&geometry(&sections));
    assert_eq!(values(&text, "kind")[..3], ["\"casing\"", "\"casing\"", "\"open\""]);
    assert_eq!(values(&text, "to"), ["\"1900 m\"", "\"3000 m\"", "\"4000 m\""]);
    assert_eq!(values(&text, "diameter"), ["\"8.681 in\"", "\"6.276 in\"", "\"6 in\""]);
    assert!(
        text.contains("the riser in line 1 from 0 m to 100 m: it lies behind others"),
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
    assert!(text.contains("what the hole is above 950 m"), "{text}");
    assert_eq!(values(&text, "from"), ["\"950 m\""]);
    let below = text_of(&geometry(&section("open hole", 950.0, 1800.0, inside)));
    assert_eq!(values(&below, "from"), ["\"950 m\""]);
    // Rounded to the centimetre they meet.
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
        let told = refusal(&geometry(&sections));
        assert!(told.contains(reason), "{told}");
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
    assert!(text.contains("the wtMud of 0.14 lbm/ft3 in line 1: 0.002 sg is no mud's"), "{text}");
    assert_eq!(values(&text, "kind"), [r#"["trip_out", "trip_in", "rotate_off_bottom"]"#]);
    let loads = |up: f64, down: f64| {
        run(&format!(
            "<hkldRot uom='klbf'>150</hkldRot><hkldUp uom='klbf'>{up}</hkldUp>\
             <hkldDn uom='klbf'>{down}</hkldDn>"
        ))
    };
    assert!(loads(200.0, 200.0).contains("do not fall in this order, as friction makes them"));
    assert!(loads(200.0, 120.0).contains("were read with the bit at its mdHoleStop, 2000 m"));
    let unknown = run("<wobAv uom='bananas'>100</wobAv>");
    assert!(unknown.contains("wobAv in line 1: 'bananas' is no unit of force"), "{unknown}");
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

#[test]
fn names_cannot_write_into_the_case() {
    let stations = station("0", "0", "0") + &station("100", "0", "0");
    let name = "T\n[mud]\ndensity = 0\u{85}\r\n# \"";
    let file = one_series(
        "trajectory",
        &format!(
            "<trajectory><nameWell>{name}</nameWell><name>{name}</name>{stations}</trajectory>"
        ),
    );
    let text = text_of(&file);
    assert!(!text.contains("\n[mud]") && !text.contains("\ndensity"), "{text}");
    assert!(text.contains("trajectory 'T [mud] density = 0 # \"'"), "{text}");
}

#[test]
fn hostile_files_are_refused_in_time() {
    let laughs = "<?xml version='1.0'?><!DOCTYPE a [<!ENTITY b 'c'>]><trajectorys/>";
    assert!(refusal(laughs).contains("it declares a document type (DTD)"));
    let deep = tubular(&"<tubularComponent>".repeat(1000));
    assert!(refusal(&deep).contains("elements more than 64 deep"));
    let wide = tubular(&"<a/>".repeat(500_000));
    assert!(refusal(&wide).contains("objects of more than 400000 elements and 32 MB"));
    let many = tubular(&component("jar", "", "").repeat(3000));
    assert!(refusal(&many).contains("a tubular of more than 2000 components"));
    let sections = geometry(&section("casing", 0.0, 9.0, "").repeat(1000));
    assert!(refusal(&sections).contains("a geometry of more than 500 sections"));
    let objects = one_series("tubular", &"<tubular/>".repeat(2000));
    assert!(refusal(&objects).contains("more than 1000 objects"));
    let heavy = format!("<description>{}</description>", "x".repeat(40 << 20));
    assert!(refusal(&tubular(&component("jar", "", &heavy))).contains("and 32 MB"));
    assert!(
        refusal(&tubular("<tubularComponent>").replace("</tubular>", ""))
            .contains("not well-formed")
    );
}

/// Bytes of a sample, some of them changed.
fn changed(bytes: &[u8], changes: &[(usize, u8)], cut: usize) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for &(at, byte) in changes {
        let at = at % bytes.len();
        bytes[at] = byte;
    }
    let keep = bytes.len() - cut % bytes.len() / 4;
    bytes.truncate(keep);
    bytes
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    /// Damaged files are read or refused; what is written is TOML.
    #[test]
    fn damaged_files_do_not_end_the_program(
        which in 0..9usize,
        changes in prop::collection::vec((any::<usize>(), prop::sample::select(b"0195.-<>/&;\"e \n\xff".to_vec())), 0..6),
        cut in prop_oneof![Just(0usize), any::<usize>()],
    ) {
        let name = WELL.iter().chain(&WELL_21).nth(which).copied().unwrap_or_default();
        let bytes = changed(&sample(&format!("own/{name}")), &changes, cut);
        let files = [(name, bytes.as_slice())];
        if let Ok(imported) = imported(&files, &Choices::default()) {
            let template = Template::in_memory("case.toml", &imported.text, BTreeMap::new());
            if let Err(report) = template.case(&[]) {
                prop_assert!(!format!("{report:?}").contains("TOML"), "{report:?}");
            }
        }
        let _ = contents(Input::of_bytes(name, &bytes));
    }
}

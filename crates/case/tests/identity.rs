//! Two cases are the same only where every key is: each key of the schema is changed, one by one,
//! in a case in which it counts.

mod common;

use common::{EXAMPLE, SURVEY, SURVEY_NAME};
use serde_json::Value as Json;
use wholestring_case::{Case, InMemory, Override, parse, schema};

/// Keys that do not affect the results, with the reason.
const WITHOUT_EFFECT: &[(&str, &str)] = &[
    ("name", "the name of the case"),
    ("units", "display only"),
    ("dynamics.checkpoint_interval", "the loss after a kill"),
    ("modes.count", "evaluated on the static string"),
    ("modes.assembly", "evaluated on the static string"),
    ("modes.slowest", "evaluated on the static string"),
    ("modes.fastest", "evaluated on the static string"),
    ("modes.orders", "evaluated on the static string"),
    ("modes.force", "evaluated on the static string"),
    ("modes.force_at", "evaluated on the static string"),
    ("modes.lightest", "the range of the map of stability"),
    ("modes.heaviest", "the range of the map of stability"),
    ("modes.highest_frequency", "the range of the map of stability"),
    ("modes.static_over_kinetic", "an assumption of the map of stability"),
    ("mud.gel_strength", "the gel that a plan's pumps break"),
    ("plan", "evaluated at other depths and frictions"),
    ("well.hole.0.from", "where the section above ends: anything else is refused"),
    ("well.hole.0.drift", "a warning of a part of the string that is wider"),
];

/// Two values of keys whose schema does not suffice to generate them.
const VALUES: &[(&str, [&str; 2])] = &[
    ("bit.face.insert_shape", ["hemisphere", "cone"]),
    ("bit.face.exposure", ["4 mm", "5 mm"]),
    ("bit.face.cutter_length", ["13 mm", "12 mm"]),
    ("bit.face.blades", ["4", "5"]),
    ("bit.face.core_diameter", ["60 mm", "70 mm"]),
    ("bit.blades", ["4", "5"]),
    ("bit.face.rows", ["20", "21"]),
    ("bit.kind", ["pdc", "inserts"]),
    ("bit.motor.max_differential_pressure", ["55 bar", "56 bar"]),
    ("bit.law", ["rate", "regenerative"]),
    ("bit.table.file", ["points.csv", "others.csv"]),
    (
        "bit.table.points",
        [
            "[[40e3, 60, 6, 2e3], [40e3, 90, 9, 2e3], [80e3, 60, 12, 4e3], [80e3, 90, 18, 4e3]]",
            "[[40e3, 60, 6, 2e3], [40e3, 90, 9, 2e3], [80e3, 60, 12, 4e3], [80e3, 90, 19, 4e3]]",
        ],
    ),
    ("bit_test.rpm", ["[60, 90]", "[60, 91]"]),
    ("bit_test.wob", ["[\"40 kN\", \"60 kN\"]", "[\"40 kN\", \"61 kN\"]"]),
    ("catalogue", ["mine.toml", "others.toml"]),
    ("buckling.criterion", ["he-kyllingstad", "wu-juvkam-wold"]),
    ("buckling.helix_side_force", ["left-out", "counted"]),
    ("dynamics.contact_law", ["hertz", "linear"]),
    ("dynamics.friction_law", ["vector", "independent"]),
    ("dynamics.precision", ["double", "single"]),
    ("dynamics.start", ["prepared", "centred"]),
    ("dynamics.start_tension", ["static", "cold"]),
    ("ends.bit", ["held", "free"]),
    ("ends.top", ["clamped", "pinned"]),
    ("hoist.control", ["autodriller", "tuned-lift"]),
    ("hoist.max_speed", ["60 m/h", "61 m/h"]),
    ("mesh.accuracy", ["coarse", "fine"]),
    ("mesh.regions", ["one", "auto"]),
    ("model", ["soft", "dynamic"]),
    (
        "mud.dial_readings",
        [
            "[[600, 65], [300, 40], [200, 31], [100, 21], [6, 7], [3, 6]]",
            "[[600, 66], [300, 40], [200, 31], [100, 21], [6, 7], [3, 6]]",
        ],
    ),
    ("mud.flow_behaviour_index", ["0.7", "0.71"]),
    ("mud.rheology", ["newtonian", "bingham"]),
    ("operation.bit_depth", ["4200 m", "4201 m"]),
    ("operation.kind", ["trip_in", "trip_out"]),
    ("operation.rpm", ["70", "71"]),
    ("operation.schedule.0.at", ["30 s", "31 s"]),
    ("operation.schedule.0.note", ["a", "b"]),
    ("records.channels", ["position", "velocity"]),
    ("records.node_spectra", ["tension", "torque"]),
    ("records.node_spectra_at", ["4290 m", "4280 m"]),
    ("records.spectra", ["hook_load", "twist"]),
    ("rock.element_size", ["9 mm", "9.5 mm"]),
    ("rock.friction_angle", ["35 deg", "36 deg"]),
    ("string.0.blade_od", ["212 mm", "211 mm"]),
    ("string.0.catalogue", ["5 in 19.50 lb/ft G-105", "5 in 19.50 lb/ft S-135"]),
    ("string.0.component", ["pipe", "tube"]),
    ("string.0.eccentricity_cavity", ["mud", "sealed"]),
    ("string.0.id", ["57 mm", "58 mm"]),
    ("string.0.joint_od", ["168 mm", "169 mm"]),
    ("string.0.length", ["9.6 m", "9.7 m"]),
    ("string.0.mass_per_length", ["160 kg/m", "161 kg/m"]),
    ("string.0.od", ["171 mm", "172 mm"]),
    ("top_drive.control", ["constant", "soft-torque"]),
    ("well.hole.0.casing", ["9-5/8 in 40 lb/ft", "9-5/8 in 47 lb/ft"]),
    ("well.hole.0.diameter", ["222.96 mm", "223 mm"]),
    ("well.hole.0.kind", ["casing", "open"]),
    ("well.hole.0.to", ["2986.53 m", "2990 m"]),
    ("well.tortuosity.kind", ["random", "helical"]),
    ("well.path", ["spline", "minimum-curvature"]),
    (
        "well.stations",
        ["[[0, 0, 0], [1000, 0, 0], [4305, 60, 90]]", "[[0, 0, 0], [1000, 0, 0], [4305, 60, 91]]"],
    ),
    ("well.survey", [SURVEY_NAME, "other.csv"]),
    ("well.survey_unit", ["m", "ft"]),
];

/// Text inserted before the drill pipe of the example, so that a component has everything.
const TOOL: &str = "[[string]]\ncomponent = \"motor\"\nod = \"171 mm\"\nid = \"57 mm\"\nlength = \"9.6 m\"\n\
     bend = \"1.5 deg\"\nbend_at = \"2 m\"\nbend_toolface = \"90 deg\"\neccentricity = \"2 mm\"\n\
     eccentricity_phase = \"90 deg\"\nlateral_force = \"15 kN\"\nlateral_force_at = \"0.8 m\"\nlateral_force_toolface = \"90 deg\"\neccentricity_cavity = \"mud\"\nblade_od = \"212 mm\"\nblade_length = \"0.6 m\"\n";

const JOINTED: &str = "[[string]]\ncomponent = \"pipe\"\nod = \"127 mm\"\nid = \"108.6 mm\"\nlength = \"96 m\"\n\
     joint_od = \"168 mm\"\njoint_spacing = \"9.6 m\"\nmass_per_length = \"32 kg/m\"\nmake_up_torque = \"36 kN.m\"\n";

const LISTED: &str =
    "[[string]]\ncomponent = \"pipe\"\ncatalogue = \"5 in 19.50 lb/ft G-105\"\nlength = \"96 m\"\n";

const OWN: &str = "[[string]]\ncomponent = \"pipe\"\ncatalogue = \"mine\"\nlength = \"96 m\"\n";

/// A cutting law's numbers.
const CUTTERS: &str = "intrinsic_specific_energy = \"60 MPa\"\ncutter_inclination = 0.7\nwear_flat = \"5 mm\"\n\
     contact_strength = \"60 MPa\"\nfriction = 0.6\nbit_geometry = 1.0\ncore_diameter = \"60 mm\"\n\
     motor_speed = 120\n";

const ROCK: &str = "[rock]\nstrength = \"60 MPa\"\nelement_size = \"9 mm\"\n[bit_test]\nwob = [\"40 kN\", \"60 kN\"]\nrpm = [60, 90]\n";

/// The cases that keys are changed in: in each, some keys count.
fn bases() -> Vec<String> {
    let with = |from: &str, to: &str| {
        assert_eq!(EXAMPLE.matches(from).count(), 1, "{from}");
        EXAMPLE.replace(from, to)
    };
    let before_pipe = |tool: &str| {
        with(
            "[[string]]\ncomponent = \"drill pipe\"",
            &format!("{tool}[[string]]\ncomponent = \"drill pipe\""),
        )
    };
    let bit =
        |lines: &str| with("torque = \"3.1 kN.m\" ", &format!("torque = \"3.1 kN.m\"\n{lines}#"));
    let bit_alone = |lines: &str| {
        with("torque = \"3.1 kN.m\" ", &format!("{lines}#")).replace("rop = \"10 m/h\"", "#")
    };
    let and = |lines: &str| format!("{EXAMPLE}\n{lines}");
    let mud = |lines: &str| {
        with("density = \"1.2 sg\"\n", &format!("density = \"1.2 sg\"\n{lines}")).replace(
            "rpm = 70 ",
            "flow_rate = \"2000 L/min\"\nbit_pressure_drop = \"80 bar\"\nrpm = 70 ",
        )
    };
    let motor = "[bit.motor]\ndisplacement = \"12 L\"\nmax_differential_pressure = \"60 bar\"\n\
         rated_flow = \"2000 L/min\"\nstall_torque = \"12 kN.m\"\n";
    let face = |kind: &str| {
        let lines = format!("law = \"rock\"\nkind = {kind}\n[bit.face]\n");
        format!("{}{ROCK}", bit_alone(&lines))
    };
    let schedule = "[[operation.schedule]]\nat = \"30 s\"\nramp = \"2 s\"\nrpm = 80\nwob = \"50 kN\"\nnote = \"a\"\n";
    vec![
        EXAMPLE.to_owned(),
        with(
            "friction = 0.3\n[[well",
            "friction = { kinetic = 0.3, static = 0.35, around = 0.9 }\n[[well",
        ),
        with(
            "survey = \"np13-x1042-survey.csv\"",
            "stations = [[0, 0, 0], [1000, 0, 0], [4305, 60, 90]]",
        ),
        with("survey = \"np13-x1042-survey.csv\"", "survey = \"bare.csv\"\nsurvey_unit = \"m\""),
        with("diameter = \"222.96 mm\"", "casing = \"9-5/8 in 40 lb/ft\""),
        and("[well.roughness]\nrms = \"1 mm\"\ntortuosity = \"2 mm\"\n"),
        and("[well.tie_in]\nnorth = \"10 m\"\n"),
        before_pipe(TOOL),
        before_pipe(JOINTED),
        before_pipe(LISTED),
        format!("catalogue = \"mine.toml\"\n{}", before_pipe(OWN)),
        and("[well.tortuosity]\namplitude = \"0.4 deg\"\nperiod = \"100 m\"\nto = \"4200 m\"\n"),
        mud(
            "rheology = \"newtonian\"\nviscosity = \"20 mPa.s\"\nplastic_viscosity = \"20 mPa.s\"\nyield_point = \"5 Pa\"\n",
        ),
        mud("rheology = \"bingham\"\nplastic_viscosity = \"20 mPa.s\"\nyield_point = \"5 Pa\"\n"),
        mud(
            "rheology = \"herschel-bulkley\"\ndial_readings = [[600, 65], [300, 40], [200, 31], [100, 21], [6, 7], [3, 6]]\n",
        ),
        mud(
            "rheology = \"power-law\"\nconsistency_index = \"0.5 Pa.s^n\"\nflow_behaviour_index = 0.7\n",
        ),
        bit(
            "motor_speed = 120\nrock_stiffness = \"1e8 N/m\"\n[bit.excitation]\namplitude = \"1 mm\"\nroughness = \"1 mm\"\n",
        ),
        bit(
            "[bit.excitation]\namplitude = \"1 mm\"\nroughness = \"1 mm\"\nfrequency = \"20 Hz\"\n",
        ),
        format!("{}{motor}", mud("rheology = \"newtonian\"\nviscosity = \"20 mPa.s\"\n")),
        bit_alone(&format!("law = \"regenerative\"\nblades = 4\n{CUTTERS}")),
        bit_alone(&format!(
            "law = \"detournay-defourny\"\nfull_contact_depth = \"0.3 mm\"\ncleaning_limit = \"8 mm\"\n{CUTTERS}"
        )),
        bit_alone(
            "law = \"table\"\n[bit.table]\npoints = [[40e3, 60, 6, 2e3], [40e3, 90, 9, 2e3], [80e3, 60, 12, 4e3], [80e3, 90, 18, 4e3]]\n",
        ),
        bit_alone("law = \"table\"\n[bit.table]\nfile = \"points.csv\"\n"),
        face("\"pdc\""),
        face("\"core\"\ncore_diameter = \"60 mm\""),
        face("\"inserts\""),
        face("\"inserts\"").replace("[bit.face]\n", "[bit.face]\ninsert_shape = \"cone\"\n"),
        face("\"pdc\"").replace("strength = \"60 MPa\"", "cohesion = \"15 MPa\""),
        and("[hoist]\ncontrol = \"autodriller\"\n"),
        and("[hoist]\ncontrol = \"block-velocity\"\nblock_velocity = \"0.3 m/s\"\n"),
        and("[hoist]\ncontrol = \"hook-load\"\nhook_load = \"900 kN\"\n"),
        and("[hoist]\ncontrol = \"tuned-lift\"\n"),
        and(
            "[top_drive]\ncontrol = \"pi\"\ninertia = \"2900 kg.m2\"\nproportional = \"1 kN.m.s\"\nintegral = \"1 kN.m\"\n",
        ),
        and("[top_drive]\ncontrol = \"soft-torque\"\ninertia = \"2900 kg.m2\"\n"),
        and("[top_drive]\ncontrol = \"z-torque\"\ninertia = \"2900 kg.m2\"\n"),
        and(
            "[records]\nframes = \"10 Hz\"\nspectra = \"hook_load\"\nnode_spectra = \"tension\"\nnode_spectra_at = \"4290 m\"\n",
        ),
        and(schedule),
        and(&schedule.replace(
            "wob = \"50 kN\"",
            "block_velocity = \"0.1 m/s\"\nflow_rate = \"1000 L/min\"",
        )),
        with("contact_law = \"hertz\"", "contact_law = \"linear\""),
        with("start = \"prepared\"", "start = \"centred\""),
        with("element_length = \"auto\"", "element_length = \"3.2 m\""),
        with("friction = 0.3\n[[well", "friction = { kinetic = 0.3, static = 0.35 }\n[[well"),
    ]
}

fn read(text: &str, change: &Override) -> Result<Case, String> {
    let mut files = InMemory::default();
    let mut put =
        |name: &str, text: &str| files.0.insert(name.to_owned(), text.as_bytes().to_vec());
    put(SURVEY_NAME, SURVEY);
    let own = "[[tubular]]\nname = \"mine\"\nod = \"127 mm\"\nid = \"108 mm\"\nyield_strength = \"931 MPa\"\n";
    put("mine.toml", own);
    put("others.toml", &own.replace("108", "107"));
    put("bare.csv", "md,inc,azi\n0,0,0\n1000,0,0\n4305,50,0\n");
    put("other.csv", "md (m),inc (deg),azi (deg)\n0,0,0\n1000,0,0\n4305,50,0\n");
    let head = "weight_on_bit_N,rotary_speed_rpm,rate_of_penetration_m_per_h,torque_N_m\n";
    put(
        "points.csv",
        &format!("{head}40e3,60,6,2e3\n80e3,60,12,4e3\n40e3,90,9,2e3\n80e3,90,18,4e3\n"),
    );
    put(
        "others.csv",
        &format!("{head}40e3,60,6,2e3\n80e3,60,12,4e3\n40e3,90,9,2e3\n80e3,90,19,4e3\n"),
    );
    let changes = std::slice::from_ref(change);
    parse("case.toml", text.as_bytes(), &files, changes).map_err(|report| report.render(false))
}

/// Returns the keys that have values, dotted, lists counted from zero.
fn leaves(rule: &Json, path: &str, all: &mut Vec<(String, Json)>) {
    let mut below = false;
    let either = ["anyOf", "oneOf"].map(|word| rule[word].as_array().cloned().unwrap_or_default());
    for rule in either.iter().flatten().chain([rule]) {
        let dotted = |key: &str| match path {
            "" => key.to_owned(),
            path => format!("{path}.{key}"),
        };
        for (key, rule) in rule["properties"].as_object().into_iter().flatten() {
            below = true;
            leaves(rule, &dotted(key), all);
        }
        if rule["items"]["properties"].is_object() {
            below = true;
            leaves(&rule["items"], &dotted("0"), all);
        }
    }
    if !below {
        all.push((path.to_owned(), rule.clone()));
    }
}

/// Two values of a key, from its schema: an example and one a little more, a default and one a
/// little more.
fn values(path: &str, rule: &Json) -> [String; 2] {
    if let Some((_, values)) = VALUES.iter().find(|(key, _)| *key == path) {
        return values.map(str::to_owned);
    }
    let either = rule["anyOf"].as_array().cloned().unwrap_or_default();
    let example = either.iter().find_map(|rule| rule["examples"][0].as_str());
    if let Some(example) = example {
        let (number, unit) = example.split_once(' ').expect("a number and its unit");
        let number: f64 = number.parse().unwrap_or_else(|_| panic!("{path}: {example}"));
        return [number, 1.02 * number].map(|number| format!("{number} {unit}"));
    }
    if rule["type"] == "integer" {
        let first = rule["default"].as_u64().or(rule["minimum"].as_u64()).unwrap_or(0) + 1;
        return [first, first + 1].map(|number| number.to_string());
    }
    assert_eq!(rule["type"], "number", "no two values of {path} are known");
    let bound = |key: &str| rule[key].as_f64();
    let highest = bound("maximum").unwrap_or(1.0);
    let lowest = bound("minimum").or(bound("exclusiveMinimum")).unwrap_or(0.0);
    let default = bound("default").filter(|default| *default > 0.0 && *default < highest);
    let first = default.unwrap_or(lowest + 0.3 * (highest.min(1.0) - lowest));
    [first, 1.02 * first].map(|number| number.to_string())
}

/// Changes the key in every case; the first in which both values are valid decides.
fn counts(path: &str, rule: &Json, bases: &[String]) -> Result<(), String> {
    let values = values(path, rule);
    let mut why = String::new();
    for base in bases {
        // The face of a bit takes long, and other keys are tested elsewhere.
        if base.contains("[rock]") && !["bit", "rock"].iter().any(|table| path.starts_with(table)) {
            continue;
        }
        // The component with everything is the second one.
        let tools = base.matches("[[string]]").count() > 2;
        let key = path.replace("string.0", if tools { "string.1" } else { "string.0" });
        let change = |value: &String| format!("{key}={value}").parse().expect("KEY=VALUE");
        let [one, other] = [0, 1].map(|i| read(base, &change(&values[i])));
        match (one, other) {
            (Ok(one), Ok(other)) if one.identity() != other.identity() => return Ok(()),
            (Ok(_), Ok(_)) => {}
            (Err(report), _) | (_, Err(report)) => why = report,
        }
    }
    Err(format!("{path} = {values:?} makes no difference; {why}"))
}

#[test]
fn every_key_makes_another_case() {
    let (schema, bases) = (schema(), bases());
    let unchanged: Override = "name=the same".parse().expect("KEY=VALUE");
    let refused: Vec<String> = bases
        .iter()
        .enumerate()
        .filter_map(|(i, base)| Some(format!("{i}: {}", read(base, &unchanged).err()?)))
        .collect();
    assert!(refused.is_empty(), "{}", refused.join("\n"));
    let mut keys = Vec::new();
    leaves(&schema, "", &mut keys);
    assert!(keys.len() > 190, "{} keys", keys.len());
    let is_in = |path: &str, key: &str| {
        path.strip_prefix(key).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    let without = |path: &str| WITHOUT_EFFECT.iter().any(|(key, _)| is_in(path, key));
    let mistakes: Vec<String> = keys
        .iter()
        .filter(|(path, _)| !without(path))
        .filter_map(|(path, rule)| counts(path, rule, &bases).err())
        .collect();
    assert!(mistakes.is_empty(), "{} of {}:\n{}", mistakes.len(), keys.len(), mistakes.join("\n"));
}

#[test]
fn what_is_only_shown_makes_no_other_case() {
    let plain: Override = "name=one".parse().expect("KEY=VALUE");
    let identity = read(EXAMPLE, &plain).expect("the example").identity();
    for change in ["name=other", "units=field", "dynamics.checkpoint_interval=5 s"] {
        let change = change.parse().expect("KEY=VALUE");
        assert_eq!(read(EXAMPLE, &change).expect("sound").identity(), identity);
    }
}

/// Fields that earlier versions did not compare.
#[test]
fn settings_tell_of_bends_eccentricities_and_the_tolerance() {
    let [_, _, _, _, _, _, _, tool, ..] = &bases()[..] else {
        panic!("the base with a tool");
    };
    let plain: Override = "name=one".parse().expect("KEY=VALUE");
    let case = read(tool, &plain).expect("sound");
    let motor = &case.settings["string"][1];
    let close = |key: &str, expected: f64| {
        let value = motor[key].as_f64().expect(key);
        assert!((value - expected).abs() < 1e-12, "{key} = {value}");
    };
    close("bend_rad", 1.5_f64.to_radians());
    close("bend_at_m", 2.0);
    close("bend_toolface_rad", 90_f64.to_radians());
    close("lateral_force_N", 15e3);
    close("lateral_force_at_m", 0.8);
    close("lateral_force_toolface_rad", 90_f64.to_radians());
    close("eccentricity_m", 2e-3);
    close("eccentricity_phase_rad", 90_f64.to_radians());
    assert_eq!(motor["eccentricity_cavity"], "mud");
    let hoist = |lines: &str| {
        let text = format!("{EXAMPLE}\n[hoist]\n{lines}");
        read(&text, &plain).expect("sound").settings["hoist"].clone()
    };
    let tuned = hoist("control = \"tuned-lift\"\ntolerance = 0.02\n");
    assert_eq!(tuned["tolerance"], 0.02);
    // Numbers of a control that is never active are omitted.
    assert_eq!(tuned["gain_m_per_s_per_N"], Json::Null);
    let speed = hoist("control = \"block-velocity\"\nblock_velocity = \"0.1 m/s\"\ngain = 1e-6\n");
    assert_eq!(speed["gain_m_per_s_per_N"], Json::Null);
    assert_eq!(speed["filter_s"], Json::Null);
    assert_eq!(speed["block_velocity_m_per_s"], 0.1);
    assert_eq!(speed["tolerance"], Json::Null);
    let automatic = hoist("control = \"autodriller\"\ngain = 1e-6\n");
    assert_eq!(automatic["gain_m_per_s_per_N"], 1e-6);
    assert_eq!(automatic["min_speed_m_per_s"], 0.0);
    // An operation on bottom selects the autodriller with its default settings.
    let by_itself = hoist("gain = 1e-6\n");
    assert_eq!(by_itself["gain_m_per_s_per_N"], 1e-7);
}

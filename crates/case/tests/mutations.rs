//! Ten thousand mutations of the shipped cases: each is accepted or refused with a message, and
//! none panics; accepted ones run.

use std::{
    ops::Range,
    panic::{AssertUnwindSafe, catch_unwind},
};

mod common;

use common::schema_check;
use fastrand::Rng;
use toml::de::{DeTable, DeValue};
use wholestring::{
    dynamics::{BitLaw, DynamicOutcome, ElementLength, Simulation},
    operation::Operation,
    statics::soft::{self, SoftSettings},
};
use wholestring_case::{Case, InMemory, parse};
use wholestring_cases::{ALL, ReadyCase};

const MUTATIONS: usize = 10_000;

/// Of accepted mutations, one in this many is also run.
const SHARE_OF_RUNS: usize = 4;

/// A shipped case and the files that it names.
struct Shipped {
    name: String,
    text: String,
    files: InMemory,
}

fn shipped() -> Vec<Shipped> {
    let beside = ALL.iter().flat_map(|case| case.beside);
    let files = InMemory(
        beside.map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec())).collect(),
    );
    let shipped = |case: &ReadyCase| Shipped {
        name: case.file_name.to_owned(),
        text: case.text.to_owned(),
        files: files.clone(),
    };
    let mut cases: Vec<Shipped> = ALL.iter().map(shipped).collect();
    // The case that a seed changes depends on their order.
    cases.sort_by(|one, other| one.name.cmp(&other.name));
    cases
}

#[test]
fn the_shipped_cases_are_sound() {
    for case in shipped() {
        let read = parse(&case.name, case.text.as_bytes(), &case.files, &[]);
        let read = read.unwrap_or_else(|report| panic!("{report}"));
        // Well B's pipe has a shear modulus that gives the recorded torsional stiffness.
        let warnings = read.warnings.to_string();
        let known = case.name.starts_with("well-b") && warnings.matches("warning: ").count() == 1;
        assert!(warnings.is_empty() || known && warnings.contains("Poisson's ratio"), "{warnings}");
    }
}

#[test]
fn every_mutation_is_accepted_or_answered() {
    let cases = shipped();
    let schema = wholestring_case::schema();
    let keys = schema_keys(&schema);
    let (mut valid_toml, mut accepted) = (0, 0);
    for seed in 0..MUTATIONS {
        let mut rng = Rng::with_seed(seed as u64);
        let case = &cases[seed % cases.len()];
        let mut files = case.files.clone();
        let bytes = mutate(case, &keys, &mut files, &mut rng);
        let text = std::str::from_utf8(&bytes).ok();
        let is_toml = text.is_some_and(|text| DeTable::parse(text).is_ok());
        let is_changed = bytes != case.text.as_bytes() || files.0 != case.files.0;
        valid_toml += usize::from(is_toml && is_changed);
        let outcome =
            catch_unwind(AssertUnwindSafe(|| match parse(&case.name, &bytes, &files, &[]) {
                Ok(read) => {
                    check_accepted(&read);
                    if seed % SHARE_OF_RUNS == 0 {
                        let operation = rng.usize(..read.operations.len());
                        run_dynamics(&read, &read.operations[operation]);
                    }
                    let text = std::str::from_utf8(&bytes).expect("an accepted text");
                    let problems = schema_check::problems(&schema, text);
                    assert!(problems.is_empty(), "accepted against the schema: {problems:?}");
                    true
                }
                Err(report) => {
                    assert!(report.errors() > 0);
                    for diagnostic in &report.diagnostics {
                        assert!(!diagnostic.message.is_empty());
                    }
                    assert!(!report.render(seed % 2 == 0).trim().is_empty());
                    false
                }
            }));
        match outcome {
            Ok(was_accepted) => accepted += usize::from(was_accepted),
            Err(_) => panic!(
                "mutation {seed} of {} fails:\n{}",
                case.name,
                String::from_utf8_lossy(&bytes)
            ),
        }
    }
    println!("{valid_toml} of {MUTATIONS} mutations are TOML, {accepted} are accepted");
    assert!(valid_toml >= MUTATIONS / 2, "only {valid_toml} are valid TOML");
    // A reader that refuses everything would pass otherwise.
    assert!(accepted >= MUTATIONS / 50, "only {accepted} are accepted");
    assert!(accepted <= MUTATIONS / 2, "{accepted} are accepted");
}

/// Properties of a case that a solver relies on.
fn check_accepted(case: &Case) {
    assert!(!case.models.is_empty() && !case.operations.is_empty());
    let well = &case.model.well;
    let string = &case.model.string;
    for operation in &case.operations {
        assert!(operation.bit_depth_m > 0.0 && operation.bit_depth_m <= 20_000.0);
        assert!((operation.bit_depth_m - string.length_m()).abs() < 1e-6);
        let sections = well.hole.sections();
        assert!(sections[sections.len() - 1].to_md_m >= operation.bit_depth_m - 1e-6);
        for number in [
            operation.rotary_speed_rad_per_s,
            operation.weight_on_bit_N,
            operation.bit_torque_N_m,
            operation.rate_of_penetration_m_per_s,
            operation.trip_speed_m_per_s,
        ] {
            assert!(number.is_finite() && number >= 0.0);
        }
        for i in 0..=20 {
            let point = well.path.at(operation.bit_depth_m * f64::from(i) / 20.0);
            assert!((point.tangent.norm() - 1.0).abs() < 1e-6);
            assert!(point.position_m.iter().all(|number| number.is_finite()));
            assert!(point.curvature_per_m.norm() < 10.0);
        }
    }
    for component in string.components() {
        assert!(component.length_m > 0.0 && component.od_m > component.id_m);
        assert!(component.mass_per_length_kg_per_m.is_finite());
        let buoyed = component.buoyed_weight_per_length_N_per_m(case.model.mud.density_kg_per_m3);
        assert!(buoyed > 0.0);
    }
    for operation in &case.operations {
        let answer = soft::solve(
            &case.model,
            operation,
            &SoftSettings { step_m: 30.0, ..SoftSettings::default() },
        );
        match answer {
            Ok(profile) => {
                let scalars = profile.scalars;
                assert!(scalars.hook_load_N.is_finite() && scalars.surface_torque_N_m.is_finite());
            }
            // The force of a capstan of many turns exceeds the range of numbers.
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
    if let ElementLength::Uniform(length_m) = case.dynamics.mesh.element_length {
        assert!(string.length_m() / length_m <= 1e5);
    }
    assert!(case.dynamics.duration_s / case.dynamics.sample_interval_s <= 2e6);
    let settings = case.settings.to_string();
    assert!(settings.len() < 64 << 20);
}

/// Runs the dynamics for a few hundredths of a second, with a mesh coarse enough for a test. The
/// run ends, diverges or cannot begin, each with a message; its results never contain invalid
/// numbers.
fn run_dynamics(case: &Case, operation: &Operation) {
    const MAX_ELEMENTS: f64 = 150.0;
    const RUN_S: f64 = 0.03;
    const LONGEST_S: f64 = 0.05;
    let mut settings = case.dynamics.clone();
    let length_m = case.model.string.length_m();
    let longest_m = length_m / MAX_ELEMENTS;
    settings.mesh.element_length = ElementLength::Uniform(match settings.mesh.element_length {
        ElementLength::Uniform(own_m) => own_m.max(longest_m),
        ElementLength::Auto(_) => longest_m,
    });
    // A bit on solid rock is run in before the string begins, for seconds.
    if matches!(settings.bit.law, BitLaw::Rock(_)) {
        return;
    }
    // The window opens within the run, and is sampled.
    settings.settle_s = settings.settle_s.min(RUN_S / 2.0);
    settings.steady = None;
    settings.sample_interval_s = settings.sample_interval_s.min(LONGEST_S);
    let mut simulation = match Simulation::new(&case.model, operation, &settings) {
        Ok(simulation) => simulation,
        Err(error) => {
            assert!(!error.to_string().is_empty());
            return;
        }
    };
    if let Err(diverged) = simulation.advance(RUN_S) {
        assert!(!diverged.to_string().is_empty());
    }
    assert_finite(&simulation.outcome());
}

/// Every number of an outcome is finite.
fn assert_finite(outcome: &DynamicOutcome) {
    // Debug prints every field, including future ones.
    let text = format!("{outcome:?}");
    for word in ["NaN", "inf"] {
        let found = text.split(|c: char| !c.is_alphanumeric()).any(|part| part == word);
        if found {
            let at = text.find(word).unwrap_or(0);
            let from = text[..at].rfind(": [").map_or(0, |from| from.saturating_sub(30));
            panic!("{word} at {}", &text[from..(from + 200).min(text.len())]);
        }
    }
}

/// Returns the names of all keys.
fn schema_keys(schema: &serde_json::Value) -> Vec<String> {
    fn visit(schema: &serde_json::Value, keys: &mut Vec<String>) {
        if let Some(properties) = schema.get("properties").and_then(|keys| keys.as_object()) {
            keys.extend(properties.keys().cloned());
        }
        match schema {
            serde_json::Value::Object(object) => object.values().for_each(|v| visit(v, keys)),
            serde_json::Value::Array(items) => items.iter().for_each(|v| visit(v, keys)),
            _ => {}
        }
    }
    let mut keys = Vec::new();
    visit(schema, &mut keys);
    keys.sort();
    keys.dedup();
    keys
}

fn mutate(case: &Shipped, keys: &[String], files: &mut InMemory, rng: &mut Rng) -> Vec<u8> {
    let mut text = case.text.clone();
    if rng.u8(..10) < 3 {
        let mut bytes = text.into_bytes();
        for _ in 0..rng.usize(1..6) {
            mutate_bytes(&mut bytes, rng);
        }
        return bytes;
    }
    for _ in 0..rng.usize(1..4) {
        let changed = mutate_structure(&text, keys, rng);
        // Most mutations should be valid TOML: an invalid one is tried again, once.
        text = match DeTable::parse(&changed) {
            Ok(_) => changed,
            Err(_) => mutate_structure(&text, keys, rng),
        };
    }
    if rng.u8(..10) == 0 {
        for survey in files.0.values_mut() {
            mutate_survey(survey, rng);
        }
    }
    text.into_bytes()
}

fn mutate_bytes(bytes: &mut Vec<u8>, rng: &mut Rng) {
    if bytes.is_empty() {
        return;
    }
    let at = rng.usize(..bytes.len());
    match rng.u8(..6) {
        0 => bytes[at] ^= 1 << rng.u8(..8),
        1 => bytes.truncate(at),
        2 => bytes.insert(at, rng.u8(..)),
        3 => {
            let end = (at + rng.usize(1..40)).min(bytes.len());
            bytes.drain(at..end);
        }
        4 => {
            let end = (at + rng.usize(1..200)).min(bytes.len());
            let piece = bytes[at..end].to_vec();
            let to = rng.usize(..bytes.len());
            bytes.splice(to..to, piece);
        }
        _ => {
            const SIGNS: &[u8] = b"[]{}=\"'.,#\n\r\t\\+-_eE0\0\xff";
            bytes[at] = SIGNS[rng.usize(..SIGNS.len())];
        }
    }
}

fn mutate_survey(survey: &mut Vec<u8>, rng: &mut Rng) {
    if rng.bool() {
        mutate_bytes(survey, rng);
        return;
    }
    let text = String::from_utf8_lossy(survey).into_owned();
    let mut lines: Vec<&str> = text.lines().collect();
    let replaced = format!("{},{},{}", number(rng), number(rng), number(rng));
    let at = rng.usize(..lines.len());
    let other = rng.usize(..lines.len());
    match rng.u8(..3) {
        0 => lines[at] = &replaced,
        1 => lines.swap(at, other),
        _ => lines.insert(at, lines[other]),
    }
    *survey = lines.join("\n").into_bytes();
}

/// Places of the keys and values of a case.
#[derive(Default)]
struct Sites {
    keys: Vec<Range<usize>>,
    scalars: Vec<Range<usize>>,
    lists: Vec<Range<usize>>,
}

fn sites(text: &str) -> Sites {
    fn visit(value: &toml::Spanned<DeValue<'_>>, sites: &mut Sites) {
        match value.get_ref() {
            DeValue::Table(table) => visit_table(table, sites),
            DeValue::Array(items) => {
                sites.lists.push(value.span());
                items.iter().for_each(|item| visit(item, sites));
            }
            _ => sites.scalars.push(value.span()),
        }
    }
    fn visit_table(table: &DeTable<'_>, sites: &mut Sites) {
        for (key, value) in table {
            sites.keys.push(key.span());
            visit(value, sites);
        }
    }
    let mut sites = Sites::default();
    if let Ok(table) = DeTable::parse(text) {
        visit_table(table.get_ref(), &mut sites);
    }
    sites
}

fn pick<T: Clone>(items: &[T], rng: &mut Rng) -> Option<T> {
    (!items.is_empty()).then(|| items[rng.usize(..items.len())].clone())
}

fn mutate_structure(text: &str, keys: &[String], rng: &mut Rng) -> String {
    let sites = sites(text);
    let mut changed = text.to_owned();
    let done = match rng.u8(..20) {
        0..=6 => pick(&sites.scalars, rng).map(|at| {
            let value = other_value(&text[at.clone()], rng);
            changed.replace_range(at, &value);
        }),
        7..=11 => pick(&sites.scalars, rng).map(|at| {
            let value = scaled(&text[at.clone()], rng);
            changed.replace_range(at, &value);
        }),
        12 => pick(&sites.scalars, rng).zip(pick(&sites.scalars, rng)).map(|(a, b)| {
            changed.replace_range(a, &text[b]);
        }),
        13 => pick(&sites.keys, rng).zip(pick(keys, rng)).map(|(at, key)| {
            changed.replace_range(at, &key);
        }),
        14 => pick(&sites.keys, rng).map(|at| {
            let mut name = text[at.clone()].to_owned();
            let place = rng.usize(..=name.len());
            if name.is_char_boundary(place) {
                name.insert(place, rng.lowercase());
            }
            changed.replace_range(at, &name);
        }),
        15 => pick(&sites.lists, rng).map(|at| {
            // The place of lists of headed tables is their first heading.
            let heading = text[at.clone()].starts_with("[[");
            changed.replace_range(at, if heading { "[mud]" } else { "[]" });
        }),
        16 => {
            let lines: Vec<&str> = text.lines().collect();
            let drop = rng.usize(..lines.len());
            let remaining = lines.iter().enumerate().filter(|(i, _)| *i != drop);
            changed = remaining.map(|(_, line)| *line).collect::<Vec<_>>().join("\n");
            Some(())
        }
        17 => {
            // A table duplicated, removed, or moved.
            let mut blocks: Vec<&str> = text.split("\n[").collect();
            let (a, b) = (rng.usize(..blocks.len()), rng.usize(..blocks.len()));
            match rng.u8(..3) {
                0 if a > 0 => blocks.insert(a, blocks[b]),
                1 if blocks.len() > 1 => {
                    blocks.remove(a);
                }
                _ => blocks.swap(a, b),
            }
            changed = blocks.join("\n[");
            Some(())
        }
        _ => pick(keys, rng).map(|key| {
            // A new key, in some table.
            let ends: Vec<usize> = text.match_indices("]\n").map(|(at, _)| at + 2).collect();
            let at = pick(&ends, rng).unwrap_or(0);
            let value = other_value("1", rng);
            changed.insert_str(at, &format!("{key} = {value}\n"));
        }),
    };
    done.map_or_else(|| text.to_owned(), |()| changed)
}

/// Returns numbers in forms that computers and people write.
fn number(rng: &mut Rng) -> String {
    const EXTREMES: &str = "\
        0 -0.0 1 -1 nan -nan inf -inf 1e308 -1e308 1e-308 1e400 4.9e-324 9223372036854775807 \
        -9223372036854775808 99999999999999999999 0xffffffff 1_000 1e-12 1e12 0.5 2 100 20000";
    if rng.bool() {
        let extremes: Vec<&str> = EXTREMES.split(' ').collect();
        extremes[rng.usize(..extremes.len())].to_owned()
    } else {
        let magnitude = rng.f64() * 24.0 - 12.0;
        format!("{:e}", 10_f64.powf(magnitude) * if rng.u8(..4) == 0 { -1.0 } else { 1.0 })
    }
}

fn other_value(old: &str, rng: &mut Rng) -> String {
    const UNITS: &[&str] = &[
        "m", "mm", "in", "ft", "kg/m3", "sg", "ppg", "kN", "tf", "klbf", "kN.m", "GPa", "psi", "s",
        "h", "rpm", "m/h", "deg", "kg/m", "N/m", "furlong", "", "1/s", "%",
    ];
    const WORDS: &[&str] = &[
        "soft",
        "dynamic",
        "stiff",
        "drill",
        "slide",
        "trip_in",
        "casing",
        "open",
        "to surface",
        "hertz",
        "linear",
        "vector",
        "centred",
        "block-velocity",
        "hook-load",
        "spline",
        "minimum-curvature",
        "field",
        "",
        " ",
        "../../x",
        "np13-x1042-survey.csv",
        "5 in 19.50 lb/ft G-105",
        "Gestänge ⌀ 5½″",
        "\\u0000",
        "\\n\\n",
        "5-1/2 in",
        "1/0 in",
    ];
    const ODD: &[&str] = &[
        "true",
        "1979-05-27",
        "[]",
        "{}",
        "[[]]",
        "[nan]",
        "[[0, 0, 0], [100, 0, 0]]",
        "'''a'''",
        "{ kinetic = 0.2, static = 0.3 }",
        "{ kinetic = 1e308 }",
        "[\"drill\", \"slide\"]",
    ];
    match rng.u8(..6) {
        0 | 1 => number(rng),
        2 | 3 => format!("\"{} {}\"", number(rng), UNITS[rng.usize(..UNITS.len())]),
        4 => match rng.u8(..12) {
            0 => format!("\"{}\"", "9".repeat(10_000)),
            1 => format!("\"{}\"", old.replace(['"', '\\'], "").repeat(3)),
            _ => format!("\"{}\"", WORDS[rng.usize(..WORDS.len())]),
        },
        _ => ODD[rng.usize(..ODD.len())].to_owned(),
    }
}

/// Returns the same quantity, a little or a lot larger or smaller: often still a valid case.
fn scaled(old: &str, rng: &mut Rng) -> String {
    let quoted = old.starts_with('"');
    let inside = old.trim_matches('"');
    let digits = inside.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(inside.len());
    let Ok(value) = inside[..digits].parse::<f64>() else {
        return other_value(old, rng);
    };
    let factor = match rng.u8(..3) {
        0 => 0.9 + 0.2 * rng.f64(),
        1 => 0.1 + 2.0 * rng.f64(),
        _ => 10_f64.powi(rng.i32(-4..5)),
    };
    let text = format!("{}{}", value * factor, &inside[digits..]);
    if quoted { format!("\"{text}\"") } else { text }
}

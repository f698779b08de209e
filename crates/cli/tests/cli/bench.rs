//! `wholestring bench`: its measurements and their output, never the speed of this machine.

use serde_json::Value;
use wholestring::{internals::instruction_sets, rock::Stepper};

use crate::desk::{Desk, args};

/// A short string of long elements, measured once: some hundredths of a second.
const SMALL: [&str; 6] =
    ["--repeat", "1", "--set", "bit_depth=400 m", "--set", "mesh.element_length=10 m"];

/// Output on the screen and in the file, for some parts.
fn measured(arguments: &[&str]) -> (String, Value) {
    let desk = Desk::new();
    let output = desk.done(&[&["bench", "--json", "speed.json"], arguments].concat());
    let json = desk.text("speed.json");
    (String::from_utf8(output.stdout).unwrap(), serde_json::from_str(&json).unwrap())
}

fn positive(number: &Value) -> bool {
    number.as_f64().is_some_and(|x| x > 0.0 && x.is_finite())
}

/// A row for each precision and each instruction set of this processor, the fastest first.
fn assert_every_instruction_set(rows: &Value) {
    let rows = rows.as_array().unwrap();
    let sets = instruction_sets();
    let expected: Vec<[&str; 2]> = ["double", "single"]
        .iter()
        .flat_map(|precision| sets.iter().map(|set| [*precision, *set]))
        .collect();
    let found: Vec<[&str; 2]> = rows
        .iter()
        .map(|row| ["precision", "instructions"].map(|key| row[key].as_str().unwrap()))
        .collect();
    assert_eq!(found, expected);
    for row in rows {
        let spread = &row["ns_per_element_step"];
        for key in ["median", "least", "most"] {
            assert!(positive(&spread[key]), "{row}");
        }
    }
}

#[test]
fn inner_loop_and_whole_run_with_every_instruction_set() {
    let (text, numbers) = measured(&[&["kernel", "run"], &SMALL[..]].concat());
    let kernel = &numbers["kernel"];
    assert_every_instruction_set(&kernel["rows"]);
    assert_every_instruction_set(&numbers["run"]);
    for row in kernel["rows"].as_array().unwrap() {
        assert!(positive(&row["gflop_per_s"]) && positive(&row["peak_gflop_per_s"]));
    }
    for row in numbers["run"].as_array().unwrap() {
        assert!(positive(&row["real_time_factor"]));
    }
    for kind in ["additions", "multiplications", "multiply_additions", "divisions", "roots"] {
        assert!(positive(&kernel["flops"][kind]), "{kind}");
    }
    for part in ["mechanisms", "memory", "sweep"] {
        assert!(numbers.get(part).is_none(), "{part} was not requested");
    }
    assert_eq!(numbers["bit_depth_m"], 400.0);
    for line in [
        "NP13-X1042 at total depth: bit at 400 m,",
        "median of 1\n",
        "The inner loop\nprecision  instructions  ns per element-step",
        "An element-step is ",
        "A whole run\nprecision  instructions  ns per element-step",
    ] {
        assert!(text.contains(line), "{line:?} is not in {text}");
    }
}

#[test]
fn what_each_mechanism_costs() {
    let (text, numbers) = measured(&[&["mechanisms"], &SMALL[..]].concat());
    let mechanisms = &numbers["mechanisms"];
    assert!(positive(&mechanisms["ns_per_element_step"]));
    let rows = mechanisms["rows"].as_array().unwrap();
    assert!(rows.len() >= 15);
    for row in rows {
        let name = row["mechanism"].as_str().unwrap();
        assert!(positive(&row["ns_per_element_step"]), "{row}");
        assert!(positive(&row["time_ratio"]["median"]), "{row}");
        assert!(text.contains(&format!("\n{name} ")), "{name}");
    }
}

/// All of the compressed rock yields, and some of that under the bit; the bit touches both.
#[test]
fn solid_rock_under_a_bit_with_every_instruction_set() {
    let (text, numbers) = measured(&["rock", "--repeat", "1"]);
    let rows = numbers["rock"]["rows"].as_array().unwrap();
    let sets: Vec<&str> = Stepper::all().iter().map(|s| s.instructions).collect();
    let found: Vec<&str> = rows.iter().map(|row| row["instructions"].as_str().unwrap()).collect();
    assert_eq!(found, [&sets[..], &sets[..]].concat());
    for (place, row) in rows.iter().enumerate() {
        assert!(positive(&row["ns_per_hexahedron_step"]["median"]), "{row}");
        assert!(positive(&row["contact_ns_per_hexahedron_step"]), "{row}");
        assert!(row["touching_nodes"].as_u64().unwrap() > 5, "{row}");
        let yielding = row["yielding"].as_f64().unwrap();
        let expected = if place < sets.len() { 0.001..0.5 } else { 0.95..1.1 };
        assert!(expected.contains(&yielding), "{row}");
    }
    assert!(numbers.get("kernel").is_none());
    assert!(text.contains("\nSolid rock, "), "{text}");
}

#[test]
fn a_sweep_of_every_law_and_precision() {
    let (text, numbers) = measured(&args(
        "sweep --set 'mesh.element_length=30 m' --set 'dynamics.settle=0.1 s' \
         --set 'dynamics.duration=0.1 s'",
    ));
    let sweep = &numbers["sweep"];
    assert_eq!(sweep["cases"], 60);
    let rows = sweep["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    for row in rows {
        let simulated = row["simulated_s"].as_f64().unwrap();
        assert!((simulated - 12.0).abs() < 1e-9, "{row}");
        assert!(positive(&row["wall_time_s"]), "{row}");
    }
    assert!(text.contains("A sweep of 60 cases on "), "{text}");
}

/// A run of 1346 elements over 80 s with tables and pictures, without frames, takes less than 50
/// MB. Measured: 40 MB, with optimised code. A run of seconds writes no checkpoint, and must not do
/// so on a slow machine, where it takes minutes.
#[test]
#[cfg(target_os = "linux")]
fn a_run_takes_less_than_50_MB() {
    let (text, numbers) = measured(&["memory", "--set", "dynamics.checkpoint_interval=1 h"]);
    let peak_MB = numbers["memory"]["peak_MB"].as_f64().unwrap();
    assert!(peak_MB > 1.0 && peak_MB < 50.0, "{text}");
}

/// A run of 81 000 samples takes little more memory than one of 21 000, because its series is on
/// disk. In memory, the 60 000 additional samples would take 70 MB.
#[test]
#[cfg(target_os = "linux")]
fn memory_does_not_grow_with_the_simulated_time() {
    let peak_MB = |duration: &'static str| {
        let case = args(
            "memory --set 'bit_depth=400 m' --set 'mesh.element_length=30 m' --set model=dynamic \
             --set 'dynamics.sample_interval=0.001 s' --set 'dynamics.settle=1 s' \
             --set 'dynamics.checkpoint_interval=1 h' --set",
        );
        let (_, numbers) = measured(&[&case[..], &[duration]].concat());
        numbers["memory"]["peak_MB"].as_f64().unwrap()
    };
    let [short_MB, long_MB] =
        [peak_MB("dynamics.duration=20 s"), peak_MB("dynamics.duration=80 s")];
    assert!(long_MB < short_MB + 10.0, "{short_MB} MB, {long_MB} MB");
}

#[test]
fn a_key_that_the_case_does_not_have_is_refused() {
    let output = Desk::new().run(&["bench", "--set", "mesh.element_lenght=10 m"]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("did you mean `element_length`?"), "{message}");
    assert!(output.stdout.is_empty());
}

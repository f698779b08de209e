//! Time of the stiff string by its length, and the rate and time of its solutions in random wells:
//! `cargo bench -p wholestring --bench stiff_string -- 1000`. With the word `whirl` the dynamics
//! determine whether the buckled strings that rotate roll around their holes for ever; `only 77
//! 220` solves one well, by its seed, with one weight in kN.
//!
//! The seeds are fixed: every machine tries the same [wells](well).

#[path = "../../tests/common/mod.rs"]
mod common;

mod attempt;
mod clock;
mod lengths;
mod well;

use attempt::{Class, End, Try};

/// Diameter of the hole, m.
const HOLE_M: f64 = 0.2159;

/// Weights on the bit while drilling and sliding, N: none, about the sinusoidal and the helical
/// load of 5 in pipe in such a horizontal hole, and twice the latter.
const WEIGHTS_N: [f64; 4] = [0.0, 150e3, 220e3, 440e3];

/// Wells of a list.
const LISTED: usize = 12;

/// Default number of wells.
const WELLS: u64 = 200;

/// Time in which a string reaches rest in the dynamics, if it does, and the window after it, s.
const WHIRL_S: [f64; 2] = [40.0, 40.0];

/// Solutions slower than this number of medians are counted.
const MEDIANS: f64 = 50.0;

fn main() {
    let words: Vec<String> = std::env::args().collect();
    if let Some(at) = words.iter().position(|word| word == "only") {
        let [seed, weight_kN] =
            [1, 2].map(|next| words[at + next].parse::<u64>().expect("a number"));
        let one = Try::well(seed, 1e3 * weight_kN as f64);
        println!("{}: {:?}", described(&one), one.end);
        if one.kind.rotates() {
            println!("  {} turns by the dynamics", turns(&one));
        }
        return;
    }
    let wells = words.iter().find_map(|word| word.parse().ok()).unwrap_or(WELLS);
    lengths::lengths();
    let weights =
        WEIGHTS_N.into_iter().flat_map(|weight_N| (0..wells).map(move |seed| (seed, weight_N)));
    let tried: Vec<Try> = weights.map(|(seed, weight_N)| Try::well(seed, weight_N)).collect();
    println!(
        "{wells} wells, each with four weights on the bit of what drills or slides: {} tries;",
        tried.len()
    );
    println!("compression along the soft string:");
    classes(&tried);
    times(&tried);
    let mut slowest: Vec<&Try> = tried.iter().collect();
    slowest.sort_by(|a, b| b.ms.total_cmp(&a.ms));
    let ended = |end: End| tried.iter().filter(move |one| one.end == end).take(LISTED);
    list("slowest", slowest.into_iter().take(LISTED));
    list("no reason", ended(End::NotConverged));
    list("found, but not stable", ended(End::Found { stable: false }));
    if words.iter().any(|word| word == "whirl") {
        whirls(&tried);
    }
}

/// Prints the results by compression; among those that have a static equilibrium and do not roll
/// for ever, the part that was found; and the part that was found or has a reason.
fn classes(tried: &[Try]) {
    println!(
        "| compression | tries | found | stable | locks up | rolls | no reason | found of those that \
         may rest, % | found or with a reason, % |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for class in Class::ALL {
        let members: Vec<&Try> = tried.iter().filter(|one| Class::of(one) == class).collect();
        let count = |end: End| members.iter().filter(|one| one.end == end).count();
        let found = members.iter().filter(|one| one.found()).count();
        let [locks_up, rolls, unknown] = [End::LocksUp, End::Rolls, End::NotConverged].map(count);
        let part = |some: usize, all: usize| 100.0 * some as f64 / all.max(1) as f64;
        println!(
            "| {} | {} | {found} | {} | {locks_up} | {rolls} | {unknown} | {:.1} | {:.1} |",
            class.name(),
            members.len(),
            count(End::Found { stable: true }),
            part(found, members.len() - rolls - locks_up),
            part(members.len() - unknown, members.len()),
        );
    }
}

/// Prints the times, and the number of solutions that took too long.
fn times(tried: &[Try]) {
    let sorted_ms = |belongs: &dyn Fn(&Try) -> bool| {
        let some = tried.iter().filter(|one| belongs(one));
        let mut times_ms: Vec<f64> = some.map(|one| one.ms).collect();
        times_ms.sort_by(f64::total_cmp);
        times_ms
    };
    let part =
        |times_ms: &[f64], part: f64| times_ms[((times_ms.len() - 1) as f64 * part) as usize];
    let median_ms = part(&sorted_ms(&|_| true), 0.5);
    type Belongs = fn(&Try) -> bool;
    let groups: [(&str, Belongs); 3] =
        [("all", |_| true), ("found", Try::found), ("not found", |one| !one.found())];
    for (name, belongs) in groups {
        let times_ms = sorted_ms(&belongs);
        let Some(most_ms) = times_ms.last() else { continue };
        let slow = times_ms.iter().filter(|ms| **ms > MEDIANS * median_ms).count();
        println!(
            "{name}: median {:.1} ms, 90 % {:.1} ms, 99 % {:.1} ms, most {most_ms:.1} ms; {slow} \
             slower than {MEDIANS} medians of all, {:.0} ms",
            part(&times_ms, 0.5),
            part(&times_ms, 0.9),
            part(&times_ms, 0.99),
            MEDIANS * median_ms
        );
    }
}

/// Prints a list of wells for inspection.
fn list<'a>(title: &str, tries: impl Iterator<Item = &'a Try>) {
    println!("{title}:");
    for one in tries {
        println!("  {}", described(one));
    }
}

fn described(one: &Try) -> String {
    let Try { seed, weight_N, kind, ms, steps, over: [sinusoidal, helical], .. } = one;
    format!(
        "seed {seed}, {:.0} kN, {}: {ms:.0} ms, {steps} steps, {sinusoidal:.2} of the sinusoidal \
         load, {helical:.2} of the helical",
        weight_N / 1e3,
        kind.name()
    )
}

/// Prints the whirl of the buckled strings that rotate, by the dynamics: the turns around the hole
/// in the window of the node that moves farthest.
fn whirls(tried: &[Try]) {
    for (name, found) in [("not found", false), ("found", true)] {
        let buckled = tried.iter().filter(|one| {
            Class::of(one) == Class::Buckled && one.kind.rotates() && one.found() == found
        });
        println!("{name} by the stiff string; turns backwards round the hole by the dynamics:");
        for one in buckled {
            println!("  {} turns: {}: {:?}", turns(one), described(one), one.end);
        }
    }
}

fn turns(one: &Try) -> String {
    let (model, operation) = well::well(one.seed, one.weight_N);
    let turns = common::whirl::turns(&model, &operation, WHIRL_S);
    turns.map_or("none".to_owned(), |turns| format!("{turns:.1}"))
}

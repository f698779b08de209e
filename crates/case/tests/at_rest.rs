//! The stiff string compared with the dynamics brought to rest, in every shipped case that has a
//! steady state: `cargo test -p wholestring-case --test at_rest -- --include-ignored --nocapture`
//! prints the table of `docs/src/theory/stiff-string.md`.

use std::{
    fs,
    path::{Path, PathBuf},
    sync::Mutex,
    thread,
};

use wholestring::{
    dynamics::{BitSettings, MeshSettings, RodDamping, Schedule, TopDriveSettings},
    outcome::Profile,
    prelude::*,
    statics::{
        soft::{self, SoftSettings},
        stiff::{self, StiffError, StiffProfile, StiffSettings},
    },
};
use wholestring_case::{Case, load};
use wholestring_verification::{report_worst, verify};

/// Length of the elements of both, m: two for each joint of pipe. The comparison is valid for any
/// mesh, because both have the same elements.
const ELEMENT_M: f64 = 4.8;

/// Time until the string is at rest, and the time over which it is averaged, s.
const SETTLE_S: f64 = 25.0;
const WINDOW_S: f64 = 5.0;

/// Mass-proportional damping that brings the string to rest, 1/s.
const DAMPING_PER_S: f64 = 0.5;

/// Largest speed of tripping and of rotation, so that operations are slow, m/s, rad/s.
const TRIP_M_PER_S: f64 = 0.02;
const TURN_RAD_PER_S: f64 = 3.0;

/// Torque of a bit of solid rock, which otherwise follows from the rock.
const TORQUE_N_M: f64 = 2000.0;
const RATE_M_PER_S: f64 = 0.004;

/// Tolerances: hook load and torque, as a part of them; side force per joint and bending moment at
/// joints, as a part of the largest; and the least parts of the joints and of the nodes that must
/// be within these and on the same side.
const SCALARS: f64 = 5e-3;
const ALONG: f64 = 2e-2;
const JOINTS: f64 = 0.97;
const SIDES: f64 = 0.99;

/// Largest variation of the surface torque of a string at rest, as a part of its mean; and the
/// least mean that counts as a torque, N·m.
const SWINGS: f64 = 1e-2;
const LEAST_TORQUE_N_M: f64 = 50.0;

/// Minimum number of operations that must agree.
const LEAST: usize = 28;

/// An operation of a case.
struct Job {
    case: String,
    model: Model,
    operation: Operation,
    settings: DynamicsSettings,
}

/// Returns the case files of a folder, without those of studies.
fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder);
    let mut files: Vec<PathBuf> = fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .filter(|path| !path.ends_with("Cargo.toml"))
        .filter(|path| !fs::read_to_string(path).expect("a text").contains("[[sweep]]"))
        .collect();
    files.sort();
    files
}

/// Returns every operation of every case, slow and quiet: no excitation of the bit, a constant
/// speed of the top, no schedule, static friction equal to kinetic friction, and more damping.
fn jobs() -> Vec<Job> {
    let quiet = |path: PathBuf| {
        let case = load(&path, &[]).unwrap_or_else(|report| panic!("{report}"));
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let Case { model, operations, dynamics, .. } = case;
        let own = dynamics.bit;
        let settings = DynamicsSettings {
            mesh: MeshSettings::uniform(ELEMENT_M),
            settle_s: SETTLE_S,
            duration_s: WINDOW_S,
            steady: None,
            schedule: Schedule::default(),
            damping: RodDamping { mass_per_s: DAMPING_PER_S, ..dynamics.damping },
            top_drive: TopDriveSettings::Constant,
            hoist_control: None,
            autodriller: Default::default(),
            bit: BitSettings {
                lateral_stiffness_N_per_m: own.lateral_stiffness_N_per_m,
                ..BitSettings::default()
            },
            ..dynamics
        };
        let model = slippery(&model);
        operations.into_iter().map(move |operation| {
            let on_bottom = operation.kind.on_bottom();
            let or = |own: f64, other: f64| if on_bottom && own == 0.0 { other } else { own };
            Job {
                case: name.clone(),
                model: model.clone(),
                operation: Operation {
                    bit_torque_N_m: or(operation.bit_torque_N_m, TORQUE_N_M),
                    rate_of_penetration_m_per_s: or(
                        operation.rate_of_penetration_m_per_s,
                        RATE_M_PER_S,
                    ),
                    trip_speed_m_per_s: operation.trip_speed_m_per_s.min(TRIP_M_PER_S),
                    rotary_speed_rad_per_s: operation.rotary_speed_rad_per_s.min(TURN_RAD_PER_S),
                    ..operation
                },
                settings: settings.clone(),
            }
        })
    };
    ["cases", "studies"].into_iter().flat_map(files).flat_map(quiet).collect()
}

/// Returns the model with kinetic friction only, because a string that sticks and slips has no
/// rest.
fn slippery(model: &Model) -> Model {
    let sections = model.well.hole.sections().iter().map(|section| {
        let mut section = *section;
        section.friction.at_rest = section.friction.kinetic;
        section
    });
    let hole = Hole::new(sections.collect()).expect("a sound hole");
    let hole = hole.with_roughness(model.well.hole.roughness().copied()).expect("a sound hole");
    Model { well: Well { path: model.well.path.clone(), hole }, ..model.clone() }
}

/// Differences between the two.
#[derive(Debug)]
struct Apart {
    hook: f64,
    torque: f64,
    /// The parts of the joints whose forces and moments agree.
    pressed: f64,
    bent: f64,
    sides: f64,
    /// Swings of the dynamic torque and weight on bit about their means, as parts of them.
    torque_swings: f64,
    weight_swings: f64,
}

impl Apart {
    fn of(stiff: &StiffProfile, moving: &DynamicOutcome, kind: OperationKind) -> Self {
        let part = |found: f64, expected: f64| {
            if found == expected { 0.0 } else { (found - expected).abs() / expected.abs() }
        };
        let joints: Vec<usize> = (0..moving.nodes.md_m.len())
            .filter(|node| moving.nodes.side_force_per_joint_N[*node].is_some())
            .collect();
        let all: Vec<usize> = (0..moving.nodes.md_m.len()).collect();
        // Pipe without distinct joints presses along its length.
        let nodes = if joints.is_empty() { &all } else { &joints };
        let sides = |node: &usize| side(stiff, *node) == side(&moving.nodes, *node);
        let torque = moving.statistic("surface_torque_N_m").expect("a statistic");
        let weight = moving.statistic("weight_on_bit_N").expect("a statistic");
        // A string that does not rotate has the torque of the bit, or next to none.
        let twisted = kind.rotates() && torque.mean > LEAST_TORQUE_N_M;
        Self {
            hook: part(stiff.scalars.hook_load_N, moving.scalars.hook_load_N),
            torque: if twisted {
                part(stiff.scalars.surface_torque_N_m, moving.scalars.surface_torque_N_m)
            } else {
                0.0
            },
            pressed: alike(nodes, &stiff.side_force_N_per_m, &moving.nodes.side_force_N_per_m),
            bent: alike(nodes, &stiff.bending_moment_N_m, &moving.nodes.bending_moment_N_m),
            sides: share(&all, sides),
            torque_swings: if twisted { torque.std / torque.mean } else { 0.0 },
            weight_swings: if kind.on_bottom() { weight.std / weight.mean } else { 0.0 },
        }
    }
}

/// Returns the share of the nodes at which two columns agree within the tolerance.
fn alike(nodes: &[usize], found: &[f64], expected: &[f64]) -> f64 {
    let largest = nodes.iter().map(|node| expected[*node].abs()).fold(0.0, f64::max);
    share(nodes, |node| (found[*node] - expected[*node]).abs() <= ALONG * largest)
}

fn share(nodes: &[usize], holds: impl Fn(&usize) -> bool) -> f64 {
    nodes.iter().filter(|node| holds(node)).count() as f64 / nodes.len() as f64
}

/// Returns the side on which a node presses its hole.
fn side(profile: &Profile, node: usize) -> i8 {
    let force = profile.side_force_N_per_m[node];
    i8::from(force > 0.0) - i8::from(force < 0.0)
}

/// Returns the largest compression along the soft string over the load of the sinusoid.
fn over_sinusoidal(job: &Job) -> f64 {
    let soft =
        soft::solve(&job.model, &job.operation, &SoftSettings::default()).expect("a soft string");
    let pairs = soft.tension_N.iter().zip(&soft.sinusoidal_load_N);
    pairs.filter_map(|(tension_N, load_N)| Some(-tension_N / (*load_N)?)).fold(0.0, f64::max)
}

/// Returns the reason why the two need not agree, as far as string and motion show it.
fn reason(
    job: &Job,
    over: f64,
    stiff: &Result<StiffProfile, StiffError>,
    apart: Option<&Apart>,
) -> Option<String> {
    let bent = job.model.string.components().iter().any(|component| component.bend.is_some());
    let swings = |swing: fn(&Apart) -> f64| apart.is_some_and(|apart| swing(apart) > SWINGS);
    match stiff {
        Err(error) if over > 1.0 => Some(format!("buckled: {}", in_a_word(error))),
        Ok(found) if !found.convergence.stable => Some("buckled, and would not stay".to_owned()),
        _ if over > 1.0 => Some("buckled: many states of rest".to_owned()),
        _ if bent && job.operation.kind.rotates() => Some("a bend that turns".to_owned()),
        _ if swings(|apart| apart.weight_swings) => Some("the weight on the bit swings".to_owned()),
        _ if swings(|apart| apart.torque_swings) => Some("the torque swings".to_owned()),
        _ => None,
    }
}

fn in_a_word(error: &StiffError) -> &'static str {
    match error {
        StiffError::LocksUp { .. } | StiffError::RunsAway { .. } => "locks up",
        StiffError::Rolls { .. } => "rolls",
        _ => "not found",
    }
}

/// Result of an operation.
struct Tried {
    apart: Option<Apart>,
    reason: Option<String>,
    /// Its row of the table.
    line: String,
}

fn try_job(job: &Job) -> Tried {
    let mut simulation =
        Simulation::new(&job.model, &job.operation, &job.settings).expect("a valid case");
    let moving = simulation.advance(simulation.end_time_s()).map(|()| simulation.outcome());
    let mut at = job.operation;
    if let Ok(moving) = &moving
        && at.kind.on_bottom()
    {
        // The driller's weight differs slightly from the requested one.
        at.weight_on_bit_N = moving.scalars.weight_on_bit_N;
        at.bit_torque_N_m = moving.scalars.bit_torque_N_m;
    }
    let over = over_sinusoidal(job);
    // The dynamics have the weight at the nodes alone.
    let settings = StiffSettings { lumped_weight: true, ..job.settings.stiff_string() };
    let stiff = stiff::solve(&job.model, &at, &settings);
    let apart = stiff.as_ref().ok().zip(moving.as_ref().ok());
    let apart = apart.map(|(stiff, moving)| Apart::of(stiff, moving, at.kind));
    let reason = reason(job, over, &stiff, apart.as_ref());
    let differ = match &apart {
        Some(apart) => format!(
            "{:.1e} | {} | {:.1} | {:.1} | {:.1}",
            apart.hook,
            if apart.torque > 0.0 { format!("{:.1e}", apart.torque) } else { "–".to_owned() },
            100.0 * apart.pressed,
            100.0 * apart.bent,
            100.0 * apart.sides
        ),
        None => "– | – | – | – | –".to_owned(),
    };
    let name = job.operation.kind.name().replace('_', " ");
    let remark = reason.as_deref().unwrap_or("");
    let line = format!("| {} | {name} | {over:.2} | {differ} | {remark} |", job.case);
    Tried { apart, reason, line }
}

/// Every operation of every case: hook load and torque within 0.5 %, forces and moments of 99 % of
/// the joints within 2 % of the largest, 99 % of the nodes on the same side. The remaining
/// operations are buckled, have a bend that turns, or whirl.
#[test]
#[ignore = "minutes: run by cargo xtask verify"]
fn rests_where_the_dynamics_do_in_every_case() {
    let jobs = jobs();
    let next = Mutex::new(0..jobs.len());
    let tried = Mutex::new(Vec::new());
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let index = next.lock().expect("no panic").next();
                    let Some(index) = index else { break };
                    let result = try_job(&jobs[index]);
                    tried.lock().expect("no panic").push((index, result));
                }
            });
        }
    });
    let mut tried = tried.into_inner().expect("no panic");
    tried.sort_by_key(|(index, _)| *index);
    println!(
        "| case | operation | F/Fs | hook load | torque | joints press, % | bend, % | sides, % | |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for (_, result) in &tried {
        println!("{}", result.line);
    }
    let held: Vec<&Apart> = tried
        .iter()
        .filter(|(_, result)| result.reason.is_none())
        .map(|(_, result)| result.apart.as_ref().unwrap_or_else(|| panic!("{}", result.line)))
        .collect();
    assert!(held.len() >= LEAST, "{} of {} are to agree", held.len(), tried.len());
    type Of = fn(&Apart) -> f64;
    let numbers: [(&str, Of, f64, &str); 5] = [
        ("hook load", |apart| apart.hook, SCALARS, "required"),
        ("torque", |apart| apart.torque, SCALARS, "required"),
        (
            "joints that press otherwise",
            |apart| 1.0 - apart.pressed,
            1.0 - JOINTS,
            "2 % of the largest",
        ),
        (
            "joints that bend otherwise",
            |apart| 1.0 - apart.bent,
            1.0 - JOINTS,
            "2 % of the largest",
        ),
        ("nodes on another side", |apart| 1.0 - apart.sides, 1.0 - SIDES, "required"),
    ];
    for (what, number, most, reason) in numbers {
        let quantity = format!("stiff string against the dynamics: {what} as a part");
        let row = |apart: &&Apart| {
            verify("at rest", quantity.clone()).absolute(most, reason).row(0.0, number(apart))
        };
        report_worst(held.iter().map(row));
    }
}

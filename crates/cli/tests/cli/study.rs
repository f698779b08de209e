//! `study`: the small shipped study, from its file to its page.

use std::{fs, path::Path, process::Output};

use insta::assert_snapshot;

use crate::{
    desk::{Desk, args, masked, text as text_of, transcript},
    sweep::split,
};

/// A desk with the shipped studies.
fn desk() -> Desk {
    let desk = Desk::new();
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    for name in ["friction-on-a-slant.toml", "slant-30.toml"] {
        fs::copy(studies.join(name), desk.path(name)).unwrap();
    }
    desk
}

fn study(desk: &Desk, more: &[&str]) -> Output {
    let all = [&["study", "friction-on-a-slant.toml", "-o", "results"], more].concat();
    desk.run(&all)
}

fn read(desk: &Desk, name: &str) -> String {
    desk.text(&format!("results/{name}"))
}

/// Rows of a table of the study as label, model, computed and whether it agrees.
fn rows(desk: &Desk, name: &str) -> Vec<[String; 4]> {
    let text = read(desk, &format!("tables/{name}"));
    let mut lines = text.lines().map(split);
    let heads = lines.next().unwrap();
    let places = ["label", "model", "computed", "agrees"]
        .map(|name| heads.iter().position(|head| head == name).unwrap());
    let rows = lines.map(|cells| places.each_ref().map(|place| cells[*place].clone()));
    rows.collect()
}

/// Statics agree with their closed forms, and so do the dynamics where a soft string does not.
#[test]
fn the_small_study_meets_its_closed_forms() {
    let desk = desk();
    let output = study(&desk, &[]);
    assert_snapshot!(masked(&transcript(&output)));
    let statics = rows(&desk, "statics.csv");
    assert_eq!(statics.len(), 8);
    for [label, _, computed, agrees] in &statics {
        assert_eq!(agrees, "yes", "{label}: {computed}");
    }
    let dynamics = rows(&desk, "dynamics.csv");
    assert_eq!(dynamics.len(), 8, "{dynamics:?}");
    for [label, model, computed, agrees] in &dynamics {
        let climbs = label.starts_with("friction torque");
        let expected = if climbs && model == "soft" { "no" } else { "yes" };
        assert_eq!(agrees, expected, "{label}, {model}: {computed}");
    }

    // A case for each combination, and the exception where it applies.
    assert_eq!(desk.summary("results/statics/friction=0.35,bit_depth=2000m").operations.len(), 3);
    for (friction, settle_s) in [("0.1", 8.0), ("0.2", 6.0)] {
        let case = format!("results/dynamics/friction={friction},bit_depth=300 m");
        let summary = desk.summary(&case);
        assert_eq!(summary.settings["dynamics"]["settle_s"], settle_s);
    }
    assert_eq!(read(&desk, "statics/sweep.csv").lines().count(), 1 + 24 * 3);

    // The figure draws its own data.
    let torque = read(&desk, "figures/torque.csv");
    assert_eq!(
        torque.lines().next(),
        Some("sweep,model,operation,bit_depth,friction,quantity,value")
    );
    assert_eq!(torque.lines().count(), 1 + 24);
    let hook_load = read(&desk, "figures/hook-load.csv");
    assert_eq!(hook_load.lines().count(), 1 + 3 * 4 * 2);
    let svg = read(&desk, "figures/torque.svg");
    assert!(svg.contains("what a small top drive gives") && svg.contains("bit depth 2000 m"));
    let page = read(&desk, "report.html");
    // Each of the five figures for a wide page and for a narrow one.
    assert_eq!(page.matches("<svg").count(), 2 * 5);
    assert_eq!(page.matches("<table>").count(), 2);
    assert_eq!(page.matches("class=\"differs\"").count(), 2);
    for from_elsewhere in ["src=\"", "href=\"http", "@import", "url(h"] {
        assert!(!page.contains(from_elsewhere), "{from_elsewhere}");
    }
    let markdown = read(&desk, "tables/dynamics.md");
    assert!(markdown.contains("| soft string | dynamics |"), "{markdown}");
    // The study is no result of one kind; its sweeps are.
    for command in ["report", "plot", "export"] {
        let output = desk.run(&[command, "results"]);
        assert_eq!(output.status.code(), Some(2), "{command}");
        let stderr = text_of(&output.stderr);
        assert!(stderr.contains("results holds a study; name the folder of one of"), "{stderr}");
    }
}

/// A study of the test's own case: two wells in two sweeps, and maps of contact.
const MAPS: &str = r#"
name = "Maps"

[[sweep]]
name = "slow"
case = "slant.toml"
set = { "operation.kind" = "rotate_off_bottom", model = "dynamic", rpm = 30 }
vary = { bit_depth = ["300 m", "500 m"] }

[[sweep]]
name = "steeper"
case = "slant.toml"
set = { "operation.kind" = "rotate_off_bottom", model = "soft", "well.stations" = [[0, 30, 0], [600, 30, 0]] }
vary = { bit_depth = ["300 m", "500 m"] }

[[figure]]
name = "map"
title = "Where it touches"
sweeps = "slow"
from = "contact"
x = "time_s"
y = "md_m"
colour = "side_force_N_per_m"
window = ["0.5 s", "1.5 s"]

[[figure.level]]
label = "a seam"
value = "100 m"

[[figure]]
name = "path"
title = "The well"
sweeps = "slow"
only = { bit_depth = "500 m" }
from = "path"
x = "inclination_rad"
y = "md_m"

[[figure]]
name = "paths"
title = "The wells"
only = { bit_depth = "500 m" }
from = "path"
x = "inclination_rad"
y = "md_m"

[[table]]
name = "contact"
title = "Contact"
sweeps = "slow"
only = { bit_depth = "500 m" }

[[table.row]]
label = "side force at a depth and a time"
from = "contact"
column = "side_force_N_per_m"
depth = "250 m"
time = "1.5 s"

[[table.row]]
label = "least of a time"
from = "contact"
column = "side_force_N_per_m"
time = "1.5 s"
statistic = "min"

[[table.row]]
label = "most force of the window"
from = "contact"
column = "contact_force_N_per_m"
statistic = "max"
"#;

/// Maps show the table of contact, wells are drawn once and named if there are several, and
/// overrides of the command line apply to every case.
#[test]
fn maps_and_wells_are_drawn() {
    let desk = Desk::new();
    fs::write(desk.path("maps.toml"), MAPS).unwrap();
    let study = args("study maps.toml -o results --quiet");
    let done = |more: &[&str]| desk.done(&[&study, more].concat());
    done(&["--set", "mesh.element_length=8 m", "--png"]);
    for case in ["slow/bit_depth=300 m", "steeper/bit_depth=500 m"] {
        let summary = desk.summary(&format!("results/{case}"));
        assert_eq!(summary.settings["mesh"]["element_length_m"], 8.0, "{case}");
    }

    // Two maps over the half second on either side of the start of the window, and a line across
    // each.
    let map = read(&desk, "figures/map.svg");
    assert_eq!(map.matches("<image").count(), 2 * 2, "each with its colours");
    for text in ["Bit depth 300 m", "Bit depth 500 m", "a seam", "high side"] {
        assert!(map.contains(text), "{text}");
    }
    let contact = desk.table("results/slow/bit_depth=500 m/contact.parquet");
    let column = |name: &str| -> Vec<f64> {
        contact.numbers(name).expect(name).iter().map(|number| number.unwrap()).collect()
    };
    let (times, depths) = (column("time_s"), column("md_m"));
    let forces = column("side_force_N_per_m");
    let data = read(&desk, "figures/map.csv");
    let mut lines = data.lines();
    assert_eq!(lines.next(), Some("sweep,model,operation,bit_depth,time_s,md_m,quantity,value"));
    let seen: Vec<Vec<f64>> = lines
        .map(split)
        .filter(|cells| cells[3] == "500 m")
        .map(|cells| [4, 5, 7].map(|index: usize| cells[index].parse().unwrap()).into())
        .collect();
    let rows_between =
        (0..times.len()).filter(|row| times[*row] > 0.5 + 1e-6 && times[*row] < 1.5 + 1e-6);
    let rows_between: Vec<Vec<f64>> =
        rows_between.map(|row| vec![times[row], depths[row], forces[row]]).collect();
    assert!(rows_between.len() > 1000, "{}", rows_between.len());
    assert_eq!(seen, rows_between);

    // The table uses the same rows.
    let numbers = rows(&desk, "contact.csv");
    let computed: Vec<f64> = numbers.iter().map(|row| row[2].parse().unwrap()).collect();
    // A sample is a whole number of steps: no row ends exactly at the half second.
    let near = |value: &f64, target: f64| (value - target).abs();
    let nearest = |values: &[f64], target: f64| {
        let all = values.iter().copied();
        all.min_by(|a, b| near(a, target).total_cmp(&near(b, target)))
    };
    let time_s = nearest(&times, 1.5).unwrap();
    let rows: Vec<usize> = (0..times.len()).filter(|row| times[*row] == time_s).collect();
    let there: Vec<f64> = rows.iter().map(|row| depths[*row]).collect();
    let depth_m = nearest(&there, 250.0).unwrap();
    let row = rows.iter().find(|row| depths[**row] == depth_m).unwrap();
    assert_eq!(computed[0], forces[*row]);
    let at_time = rows.iter().map(|row| forces[*row]);
    assert_eq!(computed[1], at_time.fold(f64::INFINITY, f64::min));
    let sizes = column("contact_force_N_per_m").into_iter().zip(&times);
    let window = sizes.filter(|(_, time_s)| **time_s > 1.0);
    let most = window.map(|(size, _)| size).fold(0.0, f64::max);
    assert_eq!(computed[2], most);

    // One well has no name, two have those of their sweeps; each is drawn once.
    let texts = |name: &str| read(&desk, &format!("figures/{name}.svg"));
    let one = texts("path");
    assert!(!one.contains("dynamics") && !one.contains("soft string"));
    let two = texts("paths");
    for name in ["slow", "steeper"] {
        assert!(two.contains(name), "{name}");
    }
    let page = read(&desk, "report.html");
    for name in ["map", "path", "paths"] {
        assert!(page.contains(&format!("href=\"figures/{name}.png\"")));
        let painted = fs::read(desk.path(&format!("results/figures/{name}.png"))).unwrap();
        assert_eq!(painted[..4], *b"\x89PNG");
    }

    // A varied key cannot be set for all cases; earlier PNG files are removed unless requested
    // again.
    let output = desk.run(&[&study[..], &["--set", "bit_depth=400m"]].concat());
    assert_eq!(output.status.code(), Some(2));
    assert!(
        transcript(&output).contains("error: `bit_depth` cannot be set, sweep `slow` varies it"),
        "{}",
        transcript(&output)
    );
    done(&["--set", "mesh.element_length=8 m", "--resume"]);
    assert!(!desk.path("results/figures/map.png").exists());
}

/// Pulling takes `w L (cos i + μ sin i)`, 88 kN at 300 m and 147 kN at 500 m: a hoist of 120 kN
/// lifts only the first, and the figure rings the other.
#[test]
fn a_case_with_an_error_is_ringed() {
    const STUDY: &str = r#"
name = "Lifts"

[[sweep]]
name = "lifts"
case = "slant.toml"
set = { "operation.kind" = "trip_out", model = "soft" }
vary = { bit_depth = ["300 m", "500 m"] }

[[figure]]
name = "load"
title = "Hook load against depth"
x = "bit_depth"
y = "hook_load_N"
"#;
    let desk = Desk::new();
    fs::write(desk.path("lifts.toml"), STUDY).unwrap();
    // A ring in the legend and one for each case with an error.
    for (capacity, rings) in [("rig.hoist_capacity=120 kN", 2), ("rig.hoist_capacity=200 kN", 0)] {
        let folder = format!("results-{rings}");
        let study = ["study", "lifts.toml", "-o", &folder, "--quiet"];
        desk.done(&[&study[..], &["--set", capacity]].concat());
        let svg = desk.text(&format!("{folder}/figures/load.svg"));
        assert_eq!(svg.matches("stroke-over").count(), rings, "{svg}");
        assert_eq!(svg.contains("with errors"), rings > 0);
    }
}

/// The study of the book's tour gives the results in the book, with the soft string.
#[test]
fn the_tours_study_answers_as_told() {
    let desk = Desk::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    fs::copy(root.join("cases/slant.toml"), desk.path("my-well.toml")).unwrap();
    let tour = fs::read_to_string(root.join("docs/src/tour.md")).unwrap();
    let (_, rest) = tour.split_once("```toml\n").unwrap();
    let (study, rest) = rest.split_once("```").unwrap();
    fs::write(desk.path("my-study.toml"), study).unwrap();
    let output = desk.run(&["study", "my-study.toml", "--set", "model=soft"]);
    let text = transcript(&output);
    let folder = "out/Is the top drive strong enough-";
    assert!(text.contains("12 of 12 cases finished"), "{text}");
    assert!(text.contains(folder) && rest.contains(folder), "{text}");
    let table = desk.text(&format!("{folder}/tables/table-01.md"));
    let numbers = |text: &str| -> Vec<[String; 2]> {
        let rows = text.lines().filter(|line| line.starts_with("| torque with"));
        rows.map(|row| {
            let cells: Vec<&str> = row.split('|').map(str::trim).collect();
            [1, 4].map(|cell| cells[cell].to_owned())
        })
        .collect()
    };
    assert_eq!(numbers(&table).len(), 2, "{table}");
    assert_eq!(numbers(rest), numbers(&table));
}

/// After all shares, a resumed study solves nothing again and shows all results.
#[test]
fn shares_make_a_whole() {
    let desk = desk();
    for shard in ["1/2", "2/2"] {
        let output = study(&desk, &["--shard", shard, "--quiet"]);
        assert!(output.status.success(), "{}", transcript(&output));
    }
    let solved = |name: &str| {
        let path = desk.path("results/statics").join(name).join("summary.json");
        fs::metadata(path).unwrap().modified().unwrap()
    };
    let before = solved("friction=0.2,bit_depth=500m");
    let output = study(&desk, &["--resume"]);
    assert!(transcript(&output).contains("30 of 30 cases finished"), "{}", transcript(&output));
    assert_eq!(solved("friction=0.2,bit_depth=500m"), before);
    assert_eq!(rows(&desk, "statics.csv").len(), 8);
}

/// Simultaneous shares leave the tables and the page of the whole study.
#[test]
fn shares_at_once_make_a_whole() {
    let desk = desk();
    let done = study(&desk, &["--quiet"]);
    assert!(done.status.success(), "{}", transcript(&done));
    let begun = ["1/3", "2/3", "3/3"].map(|shard| {
        let arguments =
            ["study", "friction-on-a-slant.toml", "-o", "shares", "--quiet", "--resume", "--shard"];
        let mut command = desk.command(&[&arguments[..], &[shard]].concat());
        command.stderr(std::process::Stdio::piped()).spawn().unwrap()
    });
    for share in begun {
        let output = share.wait_with_output().unwrap();
        assert!(output.status.success(), "{}", transcript(&output));
    }
    for name in ["statics/sweep.csv", "tables/statics.csv"] {
        assert_eq!(desk.text(&format!("shares/{name}")), read(&desk, name), "{name}");
    }
}

/// A mistake in a case of the study is underlined in the study file.
#[test]
fn mistakes_are_underlined_in_the_study() {
    let desk = desk();
    let file = desk.path("friction-on-a-slant.toml");
    let text = fs::read_to_string(&file).unwrap();
    let set = text.replace("\"dynamics.settle\" = \"8 s\"", "\"dynamics.setle\" = \"8 s\"");
    assert_ne!(set, text);
    fs::write(&file, set).unwrap();
    let output = study(&desk, &[]);
    assert_snapshot!(transcript(&output));
    assert!(!desk.path("results").exists());

    let varied = text.replace("friction = [0.1, 0.2, 0.35]", "friction = [0.1, 20, 0.35, 0.2]");
    assert_ne!(varied, text);
    fs::write(&file, varied.replace("only = { friction = 0.2 }", "only = { friction = 0.35 }"))
        .unwrap();
    let output = study(&desk, &[]);
    assert_snapshot!(transcript(&output));

    fs::write(&file, text.replace("slant-30.toml\"", "slant-31.toml\"")).unwrap();
    assert_snapshot!(transcript(&study(&desk, &[])));
}

/// A figure and a row of a table that nothing is solved for are mistakes of the study; where all
/// cases are changed, they are only mentioned.
#[test]
fn what_shows_nothing_is_a_mistake() {
    let desk = desk();
    let file = desk.path("friction-on-a-slant.toml");
    let text = fs::read_to_string(&file).unwrap();
    let figure = "[[figure]]\nname = \"none\"\ntitle = \"None\"\noperations = \"back_ream\"\n\
                  x = \"friction\"\ny = \"hook_load_N\"\n";
    fs::write(&file, format!("{text}\n{figure}")).unwrap();
    let output = study(&desk, &[]);
    assert_eq!(output.status.code(), Some(2));
    let stderr = text_of(&output.stderr);
    assert!(stderr.contains("figure `none` has no results: it shows back_ream, and"), "{stderr}");
    assert!(!desk.path("results").exists());
}

/// All cases of the article's campaign are valid, and its table has the numbers of the article.
#[test]
fn the_articles_study_is_sound() {
    let desk = Desk::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let file = root.join("studies/full-hole-system-dynamics.toml");
    // The very last case is a soft string, which is solved almost instantly.
    let output =
        desk.run(&["study", file.to_str().unwrap(), "-o", "results", "--shard", "180/180"]);
    let text = transcript(&output);
    assert!(text.contains("1 of 1 case finished"), "{text}");
    assert!(text.ends_with("--- standard error\n"), "{text}");

    let text = fs::read_to_string(root.join("verification/G01_paper_targets.json")).unwrap();
    let article: serde_json::Value = serde_json::from_str(&text).unwrap();
    let numbers = read(&desk, "tables/numbers.md");
    let entry = |label: &str| {
        let mut rows = numbers.lines().filter_map(|line| {
            let cells: Vec<&str> = line.split('|').map(str::trim).collect();
            let number = cells.get(3)?.split(' ').next()?.parse::<f64>().ok()?;
            cells[1].starts_with(label).then_some(number)
        });
        rows.next().unwrap_or_else(|| panic!("{label}: {numbers}"))
    };
    for friction in ["0.1", "0.3"] {
        for (quantity, label) in [
            ("mean_friction_torque_kNm", "friction torque, friction"),
            ("max_static_torque_kNm", "maximum static friction torque, friction"),
            ("axial_friction_kN", "axial friction, friction"),
        ] {
            let printed = article["outputs"][quantity][friction].as_f64().unwrap();
            assert_eq!(entry(&format!("{label} {friction}")), printed, "{quantity}");
        }
    }
    assert_eq!(entry("largest contact force"), article["outputs"]["contact_force_max_kN"]);
}

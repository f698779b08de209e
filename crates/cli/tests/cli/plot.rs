//! `plot`: the plots of a run, of two on the same axes, and of a sweep.

use std::{collections::BTreeSet, fs};

use insta::assert_snapshot;

use crate::desk::{Desk, args, text, transcript};

const SOFT: [&str; 2] = ["--set", "model=soft"];

fn run(desk: &Desk, folder: &str, more: &[&str]) {
    let arguments = [&["run", "slant.toml", "--quiet", "-o", folder], more].concat();
    desk.done(&arguments);
}

fn files(desk: &Desk, folder: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(desk.path(folder)).unwrap();
    entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

fn read(desk: &Desk, name: &str) -> String {
    let svg = desk.text(name);
    assert!(svg.starts_with("<?xml") && svg.ends_with("</svg>\n"), "{name}");
    // Encoded pixels may contain any text.
    if !svg.contains("<image") {
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
    }
    svg
}

/// Text of a picture, in the order of drawing.
fn texts(svg: &str) -> Vec<&str> {
    let texts = svg.split("<text ").skip(1);
    texts.map(|text| text.split_once('>').unwrap().1.split_once("</text>").unwrap().0).collect()
}

#[test]
fn a_run_is_drawn() {
    let desk = Desk::new();
    let more = args(
        r#"--set records.spectra=["hook_load"] --set records.node_spectra=["torque"]
           --set 'records.node_spectra_at=["100 m", "500 m"]' --set mesh.element_length=3.2m"#,
    );
    run(&desk, "out", &more);
    let output = desk.done(&["plot", "out", "--units", "field", "--png"]);
    let names = files(&desk, "out/plots");
    assert_eq!(text(&output.stdout), format!("{} pictures in out/plots\n", names.len() / 2));
    let list: Vec<&str> = names.iter().map(String::as_str).collect();
    assert_snapshot!("names_of_a_run", list.join("\n"));
    for name in names.iter().filter(|name| name.ends_with(".svg")) {
        read(&desk, &format!("out/plots/{name}"));
    }
    let tension = read(&desk, "out/plots/tension.svg");
    for text in ["Straight slant", "Effective tension", "klbf", "Measured depth, ft", "trip out"] {
        assert!(texts(&tension).contains(&text), "{text}");
    }
    let spectrum = read(&desk, "out/plots/spectrum-torque-nodes-trip-out.svg");
    assert!(texts(&spectrum).contains(&"Density of torque, (ft·lbf)²/Hz"));
    // Two nodes, those nearest to 328 and 1640 ft.
    let depths = texts(&spectrum).into_iter().filter_map(|text| text.strip_prefix("at "));
    let depths: Vec<&str> = depths.collect();
    assert!(
        depths.len() == 2 && depths[0].starts_with("32") && depths[1].starts_with("164"),
        "{depths:?}"
    );
    // 85 mm at 300 dots per inch: the width is in the first bytes of the file.
    let png = fs::read(desk.path("out/plots/tension.png")).unwrap();
    assert_eq!(png[16..20], 1004_u32.to_be_bytes());

    // A second call without PNG removes the earlier PNG files.
    desk.done(&["plot", "out"]);
    assert_eq!(files(&desk, "out/plots").len(), names.len() / 2);
}

/// A run's own picture equals that of `plot`.
#[test]
fn the_profile_of_a_run_is_the_same() {
    let desk = Desk::new();
    run(&desk, "out", &["--units", "metric"]);
    desk.done(&["plot", "out", "--units", "metric", "-o", "pictures"]);
    assert_eq!(read(&desk, "pictures/profile.svg"), read(&desk, "out/profile.svg"));
}

#[test]
fn two_runs_stand_on_the_same_axes() {
    let desk = Desk::new();
    run(&desk, "first", &[]);
    let second = ["--set", "friction=0.4", "--set", r#"name="Rough & ready""#];
    run(&desk, "second", &second);
    let output = desk.done(&["plot", "first", "second"]);
    let stdout = text(&output.stdout);
    assert!(stdout.ends_with("pictures in first/plots-second\n"), "{stdout}");
    // Each operation has its own.
    for operation in ["trip-out", "rotate-off-bottom"] {
        for name in ["profile", "time-hook-load", "map-side-force"] {
            let svg = read(&desk, &format!("first/plots-second/{name}-{operation}.svg"));
            for run in ["Straight slant", "Rough &amp; ready"] {
                assert!(texts(&svg).iter().any(|text| text.contains(run)), "{name}: {run}");
            }
        }
    }
    // Runs of one case are distinguished by their folders.
    run(&desk, "third", &SOFT);
    desk.done(&["plot", "first", "third", "-o", "both"]);
    let svg = read(&desk, "both/torque-rotate-off-bottom.svg");
    for run in ["first", "third"] {
        assert!(texts(&svg).contains(&run), "{run}");
    }
}

#[test]
fn a_sweep_is_drawn_and_reported() {
    let desk = Desk::new();
    let sweep = args(
        "sweep slant.toml --quiet -o sweep --vary friction=0.2,0.3 \
         --vary bit_depth=300m,600m",
    );
    desk.done(&sweep);
    let page = desk.text("sweep/report.html");
    for word in ["Straight slant", "friction 0.2", "Bit depth, ft", "soft string"] {
        assert!(page.contains(word), "{word}");
    }
    fs::remove_file(desk.path("sweep/report.html")).unwrap();
    let output = desk.run(&["report", "sweep"]);
    assert_eq!(text(&output.stdout), "sweep/report.html\n");
    assert!(page == desk.text("sweep/report.html"));

    desk.done(&["plot", "sweep", "--units", "field"]);
    let names = files(&desk, "sweep/plots");
    // A straight hole has no cut-off.
    let expected = ["axial-friction.svg", "hook-load.svg", "sweep.svg", "torque.svg"];
    assert_eq!(names, expected.map(String::from).into());
    let svg = read(&desk, "sweep/plots/hook-load.svg");
    for text in ["Bit depth, ft", "klbf", "friction 0.2", "friction 0.3", "trip out"] {
        assert!(texts(&svg).contains(&text), "{text}");
    }
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let desk = Desk::new();
    run(&desk, "tripped", &[&SOFT[..], &["--set", "operation.kind=trip_in"]].concat());
    run(&desk, "drilled", &[&SOFT[..], &["--set", "operation.kind=drill"]].concat());
    let vary = ["--vary", "friction=0.2,0.3"];
    let sweep = ["sweep", "slant.toml", "--quiet", "-o", "swept"];
    desk.done(&[&sweep[..], &SOFT, &vary].concat());
    run(&desk, "thin", &[]);
    fs::remove_file(desk.path("thin/time.parquet")).unwrap();
    fs::remove_file(desk.path("thin/wear.parquet")).unwrap();
    run(&desk, "damaged", &SOFT);
    fs::write(desk.path("damaged/nodes.parquet"), "not a table").unwrap();
    for (name, folders) in [
        ("plot_no_run", &["nowhere"][..]),
        ("plot_without_tables", &["thin"]),
        ("plot_damaged", &["damaged"]),
        ("plot_nothing_in_common", &["tripped", "drilled"]),
        ("plot_run_and_sweep", &["tripped", "swept"]),
        ("plot_two_sweeps", &["swept", "swept"]),
        ("plot_three", &["tripped", "tripped", "tripped"]),
    ] {
        let output = desk.run(&[&["plot"], folders].concat());
        assert_eq!(output.status.code(), Some(2), "{name}");
        assert_snapshot!(name, transcript(&output));
    }
}

#[test]
fn the_help_of_plot() {
    assert_snapshot!(transcript(&Desk::new().run(&["plot", "--help"])));
}

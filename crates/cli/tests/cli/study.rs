//! `study`: the small study that is shipped, from its file to its page.

use std::{fs, path::Path, process::Output};

use insta::assert_snapshot;

use crate::{
    desk::{Desk, masked, transcript},
    sweep::split,
};

/// A desk with the shipped studies on it.
fn desk() -> Desk {
    let desk = Desk::new();
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    for name in ["friction-on-a-slant.toml", "slant-30.toml"] {
        fs::copy(studies.join(name), desk.path(name)).unwrap();
    }
    desk
}

fn study(desk: &Desk, more: &[&str]) -> Output {
    let all = [
        &["study", "friction-on-a-slant.toml", "-o", "results"],
        more,
    ]
    .concat();
    desk.run(&all)
}

fn read(desk: &Desk, name: &str) -> String {
    let path = desk.path("results").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
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

/// Statics meet their closed forms, and so do the dynamics, where a soft string does not.
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
        let expected = if climbs && model == "soft" {
            "no"
        } else {
            "yes"
        };
        assert_eq!(agrees, expected, "{label}, {model}: {computed}");
    }

    // A case for each combination, and the exception where it holds.
    assert_eq!(
        desk.summary("results/statics/friction=0.35,bit_depth=2000m")
            .operations
            .len(),
        3
    );
    for (friction, settle_s) in [("0.1", 8.0), ("0.2", 6.0)] {
        let case = format!("results/dynamics/friction={friction},bit_depth=300 m");
        let summary = desk.summary(&case);
        assert_eq!(summary.settings["dynamics"]["settle_s"], settle_s);
    }
    assert_eq!(read(&desk, "statics/sweep.csv").lines().count(), 1 + 24 * 3);

    // Figures draw what their data say.
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
    assert_eq!(page.matches("<svg").count(), 4);
    assert_eq!(page.matches("<table>").count(), 2);
    assert_eq!(page.matches("class=\"differs\"").count(), 2);
    for from_elsewhere in ["src=\"", "href=\"http", "@import", "url(h"] {
        assert!(!page.contains(from_elsewhere), "{from_elsewhere}");
    }
    let markdown = read(&desk, "tables/dynamics.md");
    assert!(
        markdown.contains("| soft string | dynamics |"),
        "{markdown}"
    );
}

/// Shares leave what a resumed study finds, which solves nothing again and shows all of it.
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
    assert!(
        transcript(&output).contains("30 of 30 cases finished"),
        "{}",
        transcript(&output)
    );
    assert_eq!(solved("friction=0.2,bit_depth=500m"), before);
    assert_eq!(rows(&desk, "statics.csv").len(), 8);
}

/// A mistake in a case that the study makes is underlined where the study says it.
#[test]
fn mistakes_are_underlined_in_the_study() {
    let desk = desk();
    let file = desk.path("friction-on-a-slant.toml");
    let text = fs::read_to_string(&file).unwrap();
    let set = text.replace(
        "\"dynamics.settle\" = \"8 s\"",
        "\"dynamics.setle\" = \"8 s\"",
    );
    assert_ne!(set, text);
    fs::write(&file, set).unwrap();
    let output = study(&desk, &[]);
    assert_snapshot!(transcript(&output));
    assert!(!desk.path("results").exists());

    let varied = text.replace(
        "friction = [0.1, 0.2, 0.35]",
        "friction = [0.1, 20, 0.35, 0.2]",
    );
    assert_ne!(varied, text);
    fs::write(
        &file,
        varied.replace("only = { friction = 0.2 }", "only = { friction = 0.35 }"),
    )
    .unwrap();
    let output = study(&desk, &[]);
    assert_snapshot!(transcript(&output));

    fs::write(&file, text.replace("slant-30.toml\"", "slant-31.toml\"")).unwrap();
    assert_snapshot!(transcript(&study(&desk, &[])));
}

/// All cases of the article's campaign are sound, and its table gives what the article prints.
#[test]
fn the_articles_study_is_sound() {
    let desk = Desk::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let file = root.join("studies/full-hole-system-dynamics.toml");
    // The last case of all is a soft string: it is solved in no time.
    let output = desk.run(&[
        "study",
        file.to_str().unwrap(),
        "-o",
        "results",
        "--shard",
        "180/180",
    ]);
    let told = transcript(&output);
    assert!(told.contains("1 of 1 cases finished"), "{told}");
    assert!(told.ends_with("--- standard error\n"), "{told}");

    let text = fs::read_to_string(root.join("verification/G01_paper_targets.json")).unwrap();
    let article: serde_json::Value = serde_json::from_str(&text).unwrap();
    let numbers = read(&desk, "tables/numbers.md");
    let given = |label: &str| {
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
            (
                "max_static_torque_kNm",
                "maximum static friction torque, friction",
            ),
            ("axial_friction_kN", "axial friction, friction"),
        ] {
            let printed = article["outputs"][quantity][friction].as_f64().unwrap();
            assert_eq!(given(&format!("{label} {friction}")), printed, "{quantity}");
        }
    }
    assert_eq!(
        given("largest contact force"),
        article["outputs"]["contact_force_max_kN"]
    );
}

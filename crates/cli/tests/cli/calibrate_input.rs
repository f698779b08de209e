//! `calibrate` and `plan`: files of readings with faults in their columns and rows.

use std::fs;

use crate::calibrate_checks::{CASE, check, desk, file, made, refused, words};

/// Base readings with the torque on bottom, which has 3 kN·m of the bit more.
fn with_on_bottom(columns: [usize; 2]) -> String {
    let text = file(|_, row| row);
    let rows = text.lines().skip(1).map(|line| {
        let off: f64 = line.rsplit(',').next().unwrap().parse().unwrap();
        let torques = [off, off + 3.0];
        let (cells, _) = line.rsplit_once(',').unwrap();
        format!("{cells},{},{}\n", torques[columns[0]], torques[columns[1]])
    });
    "Bit depth (m),Pick-up (kN),Slack-off (kN),Rotating (kN),Torque (kN.m),Torque on bottom (kN.m)\n"
        .to_owned()
        + &rows.collect::<String>()
}

#[test]
fn swapped_torques_are_refused_before_a_unit_is_proposed() {
    let text = refused(&with_on_bottom([1, 0]), &[]);
    assert!(
        text.contains("the torque on bottom is below the torque off bottom in 8 of 8 rows")
            && text.contains("are the columns swapped?")
            && !text.contains("Is the unit"),
        "{text}"
    );
    made(&with_on_bottom([0, 1]), &[]);
}

/// One hook load in every row and column, as of a sensor that stopped.
#[test]
fn a_frozen_sensor_is_refused() {
    let text = refused(&file(|_, [md, .., torque]| [md, 250.0, 250.0, 250.0, torque]), &[]);
    assert!(
        text.contains("the pick-up, slack-off and rotating weights are 250 kN")
            && text.contains("in all 8 rows (lines 2 to 9)")
            && text.contains("the sensor seems frozen"),
        "{text}"
    );
}

/// Without pick-up, slack-off and torques, the weights do not depend on friction in any hole.
#[test]
fn rotating_weights_alone_have_no_friction() {
    let text = file(|_, row| row);
    let rows = text.lines().map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        format!("{},{}\n", cells[0], cells[3])
    });
    let rotating: String = rows.collect();
    let text = refused(&rotating, &["--set=rig.block_weight=250 kN"]);
    assert!(
        text.contains("a string that turns off bottom has no axial friction")
            && text.contains("Give pick-up or slack-off weights or torques too")
            && !text.contains("so straight"),
        "{text}"
    );
    let held = ["--hold", "friction_cased=0.2", "--hold", "friction_open=0.3"];
    let (summary, ..) = made(&rotating, &held);
    assert_eq!(summary.estimates.len(), 1);
    // The names are those that the option accepts.
    let text = refused(&rotating, &["--hold", "friction=0.25"]);
    assert!(
        text.contains("its parameters are friction_cased, friction_open, block_weight"),
        "{text}"
    );
}

/// The readings with a column `use`.
fn with_use(uses: &dyn Fn(usize) -> &'static str) -> String {
    let text = file(|_, row| row);
    let rows = text.lines().enumerate().map(|(line, text)| match line {
        0 => format!("{text},use\n"),
        line => format!("{text},{}\n", uses(line)),
    });
    rows.collect()
}

#[test]
fn rows_that_are_not_used() {
    let last = |no: &'static str, yes: &'static str| {
        let text = with_use(&|line| if line == 8 { no } else { yes });
        made(&text, &[]).0
    };
    let expected = last("no", "yes");
    assert_eq!((expected.readings, expected.held_out), (28, 4));
    for (no, yes) in [("0", "1"), ("FALSE", "TRUE"), ("n", "y"), ("No", "")] {
        assert_eq!(last(no, yes).estimates, expected.estimates, "{no}");
    }
    // A bit above the drill pipe: the string of the case is longer.
    let text = with_use(&|_| "yes") + "50,300,290,295,0.1,no\n";
    let (summary, screen, _) = made(&text, &[]);
    assert_eq!((summary.readings, summary.held_out), (32, 0));
    let found = check(&summary, "no_readings");
    assert_eq!(found.lines, ["line 10"]);
    assert!(found.check.sentence.contains("the row is not used and left out"), "{screen}");
    let text = refused(&with_use(&|_| "no"), &[]);
    assert!(text.contains("no row is used, because `use` is \"no\" in every row"), "{text}");
    let one = file(|_, row| row).lines().take(2).collect::<Vec<_>>().join("\n");
    let text = refused(&one, &["--friction-around", "--bit-torque", "--by-section"]);
    assert!(text.contains("4 readings cannot determine"), "{text}");
}

/// A reading that is left out is not called kept by another warning.
#[test]
fn a_reading_is_not_kept_and_left_out() {
    let text = file(|place, mut row| {
        if place == 5 {
            row[1] = 82.64;
        }
        row
    });
    let (summary, screen, _) = made(&text, &["--set=rig.block_weight=250 kN"]);
    assert_eq!(summary.readings, 31);
    let of_line = summary.checks.iter().filter(|check| check.lines == ["line 7"]);
    let sentences: Vec<&str> = of_line.map(|check| check.check.sentence.as_str()).collect();
    assert!(sentences.iter().any(|sentence| sentence.contains("left out")), "{sentences:?}");
    assert!(!screen.contains("kept"), "{screen}");
}

/// A plan refuses readings in another unit than that of their heading, as a calibration does.
#[test]
fn a_plan_checks_its_readings_as_a_calibration() {
    const KLBF: f64 = 4.448_221_615;
    let thousand = |[md, a, b, c, torque]: [f64; 5]| [md, a, b, c, 1e3 * torque];
    for (text, unit) in [
        (file(|_, [md, a, b, c, torque]| [md, a / KLBF, b / KLBF, c / KLBF, torque]), "klbf"),
        (file(|_, row| row).replace("(kN)", "(t)"), "kN"),
        (file(|_, row| thousand(row)), "N.m"),
        (file(|_, row| row).replace("depth (m)", "depth (ft)"), "m"),
    ] {
        // Rows that a fit does not use are compared with a plan too.
        let unused: String = text.lines().map(|line| format!("{line},no\n")).collect();
        let desk = desk(&text);
        fs::write(desk.path("base.toml"), format!("{CASE}\n[rig]\nblock_weight = \"250 kN\"\n"))
            .unwrap();
        let more = ["--set=plan.measured=r.csv", "--set=plan.depths=2", "-o", "out"];
        let plan = desk.run(&[&["plan", "base.toml"][..], &more].concat());
        fs::write(desk.path("unused.csv"), unused.replacen(",no\n", ",use\n", 1)).unwrap();
        let more = ["--set=plan.measured=unused.csv", "--set=plan.depths=2", "-o", "out"];
        let unused = desk.run(&[&["plan", "base.toml"][..], &more].concat());
        let calibration = desk.run(&["calibrate", "base.toml", "--data", "r.csv"]);
        for output in [plan, unused, calibration] {
            let text = words(&output);
            assert_eq!(output.status.code(), Some(2), "{text}");
            assert!(text.contains(&format!("Is the unit {unit}")), "{unit}: {text}");
        }
        assert!(!desk.path("out").exists());
    }
}

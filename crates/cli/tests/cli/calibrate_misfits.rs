//! `calibrate`: readings that the model does not explain, and weights below those of the string.

use wholestring_results::CheckKind;

use crate::calibrate_checks::{check, file, made, refused};

const BLOCK: [&str; 1] = ["--set=rig.block_weight=250 kN"];

/// Torques and drag that disagree by the ratio of two units: the unit is proposed only where the
/// rotating weights match the model, and each column is named.
#[test]
fn a_unit_is_proposed_only_where_the_rotating_weights_agree() {
    let text = |rotating: f64| {
        file(|_, [md, up, down, turning, torque]| {
            [md, up, down, rotating * turning, torque / 1.355_818]
        })
    };
    let sentence = |text: &str| {
        let (summary, ..) = made(text, &BLOCK);
        check(&summary, "unit").check.sentence.clone()
    };
    let agrees = sentence(&text(1.0));
    assert!(agrees.starts_with("the torques off bottom require 0.7"), "{agrees}");
    assert!(agrees.contains("in kft-lbf instead of kN.m. Is that the unit?"), "{agrees}");
    let differs = sentence(&text(0.94));
    assert!(differs.starts_with("the torques off bottom require 0.7"), "{differs}");
    assert!(differs.contains("the model does not explain both"), "{differs}");
    assert!(!differs.contains("kft-lbf"), "{differs}");
}

/// Rotating weights that deviate from the fit by 8 %, which no indicator does.
#[test]
fn weights_that_the_model_does_not_explain() {
    let text = file(|_, [md, up, down, turning, torque]| [md, up, down, 1.09 * turning, torque]);
    let (summary, screen, _) = made(&text, &BLOCK);
    let own = check(&summary, "estimated_error");
    let sentence = &own.check.sentence;
    for part in [
        "the rotating weights deviate from the fit by 7",
        "8 % of their values, whereas a weight indicator has an error of 1 to 3 %",
        "the model does not explain them",
        "above it with the bit at 1600 m",
        "above it with the bit at 3000 m",
        "likely causes are the weights of block or pipe, the mud",
    ] {
        assert!(sentence.contains(part), "{part}: {sentence}");
    }
    assert!(screen.contains("warning: the rotating weights deviate"), "{screen}");
}

/// One rule for every line: weights far below that of the string alone are left out and named, and
/// if they are most of a column the readings are refused.
#[test]
fn weights_below_that_of_the_string() {
    let light = |lines: usize| {
        move |place: usize, [md, up, down, turning, torque]: [f64; 5]| {
            let part = if place.is_multiple_of(2) { 0.4 } else { 0.65 };
            let turning = if place < lines { part * (turning - 250.0) } else { turning };
            [md, up, down, turning, torque]
        }
    };
    let (summary, ..) = made(&file(light(3)), &[]);
    let own = check(&summary, "below_block");
    assert_eq!(own.lines, ["line 2", "line 3", "line 4"]);
    assert!(own.check.sentence.contains("in lines 2 to 4"), "{own:?}");
    let text = refused(&file(light(8)), &[]);
    assert!(
        text.contains("in lines 2 to 9, 8 of 8 readings, although the string alone weighs 43"),
        "{text}"
    );
    assert!(text.contains("too few remain"), "{text}");
}

/// The outliers that are named one by one are those that the comparison leaves out, also where one
/// of them is an outlier of the fit of all readings only.
#[test]
fn one_list_of_outliers() {
    // The rotating weights keep the robust fit from a narrow scale of the torques.
    let text = file(|place, [md, up, down, turning, torque]| {
        let up = if place == 3 { up + 90.0 } else { up };
        let torque = if place == 5 { 0.55 * torque } else { torque };
        [md, up, down, 1.12 * turning - 60.0, torque]
    });
    for more in [&BLOCK[..], &[BLOCK[0], "--one-factor"], &[BLOCK[0], "--outlier=2"]] {
        let (summary, screen, _) = made(&text, more);
        let checks = summary.checks.iter();
        let outliers = checks.filter(|check| check.check.kind == CheckKind::Outlier);
        let named: Vec<String> = outliers
            .map(|check| {
                let words = check.check.sentence.split_whitespace().nth(1).unwrap();
                format!("{words} of {}", check.lines[0])
            })
            .collect();
        let comparison = summary.comparison.as_ref().expect("outliers");
        assert!(named.len() > 1, "{screen}");
        assert_eq!(named, comparison.outliers, "{screen}");
        assert_eq!(check(&summary, "outliers").lines, comparison.outliers);
        assert!(!screen.contains("found by Huber"), "{screen}");
    }
}

/// A block that the pick-up weights alone contain: neither the case's block nor the fitted one is
/// wrong, and the weights are named with the difference.
#[test]
fn a_block_in_pick_up_weights_alone() {
    let text = |down: f64, turning: f64| {
        file(move |_, [md, a, b, c, torque]| [md, a, b - down, c - turning, torque])
    };
    let alone = "the pick-up weights alone appear to contain the block: they are 2";
    for more in [&BLOCK[..], &[]] {
        let (summary, ..) = made(&text(250.0, 250.0), more);
        let own = check(&summary, "block_not_in_readings");
        assert!(own.check.sentence.starts_with(alone), "{more:?}: {own:?}");
        assert!((own.check.value.unwrap() - 250e3).abs() < 15e3, "{more:?}: {own:?}");
        let (summary, ..) = made(&text(250.0, 0.0), more);
        let own = check(&summary, "block_not_in_readings");
        assert!(
            own.check.sentence.starts_with(
                "the pick-up weights and the rotating weights alone appear to contain the block"
            ),
            "{more:?}: {own:?}"
        );
    }
    let (summary, ..) = made(&text(0.0, 0.0), &BLOCK);
    assert!(summary.checks.iter().all(|own| own.check.kind != CheckKind::BlockNotInReadings));
}

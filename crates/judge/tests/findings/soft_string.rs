//! Findings in results of the soft string.

use wholestring::{
    operation::OperationKind::*,
    outcome::Buckling,
    prelude::*,
    statics::{
        buckling::{Criterion, Place},
        soft,
        soft::{SoftError, SoftSettings},
        stiff::StiffError,
    },
    string::LateralForce,
};

use wholestring_judge::{Check, CheckKind, Descent, Judge, NoAnswer, Severity, Verdict};

use crate::{
    common::*,
    judged::{at_full_depth, five_inch, lateral, none, only, open, soft_checks},
};

/// A string in a slant slides down as long as `cot i` exceeds the friction: just below and just
/// above `μ = 1/tan 60°`.
#[test]
fn a_hook_load_below_zero_is_an_error() {
    let slant = |mu| five_inch(&[[0.0, 60.0, 0.0], [1000.0, 60.0, 0.0]], 0.2159, mu, 260.0);
    let critical = 1.0 / 60.0_f64.to_radians().tan();
    let goes = slant(0.99 * critical);
    none(&soft_checks(&goes, &operation(TripIn, 1000.0)), CheckKind::GoesDown);
    let mut stands = slant(1.01 * critical);
    let found = soft_checks(&stands, &operation(TripIn, 1000.0));
    let check = only(&found, CheckKind::GoesDown).expect("a finding");
    // 1 % of the weight along the hole.
    assert_close("hook load", check.value.unwrap(), -0.01 * 260e3 * 0.5, 1e-6);
    assert_eq!((check.severity, check.limit), (Severity::Error, Some(0.0)));
    // A value below the resolution of an indicator counts as zero.
    let barely = slant(0.9999 * critical);
    let found = soft_checks(&barely, &operation(TripIn, 1000.0));
    assert!(only(&found, CheckKind::GoesDown).is_some());
    // A block that pushes harder makes it a warning; one that does not leaves it an error.
    for (block_N, level) in [(5e3, Severity::Warning), (1e3, Severity::Error)] {
        stands.rig.block_weight_N = Some(block_N);
        let found = soft_checks(&stands, &operation(TripIn, 1000.0));
        assert_eq!(only(&found, CheckKind::GoesDown).unwrap().severity, level);
    }
}

/// A level string that turns in its place hangs with nothing: what rounding leaves is no push.
#[test]
fn a_level_string_at_rest_is_not_pushed() {
    let level = five_inch(&[[0.0, 90.0, 0.0], [500.0, 90.0, 0.0]], 0.2159, 0.3, 260.0);
    let found = soft_checks(&level, &operation(RotateOffBottom, 500.0));
    none(&found, CheckKind::GoesDown);
    let up = five_inch(&[[0.0, 100.0, 0.0], [500.0, 100.0, 0.0]], 0.2159, 0.3, 260.0);
    let found = soft_checks(&up, &operation(RotateOffBottom, 500.0));
    assert!(only(&found, CheckKind::GoesDown).is_some(), "its weight pushes it out of the hole");
}

/// With a rig that snubs, a push is a choice: nothing is reported up to its force, an error beyond
/// it, and its push reaches the bit.
#[test]
fn a_rig_that_pushes_brings_the_string_down() {
    let level = |snubbing_force_N| {
        let stations = [[0.0, 90.0, 0.0], [500.0, 90.0, 0.0]];
        let mut model = five_inch(&stations, 0.2159, 0.3, 260.0);
        model.rig.snubbing_force_N = snubbing_force_N;
        let slide = at_full_depth(Slide, &model, 10e3);
        let found = soft_checks(&model, &slide);
        [CheckKind::GoesDown, CheckKind::LockUp].map(|kind| only(&found, kind))
    };
    // Friction and the requested weight.
    let push_N = 0.3 * 260.0 * 500.0 + 10e3;
    assert_eq!(level(Some(1.01 * push_N)), [None, None]);
    let [beyond, missing] = level(Some(0.9 * push_N)).map(|level| level.expect("a finding"));
    assert_eq!((beyond.severity, beyond.limit), (Severity::Error, Some(-0.9 * push_N)));
    assert_close("hook load", beyond.value.unwrap(), -push_N, 1e-9);
    // Friction is a part of both sides.
    let missing_N = missing.value.unwrap() - missing.limit.unwrap();
    assert_close("missing", missing_N, 0.1 * push_N, 1e-6);
    // A level string that nothing pushes has no weight to go down with.
    assert_eq!(level(None), [None, None]);
}

/// The soft string reports the forces that it leaves out.
#[test]
fn a_lateral_force_is_left_out() {
    let mut model = five_inch(&[[0.0, 60.0, 0.0], [1000.0, 60.0, 0.0]], 0.2159, 0.3, 260.0);
    let turning = operation(RotateOffBottom, 1000.0);
    none(&soft_checks(&model, &turning), CheckKind::LateralForceLeftOut);
    let mut part = pipe(260.0, 0.0635, ComponentLength::ToSurface);
    part.lateral_force =
        Some(LateralForce { force_N: 15e3, from_lower_end_m: 1.0, toolface_rad: 0.0 });
    let string = StringSpec { components: vec![part] }.assemble(1000.0);
    model.string = string.expect("a sound string");
    let found = soft_checks(&model, &turning);
    let only = only(&found, CheckKind::LateralForceLeftOut).expect("a finding");
    assert_eq!((only.severity, only.value, only.limit), (Severity::Note, Some(15e3), None));
}

/// In a straight slant without helix, the weight missing at the bit equals that at the hook.
#[test]
fn lock_up_is_what_does_not_arrive() {
    let stations = [[0.0, 60.0, 0.0], [1000.0, 60.0, 0.0]];
    let mut slant = five_inch(&stations, 0.2159, 0.5, 260.0);
    let push_N = 260e3 * (60.0_f64.to_radians().cos() - 0.5 * 60.0_f64.to_radians().sin());
    let slide =
        |model: &Model, part: f64| soft_checks(model, &at_full_depth(Slide, model, part * push_N));
    none(&slide(&slant, 0.98), CheckKind::LockUp);
    let only = only(&slide(&slant, 1.5), CheckKind::LockUp).expect("a finding");
    assert_eq!((only.severity, only.md_m), (Severity::Error, None));
    let missing_N = only.value.unwrap() - only.limit.unwrap();
    assert_close("missing", missing_N, 0.5 * push_N, 1e-9);
    slant.rig.block_weight_N = Some(0.6 * push_N);
    none(&slide(&slant, 1.5), CheckKind::LockUp);
    // The friction of a rotating string is circumferential.
    slant.rig.block_weight_N = None;
    let drill = at_full_depth(Drill, &slant, 1.5 * push_N);
    none(&soft_checks(&slant, &drill), CheckKind::LockUp);
}

/// A string that reaches its depth by less than the required factor: a note where its own weight
/// drives it, a warning where only the block does.
#[test]
fn lock_up_met_by_little_is_a_warning_where_the_block_pushes() {
    let stations = [[0.0, 60.0, 0.0], [1000.0, 60.0, 0.0]];
    let mut slant = five_inch(&stations, 0.2159, 0.5, 260.0);
    let push_N = 260e3 * (60.0_f64.to_radians().cos() - 0.5 * 60.0_f64.to_radians().sin());
    let drag_N = 0.5 * 260e3 * 60.0_f64.to_radians().sin();
    let lock_up = |model: &Model, weight_N: f64| {
        let slide = at_full_depth(Slide, model, weight_N);
        let profile = soft::solve(model, &slide, &SoftSettings::default()).expect("an answer");
        let checks = Judge::default().soft(model, &slide, &profile).checks;
        only(&checks, CheckKind::LockUp).expect("a check")
    };
    let by_weight = lock_up(&slant, 0.98 * push_N);
    assert_eq!((by_weight.verdict, by_weight.severity), (Verdict::Marginal, Severity::Note));
    slant.rig.block_weight_N = Some(0.5 * push_N);
    let pushed = lock_up(&slant, 1.48 * push_N);
    assert_eq!((pushed.verdict, pushed.severity), (Verdict::Marginal, Severity::Warning));
    let factor = (drag_N + 1.5 * push_N) / (drag_N + 1.48 * push_N);
    assert_close("factor", pushed.factor.unwrap(), factor, 1e-9);
}

/// Whether a string goes down by its weight does not depend on the block: the drag of its helix
/// counts, as where no block is known. What the block or the rig adds is said to be theirs.
#[test]
fn own_weight_is_judged_without_the_block() {
    let hook_load_N = |to_m: f64| {
        let model = lateral(to_m, 0.2);
        let slide = at_full_depth(Slide, &model, 20e3);
        soft_string(&model, &slide).expect("an answer").scalars.hook_load_N
    };
    // Where no weight hangs on the hook any more, the drag of the helix left out.
    let ends = [1500.0, 9000.0].map(|to_m| (to_m, hook_load_N(to_m)));
    let zero_m = wholestring_judge::root(|to_m| Ok::<_, ()>(hook_load_N(to_m)), ends, 1.0);
    let zero_m = zero_m.expect("a length");
    let mut pushed = 0;
    for to_m in (-30..10).map(|step| zero_m + 20.0 * f64::from(step)) {
        let mut model = lateral(to_m, 0.2);
        let slide = at_full_depth(Slide, &model, 20e3);
        let profile = soft::solve(&model, &slide, &SoftSettings::default()).expect("an answer");
        let mut goes_down = |block_weight_N, snubbing_force_N| {
            model.rig = Rig { block_weight_N, snubbing_force_N, ..Rig::default() };
            let checks = Judge::default().soft(&model, &slide, &profile).checks;
            only(&checks, CheckKind::GoesDown).expect("a check")
        };
        let alone = goes_down(None, None);
        let with_block = goes_down(Some(300e3), None);
        let with_rig = goes_down(None, Some(300e3));
        let both = [alone.severity, with_block.severity].map(|severity| severity == Severity::Ok);
        assert_eq!(both[0], both[1], "{to_m}: {alone:?} {with_block:?}");
        if alone.value > Some(0.0) && alone.severity == Severity::Error {
            pushed += 1;
            assert_eq!(with_block.severity, Severity::Warning);
            let sentence = &with_block.sentence;
            assert!(sentence.contains("for its helix drags; the block pushes it"), "{sentence}");
            let sentence = &with_rig.sentence;
            assert!(sentence.starts_with("The rig pushes the string down, for"), "{sentence}");
        }
    }
    assert!(pushed >= 2, "{pushed}");
}

/// Descent of a soft string.
fn descent(model: &Model, operation: &Operation, settings: &SoftSettings) -> Descent {
    let profile = soft::solve(model, operation, settings).expect("an answer");
    let judge = Judge { soft_has_helix_friction: settings.helix_side_force, ..Judge::default() };
    judge.descent(model, operation, &(&profile).into()).expect("a string that slides down")
}

/// In a long lateral the helix absorbs all push, as far above the bit as in `S2b`'s closed form,
/// which has no build.
#[test]
fn a_helix_that_takes_all_push_is_placed() {
    let stations = [[0.0, 90.0, 0.0], [8000.0, 90.0, 0.0]];
    let lateral = five_inch(&stations, 0.2159, 0.3, 222.036_979_824_722_35);
    // The pipe of `S2b` pressed by 120 kN locks up within 3010 m, of 210 GPa as here.
    let slide = at_full_depth(Slide, &lateral, 120e3);
    let descent = descent(&lateral, &slide, &SoftSettings::default());
    let file = verification("S2b_lockup_horizontal.json");
    let row = &file["cases"][4];
    assert_eq!(row["inputs"]["F_at_bit_N"], 120e3);
    let length_m = row["expected"]["closed_form_m"].as_f64().unwrap();
    let md_m = descent.absorbed_above_md_m.expect("a place");
    assert_close("place", 8000.0 - md_m, length_m, 1e-6);
    // A level string without a block has no weight to push with.
    let found = soft_checks(&lateral, &slide);
    assert!(only(&found, CheckKind::WeightNotAvailable).is_some());
}

/// The two profiles of `S2a`: 100 kN on the bit buckle nothing, 150 kN the lower 250 m of the
/// tangent below the drop.
#[test]
fn s2a_buckled_stretches() {
    let file = verification("S2a_buckling_along_string.json");
    let stations = [
        [0.0, 0.0, 0.0],
        [1000.0, 0.0, 0.0],
        [1900.0, 60.0, 0.0],
        [3000.0, 60.0, 0.0],
        [3900.0, 30.0, 0.0],
        [4500.0, 30.0, 0.0],
    ];
    let weight = file["inputs"]["pipe"]["w"].as_f64().unwrap();
    for row in file["profiles"].as_array().unwrap() {
        let [weight_on_bit_N, mu] = ["WOB_N", "mu"].map(|key| row["inputs"][key].as_f64().unwrap());
        let model = five_inch(&stations, 0.2159, mu, weight);
        let found = soft_checks(&model, &at_full_depth(Slide, &model, weight_on_bit_N));
        none(&found, CheckKind::HelicalBuckling);
        let changes = row["expected"]["state_changes_0none_1sin_2hel"].as_array().unwrap();
        let Some(change) = changes.first() else {
            none(&found, CheckKind::SinusoidalBuckling);
            continue;
        };
        let only = only(&found, CheckKind::SinusoidalBuckling).expect("a stretch");
        verify("S2a", "depth from which a string that slides down is buckled, m")
            .absolute(1.0, "the spacing of its nodes, by its source")
            .report(change["md_m"].as_f64().unwrap(), only.md_m.unwrap());
        assert_eq!(only.to_md_m, Some(4500.0));
        assert_eq!((only.severity, only.value), (Severity::Warning, Some(150e3)));
        // The tangent of 30°: the load of Dawson and Paslay there.
        assert_close("load", only.limit.unwrap(), 111_651.265_330_979_6, 1e-6);
    }
}

/// A vertical string is held by its own weight: Lubinski's load is reported below 10 m above the
/// bit, and no buckling for a load a tenth smaller.
#[test]
fn a_vertical_hole_has_a_scale_of_its_own() {
    let vertical = five_inch(&[[0.0, 0.0, 0.0], [2000.0, 0.0, 0.0]], 0.2159, 0.3, 260.0);
    let stiffness = vertical.string.components()[0].bending_stiffness_N_m2();
    let scale_N = (stiffness * 260.0 * 260.0).cbrt();
    let drill = |weight_N| soft_checks(&vertical, &at_full_depth(Drill, &vertical, weight_N));
    none(&drill(1.93 * scale_N), CheckKind::SinusoidalBuckling);
    let bowed = drill(1.94 * scale_N + 50.0 * 260.0);
    let check = only(&bowed, CheckKind::SinusoidalBuckling).expect("a stretch");
    // Every hole that is drilled with its collars in compression has it.
    assert_eq!(check.severity, Severity::Note);
    assert_close("from", check.md_m.unwrap(), 1950.0, 1e-6);
    assert_close("load", check.limit.unwrap(), 1.94 * scale_N, 1e-6);
    none(&bowed, CheckKind::HelicalBuckling);
    let helical = drill(5.55 * scale_N + 50.0 * 260.0);
    let check = only(&helical, CheckKind::HelicalBuckling).expect("a stretch");
    assert_eq!(check.severity, Severity::Warning);
    assert_close("from", check.md_m.unwrap(), 1950.0, 1e-6);
    // A helix is more than a bow.
    none(&helical, CheckKind::SinusoidalBuckling);
    // Less than a joint of it is a note.
    let short = drill(5.55 * scale_N + 9.0 * 260.0);
    let only = only(&short, CheckKind::HelicalBuckling).expect("a stretch");
    assert_eq!(only.severity, Severity::Note);
}

/// A lateral in which no weight reaches the bit has all three, the most severe first.
#[test]
fn a_lateral_that_cannot_be_drilled() {
    let model = lateral(4500.0, 0.35);
    let found = soft_checks(&model, &at_full_depth(Slide, &model, 49e3));
    let kinds: Vec<CheckKind> = found.iter().map(|check| check.kind).collect();
    assert_eq!(kinds[..2], [CheckKind::GoesDown, CheckKind::LockUp], "{found:?}");
    assert!(found.windows(2).all(|pair| pair[0].severity >= pair[1].severity));
    let helical: Vec<&Check> =
        found.iter().filter(|check| check.kind == CheckKind::HelicalBuckling).collect();
    assert!(!helical.is_empty());
    for stretch in helical {
        assert!(stretch.value > stretch.limit && stretch.md_m < stretch.to_md_m, "{stretch:?}");
    }
}

#[test]
fn rig_limits() {
    let mut model = five_inch(&[[0.0, 60.0, 0.0], [1000.0, 60.0, 0.0]], 0.2159, 0.3, 260.0);
    let turning = operation(RotateOffBottom, 1000.0);
    let profile = soft::solve(&model, &turning, &SoftSettings::default()).unwrap();
    let (hook_N, torque_N_m) = (profile.scalars.hook_load_N, profile.scalars.surface_torque_N_m);
    let block_N = 200e3;
    let mut levels = |part: f64, block: Option<f64>| {
        model.rig = Rig {
            block_weight_N: block,
            hoist_capacity_N: Some((hook_N + block_N) / part),
            top_drive_torque_N_m: Some(torque_N_m / part),
            ..Rig::default()
        };
        let found = soft_checks(&model, &turning);
        [CheckKind::Hoist, CheckKind::TopDrive]
            .map(|kind| only(&found, kind).map(|check| check.severity))
    };
    use Severity::*;
    assert_eq!(levels(1.01, Some(block_N)), [Some(Error); 2]);
    assert_eq!(levels(0.99, Some(block_N)), [Some(Warning), None]);
    assert_eq!(levels(0.89, Some(block_N)), [None; 2]);
    // Without the block the hoist has less to carry.
    assert_eq!(levels(1.01, None), [None, Some(Error)]);
    // A sustained torque is compared with the rating, whatever the peak torque.
    let mut top_drive = |rated: Option<f64>, peak: f64| {
        model.rig = Rig {
            top_drive_torque_N_m: rated.map(|part| torque_N_m / part),
            top_drive_peak_torque_N_m: Some(torque_N_m / peak),
            ..Rig::default()
        };
        let found = soft_checks(&model, &turning);
        only(&found, CheckKind::TopDrive)
            .map(|check| (check.severity, torque_N_m / check.limit.expect("a limit")))
    };
    let near = |found: Option<(Severity, f64)>, level, part: f64| {
        let (at, against) = found.expect("a finding");
        assert_eq!(at, level);
        assert!((against - part).abs() < 1e-9, "{against}");
    };
    assert_eq!(top_drive(None, 0.9), None);
    near(top_drive(Some(1.1), 0.9), Error, 1.1);
    near(top_drive(Some(1.2), 1.1), Error, 1.2);
    assert_eq!(top_drive(Some(0.7), 0.5), None);
}

/// A column and a finding agree: a stretch of the column's word longer than a joint is in a
/// finding, whose value and limit are those of a row.
#[test]
fn columns_and_findings_agree() {
    for criterion in [Criterion::HeKyllingstad, Criterion::ChenLinCheatham, Criterion::WuJuvkamWold]
    {
        let model = Model { buckling: criterion, ..lateral(4500.0, 0.3) };
        let slide = at_full_depth(Slide, &model, 120e3);
        let profile = soft_string(&model, &slide).expect("a sound model");
        let found = open(Judge::default().soft(&model, &slide, &profile).checks);
        for (kind, word) in [
            (CheckKind::HelicalBuckling, Buckling::Helical),
            (CheckKind::SinusoidalBuckling, Buckling::Sinusoidal),
        ] {
            let stretches: Vec<_> = found.iter().filter(|check| check.kind == kind).collect();
            if stretches.is_empty() {
                // A bow by weight alone is not reported where there is a helix.
                assert_eq!(word, Buckling::Sinusoidal, "{criterion:?}");
                continue;
            }
            for stretch in &stretches {
                let (from_m, to_m) =
                    (stretch.md_m.expect("a place"), stretch.to_md_m.expect("another"));
                let row = (0..profile.md_m.len())
                    .find(|row| Some(-profile.tension_N[*row]) == stretch.value)
                    .expect("the row of the finding");
                assert!(from_m <= profile.md_m[row] && profile.md_m[row] <= to_m);
                assert!(profile.buckling(row) >= word);
                let load_N = match word {
                    Buckling::Helical => profile.helical_load_N[row],
                    _ => profile.sinusoidal_load_N[row],
                };
                // The limit equals the load, to the rounding of compression over their quotient.
                let (limit_N, load_N) =
                    (stretch.limit.expect("a limit"), load_N.expect("clearance"));
                assert!((limit_N / load_N - 1.0).abs() < 1e-14, "{limit_N} {load_N}");
            }
            let mut outside_m = 0.0;
            for (row, md_m) in profile.md_m.iter().enumerate().skip(1) {
                let covered = stretches.iter().any(|stretch| {
                    stretch.md_m.unwrap() <= *md_m && *md_m <= stretch.to_md_m.unwrap()
                });
                outside_m = match profile.buckling(row) >= word && !covered {
                    true => outside_m + md_m - profile.md_m[row - 1],
                    false => 0.0,
                };
                assert!(outside_m <= 10.0, "{criterion:?}: {kind:?} at {md_m} m");
            }
        }
    }
}

/// On request, the wall force of a helix causes drag in the soft string: the push at nine tenths of
/// the length that locks up, as in `S2b`; beyond that length there is no result. The reported
/// lock-up, which always counts the helix, is unchanged.
#[test]
fn s2b_the_drag_of_a_helix_counts_if_asked() {
    let file = verification("S2b_lockup_horizontal.json");
    let pipe = &file["inputs"]["pipe"];
    let (stiffness, weight) = (pipe["EI"].as_f64().unwrap(), pipe["w"].as_f64().unwrap());
    let clearance_m = file["inputs"]["clearance_m"].as_f64().unwrap();
    let counted = SoftSettings { helix_side_force: true, ..SoftSettings::default() };
    let mut rows = Vec::new();
    for row in file["cases"].as_array().unwrap() {
        let (inputs, expected) = (&row["inputs"], &row["expected"]);
        let (mu, at_bit_N) =
            (inputs["mu"].as_f64().unwrap(), inputs["F_at_bit_N"].as_f64().unwrap());
        let buckling = match inputs["F_hel_rule"].as_str() {
            Some("WuJuvkamWold") => Criterion::WuJuvkamWold,
            _ => Criterion::ChenLinCheatham,
        };
        let locks_up_m = expected["closed_form_m"].as_f64().unwrap();
        let horizontal = |length_m: f64| {
            let stations = [[0.0, 90.0, 0.0], [length_m, 90.0, 0.0]];
            let model = Model { buckling, ..five_inch(&stations, 0.2159, mu, weight) };
            let slide = at_full_depth(Slide, &model, at_bit_N);
            (model, slide)
        };
        let (model, slide) = horizontal(0.9 * locks_up_m);
        let profile = soft::solve(&model, &slide, &counted).expect("an answer");
        rows.push(
            verify("S2b", "push of a soft string whose helix drags, N")
                .relative(1e-6, "what its source requires")
                .row(expected["F_at_0p9_L_N"].as_f64().unwrap(), -profile.scalars.hook_load_N),
        );
        for (row, tension_N) in profile.tension_N.iter().enumerate() {
            let helix = match profile.buckling(row) {
                Buckling::Helical => clearance_m * tension_N * tension_N / (4.0 * stiffness),
                _ => 0.0,
            };
            // Weight and helix, to the rounding of weight and mass.
            let expected = weight + helix;
            assert!((profile.side_force_N_per_m[row].abs() / expected - 1.0).abs() < 1e-9);
            let drag = -mu * profile.side_force_N_per_m[row].abs();
            assert!((profile.axial_friction_N_per_m[row] / drag - 1.0).abs() < 1e-9);
        }
        let [rubbing, plain] =
            [counted, SoftSettings::default()].map(|settings| descent(&model, &slide, &settings));
        assert_eq!(rubbing.absorbed_above_md_m.is_some(), plain.absorbed_above_md_m.is_some());
        assert_close("arrives", rubbing.arrives_N, plain.arrives_N, 1e-9);
        let (model, slide) = horizontal(1.01 * locks_up_m);
        let refused = soft::solve(&model, &slide, &counted);
        let Err(SoftError::LocksUp { md_m }) = refused else {
            panic!("it locks up: {refused:?}");
        };
        // The limit is found a step before it is infinite, where a step of a metre is as long as
        // the rest.
        assert!((md_m - 0.01 * locks_up_m).abs() < 3.0, "{md_m}");
    }
    report_worst(rows);
}

/// The helix counts in a rotating string as well: its torque grows by the wall force of the helix,
/// to rounding.
#[test]
fn the_torque_of_a_helix_counts_if_asked() {
    let model = five_inch(&[[0.0, 90.0, 0.0], [1000.0, 90.0, 0.0]], 0.2159, 0.3, 260.0);
    let drill = at_full_depth(Drill, &model, 300e3);
    let counted = SoftSettings { helix_side_force: true, ..SoftSettings::default() };
    let helix = soft::solve(&model, &drill, &counted).expect("an answer");
    let plain = soft_string(&model, &drill).expect("an answer");
    let place = Place::of(&model, 1000.0, 500.0);
    for (row, md_m) in helix.md_m.iter().enumerate() {
        assert_eq!(helix.buckling(row), Buckling::Helical, "{md_m}");
        let pressed = 260.0 + place.helix_load_N_per_m(-helix.tension_N[row]);
        let part = pressed / 260.0;
        let torque = |profile: &SoftProfile| profile.friction_torque_N_m_per_m[row];
        assert_close("torque per metre", torque(&helix), part * torque(&plain), 1e-12);
    }
    let [more, less] = [&helix, &plain].map(|profile| profile.scalars.friction_torque_N_m);
    assert!(more > 2.0 * less, "{more} {less}");
}

/// A stiff string that did not converge has the lock-up factor of the soft string in its sentence
/// where that is less than 1.2.
#[test]
fn a_stiff_string_that_did_not_converge_names_a_lock_up_that_is_near() {
    let why = NoAnswer::Stiff(StiffError::NotConverged {
        md_m: 1.2,
        residual_N: 173e3,
        iterations: 4000,
    });
    let judge = Judge::default();
    let mut named = Vec::new();
    for friction in [0.2, 0.3, 0.35, 0.4] {
        let model = lateral(3000.0, friction);
        let trip_in = at_full_depth(OperationKind::TripIn, &model, 0.0);
        let Ok(soft) = soft_string(&model, &trip_in) else { continue };
        let checks = judge.soft(&model, &trip_in, &soft).checks;
        let factor = checks.iter().find(|check| check.kind == CheckKind::LockUp);
        let factor = factor.and_then(|check| check.factor).expect("a factor");
        let checks = judge.unsolved_beside(&why, &model, &trip_in, Some(&soft)).checks;
        let sentence = &checks[0].sentence;
        let names = sentence.contains(&format!("lock-up factor is {factor:.2}"));
        assert_eq!(names, factor < 1.2, "{friction}: {factor} {sentence}");
        assert!(sentence.starts_with("Did not converge"), "{sentence}");
        named.push(names);
    }
    assert!(named.contains(&true) && named.contains(&false), "{named:?}");
    let model = lateral(3000.0, 0.4);
    let trip_in = at_full_depth(OperationKind::TripIn, &model, 0.0);
    let alone = judge.unsolved_beside(&why, &model, &trip_in, None);
    assert_eq!(alone, judge.unsolved(&why));
}

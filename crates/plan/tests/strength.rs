//! Strengths of pipe and connections, against closed forms and printed tables.

mod common;

use common::*;
use wholestring::string::{BodySection, Component, catalogue::PipeClass};
use wholestring_judge::strength::{
    Body, BodyLoads, CollapseRegime, PSI_PA, Tube, margin_of_overpull_N, surface_stresses,
    worst_stress,
};
use wholestring_verification::{report_worst, verify};

/// S3a: all stresses of both surfaces on both sides of the bend, and the governing one. Closed
/// forms: only rounding remains.
#[test]
fn s3a_points() {
    let data = verification("S3a_von_mises_points.json");
    let mut compared = Vec::new();
    for case in data["cases"].as_array().expect("cases") {
        let input = |key: &str| number(&case["inputs"], key);
        let body = pipe(input("od_m"), input("id_m"), input("yield_Pa"));
        let loads = BodyLoads {
            effective_tension_N: input("effective_tension_N"),
            bending_N_m: input("bending_moment_Nm"),
            torque_N_m: input("torque_Nm"),
            inside_Pa: input("p_inside_Pa"),
            outside_Pa: input("p_outside_Pa"),
        };
        let name = case["id"].as_str().expect("id").replace('_', " ");
        let points = case["expected"]["points"].as_array().expect("points");
        let found = surface_stresses(&body, &loads);
        assert_eq!(points.len(), found.len());
        for (point, stress) in points.iter().zip(found) {
            assert_eq!(point["surface"], stress.surface.name());
            assert_eq!(point["bending_side"], stress.side.name());
            for (what, computed, key) in [
                ("axial", stress.axial_Pa, "sigma_axial_Pa"),
                ("radial", stress.radial_Pa, "sigma_radial_Pa"),
                ("hoop", stress.hoop_Pa, "sigma_hoop_Pa"),
                ("shear", stress.shear_Pa, "tau_Pa"),
                ("von Mises", stress.von_mises_Pa, "von_mises_Pa"),
            ] {
                let (surface, side) = (stress.surface.name(), stress.side.name());
                let what = format!("{what} stress {surface} on the {side} side: {name}, Pa");
                compared.push((what, computed, number(point, key)));
            }
        }
        let worst = worst_stress(&body, &loads);
        assert_eq!(case["expected"]["where"][0], worst.surface.name(), "{name}");
        assert_eq!(case["expected"]["where"][1], worst.side.name(), "{name}");
        let factor = input("yield_Pa") / worst.von_mises_Pa;
        let what = format!("factor on the yield strength: {name}");
        compared.push((what, factor, number(&case["expected"], "safety_factor")));
        // The engine's one formula is the largest of the four.
        let burst_Pa = loads.inside_Pa - loads.outside_Pa;
        let formula = BodySection::of(&body).von_mises_Pa(
            loads.effective_tension_N,
            loads.bending_N_m,
            loads.torque_N_m,
            burst_Pa * burst_Pa,
        );
        assert_close(&name, worst.von_mises_Pa, formula, 1e-11);
    }
    report_worst(compared.iter().map(|(what, computed, expected)| {
        let check = verify("S3a", what);
        let check = if *expected == 0.0 {
            check.absolute(1e-6, "rounding")
        } else {
            check.relative(1e-11, "rounding; forces that cancel lose two digits")
        };
        check.row(*expected, *computed)
    }));
}

/// Under compression the formula uses the inside of the bend: the same for a pull and a push, and
/// equal to the four points.
#[test]
fn a_push_bears_on_the_other_side() {
    let body = pipe(0.127, 0.1086, 724e6);
    for tension_N in [-4e5, -5e4, 5e4, 4e5] {
        let loads = BodyLoads {
            effective_tension_N: tension_N,
            bending_N_m: 9e3,
            torque_N_m: 12e3,
            inside_Pa: 30e6,
            outside_Pa: 22e6,
        };
        let worst = worst_stress(&body, &loads);
        let side = if tension_N < 0.0 { "compression" } else { "tension" };
        assert_eq!(worst.side.name(), side, "{tension_N}");
        let section = BodySection::of(&body);
        let formula = section.von_mises_Pa(tension_N, 9e3, 12e3, 64e12);
        assert_close("von Mises", worst.von_mises_Pa, formula, 1e-12);
    }
}

/// Static mud presses equally from all sides, on a bar as on a pipe.
#[test]
fn pressure_alone_bears_on_nothing() {
    for id_m in [0.0, 0.1086] {
        let loads = BodyLoads { inside_Pa: 5e7, outside_Pa: 5e7, ..BodyLoads::default() };
        let worst = worst_stress(&pipe(0.127, id_m, 724e6), &loads).von_mises_Pa;
        assert!(worst < 1e-6, "{worst}");
    }
}

/// 5 in 19.50 lb/ft drill pipe of a class.
fn five_inch(yield_psi: f64, class: PipeClass) -> Component {
    let left_in = 4.276 + class.wall_left() * (5.0 - 4.276);
    Component { class, ..pipe(left_in * INCH_M, 4.276 * INCH_M, yield_psi * PSI_PA) }
}

/// S3b: torsional yield under tension and margin of overpull of API RP 7G, new and premium. The
/// formulas themselves: only rounding remains.
#[test]
fn s3b_torque_under_tension_and_overpull() {
    let data = verification("S3b_torque_under_tension_overpull.json");
    let mut compared = Vec::new();
    let body = |class| five_inch(135e3, class);
    for case in data["cases"].as_array().expect("cases") {
        let (input, expected) = (&case["inputs"], &case["expected"]);
        let od_in = number(input, "od_in");
        let class = if od_in > 4.99 { PipeClass::New } else { PipeClass::Premium };
        let pipe = body(class);
        let body = Body::of(&pipe).expect("graded");
        assert_close("diameter left", pipe.od_m / INCH_M, od_in, 1e-12);
        let tension_lbf = number(input, "tension_lbf");
        let under_N_m = body.torsional_yield_under_N_m(tension_lbf * POUND_FORCE_N);
        let name = format!("{class:?} pipe under {tension_lbf:.0} lbf");
        for (what, computed, key) in [
            ("torsional yield", under_N_m, "torque_under_tension_Nm"),
            ("tensile yield", body.tensile_yield_N(), "tensile_yield_N"),
            (
                "torsional yield without tension",
                body.torsional_yield_N_m() / FOOT_POUND_N_M,
                "torsional_yield_ftlbf",
            ),
        ] {
            compared.push((format!("{what} of {name}"), computed, number(expected, key)));
        }
    }
    for case in data["overpull"].as_array().expect("cases") {
        let (input, expected) = (&case["inputs"], &case["expected"]);
        let name = input["pipe"].as_str().expect("a pipe");
        let class = if name.ends_with("new") { PipeClass::New } else { PipeClass::Premium };
        let hangs_N = number(input, "static_hook_load_at_top_of_pipe_lbf") * POUND_FORCE_N;
        let part = number(input, "design_factor_on_yield");
        let yield_N = body(class).tensile_yield_N().expect("graded");
        let margin_N = margin_of_overpull_N(yield_N, part, hangs_N);
        let what = format!("margin of overpull of {class:?} pipe at {part}");
        compared.push((what, margin_N, number(expected, "margin_of_overpull_N")));
    }
    report_worst(compared.iter().map(|(what, computed, expected)| {
        verify("S3b", what).relative(1e-9, "rounding").row(*expected, *computed)
    }));
    let pipe = body(PipeClass::New);
    let body = Body::of(&pipe).expect("graded");
    assert_eq!(body.torsional_yield_under_N_m(1.01 * body.tensile_yield_N()), 0.0);
}

/// A05: burst and collapse of 5 in 19.50 lb/ft drill pipe as the tables of API RP 7G print them,
/// from memory: to the psi, except for the rounding of the constants of the fits (E-75 is printed
/// from three digits of them).
#[test]
fn a05_burst_and_collapse_of_drill_pipe() {
    let rows = [
        ("E-75", 75e3, PipeClass::New, 9_503.0, 9_962.0),
        ("E-75", 75e3, PipeClass::Premium, 8_688.0, 7_041.0),
        ("S-135", 135e3, PipeClass::New, 17_105.0, 15_672.0),
        ("S-135", 135e3, PipeClass::Premium, 15_638.0, 10_029.0),
    ];
    let mut compared = Vec::new();
    for (grade, yield_psi, class, burst_psi, collapse_psi) in rows {
        let pipe = five_inch(yield_psi, class);
        let body = Body::of(&pipe).expect("graded");
        let name = format!("5 in 19.50 lb/ft {grade}{}", class.suffix());
        let collapse = body.collapse(0.0);
        compared.push((format!("burst of {name}, psi"), body.burst_Pa() / PSI_PA, burst_psi));
        let what = format!("collapse of {name}, psi");
        compared.push((what, collapse.pressure_Pa / PSI_PA, collapse_psi));
    }
    report_worst(compared.iter().map(|(what, computed, expected)| {
        verify("A05", what)
            .relative(1e-3, "constants that the tables round to three digits")
            .row(*expected, *computed)
    }));
    // Under half of its tensile yield it collapses as a pipe of 0.6514 of its strength.
    let pipe = five_inch(135e3, PipeClass::New);
    let body = Body::of(&pipe).expect("graded");
    let weaker = five_inch(0.651_387_818_865_997_4 * 135e3, PipeClass::New);
    let pulled = body.collapse(0.5 * body.tensile_yield_N());
    let expected = Body::of(&weaker).expect("graded").collapse(0.0);
    assert_close("pulled", pulled.pressure_Pa, expected.pressure_Pa, 1e-12);
}

/// The four regimes of API TR 5C3 meet without a jump within the accuracy of the fits of their
/// constants, collapse falls with `D/t` and with tension, and a tube that yields under tension has
/// no capacity.
#[test]
fn collapse_in_four_regimes() {
    for yield_psi in [40e3, 55e3, 75e3, 80e3, 95e3, 110e3, 125e3, 135e3] {
        let at = |slenderness: f64, pulled: f64| {
            let tube = Tube {
                od_m: 0.2,
                id_m: 0.2 * (1.0 - 2.0 / slenderness),
                yield_strength_Pa: yield_psi * PSI_PA,
            };
            tube.collapse(pulled * yield_psi * PSI_PA)
        };
        let mut met = vec![CollapseRegime::Yield];
        let mut last = at(6.0, 0.0);
        for step in 1..6000 {
            let now = at(6.0 + 0.01 * f64::from(step), 0.0);
            assert!(now.pressure_Pa < last.pressure_Pa, "{yield_psi} psi at {step}");
            if now.regime != last.regime {
                met.push(now.regime);
                let jump = 1.0 - now.pressure_Pa / last.pressure_Pa;
                assert!(jump < 5e-3, "{yield_psi} psi, {:?}: {jump}", now.regime);
            }
            last = now;
        }
        use CollapseRegime::*;
        assert_eq!(met, [Yield, Plastic, Transition, Elastic], "{yield_psi} psi");
        // By hand: √(1 − 0.75·0.25) − 0.25 = 0.651388 of the strength under half of the yield, all
        // of it where the tube only yields.
        let [free, half] = [0.0, 0.5].map(|pulled| at(7.0, pulled).pressure_Pa);
        assert_close("half of the yield", half / free, 0.651_387_818_865_997_4, 1e-12);
        assert_eq!(at(20.0, 1.0).regime, BeyondFormulas);
        assert_eq!(at(20.0, -0.3), at(20.0, 0.0));
    }
}

/// Ranges of `D/t` as API TR 5C3 prints them for grades of casing, from memory: 0.01 where the last
/// digit is 0.01.
#[test]
fn ranges_of_collapse() {
    let regime = |yield_psi: f64, slenderness: f64| {
        let tube = Tube {
            od_m: 1.0,
            id_m: 1.0 - 2.0 / slenderness,
            yield_strength_Pa: yield_psi * PSI_PA,
        };
        tube.collapse(0.0).regime
    };
    use CollapseRegime::*;
    for (yield_psi, ends) in [
        (55e3, [14.81, 25.01, 37.21]),
        (80e3, [13.38, 22.47, 31.02]),
        (110e3, [12.44, 20.41, 26.22]),
    ] {
        for (end, [before, after]) in
            ends.into_iter().zip([[Yield, Plastic], [Plastic, Transition], [Transition, Elastic]])
        {
            assert_eq!(regime(yield_psi, end - 0.01), before, "{yield_psi} {end}");
            assert_eq!(regime(yield_psi, end + 0.01), after, "{yield_psi} {end}");
        }
    }
}

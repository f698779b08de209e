//! Tubulars: order, names and parts of the components.

use std::collections::BTreeMap;

use wholestring_case::Template;

use crate::{component, numbered, refusal, text_of, tubular, values};

#[test]
fn components_are_ordered_by_sequence_from_the_bit_up() {
    let names = |text: &str| -> Vec<String> {
        values(text, "component").into_iter().map(str::to_owned).collect()
    };
    let parts = ["drill pipe", "drill collar", "bit"];
    let expected = ["\"bit\"", "\"drill collar\"", "\"drill pipe\""];
    let up: String =
        parts.iter().rev().enumerate().map(|(at, kind)| numbered(kind, at + 1)).collect();
    let text = text_of(&tubular(&up));
    assert_eq!(names(&text), expected);
    assert!(text.contains("the order is from the bit up: component 1 (bit) first"));
    let down: String = parts.iter().enumerate().map(|(at, kind)| numbered(kind, at + 1)).collect();
    let text = text_of(&tubular(&down));
    assert_eq!(names(&text), expected);
    assert!(text.contains("the order is reversed: component 3 (bit) is last"), "{text}");
    let none: String = parts.iter().rev().map(|kind| component(kind, "", "")).collect();
    let text = text_of(&tubular(&none));
    assert_eq!(names(&text), expected);
    assert!(text.contains("no component has a sequence: in the order of the file"));
    let casing = numbered("drill collar", 1) + &numbered("drill pipe", 2);
    assert!(text_of(&tubular(&casing)).contains("no component is a bit: component 1"));
    for (parts, reason) in [
        (numbered("bit", 1) + &numbered("jar", 1), "has the same sequence as that in line 1"),
        (
            numbered("bit", 1) + &component("jar", "", ""),
            "the sequence of the jar in line 1, which",
        ),
        (
            numbered("jar", 1) + &numbered("bit", 2) + &numbered("drill pipe", 3),
            "is neither the first nor the last of 3 components",
        ),
        (component("jar", "<sequence>1.5</sequence>", ""), "'1.5' is not a number; the sequence"),
        (String::new(), "a tubularComponent of tubular 'S' is missing"),
    ] {
        let message = refusal(&tubular(&parts));
        assert!(message.contains(reason), "{message}");
    }
    // As large as numbers may be.
    let huge = component("bit", "<sequence>1e300</sequence>", "") + &numbered("jar", 2);
    assert_eq!(names(&text_of(&tubular(&huge))), ["\"bit\"", "\"jar\""]);
}

#[test]
fn components_have_the_fields_names() {
    for (kind, name) in [
        ("bit", "bit"),
        ("bit PDC fixed cutter", "PDC fixed cutter bit"),
        ("bit hole opener", "hole opener"),
        ("sub-bent", "bent sub"),
        ("heavy weight drill pipe LH", "heavy-weight drill pipe"),
        ("MWD pulser", "MWD pulser"),
        ("rotary steering tool", "rotary steerable"),
        ("stabilizer near bit", "near bit stabilizer"),
        ("motor steerable", "steerable motor"),
    ] {
        let text = text_of(&tubular(&component(kind, "", "")));
        assert_eq!(values(&text, "component"), [format!("\"{name}\"")], "{kind}");
    }
    let other =
        component("other", "", "<description>float\n[mud]\ndensity = 0 \"sub\"</description>");
    let text = text_of(&tubular(&other));
    assert_eq!(values(&text, "component"), [r#""float [mud] density = 0 \"sub\"""#]);
    assert!(!text.contains("\n[mud]"), "{text}");
}

#[test]
fn parts_of_a_component_become_its_keys_where_they_can() {
    let text_for = |kind: &str, more: &str| text_of(&tubular(&component(kind, "", more)));
    let blades = "<stabilizer><lenBlade uom='m'>0.6</lenBlade><odBladeMx uom='in'>8.5</odBladeMx>\
                  <distBladeBot uom='m'>1</distBladeBot></stabilizer>";
    let text = text_for("stabilizer", blades);
    assert_eq!(values(&text, "blade_od"), ["\"8.5 in\""]);
    assert_eq!(values(&text, "blade_length"), ["\"0.6 m\""]);
    assert!(text.contains("by distBladeBot they are 3.7 m below it"), "{text}");
    let long = text_for("stabilizer", &blades.replace("0.6", "60"));
    assert!(values(&long, "blade_length").is_empty() && long.contains("blades all along it"));
    let thin = text_for("stabilizer", &blades.replace("8.5", "4.5"));
    assert!(values(&thin, "blade_od").is_empty() && thin.contains("no wider than its od"));

    let motor = "<bend><angle uom='dega'>1.15</angle><distBendBot uom='ft'>6</distBendBot></bend>";
    let text = text_for("motor", motor);
    assert_eq!(
        (values(&text, "bend"), values(&text, "bend_at")),
        (vec!["\"1.15 deg\""], vec!["\"6 ft\""])
    );
    let outside = tubular(&component("motor", "", &motor.replace(">6<", ">60<")));
    assert!(refusal(&outside).contains("the distBendBot 60 ft is out of range"));
    let set = text_for("motor", "<motor><bendSettingsMx uom='dega'>3</bendSettingsMx></motor>");
    assert!(set.contains("it can be set up to 3, but its setting is not given"), "{set}");

    let sensor = "<mwdTool><sensor><typeMeasurement>gamma ray</typeMeasurement><offsetBot uom='m'>2\
                  </offsetBot></sensor><sensor><typeMeasurement>deviation</typeMeasurement>\
                  <offsetBot uom='m'>4</offsetBot></sensor></mwdTool>";
    assert_eq!(values(&text_for("MWD", sensor), "survey_sensor"), ["\"4 m\""]);
    let outside = text_for("MWD", &sensor.replace(">4<", ">40<"));
    assert!(values(&outside, "survey_sensor").is_empty() && outside.contains("outside it"));
    let around = sensor.replace("deviation", "azimuthal gamma ray");
    assert!(values(&text_for("MWD", &around), "survey_sensor").is_empty());
    let two = tubular(&(component("bit", "", "") + &component("MWD", "", sensor).repeat(2)));
    let text = text_of(&two);
    assert_eq!(values(&text, "survey_sensor").len(), 1);
    assert!(text.contains("of 2 directional sensors all but the lowest"));

    let joints = "<lenJointAv uom='m'>9.5</lenJointAv><grade>S135</grade><connection>\
                  <od uom='in'>6.625</od><tqMakeup uom='ft.lbf'>30000</tqMakeup></connection>";
    let text = text_for("drill pipe", joints);
    assert_eq!(values(&text, "joint_od"), ["\"6.625 in\""]);
    assert_eq!(values(&text, "joint_spacing"), ["\"9.5 m\""]);
    assert_eq!(values(&text, "yield_strength"), ["\"135000 psi\""]);
    assert_eq!(values(&text, "make_up_torque"), ["\"30000 ft-lbf\""]);
    let slick = text_for("drill pipe", "<grade>Q-1</grade>");
    assert!(
        slick.contains("its body touches the wall") && slick.contains("no grade of drill pipe or")
    );
    // The grades that tallies may have.
    for (grade, yields) in [
        ("S", "135000"),
        ("Grade S135", "135000"),
        ("G", "105000"),
        ("N80 Type 1", "80000"),
        ("L80-13Cr", "80000"),
        ("13Cr-95", "95000"),
    ] {
        let text = text_for("drill pipe", &format!("<grade>{grade}</grade>"));
        assert_eq!(values(&text, "yield_strength"), [format!("\"{yields} psi\"")], "{grade}");
    }

    // Nominal weights exclude the tool joints.
    let nominal = text_for("drill pipe", "<wtPerLen uom='lbm/ft'>19.5</wtPerLen>");
    assert!(
        nominal.contains("is the nominal weight of such pipe: with its tool joints"),
        "{nominal}"
    );
    let adjusted = text_for("drill pipe", "<wtPerLen uom='lbm/ft'>22.1</wtPerLen>");
    assert!(!adjusted.contains("nominal"));

    let bit = "<bitRecord><diaBit uom='in'>8.5</diaBit></bitRecord>";
    let text = text_for("bit", bit);
    assert_eq!(values(&text, "od"), ["\"8.5 in\""]);
    assert!(text.contains("its diaBit is 8.5 in, which fills the hole"));
    let hole = tubular(&component("bit", "", "").replace("<od uom='in'>5</od>", ""));
    let hole = hole.replace("<name>", "<diaHoleAssy uom='in'>12.25</diaHoleAssy><name>");
    assert_eq!(values(&text_of(&hole), "od"), ["\"12.25 in\""]);
}

#[test]
fn what_a_component_lacks_is_said_and_the_case_is_not_green() {
    let parts = numbered("bit", 1)
        + &numbered("drill pipe", 2).replace("<id uom='in'>3</id>", "").replace(">10<", ">0<");
    let text = text_of(&tubular(&parts));
    assert!(text.contains("the id of component 2 (drill pipe), which the file does not give"));
    assert!(text.contains("the len of component 2 (drill pipe), which is 0: not known"), "{text}");
    let template = Template::in_memory("case.toml", &text, BTreeMap::new());
    assert!(template.case(&[]).is_err());
    let negative = tubular(&numbered("jar", 1).replace(">5<", ">-5<"));
    assert!(refusal(&negative).contains("the od -5 in is out of range; expected more than 0"));
}

/// As a tally refuses them at their cells.
#[test]
fn diameters_and_weights_that_no_component_has_are_refused() {
    let pipe = |more: &str| component("drill pipe", "", more);
    let changed = |from: &str, to: &str| tubular(&pipe("").replace(from, to));
    for (text, expected) in [
        (
            changed("<id uom='in'>3<", "<id uom='in'>5.5<"),
            "the id 5.5 in is out of range; expected less",
        ),
        (
            changed("<od uom='in'>5<", "<od uom='m'>5<"),
            "the od 5 m is out of range; expected 5 mm to 2 m",
        ),
        (
            tubular(&pipe("<wtPerLen uom='kg/m'>290</wtPerLen>")),
            "the wtPerLen 290 kg/m is out of range; expected at most the",
        ),
        (
            tubular(&pipe("<wtPerLen uom='kg/m'>2.9</wtPerLen>")),
            "the wtPerLen 2.9 kg/m is out of range; expected about the",
        ),
    ] {
        let message = refusal(&text);
        assert!(message.contains(expected), "{message}");
    }
}

/// Pounds per foot under kg/m: the body of 5 in by 3 in weighs 63.7 kg/m, a solid bar 99.6 kg/m.
#[test]
fn a_weight_in_pounds_under_kilograms_is_warned_of_with_its_unit() {
    let hint = "; if lb/ft was meant, correct the unit";
    let of = |mass: &str| {
        tubular(&component("drill collar", "", &format!("<wtPerLen {mass}</wtPerLen>")))
    };
    let text = text_of(&of("uom='kg/m'>49.3"));
    let warning = format!("is less than its body of steel weighs, 63.7 kg/m{hint}");
    let text = text.lines().map(|line| line.trim_start_matches(['#', ' '])).collect::<Vec<_>>();
    let text = text.join(" ");
    assert!(text.contains(&warning), "{text}");
    assert!(!text_of(&of("uom='lbm/ft'>49.3")).contains(hint));
    let heavy = refusal(&of("uom='lbm/ft'>73.4"));
    assert!(heavy.contains("; if kg/m was meant, correct the unit"), "{heavy}");
}

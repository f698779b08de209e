//! Values that can be changed without editing the text, and their bounds.

use std::f64::consts::TAU;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_case::Case;
use wholestring_config::node::parse_text;

use crate::{
    trial::{self, Frictions, MULTIPLIER, UNIFORM},
    words,
};

/// Values of a case that can be replaced, SI.
#[derive(Debug, Serialize, ToSchema)]
pub struct SetPoints {
    /// The replaceable values.
    values: Vec<SetPoint>,
    /// Hole sections, each with its friction.
    sections: Vec<SectionFriction>,
    /// Reason why no single friction can be set for all sections; null if it can.
    no_uniform_friction: Option<&'static str>,
    /// Units of the case.
    #[schema(value_type = words::UnitSet)]
    units: &'static str,
}

/// The friction of a hole section.
#[derive(Debug, Serialize, ToSchema)]
pub struct SectionFriction {
    /// The section: `casing to 1500 m`.
    label: String,
    /// Kinetic axial friction coefficient.
    friction: f64,
}

/// A replaceable value.
#[derive(Debug, Serialize, ToSchema)]
pub struct SetPoint {
    /// The key of `--set`: `friction`, `wob`, ...
    key: &'static str,
    /// Label for display.
    label: &'static str,
    /// Its dimension; `ratio` for a bare number.
    dimension: &'static str,
    /// Its value in the case.
    now: f64,
    /// The smallest and the largest sensible value.
    #[schema(min_items = 2, max_items = 2)]
    range: [f64; 2],
}

/// The plan allows no friction that all sections could share.
const NO_UNIFORM: &str =
    "low and high of [plan.friction] leave no factor that all sections can have";

impl SetPoints {
    /// The values of a case and its text, whose plan limits the friction.
    pub fn of(case: &Case, text: &str) -> Self {
        let frictions = parse_text(text, 0).map(|root| Frictions::of(&root)).unwrap_or_default();
        let uniform = uniform_friction(case, &frictions);
        let no_uniform_friction = uniform.is_none().then_some(NO_UNIFORM);
        let all = [
            Some(multiplier(&frictions)),
            uniform,
            weight(case),
            speed(case),
            mud(case),
            depth(case),
        ];
        let sections = case.model.well.hole.sections().iter().enumerate();
        let section =
            |(place, section): (usize, &wholestring::well::HoleSection)| SectionFriction {
                label: trial::section(case, place).unwrap_or_default(),
                friction: section.friction.kinetic,
            };
        Self {
            values: all.into_iter().flatten().collect(),
            sections: sections.map(section).collect(),
            no_uniform_friction,
            units: case.units.name(),
        }
    }
}

/// The factor on every section's own friction, and on that of the plan.
fn multiplier(frictions: &Frictions) -> SetPoint {
    SetPoint {
        key: MULTIPLIER,
        label: "Friction multiplier, each section's own factor",
        dimension: "ratio",
        now: 1.0,
        range: frictions.scales(),
    }
}

/// One friction for all sections, within the limits of the plan; if the sections differ, its
/// initial value is their mean over the hole.
fn uniform_friction(case: &Case, frictions: &Frictions) -> Option<SetPoint> {
    let sections = case.model.well.hole.sections();
    let lengths = sections.iter().map(|section| section.to_md_m - section.from_md_m.max(0.0));
    let (length_m, sum) =
        lengths.zip(sections).fold((0.0, 0.0), |(length_m, sum), (own_m, section)| {
            (length_m + own_m, sum + own_m * section.friction.kinetic)
        });
    let now = sum / length_m;
    // Usual factors of cased and open holes, in water- and oil-based mud, are between 0.1 and 0.5.
    let range = frictions.uniforms((2.0 * now).clamp(0.6, 2.0))?;
    now.is_finite().then_some(SetPoint {
        key: UNIFORM,
        label: "Friction, one factor for all sections",
        dimension: "ratio",
        now,
        range,
    })
}

fn weight(case: &Case) -> Option<SetPoint> {
    let drills = case.operations.iter().find(|operation| operation.kind.on_bottom())?;
    Some(SetPoint {
        key: "wob",
        label: "Weight on bit",
        dimension: "force",
        now: drills.weight_on_bit_N,
        range: [0.0, (2.0 * drills.weight_on_bit_N).max(100e3)],
    })
}

fn speed(case: &Case) -> Option<SetPoint> {
    const REV_PER_MIN: f64 = TAU / 60.0;
    let now =
        case.operations.iter().find(|operation| operation.kind.rotates())?.rotary_speed_rad_per_s;
    Some(SetPoint {
        key: "rpm",
        label: "Rotary speed",
        dimension: "rotary speed",
        now,
        // A rotating string may not stop.
        range: [now.min(10.0 * REV_PER_MIN), (2.0 * now).max(180.0 * REV_PER_MIN)],
    })
}

fn mud(case: &Case) -> Option<SetPoint> {
    let now = case.model.mud.density_kg_per_m3;
    // From air to the heaviest muds with barite.
    Some(SetPoint {
        key: "mud.density",
        label: "Mud density",
        dimension: "density",
        now,
        range: [now.min(800.0), now.max(2200.0)],
    })
}

/// From the depth at which the part below the uppermost pipe hangs in the hole, to the end of the
/// hole.
fn depth(case: &Case) -> Option<SetPoint> {
    let now = case.operations.first()?.bit_depth_m;
    let hole_m = case.model.well.hole.sections().last()?.to_md_m;
    let deepest_m = hole_m.min(case.model.well.path.last_md_m());
    let shallowest_m = case.setup().below_topmost_m().ceil().max(1.0);
    (shallowest_m < deepest_m).then_some(SetPoint {
        key: "bit_depth",
        label: "Bit depth",
        dimension: "length",
        now,
        range: [shallowest_m, deepest_m],
    })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use wholestring_case::{Disk, parse};

    use super::*;

    /// A text in place of that of a shipped case's file, as in the app.
    fn answered(text: &str, set: &[(&str, String)]) -> Result<SetPoints, crate::refusal::Refusal> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
        let files = Disk::beside(&folder.join("case.toml"));
        let set = set.iter().map(|(key, value)| ((*key).to_owned(), value.clone())).collect();
        let changes = trial::overrides(text, &set)?;
        let case = parse("case.toml", text.as_bytes(), &files, &changes)?;
        Ok(SetPoints::of(&case, text))
    }

    fn shipped(name: &str) -> String {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
        std::fs::read_to_string(folder.join(name)).expect(name)
    }

    fn written(key: &str, value: f64) -> String {
        match key {
            "wob" => format!("{value} N"),
            "rpm" => format!("{} rpm", value * 60.0 / TAU),
            "mud.density" => format!("{value} kg/m3"),
            "bit_depth" => format!("{value} m"),
            _ => value.to_string(),
        }
    }

    /// Each value is within its range, and a case with it replaced by an end of the range is valid
    /// and has it.
    #[test]
    fn what_may_be_replaced_is_valid_at_the_ends_of_its_range() {
        let text = shipped("np13-x1042.toml");
        let points = answered(&text, &[]).expect("a valid case");
        let keys: Vec<&str> = points.values.iter().map(|point| point.key).collect();
        let expected =
            ["friction_multiplier", "friction", "wob", "rpm", "mud.density", "bit_depth"];
        assert_eq!(keys, expected);
        assert_eq!(points.sections.len(), 2);
        for SetPoint { key, now, range, .. } in points.values {
            assert!((range[0]..=range[1]).contains(&now), "{key}");
            for end in range {
                let changed = answered(&text, &[(key, written(key, end))]).expect("a valid case");
                if key == "friction_multiplier" {
                    let friction = changed.sections[0].friction;
                    assert!((friction - 0.3 * end).abs() < 1e-4, "{friction} {end}");
                    continue;
                }
                let found = changed.values.iter().find(|point| point.key == key);
                let found = found.expect("the value").now;
                // Units are converted in both directions.
                assert!((found - end).abs() <= 1e-9 * end.abs().max(1.0), "{key} {end}");
            }
        }
    }

    /// In a plan with low and high friction, every value of the sliders is one that it allows.
    #[test]
    fn a_plan_with_low_and_high_is_valid_at_every_friction() {
        let slant = shipped("slant.toml");
        let held = |plan: &str| format!("{slant}\n[plan.friction]\n{plan}\n");
        let cases = [
            (shipped("forge-16a.toml"), false),
            (held("low = 0.15\nhigh = 0.35"), true),
            (held("low = { cased = 0.1 }\nexpected = 0.25\nhigh = { open = 0.3 }"), true),
            (
                held("low = { cased = 0.1, open = 0.25 }\nhigh = { cased = 0.22, open = 0.4 }"),
                false,
            ),
            (
                held("low = 0.1\nhigh = { cased = { kinetic = 0.4, around = 0.25 }, open = 0.5 }"),
                true,
            ),
        ];
        for (text, has_uniform) in cases {
            let points = answered(&text, &[]).expect("a valid case");
            let keys: Vec<&str> = points.values.iter().map(|point| point.key).collect();
            assert_eq!(keys.contains(&"friction"), has_uniform, "{text}");
            assert_eq!(points.no_uniform_friction.is_none(), has_uniform);
            let frictions = points.values.iter().filter(|point| point.key.starts_with("friction"));
            for SetPoint { key, range: [low, high], .. } in frictions {
                for step in 0..=40 {
                    let value = low + (high - low) * f64::from(step) / 40.0;
                    let value = format!("{:.4}", value.clamp(*low, *high));
                    let found = answered(&text, &[(key, value.clone())]);
                    assert!(found.is_ok(), "{key} = {value}: {:?}", found.unwrap_err());
                }
            }
        }
    }
}

//! What may be changed without touching the text, and within which bounds.

use std::f64::consts::TAU;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring_case::Case;

/// Values that a case has and that may be replaced, SI.
#[derive(Debug, Serialize, ToSchema)]
pub struct SetPoints {
    /// What may be replaced.
    values: Vec<SetPoint>,
    /// Hole sections, each of which has its friction.
    sections: usize,
}

/// A value that may be replaced.
#[derive(Debug, Serialize, ToSchema)]
pub struct SetPoint {
    /// The key of `--set`: `friction`, `wob`, ...
    key: &'static str,
    /// For people.
    label: &'static str,
    /// Its dimension; `ratio` of a bare number.
    dimension: &'static str,
    /// What the case has.
    now: f64,
    /// The least and the most that make sense.
    range: [f64; 2],
}

impl SetPoints {
    /// Those of a case.
    pub fn of(case: &Case) -> Self {
        let sections = case.model.well.hole.sections();
        let all = [friction(case), weight(case), speed(case), mud(case), depth(case)];
        Self { values: all.into_iter().flatten().collect(), sections: sections.len() }
    }
}

/// Friction of all sections; where they differ, their mean along the hole.
fn friction(case: &Case) -> Option<SetPoint> {
    let sections = case.model.well.hole.sections();
    let lengths = sections.iter().map(|of| of.to_md_m - of.from_md_m.max(0.0));
    let (length_m, sum) = lengths.zip(sections).fold((0.0, 0.0), |(length_m, sum), (own_m, of)| {
        (length_m + own_m, sum + own_m * of.friction.kinetic)
    });
    let now = sum / length_m;
    // Of cased and open holes, in water and in oil, what is used lies between 0.1 and 0.5.
    now.is_finite().then(|| SetPoint {
        key: "friction",
        label: "Friction, all sections",
        dimension: "ratio",
        now,
        range: [0.0, (2.0 * now).clamp(0.6, 2.0)],
    })
}

fn weight(case: &Case) -> Option<SetPoint> {
    let drills = case.operations.iter().find(|of| of.kind.on_bottom())?;
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
    let now = case.operations.iter().find(|of| of.kind.rotates())?.rotary_speed_rad_per_s;
    Some(SetPoint {
        key: "rpm",
        label: "Rotary speed",
        dimension: "rotary speed",
        now,
        // What turns may not stand still.
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

/// From where what stands below the pipe that runs to surface hangs in the hole, to its end.
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

    use wholestring_case::{Override, load};

    use super::*;

    /// Each value lies within its range, and a case with it replaced by an end is sound and has it.
    #[test]
    fn what_may_be_replaced_is_sound_at_the_ends_of_its_range() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/np13-x1042.toml");
        let case = load(&file, &[]).expect("a sound case");
        let points = SetPoints::of(&case);
        let keys: Vec<&str> = points.values.iter().map(|of| of.key).collect();
        assert_eq!(keys, ["friction", "wob", "rpm", "mud.density", "bit_depth"]);
        assert_eq!(points.sections, 2);
        for SetPoint { key, now, range, .. } in points.values {
            assert!((range[0]..=range[1]).contains(&now), "{key}");
            for end in range {
                let value = match key {
                    "friction" => format!("{end}"),
                    "wob" => format!("{end} N"),
                    "rpm" => format!("{} rpm", end * 60.0 / TAU),
                    "mud.density" => format!("{end} kg/m3"),
                    _ => format!("{end} m"),
                };
                let set: Override = format!("{key}={value}").parse().expect("an override");
                let changed = load(&file, &[set]).expect("a sound case");
                let found = SetPoints::of(&changed).values;
                let found = found.iter().find(|of| of.key == key).expect("the value");
                // Units are converted there and back.
                assert!((found.now - end).abs() <= 1e-9 * end.abs().max(1.0), "{key} {end}");
            }
        }
    }
}

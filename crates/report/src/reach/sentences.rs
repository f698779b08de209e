//! Results of a reach in sentences.

use wholestring_results::{ReachLimit, ReachOfFriction, ReachSummary};
use wholestring_units::{Dimension, UnitSet};

/// A friction factor in words.
pub(super) fn friction(reach: &ReachOfFriction) -> String {
    friction_words(reach.friction)
}

/// A friction factor in words; without one, the sections have the case's own.
pub(super) fn friction_words(friction: Option<f64>) -> String {
    match friction {
        Some(friction) => format!("friction {friction}"),
        None => "the case's friction".into(),
    }
}

/// A depth to the metre or foot.
fn depth(depth_m: f64, units: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(units);
    format!("{:.0} {}", unit.from_si(depth_m), unit.symbol)
}

/// The limit that stops the well first, in a sentence for each friction factor. Unsolved operations
/// may stop it earlier.
pub fn reach_answers(summary: &ReachSummary, units: UnitSet) -> Vec<String> {
    let answer = |reach: &ReachOfFriction| {
        let mut at = friction(reach);
        if !reach.missing.is_empty() {
            let missing: Vec<&str> =
                reach.missing.iter().map(|operation| operation.words()).collect();
            at += &format!(" without {}, interrupted,", missing.join(", "));
        }
        let Some(first) = &reach.first else {
            return format!("At {at} no limit is reached down to {}.", depth(summary.to_m, units));
        };
        let found = reach
            .limits
            .iter()
            .find(|limit| limit.limit == first.limit && limit.operation == first.operation);
        let title = found.map_or(first.limit.title(), |limit| limit.title.as_str());
        let already = match found.is_some_and(|limit| limit.already) {
            true => " already",
            false => "",
        };
        format!(
            "At {at} it is stopped{already} at {}: {title}, {}.",
            depth(first.depth_m, units),
            first.operation
        )
    };
    summary.frictions.iter().map(answer).collect()
}

/// Depth of the bit where a limit is reached, in words; `depth` writes a depth in m.
pub fn end_of_limit(
    limit: &ReachLimit,
    summary: &ReachSummary,
    depth: impl Fn(f64) -> String,
) -> String {
    match (limit.depth_m, limit.locked_up_m) {
        (Some(_), _) if limit.already => format!("{} already", depth(summary.from_m)),
        (Some(depth_m), _) => depth(depth_m),
        (None, _) if limit.margin_at_from.is_none() => "no answer: locked up".to_owned(),
        (None, Some(locked_up_m)) => format!("none to {}: locked up", depth(locked_up_m)),
        (None, None) => format!("none to {}", depth(summary.to_m)),
    }
}

/// Note on the bending stiffness, which the soft string leaves out.
pub(super) const SOFT: &str = "The reach is that of the soft string. With its bending stiffness the string \
                    may lock up at a shallower depth: solve the deepest point with the stiff \
                    string too.";

/// Additional notes: the model, the hole and the helices, operations that were left out, limits that
/// could not be checked.
pub fn reach_notes(summary: &ReachSummary, units: UnitSet) -> Vec<String> {
    let mut notes = vec![SOFT.to_owned()];
    notes.extend(assumptions(summary, units));
    notes.extend(summary.unchecked.iter().map(|phrase| format!("Not checked: {phrase}.")));
    notes
}

/// The critical inclination, the treatment of helices, and operations that were left out.
pub(super) fn assumptions(summary: &ReachSummary, units: UnitSet) -> Vec<String> {
    let angle = |rad: f64| {
        let unit = Dimension::Angle.unit_in(units);
        format!("{:.1} {}", unit.from_si(rad), unit.symbol)
    };
    let mut notes = Vec::new();
    for reach in &summary.frictions {
        let Some(critical_rad) = reach.critical_inclination_rad else { continue };
        let inclination = angle(summary.inclination_rad);
        let (at, critical) = (friction(reach), angle(critical_rad));
        notes.push(match summary.inclination_rad < critical_rad {
            true => format!(
                "At {at} a string slides down by its own weight to {critical}; at {inclination} its \
                 slack-off weight grows with depth."
            ),
            false => format!(
                "At {at} a string slides down by its own weight to {critical} only; at {inclination} \
                 each metre has to be pushed."
            ),
        });
    }
    if summary.stop_at_helix {
        notes.push(
            "A helix counts as a stop, as requested, except where the hole is vertical.".into(),
        );
    }
    if !summary.helix_side_force {
        notes.push(
            "The wall force of a helix causes no friction, so that no string locks up.".into(),
        );
    }
    notes.extend(summary.left_out.iter().cloned());
    notes
}

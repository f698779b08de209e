//! Depths of the bit that a plan lists.

use wholestring_config::prelude::*;
use wholestring_plan::Setup;

/// The rule of a depth.
pub(crate) fn depth(example: &'static str) -> Quantity {
    let range = Range::positive_to(20_000.0).usual(10.0, 13_000.0);
    Quantity::si(Dimension::Length, range, example)
}

/// Depths, growing; none may be listed twice.
pub(crate) fn listed_once(listed: &[Spanned<f64>], reader: &mut Reader) -> Option<Vec<f64>> {
    for (index, at) in listed.iter().enumerate() {
        if let Some(first) = listed[..index].iter().find(|first| first.value == at.value) {
            return Diagnostic::error(format!("{} m is listed twice", number_text(at.value)))
                .at(at.place, "again here")
                .at(first.place, "first here")
                .refuse(reader);
        }
    }
    let mut depths_m: Vec<f64> = listed.iter().map(|at| at.value).collect();
    depths_m.sort_by(f64::total_cmp);
    Some(depths_m)
}

/// A depth must be in the hole, and leave room for the components below the pipe.
pub(crate) fn check_depth(at: &Spanned<f64>, setup: &Setup, reader: &mut Reader) -> Option<()> {
    let metres = |value: f64| number_text((1e3 * value).round() / 1e3);
    let hole_m = setup.well.hole.sections().last().map_or(0.0, |last| last.to_md_m);
    if at.value > hole_m {
        return Diagnostic::error(format!(
            "a bit depth of the plan is beyond the hole: {} m, the hole ends at {} m",
            metres(at.value),
            metres(hole_m)
        ))
        .at(at.place, format!("expected {} m or less", metres(hole_m)))
        .refuse(reader);
    }
    let assembly_m = setup.shallowest_m();
    if at.value <= assembly_m {
        return Diagnostic::error(format!(
            "a bit depth of the plan leaves no room for the string: {} m stand below its topmost \
             component",
            metres(assembly_m)
        ))
        .at(at.place, format!("expected more than {} m", metres(assembly_m)))
        .refuse(reader);
    }
    Some(())
}

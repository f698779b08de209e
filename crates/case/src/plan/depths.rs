//! Depths of the bit that a plan lists.

use wholestring_config::prelude::*;
use wholestring_plan::Setup;

/// The rule of a depth.
pub(crate) fn depth(example: &'static str) -> Quantity {
    let range = Range::positive_to(20_000.0).usual(10.0, 13_000.0);
    Quantity::si(Dimension::Length, range, example)
}

/// Checks that depths are in increasing order; none may be listed twice.
pub(crate) fn listed_once(listed: &[Spanned<f64>], reader: &mut Reader) -> Option<Vec<f64>> {
    for (index, at) in listed.iter().enumerate() {
        if let Some(first) = listed[..index].iter().find(|first| first.value == at.value) {
            return Diagnostic::error(format!(
                "{} is listed twice",
                reader.shown(Dimension::Length, at.value)
            ))
            .at(at.place, "again here")
            .at(first.place, "first here")
            .refuse(reader);
        }
    }
    let mut depths_m: Vec<f64> = listed.iter().map(|at| at.value).collect();
    depths_m.sort_by(f64::total_cmp);
    Some(depths_m)
}

/// Refuses a depth that is not in the hole, or not below the length of the bit.
pub(crate) fn check_depth(at: &Spanned<f64>, setup: &Setup, reader: &mut Reader) -> Option<()> {
    let units = reader.units();
    let length = |value: f64| shown(Dimension::Length, value, units);
    let hole_m = setup.well.hole.sections().last().map_or(0.0, |last| last.to_md_m);
    if at.value > hole_m {
        return Diagnostic::error(format!(
            "a bit depth of the plan is beyond the hole: {}, the hole ends at {}",
            length(at.value),
            length(hole_m)
        ))
        .at(at.place, format!("expected {} or less", length(hole_m)))
        .refuse(reader);
    }
    let least_m = setup.least_depth_m();
    if at.value <= least_m {
        return Diagnostic::error(format!(
            "a bit depth of the plan is too small for the string: its lowest component is {} long",
            length(least_m)
        ))
        .at(at.place, format!("expected more than {}", length(least_m)))
        .refuse(reader);
    }
    Some(())
}

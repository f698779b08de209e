//! Key facts of a plan.

use wholestring::well::FrictionLevel;
use wholestring_results::PlanSummary;

use super::levels::plan_friction_label;
use crate::{Cell, Fact};

/// Facts of the head of the page.
pub(super) fn facts(summary: &PlanSummary) -> Vec<Fact> {
    let quantity = |number: Option<f64>, dimension: &str| {
        number.map_or(Cell::Nothing, |value| Cell::quantity(value, dimension))
    };
    let names: Vec<&str> = summary.operations.iter().map(|operation| operation.words()).collect();
    let models: Vec<String> =
        summary.models.iter().map(|model| format!("{model} string")).collect();
    let frictions = FrictionLevel::ALL.map(|level| plan_friction_label(summary, level));
    let depths = &summary.bit_depths_m;
    let ends = [depths.first(), depths.last()].map(|depth| depth.copied().unwrap_or(f64::NAN));
    vec![
        Fact::new("Operations", Cell::Text(names.join(", "))),
        Fact::new("Solved by", Cell::Text(models.join(", "))),
        Fact::new("Friction", Cell::Text(frictions.join(", "))),
        Fact::new("Bit depths", Cell::Text(depths.len().to_string())),
        Fact::new("From", Cell::quantity(ends[0], "length")),
        Fact::new("To", Cell::quantity(ends[1], "length")),
        Fact::new("Mud density", quantity(summary.mud_density_kg_per_m3(), "density")),
        Fact::new("Weight of the block", quantity(summary.block_weight_N(), "force")),
    ]
}

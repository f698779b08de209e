//! What an engineer must know, on its way to the page.

use wholestring_report::{Cell, Finding, Level};
use wholestring_results::{Finding as Found, Level as Grave};

/// A finding of the summary as the page shows it.
pub(super) fn page_finding(found: &Found) -> Finding {
    let cell = |value: Option<f64>| {
        value.map_or(Cell::Nothing, |value| match dimension(&found.unit) {
            Some(dimension) => Cell::quantity(value, dimension),
            None => Cell::number(value),
        })
    };
    Finding {
        kind: found.kind.clone(),
        level: match found.level {
            Grave::Note => Level::Note,
            Grave::Warning => Level::Warning,
            Grave::Error => Level::Error,
        },
        md_m: found.md_m,
        to_md_m: found.to_md_m,
        value: cell(found.value),
        limit: cell(found.limit),
        message: found.message.clone(),
    }
}

/// The dimension of what has an SI unit; none of a ratio and of units that the page has no other
/// for.
fn dimension(unit: &str) -> Option<&'static str> {
    Some(match unit {
        "N" => "force",
        "N.m" | "N·m" => "torque",
        "N/m" => "force per length",
        // Depths are places of findings, not values: a length is that of a penetration.
        "m" => "diameter",
        "m/s" => "speed",
        "rad/s" => "rotary speed",
        "rad" => "angle",
        "Pa" => "pressure",
        "s" => "time",
        _ => return None,
    })
}

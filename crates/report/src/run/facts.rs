//! Key facts of a case.

use serde_json::Value as Json;
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_results::{Friction, Summary};

use crate::{Cell, Fact};

/// Key facts of a run: operation, depth, string.
pub(crate) fn facts(summary: &Summary) -> Vec<Fact> {
    let settings = &summary.settings;
    let operation = &settings["operation"];
    let number = |label: &str, value: &Json, dimension: &str| {
        Fact::new(label, value.as_f64().map_or(Cell::Nothing, |si| Cell::quantity(si, dimension)))
    };
    let kinds: Vec<OperationKind> =
        texts(&operation["kind"]).filter_map(OperationKind::from_name).collect();
    let any = |is: fn(OperationKind) -> bool| kinds.iter().any(|kind| is(*kind));
    let names: Vec<&str> = kinds.iter().map(|kind| kind.words()).collect();
    let methods: Vec<&str> = texts(&settings["model"])
        .map(|name| ModelKind::named(name).map_or(name, |model| model.method().long_name))
        .collect();
    let title = if names.len() > 1 { "Operations" } else { "Operation" };
    let mut facts = vec![
        Fact::new(title, Cell::Text(names.join(", "))),
        Fact::new("Solved by", Cell::Text(methods.join(", "))),
        number("Bit depth", &operation["bit_depth_m"], "length"),
    ];
    if any(OperationKind::rotates) {
        let speed = &operation["rotary_speed_rad_per_s"];
        facts.push(number("Rotary speed", speed, "rotary speed"));
    }
    if any(OperationKind::on_bottom) {
        facts.push(number("Weight on bit", &operation["wob_N"], "force"));
        let bit = &settings["bit"];
        if bit["law"] == "rock" {
            // Rate and torque result from the rock; those of the settings are an initial estimate.
            facts.push(number("Rock strength", &settings["rock"]["strength_Pa"], "stress"));
        } else {
            let rate = &operation["rop_m_per_s"];
            facts.push(number("Rate of penetration", rate, "rate of penetration"));
            facts.push(number("Bit torque", &bit["torque_N_m"], "torque"));
        }
    }
    if any(OperationKind::trips) {
        facts.push(number("Trip speed", &operation["trip_speed_m_per_s"], "speed"));
    }
    facts.extend(summary.operations.first().map(|solved| {
        let text = match &solved.friction {
            Friction::Uniform(value) => value.to_string(),
            Friction::BySection(values) => {
                values.iter().map(f64::to_string).collect::<Vec<_>>().join(" / ")
            }
        };
        Fact::new("Friction factor", Cell::Text(text))
    }));
    facts.push(number("Mud density", &settings["mud"]["density_kg_per_m3"], "density"));
    facts.push(number("Weight of the block", &settings["rig"]["block_weight_N"], "force"));
    let flow = &operation["flow_rate_m3_per_s"];
    if flow.as_f64().is_some_and(|flow| flow > 0.0) {
        facts.push(number("Flow rate", flow, "flow rate"));
    }
    if texts(&settings["model"]).any(|name| ModelKind::named(name).is_some_and(ModelKind::in_time))
    {
        let dynamics = &settings["dynamics"];
        facts.push(number("Window", &dynamics["duration_s"], "time"));
        facts.push(match dynamics["settle_s"].as_str() {
            Some(_) => Fact::new("Settled before", Cell::Text("until steady".into())),
            None => number("Settled before", &dynamics["settle_s"], "time"),
        });
    }
    facts.retain(|fact| fact.value != Cell::Nothing);
    facts
}

/// The words of a list, or a single one.
fn texts(value: &Json) -> impl Iterator<Item = &str> {
    let list = value.as_array().map_or(&[][..], |list| list);
    list.iter().filter_map(Json::as_str).chain(value.as_str())
}

//! Key facts of a case.

use serde_json::Value as Json;
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_report::{Cell, Fact};
use wholestring_results::{Friction, Summary};

/// Key facts of a run: operation, depth, string.
pub(crate) fn facts(summary: &Summary) -> Vec<Fact> {
    let settings = &summary.settings;
    let operation = &settings["operation"];
    let kinds: Vec<OperationKind> =
        texts(&operation["kind"]).filter_map(OperationKind::from_name).collect();
    let any = |is: fn(OperationKind) -> bool| kinds.iter().any(|kind| is(*kind));
    let mut found = Vec::new();
    let mut add = |label: &str, value: Cell| {
        found.push(Fact { label: label.into(), value });
    };
    let names: Vec<&str> = kinds.iter().map(|kind| kind.words()).collect();
    add(if names.len() > 1 { "Operations" } else { "Operation" }, Cell::Text(names.join(", ")));
    let models: Vec<&str> = texts(&settings["model"])
        .map(|name| ModelKind::named(name).map_or(name, |model| model.method().long_name))
        .collect();
    add("Solved by", Cell::Text(models.join(", ")));
    add("Bit depth", quantity(&operation["bit_depth_m"], "length"));
    if any(OperationKind::rotates) {
        let speed = &operation["rotary_speed_rad_per_s"];
        add("Rotary speed", quantity(speed, "rotary speed"));
    }
    if any(OperationKind::on_bottom) {
        add("Weight on bit", quantity(&operation["wob_N"], "force"));
        let bit = &settings["bit"];
        if bit["law"] == "rock" {
            // Rate and torque result from the rock; those of the settings are an initial estimate.
            let strength = &settings["rock"]["strength_Pa"];
            add("Rock strength", quantity(strength, "stress"));
        } else {
            let rate = &operation["rop_m_per_s"];
            add("Rate of penetration", quantity(rate, "rate of penetration"));
            add("Bit torque", quantity(&bit["torque_N_m"], "torque"));
        }
    }
    if any(OperationKind::trips) {
        let speed = &operation["trip_speed_m_per_s"];
        add("Trip speed", quantity(speed, "speed"));
    }
    if let Some(solved) = summary.operations.first() {
        let text = match &solved.friction {
            Friction::Uniform(value) => value.to_string(),
            Friction::BySection(values) => {
                let values: Vec<String> = values.iter().map(f64::to_string).collect();
                values.join(" / ")
            }
        };
        add("Friction factor", Cell::Text(text));
    }
    let density = &settings["mud"]["density_kg_per_m3"];
    add("Mud density", quantity(density, "density"));
    let block = &settings["rig"]["block_weight_N"];
    add("Weight of the block", quantity(block, "force"));
    if operation["flow_rate_m3_per_s"].as_f64().is_some_and(|flow| flow > 0.0) {
        let flow = &operation["flow_rate_m3_per_s"];
        add("Flow rate", quantity(flow, "flow rate"));
    }
    if texts(&settings["model"]).any(|name| ModelKind::named(name).is_some_and(ModelKind::in_time))
    {
        let dynamics = &settings["dynamics"];
        add("Window", quantity(&dynamics["duration_s"], "time"));
        add(
            "Settled before",
            match dynamics["settle_s"].as_str() {
                Some(_) => Cell::Text("until steady".into()),
                None => quantity(&dynamics["settle_s"], "time"),
            },
        );
    }
    found.retain(|fact| fact.value != Cell::Nothing);
    found
}

fn quantity(value: &Json, dimension: &str) -> Cell {
    value.as_f64().map_or(Cell::Nothing, |value| Cell::quantity(value, dimension))
}

/// The words of a list, or a single one.
fn texts(value: &Json) -> impl Iterator<Item = &str> {
    let list = value.as_array().map_or(&[][..], |list| list);
    list.iter().filter_map(Json::as_str).chain(value.as_str())
}

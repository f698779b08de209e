//! The record of a run of some of a case's operations.

use serde_json::Value as Json;
use wholestring::{dynamics::DynamicsSettings, operation::Operation, outcome::ModelKind};

use super::{bit, hoist, operation};

/// Reduces a record of all operations to one of these, solved by these models.
pub(crate) fn narrow(
    settings: &mut Json,
    models: &[ModelKind],
    operations: &[Operation],
    dynamics: &DynamicsSettings,
) {
    let names: Vec<&str> = models.iter().map(|model| model.name()).collect();
    let control = settings["hoist"]["control"].as_str().map(str::to_owned);
    settings["model"] = names.into();
    settings["bit"]["torque_N_m"] = bit::bit_torque(operations);
    settings["hoist"] = hoist::hoist(dynamics, operations, control.as_deref()).into();
    settings["operation"] = operation::operation(operations, &dynamics.schedule).into();
}

//! All tables of the record of a run.

use serde_json::Value as Json;
use wholestring::{
    dynamics::DynamicsSettings, model::Model, operation::Operation, outcome::ModelKind,
    rock::DrillingSpec, statics::soft::SoftSettings,
};
use wholestring_config::prelude::word_of;
use wholestring_units::UnitSet;

use super::{
    bit,
    fields::{Fields, json as to_json},
    run, well,
};
use crate::{
    bit_test::BitTest,
    buckling::{CRITERIA, HELIX_SIDE_FORCE},
    case::table::CaseTable,
    dynamics::records::Records,
    rig::HoistTable,
};

/// Values built from the tables of a case.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Given<'a> {
    pub(crate) name: &'a str,
    pub(crate) units: UnitSet,
    pub(crate) models: &'a [ModelKind],
    pub(crate) model: &'a Model,
    pub(crate) operations: &'a [Operation],
    pub(crate) soft: &'a SoftSettings,
    pub(crate) dynamics: &'a DynamicsSettings,
    pub(crate) records: &'a Records,
    pub(crate) drilling: Option<&'a DrillingSpec>,
    pub(crate) bit_test: Option<&'a BitTest>,
}

/// Returns the inputs of the solvers, in SI, with units in the names of the keys.
pub(crate) fn settings(inputs: &Given<'_>, case: &CaseTable) -> Json {
    let Given {
        name,
        units,
        models,
        model,
        operations,
        soft,
        dynamics,
        records,
        drilling,
        bit_test,
    } = *inputs;
    let survey = case.well.get().and_then(|well| well.survey.get());
    let tortuosity = case.well.get().and_then(|well| well.tortuosity.given()?.value.settings());
    let dynamics_table = case.dynamics.get();
    let checkpoint_interval_s = dynamics_table.and_then(|table| table.checkpoint_interval.get());
    let control = case.hoist.get().and_then(HoistTable::control_word);
    let mut bit = bit::bit(&dynamics.bit, operations);
    if let Some(drilling) = drilling {
        bit = bit.with("face", bit::face(&drilling.bit));
    }
    let mut whole = Fields::empty()
        .with("name", name)
        .with("model", models.iter().map(|model| model.name()).collect::<Vec<_>>())
        .with("units", units.name())
        .with("well", well::well(&model.well, survey, tortuosity))
        .with("mud", Fields::of(&model.mud).tag_inside("rheology", "law"))
        .with("string", well::string(&model.string))
        .with("bit", bit)
        .with("rig", to_json(&model.rig))
        .with("ends", Fields::of(&model.ends).words(["top", "bit"]))
        .with("buckling", buckling(model, soft))
        .with("hoist", well::hoist(dynamics, operations, control))
        .with("top_drive", well::top_drive(&dynamics.top_drive))
        .with("operation", run::operation(operations, &dynamics.schedule))
        .with("mesh", run::mesh(dynamics))
        .with("dynamics", run::run(dynamics, checkpoint_interval_s.copied()))
        .with("records", run::records(records));
    if let Some(drilling) = drilling {
        whole = whole.with("rock", bit::rock(drilling));
    }
    if let Some(test) = bit_test {
        whole = whole.with("bit_test", bit::bit_test(test));
    }
    whole.into()
}

fn buckling(model: &Model, soft: &SoftSettings) -> Fields {
    Fields::empty()
        .with("criterion", word_of(CRITERIA, &model.buckling))
        .with("helix_side_force", word_of(HELIX_SIDE_FORCE, &soft.helix_side_force))
}

// The record of a run of some of a case's operations.

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
    settings["hoist"] = well::hoist(dynamics, operations, control.as_deref()).into();
    settings["operation"] = run::operation(operations, &dynamics.schedule).into();
}

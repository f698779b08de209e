//! `dynamics` and `records` in the record of a run.

use serde_json::{Value as Json, json};
use wholestring::dynamics::{ContactLaw, DynamicsSettings, ElementLength, Regions};

use super::fields::{Fields, word};
use crate::{dynamics::records::Records, values::auto::AUTO};

pub(super) fn run(dynamics: &DynamicsSettings, checkpoint_interval_s: Option<f64>) -> Fields {
    let fields = Fields::of(dynamics)
        // These have tables of their own.
        .without(["mesh", "hoist_control", "autodriller", "hoist_line"])
        .without(["lift_tolerance", "top_drive", "schedule", "bit", "probes"])
        .without(["steady"])
        .spread("centred", "start_")
        .spread_variant("contact_law", "contact_law")
        .words(["start", "start_tension", "friction_law", "precision"])
        .with("checkpoint_interval_s", checkpoint_interval_s);
    let fields = match dynamics.contact_law {
        ContactLaw::Hertz { .. } => {
            fields.renamed([("dissipation_s_per_m", "hertz_dissipation_s_per_m")])
        }
        ContactLaw::Linear { .. } => fields.renamed([
            ("stiffness_N_per_m", "contact_stiffness_N_per_m"),
            ("damping_ratio", "contact_damping_ratio"),
        ]),
    };
    match dynamics.steady {
        // A word where the run determines it: the numerics of each operation contain the value.
        Some(_) => fields.with("settle_s", AUTO),
        None => fields,
    }
}

/// `mesh` in the record of a run.
pub(super) fn mesh(dynamics: &DynamicsSettings) -> Fields {
    let fields = match dynamics.mesh.element_length {
        ElementLength::Uniform(length_m) => Fields::empty().with("element_length_m", length_m),
        ElementLength::Auto(accuracy) => {
            Fields::empty().with("element_length_m", AUTO).with("accuracy", word(&accuracy))
        }
    };
    let fields = match dynamics.mesh.refinement {
        1 => fields,
        refinement => fields.with("refinement", refinement),
    };
    match dynamics.mesh.regions {
        Regions::One => fields,
        Regions::Auto => fields.with("regions", word(&dynamics.mesh.regions)),
    }
}

pub(super) fn records(records: &Records) -> Fields {
    let channels = records.channels.iter().map(|channel| channel.name());
    let spectra = records.spectra.iter().map(|signal| signal.name());
    let probes = records.probes.iter();
    let probes = probes.map(|probe| json!({ "md_m": probe.md_m, "signal": probe.signal.name() }));
    Fields::of(records)
        .without(["probes"])
        .with("channels", channels.collect::<Vec<_>>())
        .with("spectra", spectra.collect::<Vec<_>>())
        .with("node_spectra", probes.collect::<Json>())
}

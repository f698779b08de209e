//! From a text to a [`Case`].

use std::path::Path as FilePath;

use wholestring::{model::Model, mud::Fluids, well::Well};
use wholestring_config::{diagnostic::Report, file::tree, kind::Kind, prelude::*, usual};

use super::table;
use crate::{
    case::{Case, stages::Tables, table::CaseTable},
    dynamics::effort,
    edit::overrides::{self, Override},
    modes, plan,
    settings::{Given, settings},
    uncertain,
};

/// Reads a case from its text; `name` is its name in diagnostics.
///
/// # Errors
/// A report of every mistake that was found, if there is one.
pub fn parse(
    name: &str,
    text: &[u8],
    files: &dyn Files,
    changes: &[Override],
) -> Result<Case, Report> {
    parse_changed(name, text, files, changes, |_, _| {})
}

/// Like [`parse`], with further changes of its tree.
pub(crate) fn parse_changed(
    name: &str,
    text: &[u8],
    files: &dyn Files,
    changes: &[Override],
    change: impl FnOnce(&mut Entries, &mut Reader),
) -> Result<Case, Report> {
    let (mut root, mut reader) = tree(name, text, &CASE_FILE)?;
    for change in changes {
        overrides::apply(&mut root, change, &mut reader);
    }
    change(&mut root, &mut reader);
    let case = build(name, &root, files, &mut reader);
    let failed = reader.has_errors();
    let report = reader.into_report();
    match case {
        Some(case) if !failed => Ok(Case { warnings: report, ..case }),
        _ => Err(report),
    }
}

pub(crate) static CASE_FILE: Kind = Kind {
    noun: "case",
    needs: "it needs [well], [mud], [[string]] and [operation]",
    tables: || &table::TABLES,
};

/// Builds the case. Everything that can be checked is checked, also after a mistake elsewhere.
fn build(name: &str, root: &Entries, files: &dyn Files, reader: &mut Reader) -> Option<Case> {
    if let Some(Value::Text { text, .. }) = root.get("units").map(|node| &node.value)
        && let Ok(units) = text.parse()
    {
        reader.show_in(units);
    }
    // Draws of an uncertain number are read with the sources of this moment.
    let sources = reader.sources.clone();
    let case = CaseTable::read(root, Span::default(), reader);
    let tables = Tables::new(&case, files, reader);
    usual::warn_of_bare(reader);
    let models = tables.models(reader);
    let listed = models.as_deref().unwrap_or(&[]);
    let mud = case.mud.get().and_then(|mud| mud.build(reader));
    let steel = case.steel.get().and_then(|steel| steel.build(reader));
    let rig = case.rig.get().and_then(|rig| rig.build(reader));
    if let (Some(rig), Some(hoist)) = (case.rig.get(), case.hoist.get()) {
        hoist.check_block(rig, reader);
        hoist.check_push(rig, reader);
    }

    let mut bore = tables.bore(reader);
    let bit_depth_m = tables.bit_depth_m(&bore);
    let reached = tables.check_reaches(&bore, reader);
    let spec = tables.string_spec(steel.as_ref(), reader);
    bore.check_turns(spec.as_ref(), tables.rotates(), reader);
    tables.check_injector(spec.as_ref(), rig.as_ref(), reader);

    let bottom = tables.bottom(spec.as_ref(), reader);
    let operations = tables.operations(bottom.bit.as_ref(), listed, bit_depth_m, reader);
    let bit_test = tables.bit_test(&bottom, operations.as_deref(), reader);
    let dynamics = tables.dynamics(bottom.bit, listed, mud.as_ref(), reader);
    let (hole, given) = (bore.hole.as_ref(), operations.as_deref());
    tables.check_dynamics(dynamics.as_ref(), hole, given, listed, reader)?;
    let tunes_hook_load = tables.tunes_hook_load(given, dynamics.as_ref(), reader);
    let records = tables.records(dynamics.as_ref(), bit_depth_m, reader);

    let drill_string = tables.string(spec.as_ref(), bit_depth_m, reader);
    if let Some(string) = &drill_string {
        tables.check_string(string, hole, mud.as_ref(), reader);
    }

    reached?;
    let model = Model {
        well: Well { path: bore.path?, hole: bore.hole? },
        string: drill_string?,
        mud: mud?,
        fluids: Fluids::default(),
        rig: rig?,
        ends: bottom.ends?,
        buckling: *case.buckling.get()?.criterion.get()?,
    };
    let soft = case.buckling.get()?.soft()?;
    let (models, operations) = (models?, operations?);
    let (mut dynamics, records, tunes_hook_load) = (dynamics?, records?, tunes_hook_load?);
    let (drilling, bit_test) = (bottom.drilling?, bit_test?);
    dynamics.probes.clone_from(&records.probes);
    if let Some(drilling) = &drilling {
        let solved = (&*models, &*operations);
        tables.check_rock(drilling, bit_test.as_ref(), solved, &dynamics, reader)?;
    }
    effort::check_effort(&models, &model, &operations, &dynamics, &case, reader)?;
    let modes = case.modes.get()?;
    let modes = modes::build(modes, &model.string, &operations, &dynamics, reader)?;
    let spec = spec?;
    let gel_strength_Pa = case.mud.get()?.gel_strength_Pa()?;
    let setup = plan::setup(&model, &spec);
    let units = *case.units.get()?;
    let beside = plan::Beside { setup: &setup, own: &operations, gel_strength_Pa, files, units };
    let plan = plan::build(case.plan.get()?, &beside, reader)?;
    let name = match case.name.optional()? {
        Some(entry) => entry.value.clone(),
        None => FilePath::new(name)
            .file_stem()
            .map_or_else(|| "case".to_owned(), |stem| stem.to_string_lossy().into_owned()),
    };
    let inputs = Given {
        name: &name,
        units,
        models: &models,
        model: &model,
        operations: &operations,
        soft: &soft,
        dynamics: &dynamics,
        records: &records,
        drilling: drilling.as_ref(),
        bit_test: bit_test.as_ref(),
    };
    let settings = settings(&inputs, &case);
    let checkpoint_interval_s = *case.dynamics.get()?.checkpoint_interval.get()?;
    let made = Case {
        name,
        units,
        models,
        model,
        string: spec,
        operations,
        bit_test,
        modes,
        plan,
        soft,
        dynamics,
        tunes_hook_load,
        checkpoint_interval_s,
        records,
        survey_notes: bore.stations.map_or_else(Vec::new, |stations| stations.notes),
        hole_notes: bore.notes,
        mud_notes: case.mud.get()?.note(reader).into_iter().collect(),
        warnings: Report::default(),
        settings,
    };
    uncertain::check::check(&made, root, reader, &|change| {
        let (mut root, mut checked) = (root.clone(), Reader::of(&CASE_FILE));
        checked.sources.clone_from(&sources);
        change(&mut root, &mut checked);
        let case = build(&made.name, &root, files, &mut checked);
        (case, checked.into_report().diagnostics)
    });
    Some(made)
}

//! From a text to a [`Case`].

use std::path::Path as FilePath;

use wholestring::{
    dynamics::RockLaw,
    model::Model,
    mud::Fluids,
    outcome::ModelKind,
    well::{USUAL_DOGLEG_RAD_PER_M, Well, endured_dogleg_rad_per_m},
};
use wholestring_config::{diagnostic::Report, file::tree, kind::Kind, prelude::*, usual};

use super::table;
use crate::{
    bit::{Around, BitTable, Law},
    bit_test::{self, BitTest},
    case::{Case, table::CaseTable},
    catalogue::OwnCatalogue,
    dynamics::{DynamicsTable, GivenSettings, effort},
    edit::overrides::{self, Override},
    modes,
    operation::OperationTable,
    plan, rock,
    settings::{Given, settings},
    string::{assembly, fit, named_size},
    uncertain,
    well::{hole, programme, roughness},
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
    let own = match case.catalogue.optional() {
        Some(Some(file)) => OwnCatalogue::beside(file, files, reader),
        entry => entry.map(|_| OwnCatalogue::default()),
    };
    usual::warn_of_bare(reader);
    let models = models(&case, reader);
    let mud = case.mud.get().and_then(|mud| mud.build(reader));
    let steel = case.steel.get().and_then(|steel| steel.build(reader));
    let rig = case.rig.get().and_then(|rig| rig.build(reader));
    if let (Some(rig), Some(hoist)) = (case.rig.get(), case.hoist.get()) {
        hoist.check_block(rig, reader);
        hoist.check_push(rig, reader);
    }

    let well = case.well.at();
    let mut stations = well.and_then(|at| at.value.stations(at.place, files, reader));
    let units = case.units.get().copied().unwrap_or_default();
    let path = well
        .zip(stations.as_mut())
        .and_then(|(at, stations)| at.value.path(stations, units, reader));
    let sections = well.and_then(|at| at.value.hole.get());
    let rough = well.and_then(|at| at.value.roughness.given());
    let rough = rough.map(|at| &at.value);
    let hole = sections.and_then(|sections| hole::build(sections, rough, own.as_ref(), reader));
    let hole_notes = match (&hole, sections) {
        (Some(hole), Some(sections)) => programme::check(hole, sections, reader),
        _ => Vec::new(),
    };

    let last_md_m = path.as_ref().map(|path| path.last_md_m());
    let operation = case.operation.get();
    let bit_depth_m = operation.and_then(|operation| operation.bit_depth_m(last_md_m));
    let bit_place = operation.and_then(OperationTable::bit_depth_place);
    let reached = well.zip(bit_depth_m).and_then(|(at, bit_depth_m)| {
        at.value.reaches(path.as_ref(), hole.as_ref(), bit_depth_m, bit_place, reader)
    });

    let components = case.string.get();
    let spec = components
        .zip(steel.as_ref())
        .zip(own.as_ref())
        .and_then(|((components, steel), own)| assembly::spec(components, steel, own, reader));
    if let (Some(_), Some(stations)) = (&path, stations.as_mut()) {
        let od_m = spec.as_ref().and_then(assembly::longest).map(|pipe| pipe.od_m);
        let endured = od_m.map_or(USUAL_DOGLEG_RAD_PER_M, endured_dogleg_rad_per_m);
        stations.check_turns(endured, reader);
    }
    let lowest = spec.as_ref().and_then(|spec| spec.components.first());
    let bit_radius_m = lowest.map(|bit| 0.5 * bit.od_m);
    let tested = bit_test::place(&case.bit_test);
    let drilling = case.bit.get().and_then(|bit| {
        let required_by = match tested {
            Some(place) => Some((place, "a bit test")),
            None => {
                let law = bit.laws.law.at().filter(|law| law.value == Law::Rock);
                law.map(|law| (law.place, "the law \"rock\""))
            }
        };
        let od = components.and_then(|all| all.first()).map(|at| at.value.od_place(at.place));
        let lowest = lowest.map(|bit| bit.od_m).zip(od);
        rock::drilling(&case.rock, bit, required_by, lowest, reader)
    });
    let ends = case.ends.get().and_then(|ends| ends.build(case.bit.get(), reader));
    let around = Around {
        radius_m: bit_radius_m,
        flow_m3_per_s: operation.and_then(|operation| operation.flow_rate.get().copied()),
        drilling: drilling.as_ref().and_then(Option::as_ref),
        is_tested: tested.is_some(),
        files,
    };
    let bit = case.bit.get().and_then(|bit| bit.build(&around, reader));

    let operations = match (operation, case.bit.get()) {
        (Some(operation), Some(table)) => operation.build(
            (table, bit.as_ref()),
            models.as_deref().unwrap_or(&[]),
            bit_depth_m,
            reader,
        ),
        _ => None,
    };
    let sample_interval_s = case.dynamics.get().and_then(DynamicsTable::sample_interval_s);
    let valid = bit.as_ref().zip(operations.as_ref()).zip(sample_interval_s);
    let bit_test = match (&drilling, valid, case.bit_test.at()) {
        (Some(None), ..) => Some(None),
        (Some(Some(drilling)), Some(((bit, operations), sample_interval_s)), Some(table)) => {
            let around = bit_test::Around { drilling, bit, operations, sample_interval_s };
            bit_test::build(table, tested.is_some(), &around, reader)
        }
        _ => None,
    };
    let schedule = operation.and_then(|operation| {
        let end_s = case.dynamics.get().and_then(DynamicsTable::end_s);
        operation.schedule(models.as_deref().unwrap_or(&[]), end_s, reader)
    });
    let top_drive = case.top_drive.get().and_then(|drive| drive.build(reader));
    if let (Some(operation), Some(mud)) = (operation, &mud) {
        let turns_motor = case.bit.get().is_some_and(BitTable::takes_flow);
        operation.check_flow(mud, turns_motor, reader);
    }
    let dynamics = match (case.dynamics.get(), case.mesh.get(), case.hoist.get()) {
        (Some(dynamics), Some(mesh), Some(hoist)) => {
            let given_settings = GivenSettings { hoist, bit, top_drive, schedule };
            dynamics.build(mesh, given_settings, reader)
        }
        _ => None,
    };

    if let (Some(dynamics), Some(hole)) = (case.dynamics.get(), &hole) {
        dynamics.check_stribeck(hole, reader);
    }
    if let (Some(table), Some(settings), Some(operations), Some(models)) =
        (case.dynamics.get(), &dynamics, &operations, &models)
        && ModelKind::any_in_time(models)
    {
        table.check_precision(operations, settings, reader)?;
    }
    let tunes_hook_load = match (case.hoist.get(), &operations, &dynamics) {
        (Some(hoist), Some(operations), Some(dynamics)) => {
            hoist.tunes_hook_load(operations, &dynamics.schedule, reader)
        }
        _ => None,
    };
    let records = match (&dynamics, case.records.get()) {
        (Some(dynamics), Some(records)) => records.build(dynamics, bit_depth_m, reader),
        _ => None,
    };

    let drill_string = match (&spec, components, bit_depth_m) {
        (Some(spec), Some(components), Some(bit_depth_m)) => {
            assembly::assemble(spec, components, bit_depth_m, bit_place, reader)
        }
        _ => None,
    };
    if let (Some(drill_string), Some(components)) = (&drill_string, components) {
        if let (Some(hole), Some(sections)) = (&hole, sections) {
            fit::check_clearance(drill_string, components, hole, sections, reader);
            fit::check_gauge(drill_string, components, hole, sections, reader);
            if let Some(own) = &own {
                programme::check_drift(drill_string, components, hole, sections, own, reader);
            }
            let rms = rough.and_then(|table| table.rms.given());
            roughness::check_clearance(drill_string, hole, rms.map(|at| at.place), reader);
        }
        named_size::check(drill_string, components, reader);
        fit::check_programme(drill_string, components, reader);
        if let Some(mud) = &mud {
            let wob = operation.and_then(|operation| operation.wob.given());
            fit::check_weight_on_bit(drill_string, mud, wob, reader);
        }
        if let (Some(mud), Some(place)) = (&mud, case.mud.get().and_then(|mud| mud.density.at())) {
            fit::check_weight(drill_string, components, mud, place.place, reader);
        }
    }

    reached?;
    let model = Model {
        well: Well { path: path?, hole: hole? },
        string: drill_string?,
        mud: mud?,
        fluids: Fluids::default(),
        rig: rig?,
        ends: ends?,
        buckling: *case.buckling.get()?.criterion.get()?,
    };
    let soft = case.buckling.get()?.soft()?;
    let (models, operations) = (models?, operations?);
    let (mut dynamics, records, tunes_hook_load) = (dynamics?, records?, tunes_hook_load?);
    let (drilling, bit_test) = (drilling?, bit_test?);
    dynamics.probes.clone_from(&records.probes);
    if let (Some(drilling), Some(rock)) = (&drilling, case.rock.given()) {
        let drills = ModelKind::any_in_time(&models)
            && case.bit.get().and_then(|bit| bit.laws.law.get()) == Some(&Law::Rock)
            && operations.iter().any(|one| one.kind.on_bottom());
        let speeds = operations
            .iter()
            .filter(|one| drills && one.kind.on_bottom())
            .map(|one| dynamics.bit.drilling_speed_rad_per_s(one));
        let run_s = speeds
            .clone()
            .map(|speed_rad_per_s| dynamics.longest_s() + RockLaw::run_in_s(speed_rad_per_s));
        let test_s = tested.and(bit_test.as_ref()).map_or(0.0, BitTest::time_s);
        let longest_s = run_s.fold(test_s, f64::max);
        let points = tested.and(bit_test.as_ref()).into_iter();
        let points = points.flat_map(|test| test.rotary_speeds_rad_per_s.iter().copied());
        let fastest = speeds.chain(points).fold(0.0, f64::max);
        rock.value.warn_of_inertia(drilling, fastest, rock.place, reader);
        rock.value.check_effort(drilling, longest_s, rock.place, reader)?;
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
        survey_notes: stations.map_or_else(Vec::new, |stations| stations.notes),
        hole_notes,
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

fn models(case: &CaseTable, reader: &mut Reader) -> Option<Vec<ModelKind>> {
    let models = case.model.get()?;
    once_each(models, ModelKind::name, reader)?;
    Some(models.iter().map(|at| at.value).collect())
}

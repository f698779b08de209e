//! The whole case: its top level, and how a text becomes a [`Case`].

use std::path::Path as FilePath;

use wholestring::{
    dynamics::{BitLaw, DynamicsSettings, RockLaw},
    model::Model,
    operation::Operation,
    outcome::ModelKind,
    rock::DrillingSpec,
    well::Well,
};
use wholestring_units::UnitSet;

use crate::{
    assembly,
    bit::{Around, BitTable, Law},
    bit_test::{self, BitTest, BitTestTable},
    diagnostic::{Diagnostic, Report},
    dynamics::{DynamicsTable, MeshTable, Told},
    effort, fit, hole,
    mud::MudTable,
    node::{self, Entries, Node, Value},
    operation::OperationTable,
    overrides::{self, Override},
    reader::{Kind, Reader},
    records::{Records, RecordsTable},
    rig::{HoistTable, RigTable},
    rock::{self, RockTable},
    roughness,
    rule::{At, Choice, List, Rule, Section, Table, Text, once_each},
    settings,
    source::{Files, Place},
    steel::SteelTable,
    string::ComponentTable,
    table::{default, optional, required, table},
    template::Template,
    top_drive::TopDriveTable,
    usual,
    well::WellTable,
};

/// The models that can solve a case.
const MODELS: &[(&str, ModelKind)] = &{
    let mut models = [("", ModelKind::Soft); ModelKind::ALL.len()];
    let mut place = 0;
    while place < models.len() {
        let model = ModelKind::ALL[place];
        models[place] = (model.name(), model);
        place += 1;
    }
    models
};

/// A set of units by name.
pub(crate) const UNIT_SETS: Choice<UnitSet> = Choice {
    noun: "a unit set",
    words: &[
        ("si", UnitSet::Si),
        ("metric", UnitSet::Metric),
        ("field", UnitSet::Field),
    ],
};

/// A model by name; the stiff string is known, but not built.
pub(crate) struct ModelRule;

impl ModelRule {
    fn choice() -> Choice<ModelKind> {
        Choice {
            noun: "a model",
            words: MODELS,
        }
    }
}

impl Rule for ModelRule {
    type Value = ModelKind;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<ModelKind> {
        if let Value::Text { text, .. } = &node.value
            && text == "stiff"
        {
            reader.report(
                Diagnostic::error("the stiff string is not built yet")
                    .at(node.place, "expected \"soft\" or \"dynamic\""),
            );
            return None;
        }
        Self::choice().read(node, reader)
    }

    fn schema(&self) -> serde_json::Value {
        Self::choice().schema()
    }

    fn json(&self, value: &ModelKind) -> serde_json::Value {
        Self::choice().json(value)
    }
}

table! {
    /// A drill string in a well, and what is done with it. Quantities are text with a unit
    /// ("5-1/2 in", "1.2 sg"); a bare number is SI, except in `stations` (m, deg, deg) and `rpm`.
    CaseTable in "the case" {
        /// What the case is called in results. Default: the name of the file.
        name: String = optional(Text);
        /// "soft" (statics without bending stiffness), "dynamic" (the whole string in time), or a
        /// list that is solved one by one.
        model: Vec<At<ModelKind>> = default(
            List { item: ModelRule, or_one: true, noun: "models", most: MODELS.len() },
            vec![At { value: ModelKind::Soft, place: Place::default() }],
        );
        /// Units that people are shown: "si" (m, kN, kN.m, mm, kg/m3), "metric" (m, t, kN.m, mm,
        /// sg) or "field" (ft, klbf, ft-lbf, in, ppg). Files for machines are SI always.
        units: UnitSet = default(UNIT_SETS, UnitSet::Si);
        /// Where the hole runs and how wide it is and how it rubs.
        well: WellTable = required(Section::<WellTable>::RULE);
        /// Drilling fluid, the same inside the string and in the annulus.
        mud: MudTable = required(Section::<MudTable>::RULE);
        /// The metal of the string, wherever a component does not say otherwise.
        steel: SteelTable = optional(Section::<SteelTable>::RULE);
        /// The string, component by component from the bit up.
        string: Vec<At<ComponentTable>> = required(List {
            item: Section::<ComponentTable>::RULE,
            or_one: false,
            noun: "components ([[string]])",
            most: 5000,
        });
        /// The bit on the rock.
        bit: BitTable = optional(Section::<BitTable>::RULE);
        /// Solid rock under the bit.
        rock: RockTable = optional(Section::<RockTable>::RULE);
        /// The bit alone on its rock.
        bit_test: BitTestTable = optional(Section::<BitTestTable>::RULE);
        /// Limits of the rig.
        rig: RigTable = optional(Section::<RigTable>::RULE);
        /// How the top of the string is moved along the hole in the dynamic model.
        hoist: HoistTable = optional(Section::<HoistTable>::RULE);
        /// What turns the top of the string in the dynamic model.
        top_drive: TopDriveTable = optional(Section::<TopDriveTable>::RULE);
        /// What the driller is doing.
        operation: OperationTable = required(Section::<OperationTable>::RULE);
        /// How finely the string is cut.
        mesh: MeshTable = optional(Section::<MeshTable>::RULE);
        /// Settings of the dynamic model.
        dynamics: DynamicsTable = optional(Section::<DynamicsTable>::RULE);
        /// What a dynamic run keeps beside its tables.
        records: RecordsTable = optional(Section::<RecordsTable>::RULE);
    }
}

/// A case in which everything has been checked.
#[derive(Debug, Clone)]
pub struct Case {
    /// What it is called.
    pub name: String,
    /// Units that people are shown.
    pub units: UnitSet,
    /// The models to solve, in the order of the case.
    pub models: Vec<ModelKind>,
    /// Well, string, mud and rig.
    pub model: Model,
    /// The operations to solve, in the order of the case.
    pub operations: Vec<Operation>,
    /// The bit alone on its rock: of a case with `[bit_test]`, and of one whose operation drills solid rock.
    pub bit_test: Option<BitTest>,
    /// What a dynamic run needs beside these.
    pub dynamics: DynamicsSettings,
    /// Whether the top hangs on a constant lift that is found before each dynamic run, such that the mean weight on bit is
    /// the operation's: [`wholestring::dynamics::tune_lift`].
    pub tunes_lift: bool,
    /// Time on the clock between checkpoints of a dynamic run, s.
    pub checkpoint_interval_s: f64,
    /// What a dynamic run keeps beside its tables.
    pub records: Records,
    /// How the survey file was understood, in sentences; empty where the stations stand in the case.
    pub survey_notes: Vec<String>,
    /// What is probably not meant, but can be computed.
    pub warnings: Report,
    /// The case with all defaults filled in: SI numbers, units in the names of the keys.
    pub settings: serde_json::Value,
}

impl Case {
    /// Bit and solid rock, in a run or in a bit test; none where nothing asks for them.
    pub fn drilling(&self) -> Option<&DrillingSpec> {
        match &self.dynamics.bit.law {
            BitLaw::Rock(law) => Some(&law.drilling),
            _ => self.bit_test.as_ref().map(|test| &test.drilling),
        }
    }
}

/// Reads the case at `path`, and the survey that it names.
///
/// # Errors
/// A report of every mistake that was found, if there is one.
pub fn load(path: &FilePath, changes: &[Override]) -> Result<Case, Report> {
    Template::read(path)?.case(changes)
}

/// Reads a case from its text; `name` is what diagnostics call it.
///
/// # Errors
/// A report of every mistake that was found, if there is one.
pub fn parse(
    name: &str,
    text: &[u8],
    files: &dyn Files,
    changes: &[Override],
) -> Result<Case, Report> {
    let (mut root, mut reader) = tree(name, text, &CASE_FILE)?;
    for change in changes {
        overrides::apply(&mut root, change, &mut reader);
    }
    let case = build(name, &root, files, &mut reader);
    let failed = reader.has_errors();
    let report = reader.into_report();
    match case {
        Some(case) if !failed => Ok(Case {
            warnings: report,
            ..case
        }),
        _ => Err(report),
    }
}

static CASE_FILE: Kind = Kind {
    noun: "case",
    needs: "it needs [well], [mud], [[string]] and [operation]",
    tables: || &crate::schema::TABLES,
};

/// The keys and values of a file, and the reader that knows its text.
pub(crate) fn tree(
    name: &str,
    text: &[u8],
    kind: &'static Kind,
) -> Result<(Entries, Reader), Report> {
    let text = match as_text(text, kind) {
        Ok(text) => text,
        Err(diagnostic) => return Err(Report::about_file(name, diagnostic)),
    };
    let mut reader = Reader::of(kind);
    let source = reader.add_source(name, text);
    match node::parse_text(text, source) {
        Ok(root) => Ok((root, reader)),
        Err(mistakes) => {
            mistakes
                .into_iter()
                .for_each(|mistake| reader.report(mistake));
            Err(reader.into_report())
        }
    }
}

/// The text of a file, or why it is none.
fn as_text<'a>(bytes: &'a [u8], kind: &Kind) -> Result<&'a str, Diagnostic> {
    let noun = kind.noun;
    const MOST_BYTES: usize = 8 << 20;
    if bytes.len() > MOST_BYTES {
        let message = format!(
            "this file holds {} MB: it is no {noun} file",
            bytes.len() >> 20
        );
        return Err(Diagnostic::error(message)
            .help(format!("a {noun} file is a TOML text of some kilobytes")));
    }
    // Editors on Windows may put a byte order mark in front.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let help = format!("a {noun} file is a TOML text in UTF-8");
    match std::str::from_utf8(bytes) {
        Ok(text) if text.trim().is_empty() => {
            Err(Diagnostic::error(format!("the {noun} file is empty")).help(kind.needs))
        }
        Ok(text) if text.contains('\0') => {
            Err(Diagnostic::error("this file is not a text: it holds zero bytes").help(help))
        }
        Ok(text) => Ok(text),
        Err(error) => {
            let line = bytes[..error.valid_up_to()]
                .iter()
                .filter(|&&byte| byte == b'\n')
                .count();
            let message = format!("this file is not a text: line {} is not UTF-8", line + 1);
            Err(Diagnostic::error(message).help(help))
        }
    }
}

/// Everything that can be checked is checked, also where something else is wrong.
fn build(name: &str, root: &Entries, files: &dyn Files, reader: &mut Reader) -> Option<Case> {
    if let Some(Value::Text { text, .. }) = root.get("units").map(|node| &node.value)
        && let Ok(units) = text.parse()
    {
        reader.show_in(units);
    }
    let case = CaseTable::read(root, Place::default(), reader);
    usual::warn_of_bare(reader);
    let models = models(&case, reader);
    let mud = case.mud.get().and_then(|mud| mud.build(reader));
    let steel = case.steel.get().and_then(|steel| steel.build(reader));
    let rig = case.rig.get().and_then(|rig| rig.build(reader));
    if let (Some(rig), Some(hoist)) = (case.rig.get(), case.hoist.get()) {
        hoist.check_block(rig, reader);
    }

    let well = case.well.at();
    let stations = well.and_then(|at| at.value.stations(at.place, files, reader));
    let path = well
        .zip(stations.as_ref())
        .and_then(|(at, stations)| at.value.path(stations, reader));
    let sections = well.and_then(|at| at.value.hole.get());
    let rough = well.and_then(|at| at.value.roughness.given());
    let hole =
        sections.and_then(|sections| hole::build(sections, rough.map(|at| &at.value), reader));

    let last_md_m = path.as_ref().map(|path| path.last_md_m());
    let operation = case.operation.get();
    let bit_depth_m = operation.and_then(|operation| operation.bit_depth_m(last_md_m));
    let bit_place = operation.and_then(OperationTable::bit_depth_place);
    let reached = well.zip(bit_depth_m).and_then(|(at, bit_depth_m)| {
        at.value
            .reaches(path.as_ref(), hole.as_ref(), bit_depth_m, bit_place, reader)
    });

    let components = case.string.get();
    let spec = components
        .zip(steel.as_ref())
        .and_then(|(components, steel)| assembly::spec(components, steel, reader));
    let lowest = spec.as_ref().and_then(|spec| spec.components.first());
    let bit_radius_m = lowest.map(|bit| 0.5 * bit.od_m);
    let tested = bit_test::place(&case.bit_test);
    let drilling = case.bit.get().and_then(|bit| {
        let asks = match tested {
            Some(place) => Some((place, "a bit test")),
            None => {
                let law = bit.law.at().filter(|law| law.value == Law::Rock);
                law.map(|law| (law.place, "the law \"rock\""))
            }
        };
        let od = components
            .and_then(|all| all.first())
            .map(|at| at.value.od_place(at.place));
        let lowest = lowest.map(|bit| bit.od_m).zip(od);
        rock::drilling(&case.rock, bit, asks, lowest, reader)
    });
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
    let sample_interval_s = case
        .dynamics
        .get()
        .and_then(DynamicsTable::sample_interval_s);
    let sound = bit.as_ref().zip(operations.as_ref()).zip(sample_interval_s);
    let bit_test = match (&drilling, sound, case.bit_test.at()) {
        (Some(None), ..) => Some(None),
        (Some(Some(drilling)), Some(((bit, operations), sample_interval_s)), Some(table)) => {
            let around = bit_test::Around {
                drilling,
                bit,
                operations,
                sample_interval_s,
            };
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
            let told = Told {
                hoist,
                bit,
                top_drive,
                schedule,
            };
            dynamics.build(mesh, told, reader)
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
    let tunes_lift = match (case.hoist.get(), &operations, &dynamics) {
        (Some(hoist), Some(operations), Some(dynamics)) => {
            hoist.tunes_lift(operations, &dynamics.schedule, reader)
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
            let rms = rough.and_then(|at| at.value.rms.given());
            roughness::check_clearance(drill_string, hole, rms.map(|at| at.place), reader);
        }
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
        well: Well {
            path: path?,
            hole: hole?,
        },
        string: drill_string?,
        mud: mud?,
        rig: rig?,
    };
    let (models, operations) = (models?, operations?);
    let (mut dynamics, records, tunes_lift) = (dynamics?, records?, tunes_lift?);
    let (drilling, bit_test) = (drilling?, bit_test?);
    dynamics.probes.clone_from(&records.probes);
    if let (Some(drilling), Some(rock)) = (&drilling, case.rock.given()) {
        let drills = ModelKind::any_in_time(&models)
            && case.bit.get().and_then(|bit| bit.law.get()) == Some(&Law::Rock)
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
        rock.value
            .warn_of_inertia(drilling, fastest, rock.place, reader);
        rock.value
            .check_effort(drilling, longest_s, rock.place, reader)?;
    }
    effort::check_effort(&models, &model, &operations, &dynamics, &case, reader)?;
    let name = match case.name.optional()? {
        Some(given) => given.value.clone(),
        None => FilePath::new(name).file_stem().map_or_else(
            || "case".to_owned(),
            |stem| stem.to_string_lossy().into_owned(),
        ),
    };
    let units = *case.units.get()?;
    let mut settings =
        settings::settings(&name, units, &models, &model, &operations, &dynamics, &case);
    settings["records"] = records.settings();
    if let Some(drilling) = &drilling {
        let [rock, face] = rock::settings(drilling);
        settings["rock"] = rock;
        settings["bit"]["face"] = face;
    }
    if let Some(test) = &bit_test {
        settings["bit_test"] = test.settings();
    }
    let checkpoint_interval_s = *case.dynamics.get()?.checkpoint_interval.get()?;
    Some(Case {
        name,
        units,
        models,
        model,
        operations,
        bit_test,
        dynamics,
        tunes_lift,
        checkpoint_interval_s,
        records,
        survey_notes: stations.map_or_else(Vec::new, |stations| stations.notes),
        warnings: Report::default(),
        settings,
    })
}

fn models(case: &CaseTable, reader: &mut Reader) -> Option<Vec<ModelKind>> {
    let models = case.model.get()?;
    once_each(models, ModelKind::name, reader)?;
    Some(models.iter().map(|at| at.value).collect())
}

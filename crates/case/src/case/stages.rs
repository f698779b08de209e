//! Stages of building a case. Each reads its tables and the stages above it; a part with a mistake
//! is `None`, so that all others are still checked.

use wholestring::{
    dynamics::{BitSettings, DynamicsSettings, RockLaw},
    ends::Ends,
    mud::Mud,
    operation::Operation,
    outcome::ModelKind,
    rig::Rig,
    rock::DrillingSpec,
    string::{DrillString, Material, StringSpec},
    well::{Hole, Path, USUAL_DOGLEG_RAD_PER_M, endured_dogleg_rad_per_m},
};
use wholestring_config::prelude::*;
use wholestring_units::UnitSet;

use crate::{
    bit::{Around, BitTable, Law},
    bit_test::{self, BitTest},
    case::table::CaseTable,
    catalogue::OwnCatalogue,
    dynamics::{DynamicsTable, GivenSettings, records::Records},
    operation::OperationTable,
    rock,
    string::{assembly, component::ComponentTable, fit, named_size},
    well::{hole, hole::HoleTable, programme, roughness, stations::Stations},
};

/// Bending strain at which coiled tubing of 80 ksi yields.
const YIELD_STRAIN: f64 = 2.7e-3;

/// The tables of a case, which every stage reads.
pub(super) struct Tables<'a> {
    pub(super) case: &'a CaseTable,
    pub(super) files: &'a dyn Files,
    /// The tubulars of the case's own catalogue.
    pub(super) own: Option<OwnCatalogue>,
}

impl<'a> Tables<'a> {
    /// The tables of a case, with the file of its catalogue.
    pub(super) fn new(case: &'a CaseTable, files: &'a dyn Files, reader: &mut Reader) -> Self {
        let own = match case.catalogue.optional() {
            Some(Some(file)) => OwnCatalogue::beside(file, files, reader),
            entry => entry.map(|_| OwnCatalogue::default()),
        };
        Self { case, files, own }
    }

    /// Units of displayed results.
    pub(super) fn units(&self) -> UnitSet {
        self.case.units.get().copied().unwrap_or_default()
    }

    /// The models to solve.
    pub(super) fn models(&self, reader: &mut Reader) -> Option<Vec<ModelKind>> {
        let models = self.case.model.get()?;
        once_each(models, ModelKind::name, reader)?;
        Some(models.iter().map(|at| at.value).collect())
    }

    /// Path and hole.
    pub(super) fn bore(&self, reader: &mut Reader) -> Bore {
        let well = self.case.well.at();
        let mut stations = well.and_then(|at| at.value.stations(at.place, self.files, reader));
        let units = self.units();
        let path = well
            .zip(stations.as_mut())
            .and_then(|(at, stations)| at.value.path(stations, units, reader));
        let rough = well.and_then(|at| at.value.roughness.given()).map(|at| &at.value);
        let sections = self.sections();
        let own = self.own.as_ref();
        let hole = sections.and_then(|sections| hole::build(sections, rough, own, reader));
        let notes = match (&hole, sections) {
            (Some(hole), Some(sections)) => programme::check(hole, sections, reader),
            _ => Vec::new(),
        };
        Bore { stations, path, hole, notes }
    }

    /// Sections of the hole.
    fn sections(&self) -> Option<&'a Vec<Spanned<HoleTable>>> {
        self.case.well.get()?.hole.get()
    }

    /// Components of the string, from the bit up.
    fn components(&self) -> Option<&'a Vec<Spanned<ComponentTable>>> {
        self.case.string.get()
    }

    /// Place at which the case requires a bit test.
    pub(super) fn bit_test_place(&self) -> Option<Span> {
        bit_test::place(&self.case.bit_test)
    }

    /// Depth of the bit, m: the operation's, or that of the last station.
    pub(super) fn bit_depth_m(&self, bore: &Bore) -> Option<f64> {
        let last_md_m = bore.path.as_ref().map(Path::last_md_m);
        self.case.operation.get()?.bit_depth_m(last_md_m)
    }

    /// Place at which the case gives the depth of the bit.
    pub(super) fn bit_depth_place(&self) -> Option<Span> {
        self.case.operation.get().and_then(OperationTable::bit_depth_place)
    }

    /// Checks that path and hole reach the bit.
    pub(super) fn check_reaches(&self, bore: &Bore, reader: &mut Reader) -> Option<()> {
        let (well, bit_depth_m) = self.case.well.at().zip(self.bit_depth_m(bore))?;
        let (path, hole) = (bore.path.as_ref(), bore.hole.as_ref());
        well.value.reaches(path, hole, bit_depth_m, self.bit_depth_place(), reader)
    }

    /// The string as the case gives it, before it is cut to the depth of the bit.
    pub(super) fn string_spec(
        &self,
        steel: Option<&Material>,
        reader: &mut Reader,
    ) -> Option<StringSpec> {
        assembly::spec(self.components()?, steel?, self.own.as_ref()?, reader)
    }

    /// The string at the depth of the bit.
    pub(super) fn string(
        &self,
        spec: Option<&StringSpec>,
        bit_depth_m: Option<f64>,
        reader: &mut Reader,
    ) -> Option<DrillString> {
        let place = self.bit_depth_place();
        assembly::assemble(spec?, self.components()?, bit_depth_m?, place, reader)
    }

    /// Checks the string against the hole, the mud and the weight on bit.
    pub(super) fn check_string(
        &self,
        string: &DrillString,
        hole: Option<&Hole>,
        mud: Option<&Mud>,
        reader: &mut Reader,
    ) {
        let Some(components) = self.components() else { return };
        if let (Some(hole), Some(sections)) = (hole, self.sections()) {
            fit::check_clearance(string, components, hole, sections, reader);
            fit::check_gauge(string, components, hole, sections, reader);
            if let Some(own) = &self.own {
                programme::check_drift(string, components, hole, sections, own, reader);
            }
            let rough = self.case.well.get().and_then(|well| well.roughness.given());
            let rms = rough.and_then(|table| table.value.rms.given());
            roughness::check_clearance(string, hole, rms.map(|at| at.place), reader);
        }
        named_size::check(string, components, reader);
        fit::check_programme(string, components, reader);
        let Some(mud) = mud else { return };
        let wob = self.case.operation.get().and_then(|operation| operation.wob.given());
        fit::check_weight_on_bit(string, mud, wob, reader);
        if let Some(density) = self.case.mud.get().and_then(|mud| mud.density.at()) {
            fit::check_weight(string, components, mud, density.place, reader);
        }
    }

    /// Bit, rock and ends of the string.
    pub(super) fn bottom(&self, spec: Option<&StringSpec>, reader: &mut Reader) -> Bottom {
        let bit_table = self.case.bit.get();
        let tested = self.bit_test_place();
        let lowest = spec.and_then(|spec| spec.components.first());
        let drilling = bit_table.and_then(|bit| {
            let required_by = match tested {
                Some(place) => Some((place, "a bit test")),
                None => {
                    let law = bit.laws.law.at().filter(|law| law.value == Law::Rock);
                    law.map(|law| (law.place, "the law \"rock\""))
                }
            };
            let od = self.components().and_then(|all| all.first());
            let od = od.map(|at| at.value.od_place(at.place));
            let lowest = lowest.map(|bit| bit.od_m).zip(od);
            rock::drilling(&self.case.rock, bit, required_by, lowest, reader)
        });
        let ends = self.case.ends.get().and_then(|ends| ends.build(bit_table, reader));
        let operation = self.case.operation.get();
        let around = Around {
            radius_m: lowest.map(|bit| 0.5 * bit.od_m),
            flow_m3_per_s: operation.and_then(|operation| operation.flow_rate.get().copied()),
            drilling: drilling.as_ref().and_then(Option::as_ref),
            is_tested: tested.is_some(),
            files: self.files,
        };
        let bit = bit_table.and_then(|bit| bit.build(&around, reader));
        Bottom { drilling, ends, bit }
    }

    /// Whether an operation rotates the string.
    pub(super) fn rotates(&self) -> bool {
        let kinds = self.case.operation.get().and_then(|operation| operation.kind.get());
        kinds.is_none_or(|kinds| kinds.iter().any(|kind| kind.value.rotates()))
    }

    /// Warns of operations that rotate coiled tubing.
    pub(super) fn check_injector(
        &self,
        spec: Option<&StringSpec>,
        rig: Option<&Rig>,
        reader: &mut Reader,
    ) {
        if let (Some(spec), Some(rig)) = (spec, rig)
            && assembly::is_injected(spec, rig)
            && let Some(operation) = self.case.operation.get()
        {
            operation.check_injector(reader);
        }
    }

    /// Operations.
    pub(super) fn operations(
        &self,
        bit: Option<&BitSettings>,
        models: &[ModelKind],
        bit_depth_m: Option<f64>,
        reader: &mut Reader,
    ) -> Option<Vec<Operation>> {
        let (operation, table) = self.case.operation.get().zip(self.case.bit.get())?;
        operation.build((table, bit), models, bit_depth_m, reader)
    }

    /// Test of bit and rock without the string; `Some(None)` of a case without one.
    pub(super) fn bit_test(
        &self,
        bottom: &Bottom,
        operations: Option<&[Operation]>,
        reader: &mut Reader,
    ) -> Option<Option<BitTest>> {
        let Some(drilling) = bottom.drilling.as_ref()? else { return Some(None) };
        let around = bit_test::Around {
            drilling,
            bit: bottom.bit.as_ref()?,
            operations: operations?,
            sample_interval_s: self
                .case
                .dynamics
                .get()
                .and_then(DynamicsTable::sample_interval_s)?,
        };
        let requested = self.bit_test_place().is_some();
        bit_test::build(self.case.bit_test.at()?, requested, &around, reader)
    }

    /// Settings of the dynamic model.
    pub(super) fn dynamics(
        &self,
        bit: Option<BitSettings>,
        models: &[ModelKind],
        mud: Option<&Mud>,
        reader: &mut Reader,
    ) -> Option<DynamicsSettings> {
        let operation = self.case.operation.get();
        let schedule = operation.and_then(|operation| {
            let end_s = self.case.dynamics.get().and_then(DynamicsTable::end_s);
            operation.schedule(models, end_s, reader)
        });
        let top_drive = self.case.top_drive.get().and_then(|drive| drive.build(reader));
        if let (Some(operation), Some(mud)) = (operation, mud) {
            let turns_motor = self.case.bit.get().is_some_and(BitTable::takes_flow);
            operation.check_flow(mud, turns_motor, reader);
        }
        let dynamics = self.case.dynamics.get()?;
        let (mesh, hoist) = self.case.mesh.get().zip(self.case.hoist.get())?;
        let given_settings = GivenSettings { hoist, bit, top_drive, schedule };
        dynamics.build(mesh, given_settings, reader)
    }

    /// Checks the settings of the dynamic model against hole and operations.
    pub(super) fn check_dynamics(
        &self,
        settings: Option<&DynamicsSettings>,
        hole: Option<&Hole>,
        operations: Option<&[Operation]>,
        models: &[ModelKind],
        reader: &mut Reader,
    ) -> Option<()> {
        let Some(table) = self.case.dynamics.get() else { return Some(()) };
        if let Some(hole) = hole {
            table.check_stribeck(hole, reader);
        }
        match (settings, operations) {
            (Some(settings), Some(operations)) if ModelKind::any_in_time(models) => {
                table.check_precision(operations, settings, reader)
            }
            _ => Some(()),
        }
    }

    /// Whether the lift of the hook is tuned to the weight on bit.
    pub(super) fn tunes_hook_load(
        &self,
        operations: Option<&[Operation]>,
        dynamics: Option<&DynamicsSettings>,
        reader: &mut Reader,
    ) -> Option<bool> {
        self.case.hoist.get()?.tunes_hook_load(operations?, &dynamics?.schedule, reader)
    }

    /// Further outputs of a dynamic run.
    pub(super) fn records(
        &self,
        dynamics: Option<&DynamicsSettings>,
        bit_depth_m: Option<f64>,
        reader: &mut Reader,
    ) -> Option<Records> {
        let (dynamics, records) = dynamics.zip(self.case.records.get())?;
        records.build(dynamics, bit_depth_m, reader)
    }

    /// Checks that solid rock can be solved: its inertia, and the effort of run and bit test.
    pub(super) fn check_rock(
        &self,
        drilling: &DrillingSpec,
        bit_test: Option<&BitTest>,
        (models, operations): (&[ModelKind], &[Operation]),
        dynamics: &DynamicsSettings,
        reader: &mut Reader,
    ) -> Option<()> {
        let Some(rock) = self.case.rock.given() else { return Some(()) };
        let law = self.case.bit.get().and_then(|bit| bit.laws.law.get());
        let drills = ModelKind::any_in_time(models) && law == Some(&Law::Rock);
        let speeds = operations
            .iter()
            .filter(|one| drills && one.kind.on_bottom())
            .map(|one| dynamics.bit.drilling_speed_rad_per_s(one));
        let run_s = speeds
            .clone()
            .map(|speed_rad_per_s| dynamics.longest_s() + RockLaw::run_in_s(speed_rad_per_s));
        let required = self.bit_test_place().and(bit_test);
        let longest_s = run_s.fold(required.map_or(0.0, BitTest::time_s), f64::max);
        let points = required.into_iter();
        let points = points.flat_map(|test| test.rotary_speeds_rad_per_s.iter().copied());
        let fastest = speeds.chain(points).fold(0.0, f64::max);
        rock.value.warn_of_inertia(drilling, fastest, rock.place, reader);
        rock.value.check_effort(drilling, longest_s, rock.place, reader)
    }
}

/// Path and hole of a case.
pub(super) struct Bore {
    pub(super) stations: Option<Stations>,
    pub(super) path: Option<Path>,
    pub(super) hole: Option<Hole>,
    /// Interpretation of the casing programme.
    pub(super) notes: Vec<String>,
}

impl Bore {
    /// Checks the doglegs of the stations against the endurance of the longest pipe of a string; of
    /// coiled tubing, which has no joints and does not rotate, against its yield.
    pub(super) fn check_turns(
        &mut self,
        spec: Option<&StringSpec>,
        rotates: bool,
        reader: &mut Reader,
    ) {
        if let (Some(_), Some(stations)) = (&self.path, self.stations.as_mut()) {
            let pipe = spec.and_then(assembly::longest);
            let endured = pipe.map_or(USUAL_DOGLEG_RAD_PER_M, |pipe| {
                match pipe.joints.is_none() && !rotates {
                    true => 2.0 * YIELD_STRAIN / pipe.od_m,
                    false => endured_dogleg_rad_per_m(pipe.od_m),
                }
            });
            stations.check_turns(endured, reader);
        }
    }
}

/// Bit, rock and ends of the string of a case.
pub(super) struct Bottom {
    /// Bit and solid rock; `Some(None)` of a case without them.
    pub(super) drilling: Option<Option<DrillingSpec>>,
    pub(super) ends: Option<Ends>,
    pub(super) bit: Option<BitSettings>,
}

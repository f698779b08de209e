//! `[plan]`: inputs of `wholestring plan`.

mod campaign;
mod depths;
mod dynamic;
mod factors;

use serde::Serialize;
use wholestring::{
    model::Model,
    operation::{Operation, OperationKind},
    string::StringSpec,
    well::{Friction, HoleKind},
};
use wholestring_config::prelude::*;
use wholestring_judge::LimitSettings;
use wholestring_plan::{
    CampaignSettings, FrictionLevel, Frictions, KindFriction, LevelFriction, Setup, Statics,
    bit_depths_m, dynamic::DynamicPlan,
};
use wholestring_units::UnitSet;

use crate::{
    beside::{self, Measured},
    operation::kind::KindRule,
    plan::{
        campaign::{CampaignTable, FatigueTable},
        depths::{check_depth, depth, listed_once},
        dynamic::DynamicTable,
        factors::FactorsTable,
    },
    string::assembly::is_injected,
    uncertain::{
        Uncertain,
        table::{self, UncertainTable},
    },
    values::STATICS,
    well::hole::{FrictionRule, coefficient},
};

/// Default number of depths of the bit.
const DEPTHS: u64 = 30;

/// Maximum number of depths.
const MAX_DEPTHS: usize = 1000;

/// Default rotary speed off bottom of a case without one, rad/s: 60 rev/min.
const USUAL_ROTATION_RAD_PER_S: f64 = 2.0 * std::f64::consts::PI;

table! {
    /// Inputs of `wholestring plan`: hook load and torque against the depth of the bit, and related
    /// results.
    PlanTable in "[plan]" {
        /// Low, expected and high friction. Default: expected is the friction of each
        /// `[[well.hole]]`, low 0.1 less, high 0.1 more.
        friction: FrictionsTable = optional(Section::<FrictionsTable>::RULE);
        /// Number of depths of the bit, evenly from the shallowest to that of the operation. The
        /// lower ends of hole sections are added.
        depths: u64 = default(Count { from: 2, to: MAX_DEPTHS as u64 }, DEPTHS);
        /// Shallowest depth of the bit. Default: a metre more than the length of the bottom-hole
        /// assembly below the drill pipe. At any depth the string is cut at the surface.
        shallowest: f64 = optional(depth("500 m"));
        /// Depths of the bit, one by one, in place of `depths` and `shallowest`.
        bit_depths: Vec<Spanned<f64>> = optional(List::of(depth("1500 m"), "depths", MAX_DEPTHS));
        /// Operations at every depth, with the set points of [operation]. Default: "trip_out",
        /// "trip_in", "rotate_off_bottom" and the drilling kind of [operation]. Off bottom a case
        /// without `rpm` turns with 60 rev/min; coiled tubing (no joints, a rig with
        /// `snubbing_force`) does not rotate.
        operations: Vec<Spanned<OperationKind>> = optional(List::or_one(
            KindRule, "operations", OperationKind::ALL.len(),
        ));
        /// "soft" (fast), "stiff" (with bending stiffness and clearance, some seconds a depth), or
        /// both.
        models: Vec<Spanned<Statics>> = default(
            List::or_one(
                Choice { noun: "a model of a plan", words: STATICS },
                "models",
                Statics::ALL.len(),
            ),
            vec![Spanned { value: Statics::Soft, place: Span::default() }],
        );
        /// Overpull that must be available in string and hoist off bottom. 50,000 to 100,000 lbf
        /// are commonly planned.
        overpull: f64 = default(
            Quantity::si(Dimension::Force, Range::from_to(0.0, 1e7).usual(5e4, 2e6), "445 kN"),
            LimitSettings::default().overpull_N,
        );
        /// Largest side force of the wall on one joint of pipe. Default: not checked. 2,000 lbf are
        /// commonly planned against casing wear.
        side_force_per_joint: f64 = optional(
            Quantity::si(Dimension::Force, Range::from_to(1.0, 1e6).usual(1e3, 1e5), "9 kN"),
        );
        /// Required factors of the limits, capacity over load.
        factors: FactorsTable = optional(Section::<FactorsTable>::RULE);
        /// Weights and torques that were measured, relative to the folder of the case: a table with
        /// a row for each depth, in the format of `wholestring calibrate`. Drawn on the broomsticks
        /// and compared with them.
        measured: String = optional(Text);
        /// Campaign over which casing wear and fatigue are summed.
        campaign: CampaignTable = optional(Section::<CampaignTable>::RULE);
        /// Fatigue model of the string.
        fatigue: FatigueTable = optional(Section::<FatigueTable>::RULE);
        /// Numbers of the case that are not known exactly. Default: none.
        uncertain: UncertainTable = optional(Section::<UncertainTable>::RULE);
        /// Inputs from dynamic runs: peak loads while the string starts to move, and casing wear.
        /// Default: none.
        dynamic: DynamicTable = optional(Section::<DynamicTable>::RULE);
    }
}

table! {
    /// Friction, low, expected and high: each a coefficient, or { cased = 0.2, open = 0.3 } with a
    /// coefficient or a table as of `[[well.hole]]` for each.
    FrictionsTable in "[plan.friction]" {
        /// Low friction. Default: 0.1 less than the expected friction, but not below 0.05 unless
        /// the expected friction is.
        low: GivenLevel = optional(LevelRule);
        /// The friction that is expected. Default: each section's own.
        expected: GivenLevel = optional(LevelRule);
        /// High friction. Default: 0.1 more than the expected friction.
        high: GivenLevel = optional(LevelRule);
    }
}

table! {
    /// Friction of casings and of the rock at one level.
    LevelTable in "a level of [plan.friction]" {
        /// Friction of every casing and liner. Default: as without this level.
        cased: Friction = optional(FrictionRule);
        /// Friction of the rock. Default: as without this level.
        open: Friction = optional(FrictionRule);
    }
}

/// The given friction of a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GivenLevel {
    cased: Option<Friction>,
    open: Option<Friction>,
}

impl GivenLevel {
    /// Returns the level, completed from another one.
    fn or(self, other: LevelFriction) -> LevelFriction {
        LevelFriction {
            cased: self.cased.map_or(other.cased, KindFriction::Given),
            open: self.open.map_or(other.open, KindFriction::Given),
        }
    }
}

/// The friction of a level: a coefficient, or one each for casing and rock.
struct LevelRule;

impl Rule for LevelRule {
    type Value = GivenLevel;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<GivenLevel> {
        match &node.value {
            Value::Number { .. } => {
                let friction = Some(Friction::uniform(coefficient().read(node, reader)?));
                Some(GivenLevel { cased: friction, open: friction })
            }
            Value::Table(entries) => {
                let table = LevelTable::read(entries, node.place, reader);
                let value_of = |field: &Field<Friction>| Some(field.optional()?.map(|at| at.value));
                let (cased, open) = (value_of(&table.cased), value_of(&table.open));
                Some(GivenLevel { cased: cased?, open: open? })
            }
            _ => {
                let expected = "a coefficient such as 0.3, or { cased = 0.2, open = 0.3 }";
                reader.expected(node, expected);
                None
            }
        }
    }

    fn schema(&self) -> serde_json::Value {
        serde_json::json!({ "anyOf": [coefficient().schema(), LevelTable::schema()] })
    }
}

/// Settings of a plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Plan {
    /// Low, expected and high friction.
    pub frictions: Frictions,
    /// Depths of the bit, m, increasing.
    pub bit_depths_m: Vec<f64>,
    /// Operations at every depth.
    pub operations: Vec<Operation>,
    /// Models that solve them.
    pub models: Vec<Statics>,
    /// Settings of the limits.
    pub limits: LimitSettings,
    /// Campaign over which casing wear and fatigue are summed.
    pub campaign: CampaignSettings,
    /// Uncertain inputs, if any are given.
    pub uncertain: Option<Uncertain>,
    /// Measurements, which do not affect the results.
    #[serde(skip)]
    pub measured: Option<Measured>,
    /// Inputs from dynamic runs.
    pub dynamic: DynamicPlan,
}

/// Returns the parts of a model, from which it can be rebuilt at other depths and frictions.
pub(crate) fn setup(model: &Model, string: &StringSpec) -> Setup {
    Setup {
        well: model.well.clone(),
        string: string.clone(),
        mud: model.mud,
        fluids: model.fluids.clone(),
        rig: model.rig,
        ends: model.ends,
        buckling: model.buckling,
    }
}

/// Context of a plan.
pub(crate) struct Beside<'a> {
    /// The string at every depth.
    pub(crate) setup: &'a Setup,
    /// The operations of the case.
    pub(crate) own: &'a [Operation],
    /// Gel strength of the mud.
    pub(crate) gel_strength_Pa: Option<f64>,
    /// The files that the case names.
    pub(crate) files: &'a dyn Files,
    /// Units in which the case is shown.
    pub(crate) units: UnitSet,
}

pub(crate) fn build(table: &PlanTable, beside: &Beside<'_>, reader: &mut Reader) -> Option<Plan> {
    let Beside { setup, own, gel_strength_Pa, files, units } = *beside;
    let frictions = frictions(table, setup, reader);
    let depths_m = depths_m(table, setup, own.first()?.bit_depth_m, reader);
    let operations = operations(table, setup, own, reader);
    let models = table.models.get()?;
    once_each(models, Statics::name, reader)?;
    let limits = limits(table, setup, reader);
    let campaign = campaign::build(
        table.campaign.optional()?.map(|at| &at.value),
        table.fatigue.optional()?.map(|at| &at.value),
        setup,
        depths_m.as_ref()?.last().copied()?,
        reader,
    );
    let uncertain = match table.uncertain.optional()? {
        Some(entry) => table::build(&entry.value, reader)?,
        None => None,
    };
    let measured = match table.measured.optional()? {
        Some(file) => Some(beside::measured_from_file(file, (setup, units), own, files, reader)?),
        None => None,
    };
    let mut campaign = campaign?;
    campaign.operations = campaign_operations(own, operations.as_deref()?);
    let beside = dynamic::Beside {
        setup,
        own,
        planned: operations.as_deref()?,
        campaign: &campaign,
        deepest_m: depths_m.as_ref()?.last().copied()?,
        gel_strength_Pa,
        usual_rotation_rad_per_s: USUAL_ROTATION_RAD_PER_S,
    };
    let dynamic_table = table.dynamic.optional()?.and(table.dynamic.given());
    let dynamic = dynamic::build(dynamic_table, &beside, reader);
    Some(Plan {
        uncertain,
        frictions: frictions?,
        bit_depths_m: depths_m?,
        operations: operations?,
        models: models.iter().map(|at| at.value).collect(),
        limits: limits?,
        campaign,
        measured,
        dynamic: dynamic?,
    })
}

fn limits(table: &PlanTable, setup: &Setup, reader: &mut Reader) -> Option<LimitSettings> {
    let factors = match table.factors.optional()? {
        Some(entry) => factors::build(&entry.value)?,
        None => LimitSettings::default().factors,
    };
    let rig = &setup.rig;
    if let (Some(overpull), Some(capacity_N)) = (table.overpull.given(), rig.hoist_capacity_N) {
        let left_N = capacity_N - rig.block_weight_N.unwrap_or(0.0);
        if overpull.value > left_N {
            let left = reader.shown(Dimension::Force, left_N);
            let warning = Diagnostic::warning("the hoist never has this much overpull available");
            reader.report(warning.at(
                overpull.place,
                format!("the hoist can lift {left} in addition to its block, without a string"),
            ));
        }
    }
    Some(LimitSettings {
        factors,
        overpull_N: *table.overpull.get()?,
        side_force_per_joint_N: table.side_force_per_joint.optional()?.map(|at| at.value),
    })
}

fn frictions(table: &PlanTable, setup: &Setup, reader: &mut Reader) -> Option<Frictions> {
    let usual = Frictions::default();
    let Some(entry) = table.friction.optional()? else {
        return Some(usual);
    };
    let levels = [&entry.value.low, &entry.value.expected, &entry.value.high];
    let places = levels.map(|level| level.place());
    let [low, expected, high] = levels.map(Field::optional);
    let level = |entry: Option<&Spanned<GivenLevel>>, other: LevelFriction| {
        entry.map_or(other, |at| at.value.or(other))
    };
    let expected = level(expected?, usual.expected);
    let frictions = Frictions {
        low: level(low?, expected.beside(&usual.low)),
        expected,
        high: level(high?, expected.beside(&usual.high)),
    };
    // Each level must be at least the previous one in every section, along the hole and around it.
    for [less, more] in [[0, 1], [1, 2]] {
        let [less_level, more_level] = [less, more].map(|place| FrictionLevel::ALL[place]);
        for section in setup.well.hole.sections() {
            let [a, b] = [less_level, more_level].map(|level| frictions.of(level).of(section));
            let parts = [
                ("along", a.kinetic, b.kinetic),
                ("around", a.kinetic * a.around, b.kinetic * b.around),
            ];
            let wrong = parts.into_iter().find(|(_, a, b)| *a > *b + 1e-12);
            let Some((way, a, b)) = wrong else { continue };
            let names = [less_level, more_level].map(FrictionLevel::name);
            let kind = match section.kind {
                HoleKind::Casing => "casing",
                HoleKind::Open => "open hole",
            };
            let rounded = |value: f64| number_text((1e6 * value).round() / 1e6);
            let mut diagnostic = Diagnostic::error(format!(
                "{} friction is more than {} friction: {} and {} {way} the hole in the {kind} down \
                 to {}",
                names[0],
                names[1],
                rounded(a),
                rounded(b),
                reader.shown(Dimension::Length, section.to_md_m)
            ));
            for (place, level) in [(places[less], names[0]), (places[more], names[1])] {
                diagnostic = match place {
                    Some(place) => diagnostic.at(place, format!("{level} friction")),
                    None => diagnostic.help(format!(
                        "give `{level}` too: without it, it is each section's own friction"
                    )),
                };
            }
            return diagnostic.refuse(reader);
        }
    }
    Some(frictions)
}

fn depths_m(
    table: &PlanTable,
    setup: &Setup,
    deepest_m: f64,
    reader: &mut Reader,
) -> Option<Vec<f64>> {
    let shallowest = table.shallowest.optional()?;
    let Some(listed) = table.bit_depths.optional()? else {
        let count = *table.depths.get()? as usize;
        if let Some(from) = shallowest {
            check_depth(from, setup, reader)?;
            if from.value >= deepest_m {
                return Diagnostic::error(
                    "the shallowest depth of the plan is not above the depth of the bit",
                )
                .at(
                    from.place,
                    format!("the bit is at {}", reader.shown(Dimension::Length, deepest_m)),
                )
                .refuse(reader);
            }
        }
        return Some(bit_depths_m(setup, shallowest.map(|at| at.value), deepest_m, count));
    };
    for (entry, name) in
        [(table.depths.place(), "depths"), (shallowest.map(|at| at.place), "shallowest")]
    {
        if let Some(place) = entry {
            let why = "`bit_depths` lists the depths";
            reader.report(Diagnostic::idle(name, place, why));
        }
    }
    for at in &listed.value {
        check_depth(at, setup, reader)?;
    }
    listed_once(&listed.value, reader)
}

/// Operations that the campaign may need and the plan does not list: trips, rotation off bottom and
/// the drilling of the case.
fn campaign_operations(own: &[Operation], planned: &[Operation]) -> Vec<Operation> {
    use OperationKind::{RotateOffBottom, TripIn, TripOut};
    let others = [TripOut, TripIn, RotateOffBottom].map(|kind| usual(own, kind));
    let drilling = own.iter().filter(|operation| operation.kind.on_bottom()).copied();
    let all = others.into_iter().flatten().chain(drilling);
    all.filter(|one| !planned.iter().any(|other| other.kind == one.kind)).collect()
}

/// Returns the operation of the case of a kind, or one with the set points of its first; an
/// operation that rotates off bottom has a rotary speed.
fn usual(own: &[Operation], kind: OperationKind) -> Option<Operation> {
    let found = own.iter().find(|one| one.kind == kind).copied();
    let mut operation = found.or_else(|| Some(Operation { kind, ..*own.first()? }))?;
    if kind == OperationKind::RotateOffBottom && operation.rotary_speed_rad_per_s == 0.0 {
        operation.rotary_speed_rad_per_s = USUAL_ROTATION_RAD_PER_S;
    }
    Some(operation)
}

fn operations(
    table: &PlanTable,
    setup: &Setup,
    own: &[Operation],
    reader: &mut Reader,
) -> Option<Vec<Operation>> {
    use OperationKind::{RotateOffBottom, TripIn, TripOut};
    let Some(listed) = table.operations.optional()? else {
        let drilling = own.iter().filter(|one| one.kind.on_bottom()).copied();
        let off_bottom: &[OperationKind] = match is_injected(&setup.string, &setup.rig) {
            true => &[TripOut, TripIn],
            false => &[TripOut, TripIn, RotateOffBottom],
        };
        let usual = off_bottom.iter().filter_map(|kind| usual(own, *kind));
        return Some(usual.chain(drilling).collect());
    };
    once_each(&listed.value, OperationKind::name, reader)?;
    let mut operations = Vec::new();
    for at in &listed.value {
        let name = at.value.name();
        if at.value.on_bottom() && !own.iter().any(|one| one.kind == at.value) {
            return Diagnostic::error(format!(
                "`{name}` of the plan is not an operation of the case"
            ))
            .at(at.place, "drills with the set points of [operation]")
            .help(format!("add \"{name}\" to `kind` in [operation]"))
            .refuse(reader);
        }
        let operation = usual(own, at.value)?;
        if at.value.rotates() && operation.rotary_speed_rad_per_s == 0.0 {
            return Diagnostic::error(format!("`{name}` of the plan needs `rpm`"))
                .at(at.place, "turns the string; `rpm` is missing in [operation]")
                .help("such as rpm = 70")
                .refuse(reader);
        }
        operations.push(operation);
    }
    Some(operations)
}

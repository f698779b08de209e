//! `[plan.dynamic]`: results of the dynamics in a plan.

use wholestring::{
    operation::{Operation, OperationKind},
    well::{HoleKind, HoleSection},
};
use wholestring_config::prelude::*;
use wholestring_plan::{
    CampaignSettings, FrictionLevel, Setup,
    dynamic::{DynamicPlan, Event},
};

use crate::{
    operation::kind::KindRule,
    plan::depths::{check_depth, depth, listed_once},
    values::words,
};

const EVENTS: &[(&str, Event)] = words!(Event);
const LEVELS: &[(&str, FrictionLevel)] = words!(FrictionLevel);

/// Maximum number of depths: each is a dynamic run.
const MAX_DEPTHS: usize = 50;

table! {
    /// Inputs of a plan from dynamic runs. Without this table there are no dynamic runs.
    DynamicTable in "[plan.dynamic]" {
        /// Events in which the string starts to move from rest, for the peaks of hook load, torque
        /// and pump pressure: "pick_up_from_slips", "slack_off_from_slips" (to the `trip_speed` of
        /// [operation]), "break_circulation" (to its `flow_rate`), "break_rotation" (to its `rpm`,
        /// pumps off).
        events: Vec<Spanned<Event>> = optional(List::or_one(
            Choice { noun: "an event", words: EVENTS },
            "events",
            Event::ALL.len(),
        ));
        /// Operations of the campaign whose casing wear is computed from the friction work of the
        /// dynamics: the drilling kind of the campaign, or "rotate_off_bottom". They run with the
        /// settings of `[dynamics]`.
        wear: Vec<Spanned<OperationKind>> = optional(List::or_one(
            KindRule, "operations", OperationKind::ALL.len(),
        ));
        /// Depths of the bit. Default: the deepest of the plan.
        bit_depths: Vec<Spanned<f64>> = optional(List::or_one(depth("1500 m"), "depths", MAX_DEPTHS));
        /// Friction levels of the events: "low", "expected", "high". Default: "expected".
        friction: Vec<Spanned<FrictionLevel>> = optional(List::or_one(
            Choice { noun: "a level of friction", words: LEVELS },
            "levels",
            FrictionLevel::ALL.len(),
        ));
        /// Time in which the block reaches the trip speed from rest. Lowering it raises the peak.
        hoist_ramp: f64 = default(time("2 s"), DynamicPlan::default().hoist_ramp_s);
        /// Time in which the pumps reach the flow rate.
        pump_ramp: f64 = default(time("10 s"), DynamicPlan::default().pump_ramp_s);
        /// Time in which the rotary reaches its speed.
        rotary_ramp: f64 = default(time("5 s"), DynamicPlan::default().rotary_ramp_s);
        /// Observation time after the ramp. The steady value is the mean over its last quarter.
        watch: f64 = default(
            Quantity::si(Dimension::Time, Range::from_to(1.0, 3600.0).usual(2.0, 600.0), "20 s"),
            DynamicPlan::default().watch_s,
        );
    }
}

fn time(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Time, Range::from_to(0.0, 3600.0).usual(0.1, 600.0), example)
}

/// Context of a table of the plan.
pub(crate) struct Beside<'a> {
    pub(crate) setup: &'a Setup,
    /// Operations of the case.
    pub(crate) own: &'a [Operation],
    /// Operations of the plan.
    pub(crate) planned: &'a [Operation],
    pub(crate) campaign: &'a CampaignSettings,
    pub(crate) deepest_m: f64,
    pub(crate) gel_strength_Pa: Option<f64>,
    /// Rotary speed off bottom where the case gives none.
    pub(crate) usual_rotation_rad_per_s: f64,
}

/// Builds the inputs from dynamic runs.
pub(crate) fn build(
    entry: Option<&Spanned<DynamicTable>>,
    beside: &Beside<'_>,
    reader: &mut Reader,
) -> Option<DynamicPlan> {
    let Some(Spanned { value: table, place }) = entry else {
        return Some(DynamicPlan::default());
    };
    let (events, wear) = (table.events.optional()?, table.wear.optional()?);
    let events = events.map_or(&[][..], |at| &at.value);
    let wear = wear.map_or(&[][..], |at| &at.value);
    if events.is_empty() && wear.is_empty() {
        // A misspelt key has a better message.
        if reader.has_errors() {
            return None;
        }
        return Diagnostic::error("no dynamic run is requested")
            .at(*place, "neither `events` nor `wear`")
            .help("such as events = \"pick_up_from_slips\"")
            .refuse(reader);
    }
    once_each(events, Event::name, reader)?;
    once_each(wear, OperationKind::name, reader)?;
    let cased = |section: &HoleSection| section.kind == HoleKind::Casing;
    if let (Some(place), false) =
        (table.wear.place(), beside.setup.well.hole.sections().iter().any(cased))
    {
        reader.report(Diagnostic::idle("wear", place, "the hole has no casing"));
    }
    idle_ramps(table, events, reader);
    let bit_depths_m = match table.bit_depths.optional()? {
        Some(listed) => {
            for at in &listed.value {
                check_depth(at, beside.setup, reader)?;
            }
            listed_once(&listed.value, reader)?
        }
        None => vec![beside.deepest_m],
    };
    let usual = DynamicPlan::default();
    let frictions = match table.friction.optional()? {
        Some(levels) => {
            once_each(&levels.value, FrictionLevel::name, reader)?;
            levels.value.iter().map(|at| at.value).collect()
        }
        None => usual.frictions,
    };
    let set_points = match events {
        [] => None,
        _ => Some(set_points(events, beside, reader)?),
    };
    let wear: Option<Vec<Operation>> = wear.iter().map(|at| wears(at, beside, reader)).collect();
    Some(DynamicPlan {
        events: events.iter().map(|at| at.value).collect(),
        set_points,
        bit_depths_m,
        frictions,
        hoist_ramp_s: *table.hoist_ramp.get()?,
        pump_ramp_s: *table.pump_ramp.get()?,
        rotary_ramp_s: *table.rotary_ramp.get()?,
        watch_s: *table.watch.get()?,
        gel_strength_Pa: beside.gel_strength_Pa,
        wear: wear?,
    })
}

/// Warns of keys of events that are not listed.
fn idle_ramps(table: &DynamicTable, events: &[Spanned<Event>], reader: &mut Reader) {
    let has = |kinds: &[Event]| events.iter().any(|at| kinds.contains(&at.value));
    let lifts = has(&[Event::PickUpFromSlips, Event::SlackOffFromSlips]);
    let keys = [
        ("hoist_ramp", table.hoist_ramp.place(), lifts, "a pick-up or a slack-off from slips"),
        (
            "pump_ramp",
            table.pump_ramp.place(),
            has(&[Event::BreakCirculation]),
            "break_circulation",
        ),
        ("rotary_ramp", table.rotary_ramp.place(), has(&[Event::BreakRotation]), "break_rotation"),
        ("watch", table.watch.place(), !events.is_empty(), "events"),
        ("friction", table.friction.place(), !events.is_empty(), "events"),
    ];
    for (name, place, used, by) in keys {
        if let (Some(place), false) = (place, used) {
            reader.report(Diagnostic::idle(name, place, format!("used with {by}")));
        }
    }
}

/// Returns the set points that events lead to.
fn set_points(
    events: &[Spanned<Event>],
    beside: &Beside<'_>,
    reader: &mut Reader,
) -> Option<Operation> {
    let of_kind = |kind| beside.own.iter().find(|operation| operation.kind == kind).copied();
    let first = *beside.own.first()?;
    let mut set = of_kind(OperationKind::RotateOffBottom).unwrap_or(first);
    if set.rotary_speed_rad_per_s == 0.0 {
        set.rotary_speed_rad_per_s = beside.usual_rotation_rad_per_s;
    }
    if let Some(at) = events.iter().find(|at| at.value == Event::BreakCirculation) {
        let lacks = |what: &str, such: &str, reader: &mut Reader| {
            Diagnostic::error(format!("`break_circulation` needs {what}"))
                .at(at.place, "the pumps start")
                .help(such.to_owned())
                .refuse(reader)
        };
        if set.flow_rate_m3_per_s == 0.0 {
            return lacks(
                "`flow_rate`",
                "such as flow_rate = \"2000 L/min\" in [operation]",
                reader,
            );
        }
        if beside.setup.mud.rheology.is_none() {
            let such = "such as rheology = \"newtonian\" and viscosity = \"20 cP\" in [mud]";
            return lacks("a mud with a `rheology`", such, reader);
        }
    }
    Some(set)
}

/// Returns the operation of the campaign whose wear the dynamics compute.
fn wears(
    at: &Spanned<OperationKind>,
    beside: &Beside<'_>,
    reader: &mut Reader,
) -> Option<Operation> {
    let name = at.value.name();
    let refuse = |message: String, why: &str, help: String, reader: &mut Reader| {
        Diagnostic::error(message).at(at.place, why.to_owned()).help(help).refuse(reader)
    };
    let found = beside.planned.iter().find(|planned| planned.kind == at.value).copied();
    match at.value {
        OperationKind::RotateOffBottom if beside.campaign.off_bottom_s == 0.0 => refuse(
            "the campaign does not turn off bottom".to_owned(),
            "would cause no wear",
            "such as off_bottom = \"10 h\" in [plan.campaign]".to_owned(),
            reader,
        ),
        OperationKind::Drill | OperationKind::RotateOffBottom => found.or_else(|| {
            refuse(
                format!("`{name}` of the plan's dynamics is not an operation of the plan"),
                "is not there to wear",
                format!("add \"{name}\" to `operations` in [plan]"),
                reader,
            )
        }),
        _ => refuse(
            format!("casing wear by the dynamics does not support `{name}`"),
            "expected \"drill\" or \"rotate_off_bottom\"",
            "trips count by their side force".to_owned(),
            reader,
        ),
    }
}

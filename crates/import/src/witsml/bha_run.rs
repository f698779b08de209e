//! `bhaRun`: what the string did, and what was read at the surface.

use wholestring_tabular::ImportedReading;
use wholestring_units::Dimension;

use super::{
    measure::{Measure, Source, short},
    object::Object,
    tree::Node,
};
use crate::{
    error::ImportError,
    fragment::{Fragment, Note, Origin, Value},
};

/// Densities of drilling fluids, kg/m³: below are foams and gases, above nothing is pumped.
const MUDS_KG_PER_M3: std::ops::RangeInclusive<f64> = 600.0..=2600.0;

/// Keys of `[operation]`: where each stands, and what it measures.
const SET_POINTS: [(&str, &str, Dimension); 5] = [
    ("rpm", "rpmAv", Dimension::RotarySpeed),
    ("wob", "wobAv", Dimension::Force),
    ("rop", "ropAv", Dimension::RateOfPenetration),
    ("flow_rate", "flowratePump|flowratePumpAv", Dimension::FlowRate),
    ("bit_pressure_drop", "presDropBit", Dimension::Pressure),
];

/// Set points and readings of the drilling that went deepest.
pub(crate) fn read(
    object: &Object,
    source: &Source,
    fragment: &mut Fragment,
) -> Result<(), ImportError> {
    let notes = &mut fragment.notes;
    let tubular = object.node.child("tubular");
    let title = tubular.and_then(|tubular| tubular.text_of("Title"));
    if let Some(tubular) = object.node.text_of("tubular").or(title) {
        let text = format!("{} ran with the tubular '{}'", object.label(), short(tubular));
        notes.push(Note::Read(text));
    }
    let mut sets: Vec<(&Node, Option<Measure>)> = Vec::new();
    for node in object.node.all("drillingParams") {
        let stop = source.measure(node, "mdHoleStop", Dimension::Length)?;
        sets.push((node, stop.filter(|stop| stop.number > 0.0)));
    }
    let depth_m = |stop: &Option<Measure>| stop.as_ref().map_or(-1.0, Measure::si);
    let deepest = sets.iter().max_by(|a, b| depth_m(&a.1).total_cmp(&depth_m(&b.1)));
    let Some((node, stop)) = deepest else {
        let text = format!("{}: it has no drillingParams", object.label());
        notes.push(Note::LeftOut(text));
        return Ok(());
    };
    if sets.len() > 1 {
        notes.push(Note::Assumed(format!(
            "of {} drillingParams of {} those in line {} hold, which end deepest",
            sets.len(),
            object.label(),
            node.line
        )));
    }
    let mut told = Vec::new();
    for (key, names, dimension) in SET_POINTS {
        let Some(found) = source.optional(node, names, dimension, notes)? else { continue };
        if found.number > 0.0 {
            told.push(key);
            fragment.operation.push(key, found.value(), found.origin);
        }
    }
    let drills = ["rpm", "wob", "rop"].iter().all(|key| told.contains(key));
    if told.contains(&"rpm") {
        let mut kinds = vec!["trip_out", "trip_in", "rotate_off_bottom"];
        kinds.extend(drills.then_some("drill"));
        let kinds = kinds.into_iter().map(str::to_owned).collect();
        let told = if drills { "speed, weight and rate are" } else { "rotary speed is" };
        let from = format!("what a string does of which the {told} told");
        let kind = Value::Words(kinds);
        fragment.operation.push("kind", kind, Origin::Derived { from });
        fragment.operation.entries.rotate_right(1);
    }
    if let Some(stop) = stop {
        fragment.operation.push("bit_depth", stop.value(), stop.origin.clone());
    }
    mud(node, source, fragment)?;
    measured(node, stop.as_ref(), drills, source, fragment)?;
    let torques = ["tqOnBotAv", "tqDhAv"].into_iter().filter(|name| node.text_of(name).is_some());
    let torques: Vec<&str> = torques.collect();
    if drills && !torques.is_empty() {
        fragment.notes.push(Note::LeftOut(format!(
            "{}, for the bit's torque: there is the string's friction in it, of all of it or of \
             what is below a sensor; write `torque` under [bit]",
            torques.join(" and ")
        )));
    }
    Ok(())
}

/// The density of the mud, where no report has told it.
fn mud(node: &Node, source: &Source, fragment: &mut Fragment) -> Result<(), ImportError> {
    let notes = &mut fragment.notes;
    let Some(density) = source.optional(node, "wtMud", Dimension::Density, notes)? else {
        return Ok(());
    };
    if fragment.mud.get("density").is_some() {
        let text = format!("wtMud in line {}: the mudReport tells the density", density.line);
        notes.push(Note::LeftOut(text));
    } else if MUDS_KG_PER_M3.contains(&density.si()) {
        fragment.mud.push("density", density.value(), density.origin);
    } else {
        notes.push(Note::LeftOut(format!(
            "the wtMud of {} in line {}: {:.3} sg is no mud's; write `density` into the case",
            density.written,
            density.line,
            density.si() / 1e3
        )));
    }
    Ok(())
}

/// What was read at the surface with the bit at the end of the run.
fn measured(
    node: &Node,
    stop: Option<&Measure>,
    drills: bool,
    source: &Source,
    fragment: &mut Fragment,
) -> Result<(), ImportError> {
    let notes = &mut fragment.notes;
    let mut si = |name: &str, dimension| -> Result<Option<f64>, ImportError> {
        let found = source.optional(node, name, dimension, notes)?;
        Ok(found.filter(|found| found.number > 0.0).map(|found| found.si()))
    };
    let reading = ImportedReading {
        place: format!("line {}", node.line),
        bit_depth_m: stop.map_or(0.0, Measure::si),
        pick_up_N: si("hkldUp", Dimension::Force)?,
        slack_off_N: si("hkldDn", Dimension::Force)?,
        rotating_N: si("hkldRot", Dimension::Force)?,
        torque_N_m: si("tqOffBotAv", Dimension::Torque)?,
        torque_on_bottom_N_m: si("tqOnBotAv", Dimension::Torque)?.filter(|_| drills),
        mud_density_kg_per_m3: None,
        case: None,
        held_out: false,
        keys: Vec::new(),
    };
    let weights = [reading.pick_up_N, reading.rotating_N, reading.slack_off_N];
    let torques = [reading.torque_N_m, reading.torque_on_bottom_N_m];
    if weights.iter().chain(&torques).all(Option::is_none) {
        return Ok(());
    }
    if stop.is_none() {
        let text = "the hook loads and torques of the run: no mdHoleStop tells at which depth";
        notes.push(Note::LeftOut(text.to_owned()));
        return Ok(());
    }
    // Friction lifts the one and lowers the other.
    let known: Vec<f64> = weights.into_iter().flatten().collect();
    if known.windows(2).any(|pair| pair[0] < pair[1]) {
        let text = "the hook loads and torques of the run: hkldUp, hkldRot and hkldDn do not fall \
                    in this order, as friction makes them";
        notes.push(Note::LeftOut(text.to_owned()));
        return Ok(());
    }
    notes.push(Note::Assumed(format!(
        "the hook loads and torques of the run were read with the bit at its mdHoleStop, {}, and \
         hold the weight of the block",
        stop.map_or("", |stop| &stop.written)
    )));
    fragment.measured.push(reading);
    Ok(())
}

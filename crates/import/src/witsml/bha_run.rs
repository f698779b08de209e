//! `bhaRun`: operation of the string and readings at the surface.

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

/// Densities of drilling fluids, kg/m³; lower values are foams and gases, higher ones cannot be
/// pumped.
const MUDS_KG_PER_M3: std::ops::RangeInclusive<f64> = 600.0..=2600.0;

/// Keys of `[operation]` with their elements and dimensions.
const SET_POINTS: [(&str, &str, Dimension); 5] = [
    ("rpm", "rpmAv", Dimension::RotarySpeed),
    ("wob", "wobAv", Dimension::Force),
    ("rop", "ropAv", Dimension::RateOfPenetration),
    ("flow_rate", "flowratePump|flowratePumpAv", Dimension::FlowRate),
    ("bit_pressure_drop", "presDropBit", Dimension::Pressure),
];

/// Reads the set points and readings of the drilling interval that reached deepest.
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
            "of {} drillingParams of {} those in line {} are used, because they end deepest",
            sets.len(),
            object.label(),
            node.line
        )));
    }
    let mut keys = Vec::new();
    for (key, names, dimension) in SET_POINTS {
        let Some(found) = source.optional(node, names, dimension, notes)? else { continue };
        if found.number > 0.0 {
            keys.push(key);
            fragment.operation.push(key, found.value(), found.origin);
        }
    }
    let drills = ["rpm", "wob", "rop"].iter().all(|key| keys.contains(key));
    if keys.contains(&"rpm") {
        let mut kinds = vec!["trip_out", "trip_in", "rotate_off_bottom"];
        kinds.extend(drills.then_some("drill"));
        let kinds = kinds.into_iter().map(str::to_owned).collect();
        let values = if drills { "speed, weight and rate" } else { "rotary speed" };
        let from = format!("the operations of a string with the {values} given");
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
            "{}, for the bit's torque: it includes friction of the whole string or of the part \
             below a sensor; write `torque` under [bit]",
            torques.join(" and ")
        )));
    }
    Ok(())
}

/// Density of the mud, if no mud report gives it.
fn mud(node: &Node, source: &Source, fragment: &mut Fragment) -> Result<(), ImportError> {
    let notes = &mut fragment.notes;
    let Some(density) = source.optional(node, "wtMud", Dimension::Density, notes)? else {
        return Ok(());
    };
    if fragment.mud.get("density").is_some() {
        let text = format!("wtMud in line {}: the mudReport gives the density", density.line);
        notes.push(Note::LeftOut(text));
    } else if MUDS_KG_PER_M3.contains(&density.si()) {
        fragment.mud.push("density", density.value(), density.origin);
    } else {
        notes.push(Note::LeftOut(format!(
            "the wtMud of {} in line {}: {:.3} sg is outside the range of muds; write `density` \
             into the case",
            density.written,
            density.line,
            density.si() / 1e3
        )));
    }
    Ok(())
}

/// Readings at the surface with the bit at the end of the run.
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
        if let Some(found) = found.as_ref().filter(|found| found.number <= 0.0) {
            notes.push(Note::LeftOut(format!(
                "the {name} of {} in line {}: a reading is more than 0",
                found.written, found.line
            )));
        }
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
        let text = "the hook loads and torques of the run: without mdHoleStop their depth is \
             unknown";
        notes.push(Note::LeftOut(text.to_owned()));
        return Ok(());
    }
    // Friction raises one and lowers the other.
    let known: Vec<f64> = weights.into_iter().flatten().collect();
    if known.windows(2).any(|pair| pair[0] < pair[1]) {
        let text = "the hook loads and torques of the run: hkldUp, hkldRot and hkldDn do not \
             decrease in this order, as friction requires";
        notes.push(Note::LeftOut(text.to_owned()));
        return Ok(());
    }
    notes.push(Note::Assumed(format!(
        "the hook loads and torques of the run were read with the bit at its mdHoleStop, {}, and \
         include the weight of the block",
        stop.map_or("", |stop| &stop.written)
    )));
    fragment.measured.push(reading);
    Ok(())
}

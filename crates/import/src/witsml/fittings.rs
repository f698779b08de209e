//! Fittings of a component: blades, a bend, a sensor.

use wholestring_units::Dimension;

use super::{
    component::Component,
    measure::{Measure, Source, metres, push, short},
    tree::Node,
};
use crate::{
    error::ImportError,
    fragment::{Block, Note},
};

/// Distance between the middle of the blade and the middle of its component within which the case's
/// default position applies, m.
const SAME_PLACE_M: f64 = 0.1;

/// Quantities of a directional sensor in `typeMeasurement`.
const DIRECTIONS: &[&str] = &["deviation", "azimuth", "inclination", "direction"];

/// Words in `typeMeasurement` or `comments` that identify a directional sensor. Other sensors may
/// measure around the hole too, such as an azimuthal gamma ray.
const DIRECTIONAL: &[&str] = &["directional", "d&i"];

impl Component<'_> {
    /// Blades of a stabiliser, or cutters of a hole opener.
    pub(super) fn blades(
        &self,
        block: &mut Block,
        od: Option<&Measure>,
        length: Option<&Measure>,
        source: &Source,
        notes: &mut Vec<Note>,
    ) -> Result<(), ImportError> {
        let label = self.label();
        let mut widest: Option<(Measure, &Node)> = None;
        let mut count = 0;
        for (names, name) in [("stabilizer", "odBladeMx"), ("holeOpener", "diaHoleOpener")] {
            for node in self.node.all(names) {
                let Some(found) = source.measure(node, name, Dimension::Diameter)? else {
                    continue;
                };
                count += 1;
                if widest.as_ref().is_none_or(|(widest, _)| found.si() > widest.si()) {
                    widest = Some((found, node));
                }
            }
        }
        let Some((blade, node)) = widest else { return Ok(()) };
        if count > 1 {
            let text = format!("of {count} sets of blades of {label} the widest alone is read");
            notes.push(Note::LeftOut(text));
        }
        if od.is_some_and(|od| blade.si() <= od.si()) {
            let text = format!("the blades of {label}, {}: no wider than its od", blade.written);
            notes.push(Note::LeftOut(text));
            return Ok(());
        }
        push(block, "blade_od", Some(&blade));
        let Some(blades) = source.measure(node, "lenBlade", Dimension::Length)? else {
            return Ok(());
        };
        let Some(length) = length else { return Ok(()) };
        if blades.number <= 0.0 || blades.si() > length.si() {
            notes.push(Note::LeftOut(format!(
                "the lenBlade of {label}, {}, for the component is {} long: blades all along it",
                blades.written, length.written
            )));
            return Ok(());
        }
        push(block, "blade_length", Some(&blades));
        if let Some(bottom) = source.measure(node, "distBladeBot", Dimension::Length)? {
            let off_m = bottom.si() + blades.si() / 2.0 - length.si() / 2.0;
            if off_m.abs() > SAME_PLACE_M {
                let side = if off_m > 0.0 { "above" } else { "below" };
                notes.push(Note::Assumed(format!(
                    "the blades of {label} are at its middle; by distBladeBot they are {} {side} it",
                    metres(off_m.abs())
                )));
            }
        }
        Ok(())
    }

    /// The bend of a housing or a sub.
    pub(super) fn bend(
        &self,
        block: &mut Block,
        length: Option<&Measure>,
        source: &Source,
        notes: &mut Vec<Note>,
    ) -> Result<(), ImportError> {
        let label = self.label();
        let bends: Vec<&Node> = self.node.all("bend").collect();
        if let [_, _, ..] = bends[..] {
            let text = format!("of {} bends of {label} all but the first", bends.len());
            notes.push(Note::LeftOut(text));
        }
        if let Some(&bend) = bends.first() {
            let angle = source.measure(bend, "angle", Dimension::Angle)?;
            let Some(angle) = angle.filter(|angle| angle.number != 0.0) else { return Ok(()) };
            push(block, "bend", Some(&angle));
            let Some(at) = source.measure(bend, "distBendBot", Dimension::Length)? else {
                return Ok(());
            };
            if at.number < 0.0 || length.is_some_and(|length| at.si() > length.si()) {
                return Err(source.out_of_range(&at, "distBendBot", "a place of the component"));
            }
            push(block, "bend_at", Some(&at));
            return Ok(());
        }
        let motor = self.node.child("motor");
        let settings = motor.and_then(|motor| motor.text_of("bendSettingsMx"));
        if let Some(most) = settings.filter(|most| most.parse() != Ok(0.0)) {
            notes.push(Note::LeftOut(format!(
                "the bend of {label}: it can be set up to {}, but its setting is not given; write \
                 `bend` and `bend_at` into the case",
                short(most)
            )));
        }
        Ok(())
    }

    /// The directional sensor of an MWD.
    pub(super) fn sensor(
        &self,
        block: &mut Block,
        length: Option<&Measure>,
        source: &Source,
        notes: &mut Vec<Note>,
    ) -> Result<(), ImportError> {
        let tools = self.node.all("mwdTool|rotarySteerableTool|motor");
        for sensor in tools.flat_map(|tool| tool.all("sensor")) {
            let lower_text = |name| sensor.text_of(name).unwrap_or_default().to_lowercase();
            let (measures, comments) = (lower_text("typeMeasurement"), lower_text("comments"));
            let mentions = |word: &str| measures.contains(word) || comments.contains(word);
            if !DIRECTIONS.contains(&measures.as_str())
                && !DIRECTIONAL.iter().any(|word| mentions(word))
            {
                continue;
            }
            let Some(offset) = source.measure(sensor, "offsetBot", Dimension::Length)? else {
                continue;
            };
            if offset.number < 0.0 || length.is_some_and(|length| offset.si() > length.si()) {
                let text = format!(
                    "the directional sensor of {}, {} from its bottom: outside it",
                    self.label(),
                    offset.written
                );
                notes.push(Note::LeftOut(text));
                continue;
            }
            push(block, "survey_sensor", Some(&offset));
            return Ok(());
        }
        Ok(())
    }
}

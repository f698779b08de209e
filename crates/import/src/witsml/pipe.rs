//! Properties of pipe: tool joints, weight and grade.

use wholestring::string::{Material, catalogue};
use wholestring_units::Dimension;

use super::{
    component::Component,
    measure::{Measure, Source, push, short},
};
use crate::{
    error::ImportError,
    fragment::{Block, Note, Origin, Value},
    pipe::yield_psi,
};

/// Tolerance within which diameters are those of one pipe, m.
const SAME_M: f64 = 3e-4;

/// Tolerance within which weights are equal, lb/ft.
const SAME_LB_PER_FT: f64 = 0.06;

/// Range of yield strengths of string metals, Pa, from soft aluminium to the hardest steel.
const STRENGTHS_PA: std::ops::RangeInclusive<f64> = 5e7..=3e9;

/// Beginning of the note on an implausible yield strength; only one such note is written.
const NO_STRENGTH: &str = "a tensYield such as";

impl Component<'_> {
    /// Whether the weight of drill pipe is the nominal one, which excludes tool joints.
    pub(super) fn weight(
        &self,
        [od, id]: [Option<&Measure>; 2],
        mass: Option<&Measure>,
        notes: &mut Vec<Note>,
    ) {
        let (true, Some(od), Some(mass)) = (self.is_drill_pipe(), od, mass) else { return };
        let Some(pounds) = Dimension::MassPerLength.find_unit("lb/ft") else { return };
        let is_same = |here_m: f64, other: Option<&Measure>| {
            other.is_none_or(|other| (here_m - other.si()).abs() < SAME_M)
        };
        let entries = catalogue::entries();
        let found = entries.iter().find(|entry| {
            // The weight of one pipe with tool joints is about the nominal one of the next, so that
            // a rounded weight needs the inside diameter too.
            let nominal = entry.nominal_mass_kg_per_m().unwrap_or_default();
            let is_exact = pounds.from_si((mass.si() - nominal).abs()) < SAME_LB_PER_FT;
            is_same(entry.od_m, Some(od))
                && (is_exact || id.is_some() && is_same(entry.id_m, id))
                && entry.is_nominal_mass(mass.si())
        });
        if let Some(entry) = found {
            let with_joints =
                pounds.from_si(entry.mass_per_length_kg_per_m(Material::STEEL.density_kg_per_m3));
            notes.push(Note::Checked(format!(
                "the wtPerLen of {}, {}, is the nominal weight of such pipe: with its tool joints \
                 it weighs some {with_joints:.1} lb/ft, which is the value of `mass_per_length`",
                self.label(),
                mass.written
            )));
        }
    }

    /// Tool joints: connections of a pipe that are larger than its body.
    pub(super) fn joints(
        &self,
        block: &mut Block,
        od: Option<&Measure>,
        source: &Source,
        notes: &mut Vec<Note>,
    ) -> Result<(), ImportError> {
        let (mut widest, mut torque): (Option<Measure>, Option<Measure>) = (None, None);
        for connection in self.node.all("connection") {
            let found = source.measure(connection, "od", Dimension::Diameter)?;
            widest = larger(widest, found);
            let found = source.optional(connection, "tqMakeup", Dimension::Torque, notes)?;
            torque = larger(torque, found.filter(|torque| torque.number > 0.0));
        }
        if self.is_pipe() {
            let spacing = source.measure(self.node, "lenJointAv", Dimension::Length)?;
            let spacing = spacing.filter(|spacing| spacing.number > 0.0);
            let out = widest.filter(|joint| od.is_some_and(|od| joint.si() > od.si()));
            match (out, spacing) {
                (Some(joint), Some(spacing)) => {
                    push(block, "joint_od", Some(&joint));
                    push(block, "joint_spacing", Some(&spacing));
                }
                (Some(_), None) => notes.push(Note::LeftOut(format!(
                    "the tool joints of {}: lenJointAv does not give their spacing",
                    self.label()
                ))),
                (None, _) => notes.push(Note::Assumed(format!(
                    "{} has no tool joints: no connection has an od larger than the body's; its \
                     body touches the wall",
                    self.label()
                ))),
            }
        }
        push(block, "make_up_torque", torque.as_ref());
        Ok(())
    }

    /// Yield strength from a known grade, or as the file gives it.
    pub(super) fn strength(
        &self,
        block: &mut Block,
        source: &Source,
        notes: &mut Vec<Note>,
    ) -> Result<(), ImportError> {
        self.of_grade(block, notes);
        if block.get("yield_strength").is_some() {
            return Ok(());
        }
        let strength = source.optional(self.node, "tensYield", Dimension::Stress, notes)?;
        match strength.filter(|strength| strength.number != 0.0) {
            Some(strength) if STRENGTHS_PA.contains(&strength.si()) => {
                push(block, "yield_strength", Some(&strength));
            }
            Some(strength) if !notes.iter().any(|note| note.text().starts_with(NO_STRENGTH)) => {
                let (label, written) = (self.label(), strength.written);
                notes.push(Note::LeftOut(format!(
                    "{NO_STRENGTH} {written} of {label}: no metal yields there"
                )));
            }
            _ => {}
        }
        Ok(())
    }

    /// Yield strength of drill pipe of a known grade.
    fn of_grade(&self, block: &mut Block, notes: &mut Vec<Note>) {
        let grade = self.node.child("grade").filter(|grade| !grade.text.is_empty());
        let grade = grade.filter(|_| self.is_drill_pipe());
        let (Some(grade), Some(psi)) = (grade, Dimension::Stress.find_unit("psi")) else {
            return;
        };
        match yield_psi(&grade.text) {
            Some(yield_psi) => {
                let from = format!("line {}, grade: '{}'", grade.line, short(&grade.text));
                let value = Value::quantity(yield_psi, psi);
                block.push("yield_strength", value, Origin::Derived { from });
            }
            None => notes.push(Note::LeftOut(format!(
                "the grade '{}' of {}: no grade of drill pipe or casing that is known",
                short(&grade.text),
                self.label()
            ))),
        }
    }
}

fn larger(a: Option<Measure>, b: Option<Measure>) -> Option<Measure> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if b.si() > a.si() { b } else { a }),
        (a, b) => a.or(b),
    }
}

//! Properties of pipe: tool joints, weight and grade.

use wholestring::string::{
    Material,
    catalogue::{self, TubularKind},
};
use wholestring_units::Dimension;

use super::{
    component::Component,
    measure::{Measure, Source, push, short},
};
use crate::{
    error::ImportError,
    fragment::{Block, Note, Origin, Value},
};

/// Tolerance within which outside diameters are those of one pipe, m, and weights, lb/ft.
const SAME_OD_M: f64 = 2e-4;
const SAME_LB_PER_FT: f64 = 0.06;

/// Range of yield strengths of string metals, Pa, from soft aluminium to the hardest steel.
const STRENGTHS_PA: std::ops::RangeInclusive<f64> = 5e7..=3e9;

/// Beginning of the note on an implausible yield strength; only one such note is written.
const NO_STRENGTH: &str = "a tensYield such as";

impl Component<'_> {
    /// Whether the weight of drill pipe is the nominal one, which excludes tool joints.
    pub(super) fn weight(
        &self,
        od: Option<&Measure>,
        mass: Option<&Measure>,
        notes: &mut Vec<Note>,
    ) {
        let (true, Some(od), Some(mass)) = (self.is_drill_pipe(), od, mass) else { return };
        let Some(pounds) = Dimension::MassPerLength.find_unit("lb/ft") else { return };
        let nominal = |designation: &str| -> Option<f64> {
            designation.split_once(" lb/ft")?.0.rsplit_once(' ')?.1.parse().ok()
        };
        let entries = catalogue::entries();
        let mut pipes = entries.iter().filter(|entry| entry.kind == TubularKind::DrillPipe);
        let found = pipes.find(|entry| {
            let off = |nominal: f64| (nominal - pounds.from_si(mass.si())).abs();
            (entry.od_m - od.si()).abs() < SAME_OD_M
                && nominal(&entry.designation).is_some_and(|nominal| off(nominal) < SAME_LB_PER_FT)
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

    /// Yield strength from a grade of drill pipe in the catalogue, or as the file gives it.
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
        let strength = source.optional(self.node, "tensYield", Dimension::Pressure, notes)?;
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

    /// Yield strength of drill pipe of a grade in the catalogue.
    fn of_grade(&self, block: &mut Block, notes: &mut Vec<Note>) {
        let grade = self.node.child("grade").filter(|grade| !grade.text.is_empty());
        let grade = grade.filter(|_| self.is_drill_pipe());
        let (Some(grade), Some(psi)) = (grade, Dimension::Pressure.find_unit("psi")) else {
            return;
        };
        match yield_strength_Pa(&grade.text) {
            Some(yield_Pa) => {
                let from = format!("line {}, grade: '{}'", grade.line, short(&grade.text));
                let value = Value::quantity(psi.from_si(yield_Pa).round(), psi);
                block.push("yield_strength", value, Origin::Derived { from });
            }
            None => notes.push(Note::LeftOut(format!(
                "the grade '{}' of {}: no grade of the catalogue's drill pipe",
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

/// The minimum yield strength of a grade of drill pipe: `S-135`, `G105`.
fn yield_strength_Pa(grade: &str) -> Option<f64> {
    let bare = |text: &str| -> String {
        text.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_uppercase()
    };
    let name = bare(grade);
    let entries = catalogue::entries();
    let pipes = entries.iter().filter(|entry| entry.kind == TubularKind::DrillPipe);
    let mut grades = pipes.filter_map(|entry| {
        let (_, grade) = entry.designation.rsplit_once(' ')?;
        Some((bare(grade), entry.yield_strength_Pa))
    });
    grades.find(|(grade, _)| *grade == name).map(|(_, yield_Pa)| yield_Pa)
}

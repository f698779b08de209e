//! Keys of `[[string]]` for a component.

use wholestring_case::STEEL_DENSITY_KG_PER_M3;
use wholestring_units::{Dimension, number_text};

use super::{
    component::Component,
    measure::{Measure, Source, push, short},
};
use crate::{
    error::ImportError,
    fragment::{Block, Note, Origin, Value},
    pipe::{LIGHTEST, body_mass, mass_in_range, other_unit},
};

/// Diameters that a case accepts, m.
const DIAMETERS_M: std::ops::RangeInclusive<f64> = 0.005..=2.0;

impl Component<'_> {
    /// The keys of the case.
    pub(crate) fn block(
        &self,
        hole: Option<&Measure>,
        source: &Source,
        notes: &mut Vec<Note>,
    ) -> Result<Block, ImportError> {
        let label = self.label();
        let mut block = Block { remark: self.remark(), ..Block::default() };
        let type_of = self.node.child("typeTubularComp|TypeTubularComponent");
        let origin = match type_of {
            Some(child) => {
                Origin::written(format!("line {}, {}", child.line, child.name), short(&child.text))
            }
            None => Origin::at(format!("line {}, {}", self.node.line, self.node.name)),
        };
        block.push("component", Value::text(self.name()), origin);
        let length = source.positive(self.node, "len", Dimension::Length, (&label, notes))?;
        push(&mut block, "length", length.as_ref());
        let od = self.diameter(hole, source, &label, notes)?;
        if let Some(od) = od.as_ref().filter(|od| !DIAMETERS_M.contains(&od.si())) {
            return Err(source.out_of_range(od, "od", "5 mm to 2 m (0.2 to 78 in)"));
        }
        push(&mut block, "od", od.as_ref());
        let id = source.measure(self.node, "id", Dimension::Diameter)?;
        if let Some(id) = id.as_ref().filter(|id| id.number < 0.0) {
            return Err(source.out_of_range(id, "id", "0 or more"));
        }
        if let (Some(id), Some(od)) = (&id, &od)
            && id.si() >= od.si()
        {
            let expected = format!("less than the od, {}", od.written);
            return Err(source.out_of_range(id, "id", &expected));
        }
        push(&mut block, "id", id.as_ref());
        let lacks = [
            ("len", length.is_none()),
            ("od", od.is_none()),
            ("id", id.is_none() && !self.is_bit()),
        ];
        for (name, _) in lacks.iter().filter(|(_, lacks)| *lacks) {
            notes.push(Note::LeftOut(format!(
                "the {name} of {label}, which the file does not give: write it into the case"
            )));
        }
        self.joints(&mut block, od.as_ref(), source, notes)?;
        self.blades(&mut block, od.as_ref(), length.as_ref(), source, notes)?;
        let weight = (&label[..], &mut *notes);
        let mass = source.positive(self.node, "wtPerLen", Dimension::MassPerLength, weight)?;
        if let (Some(mass), Some(od), Some(id), false) = (&mass, &od, &id, self.is_bit()) {
            let joint_m = block.get("joint_od").and_then(Value::si).unwrap_or_default();
            let diameters_m = [od.si(), id.si(), od.si().max(joint_m)];
            let shown = |kg_per_m: f64| {
                let number = (mass.unit.from_si(kg_per_m) * 10.0).round() / 10.0;
                format!("{} {}", number_text(number), mass.unit.symbol)
            };
            let hint = other_unit((mass.number, mass.unit), diameters_m, STEEL_DENSITY_KG_PER_M3);
            mass_in_range(mass.si(), diameters_m, STEEL_DENSITY_KG_PER_M3, shown)
                .map_err(|expected| source.out_of_range(mass, "wtPerLen", &(expected + &hint)))?;
            let body = body_mass(diameters_m, STEEL_DENSITY_KG_PER_M3);
            if mass.si() < LIGHTEST * body && !hint.is_empty() {
                notes.push(Note::Warning(format!(
                    "the wtPerLen of {label}, {}, is less than its body of steel weighs, {}{hint}",
                    mass.written,
                    shown(body)
                )));
            }
        }
        push(&mut block, "mass_per_length", mass.as_ref());
        self.weight([od.as_ref(), id.as_ref()], mass.as_ref(), notes);
        self.strength(&mut block, source, notes)?;
        self.bend(&mut block, length.as_ref(), source, notes)?;
        self.sensor(&mut block, length.as_ref(), source, notes)?;
        if let Some(count) = self.node.text_of("count").filter(|count| *count != "1") {
            notes.push(Note::Assumed(format!(
                "{label} has a count of {}: its len is taken as the total length",
                short(count)
            )));
        }
        Ok(block)
    }

    fn remark(&self) -> Option<String> {
        let words = ["description", "vendor", "model"].map(|name| self.node.text_of(name));
        let words: Vec<String> = words.into_iter().flatten().map(short).collect();
        (!words.is_empty()).then(|| words.join(", "))
    }

    /// Outside diameter; for a bit, the diameter of the hole that it drills.
    fn diameter(
        &self,
        hole: Option<&Measure>,
        source: &Source,
        label: &str,
        notes: &mut Vec<Note>,
    ) -> Result<Option<Measure>, ImportError> {
        let own = source.positive(self.node, "od", Dimension::Diameter, (label, notes))?;
        if !self.is_bit() {
            return Ok(own);
        }
        let record = self.node.child("bitRecord");
        let gauge = match record {
            Some(record) => {
                source.positive(record, "diaBit", Dimension::Diameter, (label, notes))?
            }
            None => None,
        };
        match (gauge, own) {
            (Some(gauge), Some(own)) => {
                if (gauge.si() - own.si()).abs() > 1e-4 {
                    let (diameter, written) = (&gauge.written, &own.written);
                    notes.push(Note::LeftOut(format!(
                        "the od of {label}, {written}: its diaBit is {diameter}, which fills the \
                         hole"
                    )));
                }
                Ok(Some(gauge))
            }
            (None, None) => {
                let Some(hole) = hole else { return Ok(None) };
                let because = format!("diaHoleAssy of the tubular, line {}", hole.line);
                notes.push(Note::Assumed(format!(
                    "{label} has no diameter: the diameter of the hole is used,  {}",
                    hole.written
                )));
                Ok(Some(Measure { origin: Origin::Assumed { because }, ..hole.clone() }))
            }
            (gauge, own) => Ok(gauge.or(own)),
        }
    }
}

//! A component of a tubular: the keys of `[[string]]`.

use wholestring::string::{
    Material,
    catalogue::{self, TubularKind},
};
use wholestring_units::Dimension;

use super::{
    measure::{Measure, Source, metres, short},
    tree::Node,
};
use crate::{
    error::{ImportError, ImportErrorKind},
    fragment::{Block, Note, Origin, Value},
};

/// A blade's middle this far from its component's is where the case has it, m.
const SAME_PLACE_M: f64 = 0.1;

/// Outside diameters this close are those of one pipe, m; weights, lb/ft.
const SAME_OD_M: f64 = 2e-4;
const SAME_LB_PER_FT: f64 = 0.06;

/// Words of what measures the direction of the hole, in `typeMeasurement` or `comments`.
const DIRECTIONAL: &[&str] = &["deviation", "azimuth", "inclination", "direction", "survey", "d&i"];

/// WITSML puts the noun first.
const TURNED: &[(&str, &str)] =
    &[("sub-", "sub"), ("stabilizer ", "stabilizer"), ("motor ", "motor"), ("mill ", "mill")];

/// A component as it stands in its tubular.
pub(crate) struct Component<'a> {
    pub(crate) node: &'a Node,
    pub(crate) sequence: Option<i64>,
    /// `typeTubularComp`, in small letters.
    kind: String,
}

impl<'a> Component<'a> {
    pub(crate) fn of(node: &'a Node, source: &Source) -> Result<Self, ImportError> {
        let sequence = match node.child("sequence") {
            Some(of) => source.number_of(of, "sequence")?.map(|number| (number, of.line)),
            None => None,
        };
        if let Some((number, line)) = sequence.filter(|(number, _)| number.fract() != 0.0) {
            let (what, found) = ("sequence".to_owned(), number.to_string());
            return Err(source.error(line, ImportErrorKind::NotANumber { what, found }));
        }
        let kind = node.text_of("typeTubularComp|TypeTubularComponent").unwrap_or_default();
        let sequence = sequence.map(|(number, _)| number as i64);
        Ok(Self { node, sequence, kind: short(&kind.to_lowercase()) })
    }

    /// Whether it is the bit, not what opens the hole above one.
    pub(crate) fn is_bit(&self) -> bool {
        let opens = ["bit hole opener", "bit under reamer"].contains(&self.kind.as_str());
        let named = self.kind == "bit" || self.kind.starts_with("bit ") && !opens;
        let unnamed = ["", "other", "unknown"].contains(&self.kind.as_str());
        named || unnamed && self.node.child("bitRecord").is_some()
    }

    /// Whether it is made of joints.
    pub(crate) fn is_pipe(&self) -> bool {
        ["drill pipe", "tubing", "casing", "liner"].iter().any(|word| self.kind.contains(word))
    }

    fn is_drill_pipe(&self) -> bool {
        self.kind.contains("drill pipe") && !self.kind.contains("heavy")
    }

    /// What the case calls it: the field's words for those of WITSML.
    pub(crate) fn name(&self) -> String {
        let kind = self.kind.strip_suffix(" lh").unwrap_or(&self.kind);
        if self.is_bit() {
            return match kind.strip_prefix("bit ") {
                Some(rest) => format!("{} bit", rest.replace("pdc", "PDC")),
                None => "bit".to_owned(),
            };
        }
        match kind {
            "bit hole opener" => "hole opener".to_owned(),
            "bit under reamer" => "under-reamer".to_owned(),
            "heavy weight drill pipe" => "heavy-weight drill pipe".to_owned(),
            "logging while drilling tool" => "LWD tool".to_owned(),
            "rotary steering tool" => "rotary steerable".to_owned(),
            "" | "other" | "unknown" => match self.node.text_of("description") {
                Some(description) => short(description),
                None => "component".to_owned(),
            },
            _ => {
                let turned = TURNED.iter().find_map(|(first, noun)| {
                    Some(format!("{} {noun}", kind.strip_prefix(first)?))
                });
                turned.unwrap_or_else(|| kind.replace("mwd", "MWD"))
            }
        }
    }

    /// In messages: `component 3 (stabilizer)`.
    pub(crate) fn label(&self) -> String {
        match self.sequence {
            Some(sequence) => format!("component {sequence} ({})", self.name()),
            None => format!("the {} in line {}", self.name(), self.node.line),
        }
    }

    /// Its length, m, if it has one.
    pub(crate) fn length(&self, source: &Source) -> Result<Option<Measure>, ImportError> {
        source.measure(self.node, "len", Dimension::Length)
    }

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
            Some(of) => Origin::written(format!("line {}, {}", of.line, of.name), short(&of.text)),
            None => Origin::at(format!("line {}, {}", self.node.line, self.node.name)),
        };
        block.push("component", Value::text(self.name()), origin);
        let length = source.positive(self.node, "len", Dimension::Length, (&label, notes))?;
        push(&mut block, "length", length.as_ref());
        let od = self.diameter(hole, source, &label, notes)?;
        push(&mut block, "od", od.as_ref());
        let id = source.measure(self.node, "id", Dimension::Diameter)?;
        if let Some(id) = id.as_ref().filter(|id| id.number < 0.0) {
            return Err(source.out_of_range(id, "id", "0 or more"));
        }
        push(&mut block, "id", id.as_ref());
        let lacks = [
            ("len", length.is_none()),
            ("od", od.is_none()),
            ("id", id.is_none() && !self.is_bit()),
        ];
        for (name, _) in lacks.iter().filter(|(_, lacks)| *lacks) {
            notes.push(Note::LeftOut(format!(
                "the {name} of {label}, which the file does not tell: write it into the case"
            )));
        }
        self.joints(&mut block, od.as_ref(), source, notes)?;
        self.blades(&mut block, od.as_ref(), length.as_ref(), source, notes)?;
        let weight = (&label[..], &mut *notes);
        let mass = source.positive(self.node, "wtPerLen", Dimension::MassPerLength, weight)?;
        push(&mut block, "mass_per_length", mass.as_ref());
        self.weight(od.as_ref(), mass.as_ref(), notes);
        self.strength(&mut block, notes);
        self.bend(&mut block, length.as_ref(), source, notes)?;
        self.sensor(&mut block, length.as_ref(), source, notes)?;
        if let Some(count) = self.node.text_of("count").filter(|count| *count != "1") {
            notes.push(Note::Assumed(format!(
                "{label} has a count of {}: len is that of all of them",
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

    /// Its outside diameter: of a bit that of the hole that it drills.
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
                        "the od of {label}, {written}: its diaBit is {diameter}, which is what \
                         fills the hole"
                    )));
                }
                Ok(Some(gauge))
            }
            (None, None) => {
                let Some(hole) = hole else { return Ok(None) };
                let because = format!("diaHoleAssy of the tubular, line {}", hole.line);
                notes.push(Note::Assumed(format!(
                    "{label} has no diameter: that of the hole, {}",
                    hole.written
                )));
                Ok(Some(Measure { origin: Origin::Assumed { because }, ..hole.clone() }))
            }
            (gauge, own) => Ok(gauge.or(own)),
        }
    }

    /// Whether the weight of drill pipe is the nominal one, which leaves tool joints out.
    fn weight(&self, od: Option<&Measure>, mass: Option<&Measure>, notes: &mut Vec<Note>) {
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
                 it weighs some {with_joints:.1} lb/ft, which is what `mass_per_length` means",
                self.label(),
                mass.written
            )));
        }
    }

    /// Tool joints: the connections of a pipe that stand out over it.
    fn joints(
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
                    "the tool joints of {}: lenJointAv does not say how far apart they are",
                    self.label()
                ))),
                (None, _) => notes.push(Note::Assumed(format!(
                    "{} has no tool joints: no connection with an od larger than the body's is \
                     told; its body touches the wall",
                    self.label()
                ))),
            }
        }
        push(block, "make_up_torque", torque.as_ref());
        Ok(())
    }

    /// Blades of a stabiliser, or cutters of a hole opener.
    fn blades(
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

    /// The yield strength of drill pipe of a grade that the catalogue has.
    fn strength(&self, block: &mut Block, notes: &mut Vec<Note>) {
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

    /// The bend of a housing or a sub.
    fn bend(
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
                "the bend of {label}: it can be set up to {}, but not how it is set is told; write \
                 `bend` and `bend_at` into the case",
                short(most)
            )));
        }
        Ok(())
    }

    /// The directional sensor of an MWD.
    fn sensor(
        &self,
        block: &mut Block,
        length: Option<&Measure>,
        source: &Source,
        notes: &mut Vec<Note>,
    ) -> Result<(), ImportError> {
        let tools = self.node.all("mwdTool|rotarySteerableTool|motor");
        for sensor in tools.flat_map(|tool| tool.all("sensor")) {
            let words = ["typeMeasurement", "comments"].map(|name| sensor.text_of(name));
            let words = words.into_iter().flatten().map(str::to_lowercase);
            let is = |text: String| DIRECTIONAL.iter().any(|word| text.contains(word));
            if !words.into_iter().any(is) {
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

fn push(block: &mut Block, key: &'static str, measure: Option<&Measure>) {
    if let Some(measure) = measure {
        block.push(key, measure.value(), measure.origin.clone());
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
    let wanted = bare(grade);
    let entries = catalogue::entries();
    let pipes = entries.iter().filter(|entry| entry.kind == TubularKind::DrillPipe);
    let mut grades = pipes.filter_map(|entry| {
        let (_, grade) = entry.designation.rsplit_once(' ')?;
        Some((bare(grade), entry.yield_strength_Pa))
    });
    grades.find(|(grade, _)| *grade == wanted).map(|(_, yield_Pa)| yield_Pa)
}

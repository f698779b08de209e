//! What came out of a sweep against what was varied.

use wholestring::outcome::Method;

use super::{DRAWN, Drawn, Sweep, SweepRow};
use crate::{
    Level, Plot,
    figure::{
        Axis, Direction, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Scale, Shape, Stroke,
    },
    plots::{Shown, models, readable, subtitle},
};

/// The axis of what was varied.
enum Varied {
    /// The depth of the bit, down the page, as engineers draw it.
    Depth,
    /// Another key whose values are numbers of one unit.
    Number { key: usize, unit: String },
    /// A key whose values are words.
    Words { key: usize },
}

/// Every picture of a sweep, in a set of units (`si`, `metric` or `field`): all quantities in one,
/// then each in one of its own; those with nothing to show are left out.
pub fn sweep_plots(sweep: &Sweep, units: &str) -> Vec<Plot> {
    let shown = Shown::new(&sweep.dimensions, units);
    let drawing = Drawing::new(sweep, shown);
    let panels: Vec<(&Drawn, Panel)> =
        DRAWN.iter().filter_map(|of| Some((of, drawing.panel(of)?))).collect();
    if panels.is_empty() {
        return Vec::new();
    }
    let all = Plot { name: "sweep".into(), figure: drawing.figure(&panels, 2, 180.0) };
    let single = panels.iter().map(|panel| Plot {
        name: panel.0.name.into(),
        figure: drawing.figure(std::slice::from_ref(panel), 1, 85.0),
    });
    std::iter::once(all).chain(single).collect()
}

/// A sweep on its way to paper.
struct Drawing<'a> {
    sweep: &'a Sweep,
    shown: Shown<'a>,
    varied: Varied,
    /// The other keys that have several values.
    others: Vec<usize>,
    /// The combinations of their values, in order: each has a colour.
    families: Vec<Vec<&'a str>>,
    operations: Vec<&'a str>,
    /// The models that solved them, the most detailed first.
    models: Vec<&'static Method>,
}

impl<'a> Drawing<'a> {
    fn new(sweep: &'a Sweep, shown: Shown<'a>) -> Self {
        let varied = Varied::of(sweep);
        let along = varied.key(sweep);
        let others: Vec<usize> = (0..sweep.keys.len())
            .filter(|key| Some(*key) != along && sweep.values(*key).len() > 1)
            .collect();
        let mut families: Vec<Vec<&str>> = Vec::new();
        let mut operations: Vec<&str> = Vec::new();
        for row in sweep.rows.iter().filter(|row| !row.model.is_empty()) {
            let family: Vec<&str> = others.iter().map(|key| row.values[*key].as_str()).collect();
            if !families.contains(&family) {
                families.push(family);
            }
            if !operations.contains(&row.operation.as_str()) {
                operations.push(&row.operation);
            }
        }
        let has = |model: &str| sweep.rows.iter().any(|row| row.model == model);
        Self { sweep, shown, varied, others, families, operations, models: models(has) }
    }

    /// The place of a case on the axis of what was varied; not a number where it has none.
    fn along(&self, row: &SweepRow) -> f64 {
        match &self.varied {
            Varied::Depth => {
                let depth = row.numbers.get("bit_depth_m").copied();
                self.shown.value(depth.unwrap_or(f64::NAN), "length")
            }
            Varied::Number { key, .. } => {
                split(&row.values[*key]).map_or(f64::NAN, |(value, _)| value)
            }
            Varied::Words { key } => {
                let values = self.sweep.values(*key);
                let place = values.iter().position(|value| *value == row.values[*key]);
                place.map_or(f64::NAN, |place| place as f64)
            }
        }
    }

    fn axis(&self) -> Axis {
        match &self.varied {
            Varied::Depth => Axis {
                down: true,
                ..Axis::new(self.shown.label("Bit depth", "length"), Range::Zero)
            },
            Varied::Number { key, unit } => {
                let name = name(&self.sweep.keys[*key]);
                let unit = match unit.as_str() {
                    "" if self.sweep.keys[*key].ends_with("rpm") => "rev/min",
                    unit => unit,
                };
                let label = if unit.is_empty() { name } else { format!("{name}, {unit}") };
                Axis::new(label, Range::Near)
            }
            Varied::Words { key } => Axis {
                scale: Scale::Words(
                    self.sweep.values(*key).into_iter().map(String::from).collect(),
                ),
                ..Axis::new(name(&self.sweep.keys[*key]), Range::Tight)
            },
        }
    }

    /// Colour by what was varied, and by the operation where that is all that differs; shape by the
    /// operation. Strokes distinguish the models where there are two, else the operations.
    fn style(&self, family: usize, operation: usize) -> (Ink, Shape) {
        let ink = if self.families.len() > 1 { family } else { operation };
        (Ink::Line(ink), Shape::of(operation))
    }

    fn stroke(&self, family: usize, model: usize, operation: usize) -> Stroke {
        match (self.models.len() > 1, self.operations.len() > 1) {
            (true, _) => Stroke::of(model),
            (false, true) => Stroke::of(operation),
            (false, false) => of_family(family),
        }
    }

    /// Places in the legend of what a curve is of: its family, model and operation.
    fn keys_of(&self, family: usize, model: usize, operation: usize) -> Vec<usize> {
        let families = self.count(self.families.len());
        let models = self.count(self.models.len());
        let bands = usize::from(self.has_bands());
        let mut keys = Vec::new();
        keys.extend((families > 0).then_some(family));
        keys.extend((models > 0).then_some(families + model));
        let many = self.count(self.operations.len()) > 0;
        keys.extend(many.then_some(families + models + bands + operation));
        keys
    }

    /// As many keys as there are things to tell apart; none of one alone.
    fn count(&self, things: usize) -> usize {
        if things > 1 { things } else { 0 }
    }

    fn has_bands(&self) -> bool {
        self.models.iter().any(|of| of.in_time)
    }

    /// What a curve is called at its end: what it is of, as far as that differs, without the model,
    /// which its stroke shows.
    fn name(&self, family: usize, operation: usize) -> String {
        let mut parts = Vec::new();
        if self.families.len() > 1 {
            parts.push(self.families[family].join(", "));
        }
        if self.operations.len() > 1 {
            parts.push(readable(self.operations[operation]));
        }
        parts.join(", ")
    }

    fn panel(&self, of: &Drawn) -> Option<Panel> {
        let dimension = of.dimension();
        let value = |row: &SweepRow, end: &str| {
            let value = row.numbers.get(&format!("{}{end}", of.scalar.quantity.name)).copied();
            self.shown.value(value.unwrap_or(f64::NAN), dimension)
        };
        let (mut bands, mut curves, mut points) = (Vec::new(), Vec::new(), Vec::new());
        let mut names = Vec::new();
        for (place, family) in self.families.iter().enumerate() {
            let solved = self.operations.iter().enumerate();
            let solved = solved.flat_map(|of| {
                let models = self.models.iter().enumerate();
                models.map(move |model| (of, model))
            });
            for ((done, operation), (model, method)) in solved {
                let (ink, shape) = self.style(place, done);
                let mine = |row: &SweepRow| {
                    let values = self.others.iter().map(|key| row.values[*key].as_str());
                    row.model == method.name
                        && row.operation == *operation
                        && values.eq(family.iter().copied())
                };
                let mut rows: Vec<(f64, usize, &SweepRow)> = self
                    .sweep
                    .rows
                    .iter()
                    .enumerate()
                    .filter(|(_, row)| mine(row))
                    .map(|(place, row)| (self.along(row), place, row))
                    .collect();
                rows.sort_by(|a, b| a.0.total_cmp(&b.0));
                let column = |end: &str| -> Vec<(f64, f64)> {
                    rows.iter().map(|(at, _, row)| (*at, value(row, end))).collect()
                };
                let mean = column("");
                if !mean.iter().any(|(_, value)| value.is_finite()) {
                    continue;
                }
                let keys = self.keys_of(place, model, done);
                for marks in [&mut bands, &mut curves, &mut points] {
                    marks.push(Mark::Of { keys: keys.clone() });
                }
                let name = self.name(place, done);
                let last = mean.iter().rev().find(|(at, value)| (at + value).is_finite());
                // Where two models are one beside the other, one name is enough.
                if let (Some(end), false) = (last, name.is_empty() || names.contains(&name)) {
                    curves.push(Mark::Name { at: *end, text: name.clone() });
                    names.push(name);
                }
                let mut of_band = keys;
                of_band.push(self.band_key());
                bands.push(Mark::Of { keys: of_band });
                let ends = column("_p05").into_iter().zip(column("_p95"));
                bands.push(Mark::Band {
                    ink,
                    points: ends.map(|((at, low), (_, high))| (at, low, high)).collect(),
                });
                points.push(Mark::Points { ink, shape, points: mean.clone() });
                points.push(Mark::Spots {
                    points: mean.clone(),
                    rows: rows.iter().map(|(_, place, _)| *place).collect(),
                });
                for (key, level) in self.judged().into_iter().enumerate() {
                    let of_level = rows.iter().zip(&mean);
                    let of_level = of_level.filter(|((.., row), _)| judged(row) == Some(level));
                    let ringed: Vec<_> = of_level.map(|(_, point)| *point).collect();
                    if !ringed.is_empty() {
                        let mut of_ring = self.keys_of(place, model, done);
                        of_ring.push(self.first_judged() + key);
                        points.push(Mark::Of { keys: of_ring });
                        points.push(Mark::Rings { level, points: ringed });
                    }
                }
                curves.push(Mark::Curve {
                    ink,
                    stroke: self.stroke(place, model, done),
                    points: mean,
                });
            }
        }
        (!curves.is_empty()).then(|| Panel {
            axis: Axis {
                // Depth points down wherever an axis can.
                down: dimension == "length",
                min_span: self.shown.value(of.min_span, dimension),
                ..Axis::new(self.shown.label(of.scalar.label, dimension), Range::Near)
            },
            marks: [bands, curves, points].concat(),
            keys: Vec::new(),
        })
    }

    /// The levels that cases have, the gravest first: a ring of the gravest is about each point.
    fn judged(&self) -> Vec<Level> {
        let levels = [Level::Error, Level::Warning].into_iter();
        levels
            .filter(|level| self.sweep.rows.iter().any(|row| judged(row) == Some(*level)))
            .collect()
    }

    /// Place of the first key of a ring in the legend: after all others.
    fn first_judged(&self) -> usize {
        self.band_key() + usize::from(self.has_bands()) + self.count(self.operations.len())
    }

    /// Place of the bands' key in the legend.
    fn band_key(&self) -> usize {
        self.count(self.families.len()) + self.count(self.models.len())
    }

    fn keys(&self) -> Vec<Key> {
        let mut keys: Vec<Key> = Vec::new();
        if self.families.len() > 1 {
            keys.extend(self.families.iter().enumerate().map(|(place, family)| {
                let values = self.others.iter().zip(family);
                let values =
                    values.map(|(key, value)| format!("{} {value}", short(&self.sweep.keys[*key])));
                Key {
                    name: values.collect::<Vec<_>>().join(", "),
                    sample: Sample::Line(
                        Ink::Line(place),
                        match self.models.len() > 1 || self.operations.len() > 1 {
                            true => Stroke::Solid,
                            false => of_family(place),
                        },
                    ),
                }
            }));
        }
        if self.models.len() > 1 {
            for (place, of) in self.models.iter().enumerate() {
                keys.push(Key {
                    name: of.curve_name.into(),
                    sample: Sample::Line(Ink::Note, Stroke::of(place)),
                });
            }
        }
        if self.has_bands() {
            keys.push(Key { name: "5–95 % of the time".into(), sample: Sample::Band(Ink::Note) });
        }
        if self.operations.len() > 1 {
            keys.extend(self.operations.iter().enumerate().map(|(place, operation)| {
                let (ink, shape) = self.style(0, place);
                let ink = if self.families.len() > 1 { Ink::Note } else { ink };
                Key {
                    name: readable(operation),
                    sample: if self.models.len() > 1 {
                        Sample::Point(ink, shape)
                    } else {
                        Sample::Marked(ink, Stroke::of(place), shape)
                    },
                }
            }));
        }
        keys.extend(self.judged().into_iter().map(|level| {
            Key {
                name: match level {
                    Level::Error => "with errors",
                    _ => "with warnings",
                }
                .into(),
                sample: Sample::Ring(level),
            }
        }));
        keys
    }

    fn figure(&self, panels: &[(&Drawn, Panel)], columns: usize, width_mm: f64) -> Figure {
        let down = matches!(self.varied, Varied::Depth);
        let subtitle_text = subtitle(&self.sweep.facts, self.shown);
        Figure {
            title: self.sweep.title.clone(),
            subtitle: subtitle_text,
            keys: self.keys(),
            layout: Layout {
                direction: if down { Direction::Down } else { Direction::Across },
                columns,
                width_mm,
                panel_mm: if down { 85.0 } else { 55.0 },
            },
            shared: self.axis(),
            panels: panels.iter().map(|(_, panel)| panel.clone()).collect(),
            hole: Vec::new(),
        }
    }
}

/// Where there are more families than colours, those that share one have other strokes.
fn of_family(place: usize) -> Stroke {
    Stroke::of(place / Ink::LINES)
}

/// The level of the gravest finding of a row that is marked.
fn judged(row: &SweepRow) -> Option<Level> {
    if row.errors > 0 { Some(Level::Error) } else { (row.warnings > 0).then_some(Level::Warning) }
}

impl Varied {
    /// The depth of the bit if it varies; else the key with the most values, numbers before words.
    fn of(sweep: &Sweep) -> Self {
        let many = |key: &usize| sweep.values(*key).len();
        let keys = || 0..sweep.keys.len();
        if keys().any(|key| short(&sweep.keys[key]) == "bit depth" && many(&key) > 1) {
            return Self::Depth;
        }
        let unit = |key: usize| {
            let values = sweep.values(key);
            let mut units = values.iter().map(|value| Some(split(value)?.1));
            let first = units.next().flatten()?;
            units.all(|unit| unit == Some(first)).then(|| first.to_owned())
        };
        let numbers = keys().filter(|key| many(key) > 1);
        let numbers = numbers.filter_map(|key| Some((key, unit(key)?)));
        if let Some((key, unit)) = numbers.max_by_key(|(key, _)| many(key)) {
            return Self::Number { key, unit };
        }
        let key = keys().max_by_key(many).unwrap_or(0);
        Self::Words { key }
    }

    fn key(&self, sweep: &Sweep) -> Option<usize> {
        match self {
            Self::Depth => {
                let mut keys = sweep.keys.iter();
                keys.position(|key| short(key) == "bit depth")
            }
            Self::Number { key, .. } | Self::Words { key } => Some(*key),
        }
    }
}

/// A value as a number and its unit; nothing where it is none.
pub(super) fn split(value: &str) -> Option<(f64, &str)> {
    let value = value.trim();
    let is_number = |letter: char| letter.is_ascii_digit() || "+-.".contains(letter);
    let end = value.find(|letter| !is_number(letter)).unwrap_or(value.len());
    // An exponent belongs to the number where the whole is one.
    if let Ok(number) = value.parse::<f64>() {
        return number.is_finite().then_some((number, ""));
    }
    let number = value[..end].parse().ok()?;
    Some((number, value[end..].trim()))
}

/// The last part of a key, as people say it: `operation.bit_depth` is the bit depth.
fn short(key: &str) -> String {
    let last = key.rsplit('.').next().unwrap_or(key);
    match last {
        "rpm" => "rotary speed".into(),
        "wob" => "weight on bit".into(),
        other => other.replace('_', " "),
    }
}

/// It with a capital.
fn name(key: &str) -> String {
    let short = short(key);
    let mut letters = short.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

//! Data of a sweep's figures: the axis, and the distinction of curves.

use wholestring::{operation::OperationKind, outcome::Method};

use super::{
    DRAWN, Drawn, Sweep, SweepRow,
    varied::{Varied, name, split},
};
use crate::{
    Plot, Severity,
    draw::palette::operation_colour,
    figure::{Axis, Direction, Figure, Ink, Layout, Panel, Range, Scale, Shape, Stroke},
    plots::{DisplayUnits, models, subtitle},
};

/// Drawing of a sweep's figures.
pub(super) struct Drawing<'a> {
    pub(super) sweep: &'a Sweep,
    pub(super) display: DisplayUnits<'a>,
    pub(super) varied: Varied,
    /// The other keys that have several values.
    pub(super) others: Vec<usize>,
    /// The combinations of their values, in order: each has a colour.
    pub(super) families: Vec<Vec<&'a str>>,
    pub(super) operations: Vec<OperationKind>,
    /// The models that solved them, the most detailed first.
    pub(super) models: Vec<&'static Method>,
}

impl<'a> Drawing<'a> {
    pub(super) fn new(sweep: &'a Sweep, display: DisplayUnits<'a>) -> Self {
        let varied = Varied::of(sweep);
        let along = varied.key(sweep);
        let others: Vec<usize> = (0..sweep.keys.len())
            .filter(|key| Some(*key) != along && sweep.values(*key).len() > 1)
            .collect();
        let mut families: Vec<Vec<&str>> = Vec::new();
        let mut operations: Vec<OperationKind> = Vec::new();
        for row in sweep.rows.iter().filter(|row| row.model.is_some()) {
            let family: Vec<&str> = others.iter().map(|key| row.values[*key].as_str()).collect();
            if !families.contains(&family) {
                families.push(family);
            }
            operations.extend(row.operation.filter(|operation| !operations.contains(operation)));
        }
        let has = |model| sweep.rows.iter().any(|row| row.model == Some(model));
        Self { sweep, display, varied, others, families, operations, models: models(has) }
    }

    /// The place of a case on the axis of the varied key; not a number where it has none.
    pub(super) fn along(&self, row: &SweepRow) -> f64 {
        match &self.varied {
            Varied::Depth => {
                let depth = row.numbers.get("bit_depth_m").copied();
                self.display.value(depth.unwrap_or(f64::NAN), "length")
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

    pub(super) fn axis(&self) -> Axis {
        match &self.varied {
            Varied::Depth => Axis {
                down: true,
                ..Axis::new(self.display.label("Bit depth", "length"), Range::Zero)
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

    /// Colour by the other varied keys, and by the operation where nothing else differs; shape by
    /// the operation. Strokes distinguish the models where there are two, else the operations.
    pub(super) fn style(&self, family: usize, operation: usize) -> (Ink, Shape) {
        let colour = match self.operations.get(operation) {
            Some(kind) if self.families.len() < 2 => operation_colour(*kind),
            _ => family,
        };
        (Ink::Line(colour), Shape::of(operation))
    }

    pub(super) fn stroke(&self, family: usize, model: usize, operation: usize) -> Stroke {
        match (self.models.len() > 1, self.operations.len() > 1) {
            (true, _) => Stroke::of(model),
            (false, true) => Stroke::of(operation),
            (false, false) => of_family(family),
        }
    }

    /// Number of things to distinguish; none for one alone.
    pub(super) fn count(&self, things: usize) -> usize {
        if things > 1 { things } else { 0 }
    }

    pub(super) fn has_bands(&self) -> bool {
        self.models.iter().any(|model| model.in_time)
    }

    /// Name of a curve at its end, as far as it differs from the others, without the model, which
    /// its stroke shows.
    pub(super) fn name(&self, family: usize, operation: usize) -> String {
        let mut parts = Vec::new();
        if self.families.len() > 1 {
            parts.push(self.families[family].join(", "));
        }
        if self.operations.len() > 1 {
            parts.push(self.operations[operation].words().to_owned());
        }
        parts.join(", ")
    }
}

/// Stroke of a family: where there are more than colours, those that share one differ in it.
pub(super) fn of_family(place: usize) -> Stroke {
    Stroke::of(place / Ink::LINES)
}

/// The level of the most severe finding of a row that is marked.
pub(super) fn judged(row: &SweepRow) -> Option<Severity> {
    if row.errors > 0 {
        Some(Severity::Error)
    } else {
        (row.warnings > 0).then_some(Severity::Warning)
    }
}

// Results of a sweep against the varied key.

/// Returns every picture of a sweep, in a set of units (`si`, `metric` or `field`): all quantities
/// in one, then each in one of its own; empty ones are left out.
pub fn sweep_plots(sweep: &Sweep, units: &str) -> Vec<Plot> {
    let display = DisplayUnits::new(&sweep.head.dimensions, units);
    let drawing = Drawing::new(sweep, display);
    let panels: Vec<(&Drawn, Panel)> =
        DRAWN.iter().filter_map(|plot| Some((plot, drawing.panel(plot)?))).collect();
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

impl Drawing<'_> {
    fn figure(&self, panels: &[(&Drawn, Panel)], columns: usize, width_mm: f64) -> Figure {
        let down = matches!(self.varied, Varied::Depth);
        let subtitle_text = subtitle(&self.sweep.head.facts, self.display);
        Figure {
            title: self.sweep.head.title.clone(),
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

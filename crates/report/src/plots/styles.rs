//! Colour, stroke and name of each curve.

use wholestring::{
    operation::OperationKind,
    outcome::{Method, ModelKind},
};

use super::run::Run;
use crate::{
    Solved,
    draw::palette::operation_colour,
    figure::{Ink, Key, Sample, Stroke},
};

/// Styles of the curves of some operations of one or two runs.
///
/// For one run, operations differ by colour, for two runs the runs do; by stroke too where one
/// model solved them. Where two did, models differ by stroke, and by colour too where nothing else
/// does.
pub(super) struct CurveStyles<'a> {
    runs: &'a [Run<'a>],
    operations: &'a [OperationKind],
    /// The models that solved them, the most detailed first.
    models: Vec<&'static Method>,
}

impl<'a> CurveStyles<'a> {
    pub(super) fn new(runs: &'a [Run<'a>], operations: &'a [OperationKind]) -> Self {
        let has = |model: ModelKind| {
            runs.iter()
                .flat_map(|run| &run.report.solved)
                .any(|solved| solved.model == model && operations.contains(&solved.operation))
        };
        Self { runs, operations, models: models(has) }
    }

    /// The place of a model among those that solved.
    fn place(&self, solved: &Solved) -> usize {
        let mut models = self.models.iter();
        models.position(|model| model.name == solved.model.name()).unwrap_or(0)
    }

    /// The solutions of these operations, with the place of its run.
    pub(super) fn solved(&self) -> impl Iterator<Item = (usize, &'a Solved)> {
        let runs = self.runs.iter().enumerate();
        runs.flat_map(|(place, run)| run.report.solved.iter().map(move |solved| (place, solved)))
            .filter(|(_, solved)| self.operations.contains(&solved.operation))
    }

    /// Whether nothing but the model distinguishes curves.
    pub(super) fn alone(&self) -> bool {
        self.runs.len() == 1 && self.operations.len() == 1
    }

    pub(super) fn of(&self, run: usize, solved: &Solved) -> (Ink, Stroke) {
        let place = self.place(solved);
        if self.models.len() > 1 && self.alone() {
            return (Ink::Line(place), Stroke::of(place));
        }
        let (colour, index) = match self.runs.len() > 1 {
            true => (run, run),
            false => {
                let mut operations = self.operations.iter();
                let index = operations.position(|name| *name == solved.operation).unwrap_or(0);
                (operation_colour(solved.operation), index)
            }
        };
        (Ink::Line(colour), Stroke::of(if self.models.len() > 1 { place } else { index }))
    }

    /// The curve whose sides are filled: that of the only operation, of the better model.
    pub(super) fn is_first(&self, solved: &Solved) -> bool {
        self.alone() && self.place(solved) == 0
    }

    /// Name of a curve: a run of two, an operation of several; `None` where there is one alone.
    pub(super) fn whose(&self, run: usize, solved: &Solved) -> Option<String> {
        if self.runs.len() > 1 {
            Some(self.runs[run].name.to_owned())
        } else {
            (!self.alone()).then(|| solved.operation.words().to_owned())
        }
    }

    /// Keys of colours and strokes; none where there is one curve alone.
    pub(super) fn keys(&self) -> Vec<Key> {
        let line =
            |name: &str, ink, stroke| Key { name: name.into(), sample: Sample::Line(ink, stroke) };
        let models = self.models.iter().enumerate();
        let several = self.models.len() > 1;
        let models = models.filter(|_| several);
        if self.alone() {
            return models
                .map(|(place, model)| line(model.curve_name, Ink::Line(place), Stroke::of(place)))
                .collect();
        }
        let names: Vec<(&str, usize)> = if self.runs.len() > 1 {
            self.runs.iter().enumerate().map(|(place, run)| (run.name, place)).collect()
        } else {
            self.operations.iter().map(|&kind| (kind.words(), operation_colour(kind))).collect()
        };
        let mut keys: Vec<Key> = names
            .into_iter()
            .enumerate()
            .map(|(index, (name, colour))| {
                let stroke = if several { Stroke::Solid } else { Stroke::of(index) };
                line(name, Ink::Line(colour), stroke)
            })
            .collect();
        keys.extend(
            models.map(|(place, model)| line(model.curve_name, Ink::Note, Stroke::of(place))),
        );
        keys
    }

    /// Colour of the curve of the only operation, of the most detailed model.
    fn first_ink(&self) -> Ink {
        match self.operations {
            [operation] if self.models.len() < 2 => Ink::Line(operation_colour(*operation)),
            _ => Ink::Line(0),
        }
    }

    /// Key of a dotted curve: the least value from one tool joint to the next.
    pub(super) fn between_key(&self) -> Key {
        let ink = if self.alone() { self.first_ink() } else { Ink::Note };
        Key { name: "between the joints".into(), sample: Sample::Line(ink, Stroke::Dotted) }
    }

    /// Key of a band.
    pub(super) fn band_key(&self) -> Key {
        Key {
            name: "5–95 % of the time".into(),
            sample: Sample::Band(if self.alone() { self.first_ink() } else { Ink::Note }),
        }
    }
}

/// The methods that exist by name, the most detailed first.
pub(crate) fn models(has: impl Fn(ModelKind) -> bool) -> Vec<&'static Method> {
    let all = ModelKind::ALL.iter().rev().copied();
    all.filter(|kind| has(*kind)).map(ModelKind::method).collect()
}

//! The legend of a sweep's figures.

use super::{
    drawing::{Drawing, judged, of_family},
    varied::short,
};
use crate::{
    Severity,
    figure::{Ink, Key, Sample, Stroke},
};

impl Drawing<'_> {
    /// Places of a curve's keys in the legend: its family, model and operation.
    pub(super) fn keys_of(&self, family: usize, model: usize, operation: usize) -> Vec<usize> {
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

    /// The levels of cases, the most severe first: each point has a ring of its most severe level.
    pub(super) fn judged(&self) -> Vec<Severity> {
        let levels = [Severity::Error, Severity::Warning].into_iter();
        levels
            .filter(|level| self.sweep.rows.iter().any(|row| judged(row) == Some(*level)))
            .collect()
    }

    /// Place of the first key of a ring in the legend: after all others.
    pub(super) fn first_judged(&self) -> usize {
        self.band_key() + usize::from(self.has_bands()) + self.count(self.operations.len())
    }

    /// Place of the bands' key in the legend.
    pub(super) fn band_key(&self) -> usize {
        self.count(self.families.len()) + self.count(self.models.len())
    }

    pub(super) fn keys(&self) -> Vec<Key> {
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
            for (place, model) in self.models.iter().enumerate() {
                keys.push(Key {
                    name: model.curve_name.into(),
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
                    name: operation.words().to_owned(),
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
                    Severity::Error => "with errors",
                    _ => "with warnings",
                }
                .into(),
                sample: Sample::Ring(level),
            }
        }));
        keys
    }
}

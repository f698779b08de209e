//! What pictures that are drawn elsewhere share with those drawn here: colours, strokes, and what
//! is drawn of a run.

use std::collections::BTreeMap;

use serde::Serialize;
use wholestring::operation::OperationKind;

use crate::{
    calibration::READINGS,
    draw::palette::{LINES, PALETTE},
    figure::{BAND, CURVE, Stroke},
    operation_words::{colour, operation_name},
    plots::{
        catalogue::{RULES, Rules, TimePlot, Track, bit_plots, time_plots, tracks},
        models,
    },
};

/// Colours, strokes, and what is drawn of a run, for whoever draws with another library.
#[derive(Debug, Clone, Serialize)]
pub struct Conventions {
    /// Colours by their names: on paper, and on a dark screen.
    colours: BTreeMap<&'static str, [String; 2]>,
    /// How many curves have a colour of their own: `line-0` and so on.
    lines: usize,
    /// Dash and gap of each stroke by its place, points; none of a full line.
    strokes: Vec<Option<[f64; 2]>>,
    /// Width of a curve, points.
    curve: f64,
    /// How much of what lies below it a band hides.
    band: f64,
    rules: Rules,
    tracks: Vec<Named<Track>>,
    time: Vec<Named<TimePlot>>,
    bit: Vec<Named<TimePlot>>,
    operations: Vec<OperationLook>,
    /// Models and what their curves are called, the most detailed first.
    models: Vec<(&'static str, &'static str)>,
    /// Readings of a calibration, how they are said, and the operation whose colour they have.
    readings: Vec<(&'static str, &'static str, &'static str)>,
}

/// A picture with the name of its file.
#[derive(Debug, Clone, Serialize)]
struct Named<T> {
    name: &'static str,
    #[serde(flatten)]
    of: T,
}

/// An operation in words and the place of its colour among those of curves.
#[derive(Debug, Clone, Serialize)]
struct OperationLook {
    operation: &'static str,
    words: String,
    colour: usize,
}

impl Conventions {
    /// Those of this crate's own pictures.
    pub fn of_the_house() -> Self {
        let hex = |colour: u32| format!("#{colour:06x}");
        let plots = |all: Vec<TimePlot>| all.into_iter().map(|of| Named { name: of.name, of });
        let look = |of: OperationKind| OperationLook {
            operation: of.name(),
            words: operation_name(of.name()),
            colour: colour(of.name()),
        };
        Self {
            colours: PALETTE.iter().map(|of| (of.name, [of.light, of.dark].map(hex))).collect(),
            lines: LINES,
            strokes: (0..LINES).map(|place| Stroke::of(place).dash()).collect(),
            curve: CURVE,
            band: BAND,
            rules: RULES,
            tracks: tracks().into_iter().map(|of| Named { name: of.name, of }).collect(),
            time: plots(time_plots()).collect(),
            bit: plots(bit_plots()).collect(),
            operations: OperationKind::ALL.map(look).to_vec(),
            models: models(|_| true).into_iter().map(|of| (of.name, of.curve_name)).collect(),
            readings: READINGS.map(|(name, said, of)| (name, said, of.name())).to_vec(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Curves by their places can be told apart by stroke alone, and every colour of theirs is
    /// there.
    #[test]
    fn strokes_and_colours_of_curves_are_all_there() {
        let of = Conventions::of_the_house();
        for (place, dash) in of.strokes.iter().enumerate() {
            assert!(of.strokes[..place].iter().all(|other| other != dash), "{place}");
            assert!(of.colours.contains_key(format!("line-{place}").as_str()));
        }
        assert_eq!(of.strokes.len(), of.lines);
        assert_eq!(of.colours["line-1"], ["#e85800", "#d75c1c"]);
    }
}

//! Conventions shared with pictures that are drawn elsewhere: colours, strokes, and the drawn
//! quantities of a run.

use std::collections::BTreeMap;

use serde::Serialize;
use wholestring::operation::OperationKind;

use crate::{
    calibration::READINGS,
    draw::palette::{LINES, PALETTE, operation_colour},
    figure::{BAND, CURVE, Stroke},
    plots::{
        catalogue::{RULES, Rules, TimePlot, Track, bit_plots, time_plots, tracks},
        models,
    },
};

/// Colours, strokes and the drawn quantities of a run, for programs that draw with another library.
#[derive(Debug, Clone, Serialize)]
pub struct Conventions {
    /// Colours by their names: on paper, and on a dark screen.
    colours: BTreeMap<&'static str, [String; 2]>,
    /// Number of curves with a colour of their own: `line-0` and so on.
    lines: usize,
    /// Dash and gap of each stroke by its place, points; none for a full line.
    strokes: Vec<Option<[f64; 2]>>,
    /// Width of a curve, points.
    curve: f64,
    /// Opacity of a band.
    band: f64,
    rules: Rules,
    tracks: Vec<Named<Track>>,
    time: Vec<Named<TimePlot>>,
    bit: Vec<Named<TimePlot>>,
    operations: Vec<OperationLook>,
    /// Models and the names of their curves, the most detailed first.
    models: Vec<(&'static str, &'static str)>,
    /// Readings of a calibration, their wording, and the operation whose colour they have.
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
    /// The conventions of this crate's own pictures.
    pub fn of_the_house() -> Self {
        let hex = |colour: u32| format!("#{colour:06x}");
        let plots =
            |all: Vec<TimePlot>| all.into_iter().map(|plot| Named { name: plot.name, of: plot });
        let look = |kind: OperationKind| OperationLook {
            operation: kind.name(),
            words: kind.words().to_owned(),
            colour: operation_colour(kind),
        };
        Self {
            colours: PALETTE
                .iter()
                .map(|colour| (colour.name, [colour.light, colour.dark].map(hex)))
                .collect(),
            lines: LINES,
            strokes: (0..LINES).map(|place| Stroke::of(place).dash()).collect(),
            curve: CURVE,
            band: BAND,
            rules: RULES,
            tracks: tracks()
                .into_iter()
                .map(|track| Named { name: track.name, of: track })
                .collect(),
            time: plots(time_plots()).collect(),
            bit: plots(bit_plots()).collect(),
            operations: OperationKind::ALL.map(look).to_vec(),
            models: models(|_| true)
                .into_iter()
                .map(|model| (model.name, model.curve_name))
                .collect(),
            readings: READINGS
                .map(|(name, words, operation)| (name, words, operation.name()))
                .to_vec(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Curves can be distinguished by stroke alone, and all of their colours exist.
    #[test]
    fn strokes_and_colours_of_curves_are_all_there() {
        let conventions = Conventions::of_the_house();
        for (place, dash) in conventions.strokes.iter().enumerate() {
            assert!(conventions.strokes[..place].iter().all(|other| other != dash), "{place}");
            assert!(conventions.colours.contains_key(format!("line-{place}").as_str()));
        }
        assert_eq!(conventions.strokes.len(), conventions.lines);
        assert_eq!(conventions.colours["line-1"], ["#e85800", "#d75c1c"]);
    }
}

//! Power spectral densities.

use super::{
    catalogue::spectrum_dimension,
    run::{Context, Plot},
};
use crate::{
    Spectrum,
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Scale, Stroke},
};

/// A figure for each signal; nodes of different depths are in the same figure.
pub(super) fn plots(context: Context<'_>) -> Vec<Plot> {
    let all: Vec<(usize, &Spectrum)> = context
        .timed()
        .flat_map(|(place, timed)| timed.spectra.iter().map(move |spectrum| (place, spectrum)))
        .collect();
    let mut signals: Vec<(&str, bool)> = Vec::new();
    for (_, spectrum) in &all {
        let signal = (spectrum.signal.as_str(), spectrum.md_m.is_some());
        if !signals.contains(&signal) {
            signals.push(signal);
        }
    }
    let signals = signals.into_iter();
    signals
        .map(|(signal, of_nodes)| {
            let mine = all.iter().filter(|(_, spectrum)| {
                spectrum.signal == signal && spectrum.md_m.is_some() == of_nodes
            });
            let mine: Vec<&(usize, &Spectrum)> = mine.collect();
            let node = if of_nodes { "-nodes" } else { "" };
            let name = format!("spectrum-{}{node}", signal.replace('_', "-"));
            context.plot(&name, figure(signal, &mine, context))
        })
        .collect()
}

fn figure(signal: &str, spectra: &[&(usize, &Spectrum)], context: Context<'_>) -> Figure {
    let (runs, display) = (context.runs, context.display);
    let unit = spectra.first().map_or("", |(_, spectra)| spectra.unit.as_str());
    let of_nodes = spectra.first().is_some_and(|(_, spectra)| spectra.md_m.is_some());
    let dimension = spectrum_dimension(signal, of_nodes);
    // A density is proportional to the square of the signal.
    let factor = dimension.map_or(1.0, |name| display.value(1.0, name).powi(2));
    let symbol = dimension.map_or(unit, |name| display.symbol(name));
    let squared = match symbol {
        "" => "1/Hz".to_owned(),
        simple if simple.chars().all(char::is_alphabetic) => format!("{simple}²/Hz"),
        other => format!("({other})²/Hz"),
    };
    let mut depths: Vec<f64> = spectra.iter().filter_map(|(_, spectra)| spectra.md_m).collect();
    depths.sort_by(f64::total_cmp);
    depths.dedup();
    let overlaid = runs.len() > 1;
    let strokes = [Stroke::Solid, Stroke::Dashed, Stroke::Dotted];
    let style = |run: usize, md_m: Option<f64>| {
        let place = md_m.and_then(|md| depths.iter().position(|other| *other == md));
        let place = place.unwrap_or(0);
        if overlaid {
            (Ink::Line(run), strokes[place % strokes.len()])
        } else {
            (Ink::Line(place), Stroke::Solid)
        }
    };
    let marks = spectra.iter().map(|(run, spectra)| {
        let (ink, stroke) = style(*run, spectra.md_m);
        let density = spectra.density.iter().map(|density| density * factor);
        // The density at zero frequency is the mean's, which has no place on a logarithmic axis.
        let points = spectra.frequency_Hz.iter().copied().zip(density);
        Mark::Curve {
            ink,
            stroke,
            points: points.filter(|(frequency, _)| *frequency > 0.0).collect(),
        }
    });
    let mut keys = context.run_keys();
    if depths.len() > 1 || (overlaid && !depths.is_empty()) {
        keys.extend(depths.iter().map(|md| {
            let (ink, stroke) = style(0, Some(*md));
            Key {
                name: format!("at {}", display.quantity(*md, "length")),
                sample: Sample::Line(if overlaid { Ink::Note } else { ink }, stroke),
            }
        }));
    }
    let name = signal.replace('_', " ");
    let logarithmic =
        |label: String, range| Axis { scale: Scale::Logarithmic, ..Axis::new(label, range) };
    let at = match depths[..] {
        [md] => format!(" at {}", display.quantity(md, "length")),
        _ => String::new(),
    };
    let frequency = logarithmic("Frequency, Hz".into(), Range::Tight);
    let density = logarithmic(format!("Density of {name}{at}, {squared}"), Range::Near);
    let panels = vec![Panel::new(density, marks.collect())];
    Figure { keys, ..context.figure(Layout::across(1, 120.0, 70.0), frequency, panels) }
}

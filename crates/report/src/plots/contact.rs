//! Contact over depth and time.

use super::{
    catalogue::{ContactPlot, Shows, contact_plots},
    run::{self, Context, Plot, Run},
};
use crate::{
    ContactPicture, Packed,
    figure::{Axis, Figure, Hue, Layout, Map, Mark, Panel, Range},
};

/// Contact over depth and time of one run, in the reader's units.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ContactMap {
    /// Label of its depths, unit included.
    pub label: String,
    /// Beginning of the first row, s.
    pub from: f64,
    /// End of each row, s.
    pub ends: Vec<f64>,
    /// Depths of the middles of the stretches.
    pub middles: Vec<f64>,
    /// A value for each stretch, row after row.
    pub values: Vec<f64>,
    /// Beginning of the statistics window, s.
    pub window_from: f64,
    /// Depths of the casing's shoes.
    pub shoes: Vec<f64>,
    /// Further marks drawn over it.
    pub marks: Vec<Mark>,
}

/// Maps one below the other, over the same depths and in the same colours; `label` is that of their
/// values, unit included.
pub(crate) fn contact_figure(
    title: String,
    subtitle: String,
    (label, hue): (&str, Hue),
    maps: Vec<ContactMap>,
) -> Figure {
    let sizes = maps.iter().flat_map(|map| &map.values);
    let largest = largest(sizes.map(|value| value.abs()).collect());
    let depths = maps.iter().filter_map(|map| map.middles.last().copied());
    let deepest = depths.fold(0.0, f64::max);
    let panel_mm = if maps.len() > 1 { 75.0 } else { 95.0 };
    let panel = |map: ContactMap| {
        let mut marks = vec![Mark::Map(Map {
            from: map.from,
            ends: map.ends,
            middles: map.middles,
            values: map.values,
            hue,
            largest,
            label: label.to_owned(),
            sides: (hue == Hue::Side).then(|| ["low side".into(), "high side".into()]),
        })];
        if map.window_from > map.from {
            marks.push(Mark::SharedRule { at: map.window_from, label: "window begins".into() });
        }
        let shoes = map.shoes.into_iter().filter(|at| *at < deepest);
        marks.extend(shoes.map(|at| Mark::OwnRule { at, label: "casing shoe".into() }));
        marks.extend(map.marks);
        let axis = Axis::new(map.label, Range::Fixed(0.0, deepest));
        Panel::new(Axis { down: true, ..axis }, marks)
    };
    Figure {
        title,
        subtitle,
        keys: Vec::new(),
        layout: Layout::across(1, 180.0, panel_mm),
        shared: Axis::new("Time, s", Range::Tight),
        panels: maps.into_iter().map(panel).collect(),
        hole: Vec::new(),
    }
}

/// Side force by side, and contact force, each as a map; for two runs one below the other.
pub(super) fn plots(context: Context<'_>) -> Vec<Plot> {
    let (runs, display) = (context.runs, context.display);
    let pictures: Vec<(&Run<'_>, f64, &ContactPicture)> = context
        .timed()
        .filter_map(|(place, timed)| Some((&runs[place], timed.window_s, timed.contact.as_ref()?)))
        .collect();
    if pictures.is_empty() {
        return Vec::new();
    }
    let figure = |plot: &ContactPlot| {
        let Shows { column, title, dimension } = &plot.shows;
        let map = |(run, window_s, picture): &(&Run<'_>, f64, &ContactPicture)| {
            let name = match runs.len() {
                1 => "Measured depth",
                _ => run.name,
            };
            let cased = run.report.hole.iter().filter(|hole| hole.kind == "casing");
            ContactMap {
                label: display.label(name, "length"),
                from: picture.from_s,
                ends: picture.time_s.values(),
                middles: display.values(&picture.md_m.values(), "length"),
                values: {
                    let values = picture.values.get(*column).map(Packed::values);
                    display.values(&values.unwrap_or_default(), dimension)
                },
                window_from: *window_s,
                shoes: cased.map(|section| display.value(section.to_m, "length")).collect(),
                marks: Vec::new(),
            }
        };
        contact_figure(
            run::title(runs),
            context.subtitle.to_owned(),
            (&display.label(title, dimension), if plot.sides { Hue::Side } else { Hue::Amount }),
            pictures.iter().map(map).collect(),
        )
    };
    contact_plots()
        .iter()
        .map(|contact_plot| context.plot(contact_plot.name, figure(contact_plot)))
        .collect()
}

/// A value above nearly all sizes, so that the few largest do not take the colour from the rest.
fn largest(mut sizes: Vec<f64>) -> f64 {
    const PART: f64 = 0.985;
    sizes.retain(|size| size.is_finite());
    sizes.sort_by(f64::total_cmp);
    let place = PART * (sizes.len().saturating_sub(1)) as f64;
    let value = sizes.get(place as usize).copied().unwrap_or(0.0);
    if value > 0.0 { value } else { 1.0 }
}

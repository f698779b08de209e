//! Contact over depth and time.

use super::{Plot, Run, shown::Shown};
use crate::{
    ContactPicture,
    figure::{Axis, Direction, Figure, Hue, Layout, Map, Mark, Panel, Range},
};

/// Side force by side, and contact force, each as a map: of two runs one below the other, with the same colours.
pub(super) fn plots(
    runs: &[Run<'_>],
    operation: &str,
    shown: Shown<'_>,
    subtitle: &str,
    suffix: &str,
) -> Vec<Plot> {
    let pictures: Vec<(&Run<'_>, f64, &ContactPicture)> = runs
        .iter()
        .filter_map(|run| {
            let mut timed = run.report.runs.iter();
            let timed = timed.find(|timed| timed.operation == operation)?;
            Some((run, timed.window_s, timed.contact.as_ref()?))
        })
        .collect();
    if pictures.is_empty() {
        return Vec::new();
    }
    let deepest = pictures
        .iter()
        .filter_map(|(_, _, picture)| picture.md_m.values().last().copied())
        .fold(0.0, f64::max);
    let figure = |title: &str, hue: Hue, values: &dyn Fn(&ContactPicture) -> Vec<f64>| {
        let sizes: Vec<f64> = pictures.iter().flat_map(|(_, _, of)| values(of)).collect();
        let largest = largest(&sizes);
        let panel = |(run, window_s, picture): &(&Run<'_>, f64, &ContactPicture)| {
            let length = |si: f64| shown.value(si, "length");
            let force = |si: f64| shown.value(si, "force per length");
            let mut marks = vec![Mark::Map(Map {
                from: picture.from_s,
                ends: picture.time_s.values(),
                middles: picture.md_m.values().into_iter().map(length).collect(),
                values: values(picture).into_iter().map(force).collect(),
                hue,
                largest: force(largest),
                label: shown.label(title, "force per length"),
                sides: (hue == Hue::Side).then(|| ["low side".into(), "high side".into()]),
            })];
            if *window_s > picture.from_s {
                marks.push(Mark::SharedRule {
                    at: *window_s,
                    label: "window begins".into(),
                });
            }
            for section in run
                .report
                .hole
                .iter()
                .filter(|of| of.kind == "casing" && of.to_m < deepest)
            {
                marks.push(Mark::OwnRule {
                    at: length(section.to_m),
                    label: "casing shoe".into(),
                });
            }
            let name = if runs.len() > 1 {
                run.name
            } else {
                "Measured depth"
            };
            Panel {
                axis: Axis {
                    down: true,
                    ..Axis::new(
                        shown.label(name, "length"),
                        Range::Fixed(0.0, length(deepest)),
                    )
                },
                marks,
                keys: Vec::new(),
            }
        };
        Figure {
            title: super::title(runs),
            subtitle: subtitle.to_owned(),
            keys: Vec::new(),
            layout: Layout {
                direction: Direction::Across,
                columns: 1,
                width_mm: 180.0,
                panel_mm: if runs.len() > 1 { 75.0 } else { 95.0 },
            },
            shared: Axis::new("Time, s", Range::Tight),
            panels: pictures.iter().map(panel).collect(),
            hole: Vec::new(),
        }
    };
    vec![
        Plot {
            name: format!("map-side-force{suffix}"),
            figure: figure("Side force", Hue::Side, &|of| of.side_force.values()),
        },
        Plot {
            name: format!("map-contact-force{suffix}"),
            figure: figure("Contact force", Hue::Amount, &|of| {
                of.contact_force.values()
            }),
        },
    ]
}

/// The value that nearly all magnitudes stay below: the few largest must not take the colour from the rest.
fn largest(values: &[f64]) -> f64 {
    const PART: f64 = 0.985;
    let sizes = values.iter().map(|value| value.abs());
    let mut sizes: Vec<f64> = sizes.filter(|size| size.is_finite()).collect();
    sizes.sort_by(f64::total_cmp);
    let place = PART * (sizes.len().saturating_sub(1)) as f64;
    let value = sizes.get(place as usize).copied().unwrap_or(0.0);
    if value > 0.0 { value } else { 1.0 }
}

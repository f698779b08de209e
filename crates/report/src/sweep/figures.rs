//! Results of a sweep against the varied key.

use super::{DRAWN, Drawn, Sweep, drawing::Drawing, varied::Varied};
use crate::{
    Plot,
    figure::{Direction, Figure, Layout, Panel},
    plots::{DisplayUnits, subtitle},
};

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

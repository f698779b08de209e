//! A panel: its frame, its ticks and its marks.

use super::{
    Axis, Figure, Map, Mark, Panel, Scale, beyond, marks, names,
    place::{LABEL, Place, TICK, inside, widest},
    ruler::Ruler,
};
use crate::draw::{Anchor, Box, ColourScale, Drawing, Hue, Ink, Pen, fitting, text_width};

/// Size of the names of the sides below a frame.
const SIDE: f64 = 6.5;

const FRAME: f64 = 0.6;
const GRID: f64 = 0.4;

/// Draws a panel with the ticks and the label of its own axis.
pub(super) fn draw(on: &mut Drawing, figure: &Figure, panel: &Panel, place: &Place<'_>) {
    let frame = place.frame;
    let shade = |mark: &&Mark| matches!(mark, Mark::Shade { .. } | Mark::Found { .. });
    on.within(frame, |on| {
        for mark in panel.marks.iter().filter(shade) {
            marks::draw(on, mark, &panel.marks, place);
        }
    });
    grid(on, figure, place);
    for interval in figure.hole.iter().filter(|interval| interval.shoe) {
        let pen = Pen { dash: Some([1.0, 1.6]), ..Pen::new(Ink::Note, 0.6) };
        let line = place.shared_line(interval.to);
        if (frame.top + 1.0..frame.bottom() - 1.0).contains(&line[0].1) {
            on.line(&line, pen);
        }
    }
    on.within(frame, |on| {
        let mut open = false;
        for mark in panel.marks.iter().filter(|mark| !shade(mark)) {
            if let Mark::Of { keys } = mark {
                if open {
                    on.end();
                }
                on.begin(keys, false);
                open = true;
            }
            marks::draw(on, mark, &panel.marks, place);
        }
        if open {
            on.end();
        }
    });
    names::names(on, &panel.marks, place);
    on.frame(frame, Pen::new(Ink::Frame, FRAME));
    if panel.axis.clips {
        beyond::draw(on, &panel.marks, place);
    }
    own_axis(on, panel, place);
    for mark in &panel.marks {
        if let Mark::Map(map) = mark {
            colour_bar(on, map, &frame);
        }
    }
}

fn grid(on: &mut Drawing, figure: &Figure, place: &Place<'_>) {
    let zero = Pen::new(Ink::Frame, GRID);
    let grid = Pen::new(Ink::Grid, GRID);
    if !matches!(figure.shared.scale, Scale::Words(_)) {
        for (value, _) in &place.shared.ticks {
            on.line(&place.shared_line(*value), grid);
        }
    }
    for (value, _) in &place.own.ticks {
        on.line(&place.own_line(*value), if *value == 0.0 { zero } else { grid });
    }
}

/// Name and unit of a label, if it has both.
fn parts(label: &str) -> (&str, &str) {
    label.rsplit_once(", ").unwrap_or((label, ""))
}

fn own_axis(on: &mut Drawing, panel: &Panel, place: &Place<'_>) {
    let frame = place.frame;
    if place.down {
        for (value, text) in &place.own.ticks {
            let half = 0.5 * text_width(text, TICK);
            let x = inside(place.across(place.own.place(*value)), half, &frame);
            on.text(text, (x, frame.top - 6.0), TICK, Ink::Text, Anchor::Middle);
        }
        let middle = frame.left + frame.width / 2.0;
        let (name, unit) = parts(&panel.axis.label);
        on.text(name, (middle, frame.top - 25.0), LABEL, Ink::Text, Anchor::Middle);
        on.text(unit, (middle, frame.top - 15.5), TICK, Ink::Note, Anchor::Middle);
        if let Some([low, high]) = &panel.axis.sides {
            let y = frame.bottom() + 6.0;
            on.text(low, (frame.left, y), SIDE, Ink::Note, Anchor::Start);
            on.text(high, (frame.right(), y), SIDE, Ink::Note, Anchor::End);
        }
    } else {
        for (value, text) in &place.own.ticks {
            let y = place.own_y(*value);
            on.text(text, (frame.left - 4.0, y), TICK, Ink::Text, Anchor::End);
        }
        let x = frame.left - 4.0 - place.widest() - 8.0;
        let y = frame.top + frame.height / 2.0;
        let label = &panel.axis.label;
        if text_width(label, LABEL) <= frame.height {
            on.upright(label, (x, y), LABEL, Ink::Text);
        } else {
            // Name and unit in one line, each as long as fits.
            let (name, unit) = parts(label);
            let name = fitting(name, LABEL, frame.height + 8.0);
            on.upright(&name, (x - 9.5, y), LABEL, Ink::Text);
            on.upright(unit, (x, y), TICK, Ink::Note);
        }
    }
}

/// The scale of a map's colours, to the right of its frame.
fn colour_bar(on: &mut Drawing, map: &Map, frame: &Box) {
    let bar = Box { left: frame.right() + 8.0, width: 7.0, ..*frame };
    const STEPS: usize = 256;
    // Depth grows down the page.
    let at = |part: f64| match map.hue {
        Hue::Depth => part,
        Hue::Side | Hue::Amount => 1.0 - part,
    };
    let scale = ColourScale::new(map.hue);
    let pixels = (0..STEPS).map(|row| Some(scale.at(at((row as f64 + 0.5) / STEPS as f64))));
    let image = crate::draw::Image { columns: 1, pixels: pixels.collect() };
    on.image(image, bar);
    on.frame(bar, Pen::new(Ink::Frame, FRAME));
    let from = match map.hue {
        Hue::Side => -map.largest,
        Hue::Amount | Hue::Depth => 0.0,
    };
    let axis = Axis::new("", super::Range::Fixed(from, map.largest));
    let ruler = Ruler::new(&axis, [], frame.height / 20.0);
    for (value, text) in &ruler.ticks {
        let y = bar.top + bar.height * at(ruler.place(*value));
        on.text(text, (bar.right() + 3.0, y), TICK, Ink::Text, Anchor::Start);
    }
    let x = bar.right() + 3.0 + widest(&ruler) + 7.0;
    let at = |part: f64| (x, bar.top + part * bar.height);
    match &map.sides {
        Some([low, high]) => {
            on.upright(&map.label, at(0.5), LABEL, Ink::Text);
            on.upright(high, at(0.14), SIDE, Ink::Note);
            on.upright(low, at(0.86), SIDE, Ink::Note);
        }
        None => on.upright(&map.label, at(0.5), LABEL, Ink::Text),
    }
}

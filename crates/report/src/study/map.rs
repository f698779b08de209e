//! Contact over time and depth, as a map for each case.

use wholestring_study::Quantity;
use wholestring_units::Dimension;

use super::{
    figure::{Curve, StudyFigure, label, title, unit},
    styles::{CurveStyles, levels},
};
use crate::{
    figure::{Figure as Picture, Hue},
    plots::{ContactMap, contact_figure},
};

/// The maps, one below the other.
pub(super) fn picture(
    StudyFigure { figure, curves, sweeps, units }: StudyFigure<'_>,
    colour: &Quantity,
) -> Picture {
    let (name, dimension) = (colour.column.name, colour.column.dimension);
    let (symbol, worth) = unit(dimension, name, units);
    let (length, metre) = unit(Some(Dimension::Length), "", units);
    let hue = match name == "side_force_N_per_m" && !colour.magnitude {
        true => Hue::Side,
        false => Hue::Amount,
    };
    let styles = CurveStyles::of(curves, sweeps, units, figure);
    let of_curve = |curve: &Curve| {
        let map = curve.map.as_ref()?;
        let mut ends: Vec<f64> = curve.points.iter().map(|(time_s, _)| *time_s).collect();
        ends.dedup();
        let stretches = curve.points.len() / ends.len();
        // The string moves down as it drills; this is the mean position of each stretch.
        let middle = |stretch: usize| {
            let depths = map.depths_m.iter().skip(stretch).step_by(stretches);
            depths.sum::<f64>() / (ends.len() as f64 * metre)
        };
        let case = match curves.len() {
            1 => "Measured depth".to_owned(),
            _ => styles.name(curve),
        };
        Some(ContactMap {
            label: label(&case, &length),
            from: map.from_s,
            middles: (0..stretches).map(middle).collect(),
            values: curve.points.iter().map(|(_, si)| si / worth).collect(),
            window_from: map.window_from_s,
            shoes: map.shoes_m.iter().map(|si| si / metre).collect(),
            marks: levels(figure, metre),
            ends,
        })
    };
    contact_figure(
        figure.title.clone(),
        String::new(),
        (&label(&title(colour), &symbol), hue),
        curves.iter().filter_map(of_curve).collect(),
    )
}

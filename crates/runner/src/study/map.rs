//! Contact over time and depth, as a map for each case.

use wholestring_report::{
    ContactMap, contact_figure,
    figure::{Figure as Picture, Hue},
};
use wholestring_results::ResultsError;
use wholestring_study::{Figure, Quantity, Source};
use wholestring_units::{Dimension, UnitSet};

use super::{
    columns::{label, title, unit},
    curve::{Curve, MapData, signed},
    results::CaseResult,
    styles::{CurveStyles, levels},
};

/// Times and values of a map.
pub(super) fn read(
    result: &CaseResult,
    colour: &Quantity,
    window_s: Option<[f64; 2]>,
) -> Result<(Vec<(f64, f64)>, MapData), ResultsError> {
    let rows = result.rows(Source::Contact, ["time_s", "md_m", colour.column.name])?;
    let [from_s, to_s] = window_s.unwrap_or([0.0, f64::INFINITY]);
    // A row is an average since the one before, so a row that ends at the start of the window is
    // outside it.
    let before = rows.iter().map(|[time_s, ..]| *time_s);
    let before = before.take_while(|time_s| *time_s <= from_s + 1e-6);
    let from_s = before.fold(0.0, f64::max);
    let mut depths_m = Vec::new();
    let mut points = Vec::new();
    let seen = |time_s: f64| time_s > from_s && time_s <= to_s + 1e-6;
    for [time_s, md_m, value] in rows.into_iter().filter(|[time_s, ..]| seen(*time_s)) {
        depths_m.push(md_m);
        points.push((time_s, signed(colour, value)));
    }
    let map = MapData {
        depths_m,
        from_s,
        window_from_s: result.window_from_s()?,
        shoes_m: result.shoes_m()?,
    };
    Ok((points, map))
}

/// The maps, one below the other.
pub(super) fn picture(
    figure: &Figure,
    curves: &[Curve],
    colour: &Quantity,
    sweeps: &[String],
    units: UnitSet,
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

//! Values from frames of the whole string at a time or at a depth.

use wholestring::dynamics::Channel;
use wholestring_results::ResultsError;
use wholestring_study::{Quantity, Source};

use super::results::CaseResult;

/// A time, s, and the points of its frame.
type AtTime = (f64, Vec<(f64, f64)>);

/// Values from the frames that are nearest to these times.
pub(super) fn at_times(
    result: &CaseResult,
    x: &Quantity,
    y: &Quantity,
    times_s: &[f64],
) -> Result<Vec<AtTime>, ResultsError> {
    let mut nearest: Vec<f64> = vec![f64::INFINITY; times_s.len()];
    result.each_row(Source::Frames, ["time_s"], |[time_s]| {
        for (time, best) in times_s.iter().zip(&mut nearest) {
            if (time_s - time).abs() < (*best - time).abs() {
                *best = time_s;
            }
        }
    })?;
    let mut curves: Vec<AtTime> = nearest.into_iter().map(|time_s| (time_s, Vec::new())).collect();
    let columns = ["time_s", x.column.name, y.column.name];
    result.each_row(Source::Frames, columns, |[time_s, a, b]| {
        for (_, points) in curves.iter_mut().filter(|(curve, _)| *curve == time_s) {
            points.push((signed(x, a), signed(y, b)));
        }
    })?;
    Ok(curves)
}

/// Half a joint of pipe, m: the wall touches a string with tool joints at its joints, not at a
/// given depth.
const REACH_M: f64 = 5.0;

/// Whether the column is a force of the wall on a node.
fn is_of_wall(name: &str) -> bool {
    [Channel::Contact, Channel::Friction].iter().any(|channel| channel.columns().contains(&name))
}

/// The node for frames at a depth: the nearest in the first frame; for wall forces, the one with
/// the largest force within half a joint.
fn node_at(
    result: &CaseResult,
    depth_m: f64,
    quantities: &[&Quantity],
) -> Result<Option<f64>, ResultsError> {
    let mut names = quantities.iter().map(|quantity| quantity.column.name);
    let wall = names.find(|name| is_of_wall(name));
    let mut first = None;
    // Distance, number and sum of wall forces of each node, by its number.
    let mut nodes: Vec<(f64, f64, f64)> = Vec::new();
    let columns = ["time_s", "node", "md_m", wall.unwrap_or("md_m")];
    result.each_row(Source::Frames, columns, |[time_s, number, md_m, force]| {
        if *first.get_or_insert(time_s) == time_s {
            nodes.push(((md_m - depth_m).abs(), number, 0.0));
        }
        if let (Some(node), true) = (nodes.get_mut(number as usize), force.is_finite()) {
            node.2 += force.abs();
        }
    })?;
    let near = nodes.iter().filter(|(off, ..)| *off <= REACH_M);
    let touched = near.max_by(|a, b| a.2.total_cmp(&b.2));
    let touched = touched.filter(|(.., force)| wall.is_some() && *force > 0.0);
    let nearest = nodes.iter().min_by(|a, b| a.0.total_cmp(&b.0));
    Ok(touched.or(nearest).map(|(_, number, _)| *number))
}

/// Time and these quantities of the node at a depth.
pub(super) fn at_depth<const N: usize>(
    result: &CaseResult,
    depth_m: f64,
    window_s: Option<[f64; 2]>,
    quantities: [&Quantity; N],
) -> Result<Vec<(f64, [f64; N])>, ResultsError> {
    let Some(node) = node_at(result, depth_m, &quantities)? else {
        return Ok(Vec::new());
    };
    // Two reads return the rows in the same order: first the node and time of each, then each
    // quantity.
    let mut rows: Vec<(f64, [f64; N])> = Vec::new();
    let mut places = Vec::new();
    let mut row = 0_usize;
    result.each_row(Source::Frames, ["time_s", "node"], |[time_s, number]| {
        if number == node && within(window_s, time_s) {
            places.push(row);
            rows.push((time_s, [f64::NAN; N]));
        }
        row += 1;
    })?;
    for (column, quantity) in quantities.iter().enumerate() {
        let (mut row, mut next) = (0_usize, 0);
        result.each_row(Source::Frames, [quantity.column.name], |[value]| {
            if places.get(next) == Some(&row) {
                rows[next].1[column] = signed(quantity, value);
                next += 1;
            }
            row += 1;
        })?;
    }
    Ok(rows)
}

/// Value of the quantity, without its sign if requested.
pub(super) fn signed(quantity: &Quantity, value: f64) -> f64 {
    if quantity.magnitude { value.abs() } else { value }
}

/// Whether a time is in the window, if there is one.
pub(super) fn within(window_s: Option<[f64; 2]>, time_s: f64) -> bool {
    // Times of samples are sums, so the bounds include their rounding.
    window_s.is_none_or(|[from, to]| (from - 1e-6..=to + 1e-6).contains(&time_s))
}

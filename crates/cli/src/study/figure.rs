//! Curves of a figure: what they show, and their data as a table.

use wholestring_case::study::{Figure, FigureData, Quantity, Source, Statistic};
use wholestring_results::{Column, Data, ResultsError, Table};

use super::{
    answers::{Answer, Answers, Series, keys_of},
    map,
};

/// A curve with everything that tells it from the others.
pub(super) struct Curve {
    pub(super) series: Series,
    /// Values of the keys that are not on the axis.
    pub(super) values: Vec<(String, String)>,
    /// The column, and what is made of it.
    pub(super) quantity: Quantity,
    pub(super) statistic: Option<Statistic>,
    /// The time, s, or depth, m, that it was taken at.
    pub(super) at: Option<f64>,
    /// Its points, SI; NaN where there is none.
    pub(super) points: Vec<(f64, f64)>,
    /// Those of them whose case has an error.
    pub(super) errors: Vec<(f64, f64)>,
    /// What else a map needs; none of a curve.
    pub(super) map: Option<map::MapData>,
}

/// All curves of a figure.
pub(super) fn curves(figure: &Figure, answers: &Answers) -> Result<Vec<Curve>, ResultsError> {
    let chosen: Vec<&Answer> = answers.chosen(&figure.chosen).collect();
    let mut curves = Vec::new();
    for quantity in &figure.y {
        match &figure.data {
            FigureData::Summary { x, statistics } => {
                for statistic in statistics {
                    for answer in &chosen {
                        let place = answer.value(&x.key).and_then(|value| x.number(value));
                        let value = answer.summary(quantity, *statistic);
                        // A soft string has no spread: its curve is left out, not empty.
                        if let (Some(place), Some(value)) = (place, value) {
                            let mut curve = blank(answer, Some(&x.key), quantity, Some(*statistic));
                            curve.points.push((place, value));
                            if answer.has_error() {
                                curve.errors.push((place, value));
                            }
                            put(&mut curves, curve);
                        }
                    }
                }
            }
            FigureData::Rows { x, window_s } => {
                for answer in &chosen {
                    let mut curve = blank(answer, None, quantity, None);
                    curve.points = rows(answer, x, quantity, *window_s)?;
                    // Most cases lie in the same well: it is drawn once.
                    let again =
                        |other: &Curve| other.quantity == *quantity && other.points == curve.points;
                    if quantity.column.source != Source::Path || !curves.iter().any(again) {
                        curves.push(curve);
                    }
                }
            }
            FigureData::Times { x, times_s } => {
                for answer in &chosen {
                    for (at, points) in at_times(answer, x, quantity, times_s)? {
                        let mut curve = blank(answer, None, quantity, None);
                        (curve.at, curve.points) = (Some(at), points);
                        curves.push(curve);
                    }
                }
            }
            FigureData::Map { colour, window_s } => {
                for answer in &chosen {
                    let mut curve = blank(answer, None, colour, None);
                    let (points, map) = map::read(answer, colour, *window_s)?;
                    (curve.points, curve.map) = (points, Some(map));
                    curves.push(curve);
                }
            }
            FigureData::Depths {
                x,
                depths_m,
                window_s,
            } => {
                for answer in &chosen {
                    for depth_m in depths_m {
                        let mut curve = blank(answer, None, quantity, None);
                        curve.at = Some(*depth_m);
                        let rows = at_depth(answer, *depth_m, *window_s, [x, quantity])?;
                        curve.points = rows.iter().map(|(_, [x, y])| (*x, *y)).collect();
                        curves.push(curve);
                    }
                }
            }
        }
    }
    curves.retain(|curve| !curve.points.is_empty());
    Ok(curves)
}

fn blank(
    answer: &Answer,
    axis: Option<&str>,
    quantity: &Quantity,
    statistic: Option<Statistic>,
) -> Curve {
    let all = answer.keys.iter().zip(&answer.values);
    let others = all.filter(|(key, _)| axis != Some(key.as_str()));
    Curve {
        series: answer.series(),
        values: others
            .map(|(key, value)| (key.clone(), value.clone()))
            .collect(),
        quantity: *quantity,
        statistic,
        at: None,
        points: Vec::new(),
        errors: Vec::new(),
        map: None,
    }
}

/// Puts the points of a curve at the end of the one that is alike, or begins it.
fn put(curves: &mut Vec<Curve>, like: Curve) {
    let alike = |curve: &&mut Curve| {
        curve.series == like.series
            && curve.values == like.values
            && curve.quantity == like.quantity
            && curve.statistic == like.statistic
    };
    match curves.iter_mut().find(alike) {
        Some(curve) => {
            curve.points.extend(like.points);
            curve.errors.extend(like.errors);
        }
        None => curves.push(like),
    }
}

pub(super) fn signed(quantity: &Quantity, value: f64) -> f64 {
    if quantity.magnitude {
        value.abs()
    } else {
        value
    }
}

fn within(window_s: Option<[f64; 2]>, time_s: f64) -> bool {
    // Samples are summed times: a bound that is meant to be one takes it.
    window_s.is_none_or(|[from, to]| (from - 1e-6..=to + 1e-6).contains(&time_s))
}

fn rows(
    answer: &Answer,
    x: &Quantity,
    y: &Quantity,
    window_s: Option<[f64; 2]>,
) -> Result<Vec<(f64, f64)>, ResultsError> {
    let (source, columns) = (y.column.source, [x.column.name, y.column.name]);
    if source == Source::Time {
        let rows = answer.rows(source, [columns[0], columns[1], "time_s"])?;
        let kept = rows
            .iter()
            .filter(|[_, _, time_s]| within(window_s, *time_s));
        return Ok(kept
            .map(|[a, b, _]| (signed(x, *a), signed(y, *b)))
            .collect());
    }
    let rows = answer.rows(source, columns)?;
    Ok(rows
        .iter()
        .map(|[a, b]| (signed(x, *a), signed(y, *b)))
        .collect())
}

/// A time, s, and the points of its frame.
type AtTime = (f64, Vec<(f64, f64)>);

/// What frames say at the times that are nearest to these.
pub(super) fn at_times(
    answer: &Answer,
    x: &Quantity,
    y: &Quantity,
    times_s: &[f64],
) -> Result<Vec<AtTime>, ResultsError> {
    let mut nearest: Vec<f64> = vec![f64::INFINITY; times_s.len()];
    answer.each_row(Source::Frames, ["time_s"], |[time_s]| {
        for (wanted, best) in times_s.iter().zip(&mut nearest) {
            if (time_s - wanted).abs() < (*best - wanted).abs() {
                *best = time_s;
            }
        }
    })?;
    let mut curves: Vec<AtTime> = nearest
        .into_iter()
        .map(|time_s| (time_s, Vec::new()))
        .collect();
    let columns = ["time_s", x.column.name, y.column.name];
    answer.each_row(Source::Frames, columns, |[time_s, a, b]| {
        for (_, points) in curves.iter_mut().filter(|(of, _)| *of == time_s) {
            points.push((signed(x, a), signed(y, b)));
        }
    })?;
    Ok(curves)
}

/// Half a joint of pipe, m: the wall touches a string with tool joints at its joints, not at a given depth.
const REACH_M: f64 = 5.0;

/// What the wall does to a node.
fn is_of_wall(name: &str) -> bool {
    matches!(
        name,
        "contact_force_N" | "axial_friction_N" | "friction_torque_N_m"
    )
}

/// The node that frames at a depth are about: the nearest in the first frame, and for what the wall does, of those
/// within half a joint the one to which it does most.
fn node_at(
    answer: &Answer,
    depth_m: f64,
    quantities: &[&Quantity],
) -> Result<Option<f64>, ResultsError> {
    let mut names = quantities.iter().map(|quantity| quantity.column.name);
    let wall = names.find(|name| is_of_wall(name));
    let mut first = None;
    // Distance, number, and what the wall did, of each node by its number.
    let mut nodes: Vec<(f64, f64, f64)> = Vec::new();
    let columns = ["time_s", "node", "md_m", wall.unwrap_or("md_m")];
    answer.each_row(Source::Frames, columns, |[time_s, number, md_m, force]| {
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
    answer: &Answer,
    depth_m: f64,
    window_s: Option<[f64; 2]>,
    quantities: [&Quantity; N],
) -> Result<Vec<(f64, [f64; N])>, ResultsError> {
    let Some(node) = node_at(answer, depth_m, &quantities)? else {
        return Ok(Vec::new());
    };
    // Rows of two reads follow each other alike: the node and the time of each, then each quantity.
    let mut kept: Vec<(f64, [f64; N])> = Vec::new();
    let mut places = Vec::new();
    let mut row = 0_usize;
    answer.each_row(Source::Frames, ["time_s", "node"], |[time_s, number]| {
        if number == node && within(window_s, time_s) {
            places.push(row);
            kept.push((time_s, [f64::NAN; N]));
        }
        row += 1;
    })?;
    for (column, quantity) in quantities.iter().enumerate() {
        let (mut row, mut next) = (0_usize, 0);
        answer.each_row(Source::Frames, [quantity.column.name], |[value]| {
            if places.get(next) == Some(&row) {
                kept[next].1[column] = signed(quantity, value);
                next += 1;
            }
            row += 1;
        })?;
    }
    Ok(kept)
}

/// The data of the curves, a row per point, SI.
pub(super) fn table(
    figure: &Figure,
    curves: &[Curve],
    answers: &Answers,
    sweeps: &[String],
) -> Table {
    let mut points: Vec<(&Curve, f64, f64)> = Vec::new();
    for curve in curves {
        points.extend(curve.points.iter().map(|(x, y)| (curve, *x, *y)));
    }
    let text = |name: &str, of: &dyn Fn(&Curve) -> String| Column {
        name: name.to_owned(),
        unit: String::new(),
        meaning: String::new(),
        data: Data::Text(points.iter().map(|(curve, ..)| of(curve)).collect()),
    };
    let number = |name: &str, values: Vec<f64>| Column {
        name: name.to_owned(),
        unit: String::new(),
        meaning: String::new(),
        data: Data::Number(values.into_iter().map(Some).collect()),
    };
    let mut columns = vec![
        text("sweep", &|curve| sweeps[curve.series.0].clone()),
        text("model", &|curve| curve.series.1.name().to_owned()),
        text("operation", &|curve| curve.series.2.clone()),
    ];
    let axis = match &figure.data {
        FigureData::Summary { x, .. } => x.key.as_str(),
        FigureData::Rows { x, .. } | FigureData::Times { x, .. } | FigureData::Depths { x, .. } => {
            x.column.name
        }
        FigureData::Map { .. } => "time_s",
    };
    for key in keys_of(answers.chosen(&figure.chosen))
        .iter()
        .filter(|key| *key != axis)
    {
        columns.push(text(key, &|curve| {
            let found = curve.values.iter().find(|(name, _)| name == key);
            found.map_or_else(String::new, |(_, value)| value.clone())
        }));
    }
    let at = |name| {
        number(
            name,
            points
                .iter()
                .map(|of| of.0.at.unwrap_or(f64::NAN))
                .collect(),
        )
    };
    match figure.data {
        FigureData::Times { .. } => columns.push(at("frame_s")),
        FigureData::Depths { .. } => columns.push(at("depth_m")),
        _ => {}
    }
    let x = number(axis, points.iter().map(|(_, x, _)| *x).collect());
    columns.push(x);
    if let FigureData::Map { .. } = figure.data {
        let maps = curves.iter().filter_map(|curve| curve.map.as_ref());
        columns.push(number(
            "md_m",
            maps.flat_map(|map| map.depths_m.iter().copied()).collect(),
        ));
    }
    columns.push(text("quantity", &|curve| {
        let name = curve.quantity.column.name;
        let name = if curve.quantity.magnitude {
            format!("|{name}|")
        } else {
            name.to_owned()
        };
        match curve.statistic {
            Some(statistic) => format!("{name} {}", statistic.name()),
            None => name,
        }
    }));
    columns.push(number("value", points.iter().map(|(.., y)| *y).collect()));
    Table::new(columns)
}

/// The place of a series' method among all, the most detailed first: the others are drawn dashed
/// beside it.
pub(super) fn rank(series: &Series) -> usize {
    series.1.rank()
}

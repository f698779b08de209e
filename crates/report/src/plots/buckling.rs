//! The compressions at which a string buckles, with its tension.

use std::collections::BTreeMap;

use super::{catalogue::Track, display::DisplayUnits, styles::CurveStyles};
use crate::{
    Packed,
    figure::{Ink, Key, Mark, Sample, Stroke},
};

/// Strokes and names of the loads, of the sinusoid and of the helix. No curve of tension has them.
const LOADS: [(Stroke, &str); 2] =
    [(Stroke::WideDotted, "buckles to a sinusoid"), (Stroke::ShortDashed, "buckles to a helix")];

/// A load beyond this many times the largest compression is not drawn, because it would flatten the
/// rest.
const FAR: f64 = 1.25;

/// Loads where the string is in compression, as tensions, of the solution with the largest
/// compression; none where nothing is buckled.
pub(super) fn marks(
    track: &Track,
    styles: &CurveStyles<'_>,
    display: DisplayUnits<'_>,
) -> Vec<Mark> {
    let Some(columns) = track.buckles else {
        return Vec::new();
    };
    let solved = styles.solved().filter_map(|(_, solved)| loads(track, columns, &solved.profile));
    let Some(most) = solved.max_by(|a, b| a.largest().total_cmp(&b.largest())) else {
        return Vec::new();
    };
    let far = FAR * most.largest();
    let curve = |(load, (stroke, _)): (&Vec<f64>, (Stroke, &str))| {
        let rows = most.compression.iter().zip(load);
        let near = |(compression, load): (&f64, &f64)| match *compression > 0.0 && *load < far {
            true => -load,
            false => f64::NAN,
        };
        let values: Vec<f64> = rows.map(near).collect();
        let depths = display.values(&most.depths, "length");
        let values = display.values(&values, track.shows.dimension);
        let any = values.iter().any(|value| value.is_finite());
        let points = depths.into_iter().zip(values).collect();
        any.then_some(Mark::Curve { ink: Ink::Note, stroke, points })
    };
    most.loads.iter().zip(LOADS).filter_map(curve).collect()
}

/// Keys of the lines among these marks.
pub(super) fn keys<'a>(marks: impl Iterator<Item = &'a Mark> + Clone) -> Vec<Key> {
    let is_of = |mark: &Mark, line: Stroke| matches!(mark, Mark::Curve { ink: Ink::Note, stroke, .. } if *stroke == line);
    let present = LOADS.iter().filter(|(stroke, _)| marks.clone().any(|mark| is_of(mark, *stroke)));
    present
        .map(|(stroke, name)| Key {
            name: (*name).to_owned(),
            sample: Sample::Line(Ink::Note, *stroke),
        })
        .collect()
}

/// A compression and its loads along the string.
struct Loads {
    depths: Vec<f64>,
    compression: Vec<f64>,
    loads: [Vec<f64>; 2],
}

impl Loads {
    fn largest(&self) -> f64 {
        self.compression.iter().copied().fold(0.0, f64::max)
    }
}

/// The loads of a solution; `None` where it is not buckled.
fn loads(
    track: &Track,
    [sinusoidal, helical]: [&str; 2],
    profile: &BTreeMap<String, Packed>,
) -> Option<Loads> {
    let column = |name: &str| profile.get(name).map(Packed::values);
    let tension = column(track.shows.column)?;
    let found = Loads {
        depths: column("md_m")?,
        compression: tension.into_iter().map(|tension| -tension).collect(),
        loads: [column(sinusoidal)?, column(helical)?],
    };
    let mut rows = found.compression.iter().zip(&found.loads[0]);
    rows.any(|(compression, load)| *compression > 0.0 && compression > load).then_some(found)
}

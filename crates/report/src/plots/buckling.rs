//! The compressions at which a string buckles, beside its tension.

use std::collections::BTreeMap;

use super::{catalogue::Track, shown::Shown, styles::CurveStyles};
use crate::{
    Packed,
    figure::{Ink, Key, Mark, Sample, Stroke},
};

/// Strokes and names of the loads, of the sinusoid and of the helix. No curve of tension has them.
const LOADS: [(Stroke, &str); 2] =
    [(Stroke::WideDotted, "buckles to a sinusoid"), (Stroke::ShortDashed, "buckles to a helix")];

/// A load beyond this many times the largest compression is not shown: it would but flatten what
/// is.
const FAR: f64 = 1.25;

/// Loads where the string is in compression, as tensions, of the solution that is compressed most;
/// nothing where none is buckled.
pub(super) fn marks(track: &Track, styles: &CurveStyles<'_>, shown: Shown<'_>) -> Vec<Mark> {
    let Some(columns) = track.buckles else {
        return Vec::new();
    };
    let solved = styles.solved().filter_map(|(_, of)| loads(track, columns, &of.profile));
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
        let depths = shown.values(&most.depths, "length");
        let values = shown.values(&values, track.shows.dimension);
        let any = values.iter().any(|value| value.is_finite());
        let points = depths.into_iter().zip(values).collect();
        any.then_some(Mark::Curve { ink: Ink::Note, stroke, points })
    };
    most.loads.iter().zip(LOADS).filter_map(curve).collect()
}

/// What the lines among these marks mean.
pub(super) fn keys<'a>(marks: impl Iterator<Item = &'a Mark> + Clone) -> Vec<Key> {
    let is_of = |mark: &Mark, of: Stroke| matches!(mark, Mark::Curve { ink: Ink::Note, stroke, .. } if *stroke == of);
    let drawn = LOADS.iter().filter(|(stroke, _)| marks.clone().any(|mark| is_of(mark, *stroke)));
    drawn
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

/// Those of a solution; nothing where it is not buckled.
fn loads(
    track: &Track,
    [sinusoidal, helical]: [&str; 2],
    profile: &BTreeMap<String, Packed>,
) -> Option<Loads> {
    let column = |name: &str| profile.get(name).map(Packed::values);
    let tension = column(track.shows.column)?;
    let of = Loads {
        depths: column("md_m")?,
        compression: tension.into_iter().map(|tension| -tension).collect(),
        loads: [column(sinusoidal)?, column(helical)?],
    };
    let mut rows = of.compression.iter().zip(&of.loads[0]);
    rows.any(|(compression, load)| *compression > 0.0 && compression > load).then_some(of)
}

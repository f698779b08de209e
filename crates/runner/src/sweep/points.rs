//! Combinations of values that a sweep solves.

use std::{collections::BTreeSet, sync::Arc};

use wholestring_case::{Override, Template, Variation};

use crate::{error::Error, folder_name::file_name};

/// Largest number of cases of a sweep.
const MAX_CASES: usize = 100_000;

/// One combination of values.
pub(crate) struct Point {
    /// Index of its set.
    pub(crate) set: usize,
    /// The case file that it varies.
    pub(crate) template: Arc<Template>,
    /// Changes of the case: the common ones, then its own.
    pub(crate) changes: Vec<Override>,
    /// Its own values, as written.
    pub(crate) values: Vec<String>,
    /// Name of its folder.
    pub(crate) name: String,
}

/// All combinations, with the last key varying fastest.
pub(crate) fn points(
    template: &Arc<Template>,
    common: &[Override],
    variations: &[Variation],
) -> Result<Vec<Point>, Error> {
    let counts = variations.iter().map(|variation| variation.values.len());
    let count = counts.clone().try_fold(1_usize, usize::checked_mul);
    let Some(count) = count.filter(|count| *count <= MAX_CASES) else {
        let counts: Vec<String> = counts.map(|count| count.to_string()).collect();
        return Err(too_many(&counts.join(" × ")));
    };
    let own = (0..count).map(|case| {
        let mut stride = count;
        let own = variations.iter().map(|variation| {
            stride /= variation.values.len();
            variation.values[case / stride % variation.values.len()].clone()
        });
        own.collect()
    });
    Ok(with_names(template, common, own))
}

/// The n-th case has the n-th value of every key.
pub(crate) fn points_together(
    template: &Arc<Template>,
    common: &[Override],
    variations: &[Variation],
) -> Result<Vec<Point>, Error> {
    let count = variations.first().map_or(1, |variation| variation.values.len());
    if let Some(other) = variations.iter().find(|variation| variation.values.len() != count) {
        return Err(Error::BadInput(format!(
            "`{}` has {count} values and `{}` has {}: keys that are varied together require equal \
             numbers of values",
            variations[0].key,
            other.key,
            other.values.len()
        )));
    }
    if count > MAX_CASES {
        return Err(too_many(&count.to_string()));
    }
    let own = (0..count)
        .map(|case| variations.iter().map(|variation| variation.values[case].clone()).collect());
    Ok(with_names(template, common, own))
}

fn too_many(count: &str) -> Error {
    Error::BadInput(format!("a sweep of {count} cases, expected at most {MAX_CASES}"))
}

/// Cases with these values, each with a folder named after them.
fn with_names(
    template: &Arc<Template>,
    common: &[Override],
    own: impl Iterator<Item = Vec<Override>>,
) -> Vec<Point> {
    let point = |own: Vec<Override>| {
        let values: Vec<String> = own.iter().map(|change| change.bare().to_owned()).collect();
        let parts = own.iter().zip(&values);
        let parts: Vec<_> = parts.map(|(part, value)| format!("{}={value}", part.key)).collect();
        Point {
            set: 0,
            template: template.clone(),
            changes: [common, &own].concat(),
            values,
            name: match parts.is_empty() {
                true => "case".to_owned(),
                false => parts.join(","),
            },
        }
    };
    let mut points: Vec<Point> = own.map(point).collect();
    name_folders(&mut points);
    points
}

/// Names the folders after the values; if those are too long for a name, or some system does not
/// distinguish them, after the index of the case.
fn name_folders(points: &mut [Point]) {
    let names: Vec<String> = points.iter().map(|point| file_name(&point.name)).collect();
    let unique: BTreeSet<String> = names.iter().map(|name| name.to_lowercase()).collect();
    let whole = points
        .iter()
        .zip(&names)
        .all(|(point, name)| name.chars().count() >= point.name.chars().count());
    let digits = points.len().to_string().len();
    let speaking = whole && unique.len() == names.len();
    for (i, (point, name)) in points.iter_mut().zip(names).enumerate() {
        point.name = if speaking { name } else { format!("case-{:0digits$}", i + 1) };
    }
}

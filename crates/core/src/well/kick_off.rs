//! Kick-off and end of build, read off a survey.

use super::{Station, station::angle_between};

/// Stations nearer than this reflect the tool's repeatability rather than the hole, m.
const THIN_TO_M: f64 = 25.0;

/// Off the first direction by more than this, the hole has left its straight course.
const LEFT_RAD: f64 = 3.0 * std::f64::consts::PI / 180.0;

/// Share of the rate of turning below which a hole counts as not turning any more.
const SHARE: f64 = 0.25;

/// Distance below a station over which the build must continue, m: three stands of range-2 joints.
const LOOK_AHEAD_M: f64 = 90.0;

/// See [`super::Path::kick_off_md_m`].
pub(super) fn kick_off_md_m(survey: &[Station]) -> Option<f64> {
    let stations = thinned(survey);
    let index = kick_off(&stations)?;
    let (from, to) = (&stations[index], &stations[index + 1]);
    let rate = from.dogleg_rad(to) / (to.md_m - from.md_m);
    // The last of the stations left out below it that the hole still reaches straight.
    let straight =
        |station: &&Station| from.dogleg_rad(station) <= SHARE * rate * (station.md_m - from.md_m);
    let between = between(survey, from, to);
    Some(between.filter(straight).last().unwrap_or(from).md_m)
}

/// See [`super::Path::build_end_md_m`].
pub(super) fn build_end_md_m(survey: &[Station]) -> Option<f64> {
    let stations = thinned(survey);
    let start = kick_off(&stations)?;
    if rise_below(&stations, start) <= 0.0 {
        return None;
    }
    let mean_rise_to = |station: &Station| {
        let from = &stations[start];
        (station.inclination_rad - from.inclination_rad) / (station.md_m - from.md_m)
    };
    let last = stations.len() - 1;
    let end = (start + 1..last)
        .find(|&index| {
            let (here, next) = (&stations[index], &stations[index + 1]);
            let least = SHARE * mean_rise_to(here);
            let ahead_m = (stations[last].md_m - here.md_m).min(LOOK_AHEAD_M);
            rise_below(&stations, index) < least * ahead_m
                && next.inclination_rad - here.inclination_rad < least * (next.md_m - here.md_m)
        })
        .unwrap_or(last);
    let (above, to) = (&stations[end - 1], &stations[end]);
    let least = SHARE * mean_rise_to(to);
    // The first of the stations left out above it from which the hole does not build any more.
    let built = |station: &&Station| {
        to.inclination_rad - station.inclination_rad < least * (to.md_m - station.md_m)
    };
    Some(between(survey, above, to).find(built).unwrap_or(to).md_m)
}

/// The stations of the survey strictly between two of them.
fn between<'a>(
    survey: &'a [Station],
    above: &Station,
    below: &Station,
) -> impl Iterator<Item = &'a Station> {
    let (from, to) = (above.md_m, below.md_m);
    survey.iter().filter(move |station| station.md_m > from && station.md_m < to)
}

/// Every station that is far enough below the one kept before it, and the last one.
fn thinned(stations: &[Station]) -> Vec<Station> {
    let mut result: Vec<Station> = Vec::with_capacity(stations.len());
    for station in stations {
        if result.last().is_none_or(|above| station.md_m - above.md_m >= THIN_TO_M) {
            result.push(*station);
        }
    }
    result.extend(stations.last().filter(|last| result.last() != Some(last)));
    result
}

fn kick_off(stations: &[Station]) -> Option<usize> {
    let first = stations[0].tangent();
    let off = |index: usize| angle_between(&first, &stations[index].tangent());
    let rate = |index: usize| {
        (off(index + 1) - off(index)) / (stations[index + 1].md_m - stations[index].md_m)
    };
    let crossing = (1..stations.len()).find(|&index| off(index) > LEFT_RAD)? - 1;
    let least = SHARE * rate(crossing);
    let mut index = crossing;
    while index > 0 && rate(index - 1) >= least {
        index -= 1;
    }
    Some(index)
}

/// The most by which the inclination rises above a station's within the look-ahead, rad.
fn rise_below(stations: &[Station], index: usize) -> f64 {
    let here = &stations[index];
    let end_md_m = here.md_m + LOOK_AHEAD_M;
    let mut most: f64 = 0.0;
    for pair in stations[index..].windows(2) {
        let share = ((end_md_m - pair[0].md_m) / (pair[1].md_m - pair[0].md_m)).min(1.0);
        if share <= 0.0 {
            break;
        }
        let inclination =
            pair[0].inclination_rad + share * (pair[1].inclination_rad - pair[0].inclination_rad);
        most = most.max(inclination - here.inclination_rad);
    }
    most
}

//! Depths of the bit at which components pass curved stretches of the hole.

use crate::Setup;

/// Distance from an end of a component to a station that it is about to pass, m.
const BEFORE_M: f64 = 0.5;

/// Distance of an end that has passed a station, m: more than a step of the soft string.
const BEYOND_M: f64 = 5.5;

/// Least distance of two depths, m.
const LEAST_M: f64 = 10.0;

/// Most depths.
const MOST: f64 = 40.0;

/// Returns the depths of the bit, m, between two ends, at which an end of a component below the
/// topmost is just above or just below a station of the survey or the end of a hole section. There
/// the largest stress of a stiff component in a dogleg begins and ends, which may be missed by a
/// grid of depths. Depths close together are thinned.
pub(super) fn passages_m(setup: &Setup, [from_m, to_m]: [f64; 2]) -> Vec<f64> {
    let below_m = setup.below_topmost_m();
    let stations = setup.well.path.stations().iter().map(|station| station.md_m);
    let sections = setup.well.hole.sections().iter().map(|section| section.to_md_m);
    let places_m: Vec<f64> =
        stations.chain(sections).filter(|md_m| md_m + below_m + BEYOND_M > from_m).collect();
    let ends_m = setup.component_ends_m();
    let passed = ends_m.iter().flat_map(|end_m| {
        let pairs = places_m.iter().map(move |place_m| place_m + end_m);
        pairs.flat_map(|at_m| [at_m - BEFORE_M, at_m + BEYOND_M])
    });
    let mut depths_m: Vec<f64> = passed.filter(|at_m| *at_m > from_m && *at_m < to_m).collect();
    depths_m.sort_by(f64::total_cmp);
    let [Some(first_m), Some(last_m)] = [depths_m.first(), depths_m.last()] else {
        return depths_m;
    };
    let apart_m = ((last_m - first_m) / MOST).max(LEAST_M);
    let mut kept_m: Vec<f64> = Vec::new();
    for at_m in depths_m {
        if kept_m.last().is_none_or(|kept_m| at_m - kept_m >= apart_m) {
            kept_m.push(at_m);
        }
    }
    kept_m
}

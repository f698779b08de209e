//! Scalars computed from a profile along the string.

use crate::well::Path;

/// Length of contact over which the side force is averaged before its side is read, m.
const MEAN_LENGTH_M: f64 = 30.0;

/// A side force below this fraction of the largest one is no contact: rounding, not load.
const NO_CONTACT: f64 = 1e-9;

/// A tension below this fraction of the largest one is neither tension nor compression.
pub(crate) const SLACK: f64 = 1e-3;

/// Measured depth of the shallowest change between tension and compression, m; `None` if there is
/// none.
///
/// `md_m` grows, `tension_N` is the effective tension there. A string that hangs free has no
/// neutral point: its tension reaches zero at the bit, but does not pass it. Nor has a slack string
/// in a horizontal hole: tensions below a thousandth of the largest one are ignored.
pub fn neutral_point_m(md_m: &[f64], tension_N: &[f64]) -> Option<f64> {
    let largest_N = tension_N.iter().fold(0.0_f64, |largest, tension| largest.max(tension.abs()));
    let tensions_N = tension_N.iter().copied().take(md_m.len()).enumerate();
    neutral_point_among(tensions_N, largest_N, |index| md_m[index])
}

/// [`neutral_point_m`] of a profile that is read place by place, with their indices, and whose
/// largest magnitude is known.
pub(crate) fn neutral_point_among(
    tension_N: impl Iterator<Item = (usize, f64)>,
    largest_N: f64,
    md_m: impl Fn(usize) -> f64,
) -> Option<f64> {
    let [(above, tension_above), (below, tension_below)] = neutral_rows(tension_N, largest_N)?;
    Some(zero_between(md_m(above), tension_above, md_m(below), tension_below))
}

/// The rows between which [`neutral_point_among`] finds the change, with their tensions.
pub(crate) fn neutral_rows(
    tension_N: impl Iterator<Item = (usize, f64)>,
    largest_N: f64,
) -> Option<[(usize, f64); 2]> {
    let mut previous: Option<(usize, f64)> = None;
    for row in tension_N {
        if row.1.abs() <= SLACK * largest_N {
            continue;
        }
        if let Some(above) = previous
            && (row.1 > 0.0) != (above.1 > 0.0)
        {
            return Some([above, row]);
        }
        previous = Some(row);
    }
    None
}

/// Length of the search for the cut-off below the build, m.
const BELOW_BUILD_M: f64 = 30.0;

/// The cut-off of a string in its well: [`cutoff_depth_m`] from the kick-off to 30 m below the
/// build, or to the bit where that is shallower.
pub fn cutoff_in_build_m(
    path: &Path,
    bit_depth_m: f64,
    md_m: &[f64],
    signed_side_force_N_per_m: &[f64],
) -> Option<f64> {
    let from_md_m = path.kick_off_md_m()?;
    let to_md_m = (path.build_end_md_m()? + BELOW_BUILD_M).min(bit_depth_m);
    cutoff_depth_m(md_m, signed_side_force_N_per_m, from_md_m, to_md_m)
}

/// Measured depth of the deepest change from the high to the low side of the mean signed side force
/// between `from_md_m` and `to_md_m`, m; `None` if there is none.
///
/// `md_m` grows; the side force (per length, or per node at even spacing) is positive on the high
/// side. Each value represents half the distance to its neighbours. Stretches without contact are
/// cut out; the remaining values are averaged over 30 m, centred, less near the two ends.
pub fn cutoff_depth_m(
    md_m: &[f64],
    signed_side_force_N_per_m: &[f64],
    from_md_m: f64,
    to_md_m: f64,
) -> Option<f64> {
    let contacts = contacts(md_m, signed_side_force_N_per_m, from_md_m, to_md_m);
    // Side force and length of contact, accumulated to the end of each contact.
    let mut ends = vec![(0.0, 0.0)];
    for contact in &contacts {
        let (length_m, force_N) = ends[ends.len() - 1];
        ends.push((
            length_m + contact.length_m,
            force_N + contact.length_m * contact.force_N_per_m,
        ));
    }
    let total_m = ends[ends.len() - 1].0;
    let force_to = |at_m: f64| {
        let next = ends.partition_point(|&(end_m, _)| end_m < at_m);
        let next = next.clamp(1, ends.len() - 1);
        let (start_m, force_N) = ends[next - 1];
        force_N + (at_m - start_m) * contacts[next - 1].force_N_per_m
    };
    let mean = |index: usize| {
        let centre_m = 0.5 * (ends[index].0 + ends[index + 1].0);
        let from_m = (centre_m - MEAN_LENGTH_M / 2.0).max(0.0);
        let to_m = (centre_m + MEAN_LENGTH_M / 2.0).min(total_m);
        (force_to(to_m) - force_to(from_m)) / (to_m - from_m)
    };
    (1..contacts.len()).rev().find_map(|below| {
        let (mean_above, mean_below) = (mean(below - 1), mean(below));
        (mean_above > 0.0 && mean_below <= 0.0).then(|| {
            zero_between(contacts[below - 1].md_m, mean_above, contacts[below].md_m, mean_below)
        })
    })
}

struct Contact {
    md_m: f64,
    length_m: f64,
    force_N_per_m: f64,
}

/// The samples that touch, each with the length between `from_md_m` and `to_md_m` that it
/// represents.
fn contacts(md_m: &[f64], force_N_per_m: &[f64], from_md_m: f64, to_md_m: f64) -> Vec<Contact> {
    let count = md_m.len().min(force_N_per_m.len());
    let largest = force_N_per_m.iter().fold(0.0_f64, |largest, force| largest.max(force.abs()));
    (0..count)
        .filter_map(|index| {
            let md = md_m[index];
            let upper_m = match index.checked_sub(1) {
                Some(above) => 0.5 * (md_m[above] + md),
                None => md,
            };
            let lower_m = if index + 1 < count { 0.5 * (md + md_m[index + 1]) } else { md };
            let (upper_m, lower_m) = (upper_m.max(from_md_m), lower_m.min(to_md_m));
            let touches = force_N_per_m[index].abs() > NO_CONTACT * largest;
            (touches && lower_m > upper_m).then(|| Contact {
                md_m: 0.5 * (upper_m + lower_m),
                length_m: lower_m - upper_m,
                force_N_per_m: force_N_per_m[index],
            })
        })
        .collect()
}

/// Zero of the line through `(x0, y0)` and `(x1, y1)`, whose values have opposite signs.
fn zero_between(x0: f64, y0: f64, x1: f64, y1: f64) -> f64 {
    x0 + (x1 - x0) * (y0 / (y0 - y1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(md: &[f64], zero_md: f64) -> Vec<f64> {
        md.iter().map(|md| zero_md - md).collect()
    }

    #[test]
    fn neutral_point_of_a_line_and_of_a_hanging_string() {
        let md = [0.0, 10.0, 20.0, 30.0];
        let found = neutral_point_m(&md, &line(&md, 13.0));
        assert!((found.expect("changes sign") - 13.0).abs() < 1e-12);
        assert_eq!(neutral_point_m(&md, &line(&md, 30.0)), None);
        assert_eq!(neutral_point_m(&md, &line(&md, 20.0)), Some(20.0));
        assert_eq!(neutral_point_m(&[], &[]), None);
        // The shallowest of two.
        assert_eq!(neutral_point_m(&md, &[1.0, -1.0, -1.0, 1.0]), Some(5.0));
    }

    /// The mean of a straight line over a centred window is its middle value, so the cut-off of a
    /// straight line is its zero, whatever the spacing of the samples.
    #[test]
    fn cutoff_of_a_straight_line_is_its_zero() {
        for spacing in [0.5, 1.0, 3.2, 9.6] {
            let md: Vec<f64> = (0..400).map(|i| spacing * f64::from(i)).collect();
            let zero = 97.3;
            let found = cutoff_depth_m(&md, &line(&md, zero), 0.0, 190.0).expect("changes side");
            assert!((found - zero).abs() < 1e-9, "{spacing}: {found}");
        }
    }

    #[test]
    fn cutoff_is_the_deepest_change_of_the_mean_and_not_of_a_ripple() {
        let md: Vec<f64> = (0..1000).map(f64::from).collect();
        // High to 200 m, low to 500 m, high to 600 m, low below; on it a ripple of 3 m, a tenth of
        // the averaging length, that changes sides all the time.
        let force: Vec<f64> = md
            .iter()
            .map(|&md| {
                let mean = if md < 200.0 || (500.0..600.0).contains(&md) { 1.0 } else { -1.0 };
                mean + 3.0 * (md * std::f64::consts::TAU / 3.0).sin()
            })
            .collect();
        let found = cutoff_depth_m(&md, &force, 0.0, 1000.0).expect("changes side");
        assert!((found - 600.0).abs() < 3.0, "{found}");
        let found = cutoff_depth_m(&md, &force, 0.0, 400.0).expect("changes side");
        assert!((found - 200.0).abs() < 3.0, "{found}");
        // From low to high is no cut-off.
        assert_eq!(cutoff_depth_m(&md, &force, 300.0, 550.0), None);
    }

    /// Without contact between 40 m and 160 m the mean runs over the stretches on both sides of the
    /// gap: the side changes at the gap's ends, not within 30 m of a lone contact.
    #[test]
    fn stretches_without_contact_are_skipped() {
        let md: Vec<f64> = (0..300).map(f64::from).collect();
        let force: Vec<f64> = md
            .iter()
            .map(|&md| match md {
                md if md <= 40.0 => 1.0,
                md if md < 160.0 => 0.0,
                _ => -1.0,
            })
            .collect();
        let found = cutoff_depth_m(&md, &force, 0.0, 300.0).expect("changes side");
        assert!((40.0..=160.0).contains(&found), "{found}");
        assert_eq!(cutoff_depth_m(&md, &vec![0.0; 300], 0.0, 300.0), None);
        assert_eq!(cutoff_depth_m(&[], &[], 0.0, 300.0), None);
        assert_eq!(cutoff_depth_m(&md, &force, 400.0, 500.0), None);
    }
}

//! Reduction of lines to the points that a reader can see.

/// Returns the curve without the points that are on the line between those retained, within a
/// twentieth of a point (Ramer, Douglas and Peucker), because a fine mesh gives no finer picture.
pub(crate) fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    const WITHIN: f64 = 0.05;
    let mut keep = vec![false; points.len()];
    let mut spans = Vec::new();
    if let Some(last) = points.len().checked_sub(1) {
        keep[0] = true;
        keep[last] = true;
        spans.push((0, last));
    }
    while let Some((first, last)) = spans.pop() {
        let ((x0, y0), (x1, y1)) = (points[first], points[last]);
        let length = (x1 - x0).hypot(y1 - y0);
        let off = |&(x, y): &(f64, f64)| {
            if length > 0.0 {
                ((x - x0) * (y1 - y0) - (y - y0) * (x1 - x0)).abs() / length
            } else {
                (x - x0).hypot(y - y0)
            }
        };
        let between = (first + 1..last).map(|index| (index, off(&points[index])));
        if let Some((farthest, distance)) = between.max_by(|a, b| a.1.total_cmp(&b.1))
            && distance > WITHIN
        {
            keep[farthest] = true;
            spans.extend([(first, farthest), (farthest, last)]);
        }
    }
    let retained = points.iter().zip(keep);
    retained.filter_map(|(point, keep)| keep.then_some(*point)).collect()
}

/// Returns the curve without the points between the extremes of each stretch of `within` along it:
/// the visible part of thousands of samples in the width of a line. A curve runs across the page,
/// or down it.
pub(crate) fn envelope(points: &[(f64, f64)], within: f64, down: bool) -> Vec<(f64, f64)> {
    let turned = |(x, y): (f64, f64)| if down { (y, x) } else { (x, y) };
    let mut retained = Vec::new();
    let stretch = |point: &(f64, f64)| (turned(*point).0 / within).floor();
    for chunk in points.chunk_by(|a, b| stretch(a) == stretch(b)) {
        let (first, last) = (0, chunk.len() - 1);
        let across = |place: &usize| turned(chunk[*place]).1;
        let by = |a: &usize, b: &usize| across(a).total_cmp(&across(b));
        let low = (first..=last).min_by(by).unwrap_or(first);
        let high = (first..=last).max_by(by).unwrap_or(first);
        let mut places = [first, low.min(high), low.max(high), last].to_vec();
        places.dedup();
        retained.extend(places.into_iter().map(|place| chunk[place]));
    }
    retained
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_moves_no_point_of_the_curve_visibly() {
        let point = |i: i32| {
            let y = f64::from(i) * 0.1;
            (100.0 + 50.0 * (y / 30.0).sin() + if i == 3000 { 20.0 } else { 0.0 }, y)
        };
        let curve: Vec<_> = (0..7600).map(point).collect();
        let thin = thinned(&curve);
        assert!(thin.len() < 300, "{}", thin.len());
        assert!(thin.contains(&point(3000)));
        assert_eq!((thin[0], thin[thin.len() - 1]), (point(0), point(7599)));
        for pair in thin.windows(2) {
            let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
            for (x, y) in curve.iter().filter(|point| point.1 > y0 && point.1 < y1) {
                let line = x0 + (x1 - x0) * (y - y0) / (y1 - y0);
                // Across the curve it is within 0.05; along x a slope of 5/3 doubles that.
                assert!((line - x).abs() < 0.1, "{y}: {}", line - x);
            }
        }
        assert_eq!(thinned(&[]), []);
        assert_eq!(thinned(&[(1.0, 2.0)]), [(1.0, 2.0)]);
    }

    /// A peak of one sample among thousands remains.
    #[test]
    fn an_envelope_keeps_every_peak() {
        let point =
            |i: i32| (f64::from(i) * 1e-3, f64::from(i % 7) + if i == 4321 { 50.0 } else { 0.0 });
        let curve: Vec<_> = (0..10_000).map(point).collect();
        let reduced = envelope(&curve, 0.1, false);
        assert!(reduced.len() <= 4 * 101, "{}", reduced.len());
        assert!(reduced.contains(&point(4321)));
        assert!(reduced.windows(2).all(|pair| pair[0].0 < pair[1].0));
        assert_eq!((reduced[0], reduced[reduced.len() - 1]), (point(0), point(9999)));
        let turned =
            |points: &[(f64, f64)]| -> Vec<_> { points.iter().map(|(x, y)| (*y, *x)).collect() };
        assert_eq!(envelope(&turned(&curve), 0.1, true), turned(&reduced));
    }
}

//! Lines as the points that a reader can see.

/// The curve without the points that lie on the line between those kept, within a twentieth of a
/// point (Ramer, Douglas and Peucker): a fine mesh makes no finer picture.
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
    let kept = points.iter().zip(keep);
    kept.filter_map(|(point, keep)| keep.then_some(*point))
        .collect()
}

/// The pieces of a dashed line.
pub(crate) fn dashes(points: &[(f64, f64)], dash: f64, gap: f64) -> Vec<Vec<(f64, f64)>> {
    let mut pieces = Vec::new();
    let mut piece = Vec::new();
    // What is left of the dash or gap that the pen is in.
    let (mut drawing, mut left) = (true, dash);
    for pair in points.windows(2) {
        let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
        let length = (x1 - x0).hypot(y1 - y0);
        let at = |along: f64| {
            (
                x0 + (x1 - x0) * along / length,
                y0 + (y1 - y0) * along / length,
            )
        };
        if drawing && piece.is_empty() {
            piece.push((x0, y0));
        }
        let mut along = 0.0;
        while length - along > left {
            along += left;
            if drawing {
                piece.push(at(along));
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece.push(at(along));
            }
            drawing = !drawing;
            left = if drawing { dash } else { gap };
        }
        left -= length - along;
        if drawing && length > 0.0 {
            piece.push((x1, y1));
        }
    }
    if piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_moves_no_point_of_the_curve_visibly() {
        let point = |i: i32| {
            let y = f64::from(i) * 0.1;
            (
                100.0 + 50.0 * (y / 30.0).sin() + if i == 3000 { 20.0 } else { 0.0 },
                y,
            )
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

    #[test]
    fn dashes_keep_their_rhythm_over_corners() {
        let pieces = dashes(&[(0.0, 0.0), (4.0, 0.0), (4.0, 20.0)], 6.0, 4.0);
        assert_eq!(
            pieces,
            [
                vec![(0.0, 0.0), (4.0, 0.0), (4.0, 2.0)],
                vec![(4.0, 6.0), (4.0, 12.0)],
                vec![(4.0, 16.0), (4.0, 20.0)],
            ]
        );
    }
}

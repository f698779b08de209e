//! The wall that a string meets at each depth: the innermost pipe or open hole.

use super::measure::Measure;

/// A pipe in the hole, or a stretch of open hole.
#[derive(Debug)]
pub(crate) struct Wall {
    pub(crate) top: Measure,
    pub(crate) bottom: Measure,
    pub(crate) cased: bool,
    /// Its inside diameter, m, if it is known.
    pub(crate) id_m: Option<f64>,
}

/// A stretch of depth with one wall.
#[derive(Debug, PartialEq)]
pub(crate) struct Stretch {
    /// Which wall.
    pub(crate) wall: usize,
    pub(crate) from: Measure,
    pub(crate) to: Measure,
    /// Whether the interval between this stretch and the one above, or the surface, is unknown.
    pub(crate) gap: bool,
    /// Whether the file describes several open holes here.
    pub(crate) several: bool,
}

/// Tolerance within which depths are equal, m; tallies are rounded to the centimetre.
const SAME_M: f64 = 0.02;

/// Returns the walls from the surface down, each where it is the innermost.
///
/// In cased hole that is the narrowest pipe; in open hole, which is outside every pipe, it is the
/// last one in the file.
pub(crate) fn innermost(walls: &[Wall]) -> Vec<Stretch> {
    let mut depths: Vec<&Measure> =
        walls.iter().flat_map(|wall| [&wall.top, &wall.bottom]).collect();
    depths.sort_by(|a, b| a.si().total_cmp(&b.si()));
    depths.dedup_by(|next, previous| next.si() - previous.si() < SAME_M);
    let mut stretches: Vec<Stretch> = Vec::new();
    for pair in depths.windows(2) {
        let &[from, to] = pair else { continue };
        let middle_m = (from.si() + to.si()) / 2.0;
        let here = |wall: &&Wall| wall.top.si() < middle_m && middle_m < wall.bottom.si();
        let cased = (0..walls.len()).filter(|&index| walls[index].cased && here(&&walls[index]));
        let width = |index: &usize| walls[*index].id_m.unwrap_or(f64::INFINITY);
        let pipe = cased.min_by(|a, b| width(a).total_cmp(&width(b)));
        let open: Vec<usize> =
            (0..walls.len()).filter(|&index| !walls[index].cased && here(&&walls[index])).collect();
        let Some(wall) = pipe.or(open.last().copied()) else { continue };
        let several = pipe.is_none() && open.len() > 1;
        match stretches.last_mut() {
            Some(above) if above.to == *from && above.wall == wall => {
                above.to = to.clone();
                above.several |= several;
            }
            above => {
                let gap = match above {
                    Some(above) => above.to != *from,
                    None => from.si() > SAME_M,
                };
                let (from, to) = (from.clone(), to.clone());
                stretches.push(Stretch { wall, from, to, gap, several });
            }
        }
    }
    stretches
}

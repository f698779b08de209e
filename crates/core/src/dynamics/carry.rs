//! What a contact carries: the force of a node, shared out over the string around it.

use crate::rod::mesh::Mesh;

/// Longest stretch of string that one contact is taken to carry on either side of it, m.
pub const LONGEST_REACH_M: f64 = 10.0;

/// A contact and the stretch of string that it carries: the nodes `first..=last` over `length_m`.
pub struct Carries {
    contact: usize,
    first: usize,
    last: usize,
    length_m: f64,
}

/// Shares the string out among the nodes that touch: each carries half the way to the next contact on
/// either side, at most [`LONGEST_REACH_M`].
pub fn carried(mesh: &Mesh, touches: impl Fn(usize) -> bool) -> Vec<Carries> {
    let at = |i: usize| -mesh.nodes[i].from_bit_m;
    let touching: Vec<usize> = (0..mesh.nodes.len())
        .filter(|index| touches(*index))
        .collect();
    touching
        .iter()
        .enumerate()
        .map(|(k, &contact)| {
            let half = |other: Option<&usize>| {
                other.map_or(LONGEST_REACH_M, |o| {
                    (0.5 * (at(*o) - at(contact)).abs()).min(LONGEST_REACH_M)
                })
            };
            let above = half(k.checked_sub(1).and_then(|k| touching.get(k)));
            let below = half(touching.get(k + 1));
            let low = at(contact) - above - 1e-9;
            let high = at(contact) + below + 1e-9;
            let mut first = contact;
            while first > 0 && at(first - 1) >= low {
                first -= 1;
            }
            let mut last = contact;
            while last + 1 < mesh.nodes.len() && at(last + 1) <= high {
                last += 1;
            }
            Carries {
                contact,
                first,
                last,
                length_m: above + below,
            }
        })
        .collect()
}

/// Spreads what contacts carry over the stretches that they carry it for, per metre; a node on the
/// border between two takes their mean.
pub fn spread(carries: &[Carries], nodes: usize, force: impl Fn(usize) -> f64) -> Vec<f64> {
    let mut sum = vec![0.0; nodes];
    let mut count = vec![0u32; nodes];
    for c in carries {
        for i in c.first..=c.last {
            sum[i] += force(c.contact) / c.length_m;
            count[i] += 1;
        }
    }
    sum.iter()
        .zip(&count)
        .map(|(s, c)| if *c > 1 { s / f64::from(*c) } else { *s })
        .collect()
}

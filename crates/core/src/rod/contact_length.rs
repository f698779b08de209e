//! Contact lengths: the force of a node, spread over the string around it.

use crate::rod::mesh::Mesh;

/// Longest stretch of string that one contact is taken to carry on either side of it, m.
pub const LONGEST_REACH_M: f64 = 10.0;

/// A contact, and how far up and down the string it carries, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactLength {
    pub contact: usize,
    pub above_m: f64,
    pub below_m: f64,
}

/// Shares the string out among the nodes that touch, by the nodes' distances from the bit, from the
/// surface down: each carries half the way to the next contact on either side, at most
/// [`LONGEST_REACH_M`].
pub fn contact_lengths(from_bit_m: &[f64], touches: impl Fn(usize) -> bool) -> Vec<ContactLength> {
    let touching: Vec<usize> = (0..from_bit_m.len()).filter(|index| touches(*index)).collect();
    let half = |contact: usize, other: Option<&usize>| {
        other.map_or(LONGEST_REACH_M, |other| {
            (0.5 * (from_bit_m[*other] - from_bit_m[contact]).abs()).min(LONGEST_REACH_M)
        })
    };
    let reach = |(k, &contact): (usize, &usize)| ContactLength {
        contact,
        above_m: half(contact, k.checked_sub(1).and_then(|k| touching.get(k))),
        below_m: half(contact, touching.get(k + 1)),
    };
    touching.iter().enumerate().map(reach).collect()
}

/// A contact and the stretch of string that it carries: the nodes `first..=last` over `length_m`.
pub struct ContactSpan {
    contact: usize,
    first: usize,
    last: usize,
    length_m: f64,
}

/// Shares the string out among the nodes that touch, as [`contact_lengths`] does, in nodes.
pub fn contact_spans(mesh: &Mesh, touches: impl Fn(usize) -> bool) -> Vec<ContactSpan> {
    let from_bit_m: Vec<f64> = mesh.nodes.iter().map(|node| node.from_bit_m).collect();
    let at = |i: usize| -from_bit_m[i];
    let contact_spans = |reach: &ContactLength| {
        let contact = reach.contact;
        let low = at(contact) - reach.above_m - 1e-9;
        let high = at(contact) + reach.below_m + 1e-9;
        let mut first = contact;
        while first > 0 && at(first - 1) >= low {
            first -= 1;
        }
        let mut last = contact;
        while last + 1 < from_bit_m.len() && at(last + 1) <= high {
            last += 1;
        }
        ContactSpan { contact, first, last, length_m: reach.above_m + reach.below_m }
    };
    contact_lengths(&from_bit_m, touches).iter().map(contact_spans).collect()
}

/// Spreads the forces of contacts over the stretches that they support, per metre; a node on the
/// border between two takes their mean.
pub fn spread(
    contact_spans: &[ContactSpan],
    nodes: usize,
    force: impl Fn(usize) -> f64,
) -> Vec<f64> {
    let mut sum = vec![0.0; nodes];
    let mut count = vec![0u32; nodes];
    for c in contact_spans {
        for i in c.first..=c.last {
            sum[i] += force(c.contact) / c.length_m;
            count[i] += 1;
        }
    }
    sum.iter().zip(&count).map(|(s, c)| if *c > 1 { s / f64::from(*c) } else { *s }).collect()
}

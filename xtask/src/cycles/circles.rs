//! The circles of a graph.

use std::collections::{BTreeSet, VecDeque};

use super::modules::Arrows;

/// Maximum number of circles of a knot that are shown.
const MAX_CHAINS: usize = 12;

/// Files that each reach each other, and the shortest circles among them.
pub struct Circle {
    pub knot: BTreeSet<usize>,
    pub chains: Vec<Vec<usize>>,
}

/// The circles among `count` files, knot by knot, the shortest first.
pub fn circles(count: usize, arrows: &Arrows) -> Vec<Circle> {
    let mut next = vec![Vec::new(); count];
    for &(from, to) in arrows.keys() {
        next[from].push(to);
    }
    let mut found: Vec<Circle> = Vec::new();
    for &(from, to) in arrows.keys() {
        let Some(mut chain) = shortest(&next, to, from) else {
            continue;
        };
        // Each circle once, from its first file on.
        let first = chain.iter().enumerate().min_by_key(|&(_, file)| file);
        let first = first.map_or(0, |(index, _)| index);
        chain.rotate_left(first);
        let circle = match found.iter_mut().position(|circle| circle.knot.contains(&from)) {
            Some(index) => &mut found[index],
            None => {
                let tied = |&file: &usize| {
                    file == from
                        || (shortest(&next, from, file).is_some()
                            && shortest(&next, file, from).is_some())
                };
                found.push(Circle { knot: (0..count).filter(tied).collect(), chains: Vec::new() });
                let last = found.len() - 1;
                &mut found[last]
            }
        };
        if !circle.chains.contains(&chain) {
            circle.chains.push(chain);
        }
    }
    for circle in &mut found {
        circle.chains.sort_by_key(Vec::len);
        circle.chains.truncate(MAX_CHAINS);
    }
    found
}

/// The files on the shortest path from one to another, both included.
fn shortest(next: &[Vec<usize>], from: usize, to: usize) -> Option<Vec<usize>> {
    let mut before = vec![None; next.len()];
    let mut queue = VecDeque::from([from]);
    while let Some(file) = queue.pop_front() {
        if file == to {
            let mut way = vec![to];
            while way[way.len() - 1] != from {
                way.push(before[way[way.len() - 1]]?);
            }
            way.reverse();
            return Some(way);
        }
        for &other in &next[file] {
            if other != from && before[other].is_none() {
                before[other] = Some(file);
                queue.push_back(other);
            }
        }
    }
    None
}

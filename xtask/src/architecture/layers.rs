//! Crates in rows: each above all that it uses, with few crossing lines.

use std::collections::BTreeMap;

use super::uses::Uses;

/// A place in a row.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Place {
    /// The crate; `None` if only a line passes.
    pub(super) name: Option<String>,
    /// Places in the row below to which lines go.
    pub(super) below: Vec<usize>,
}

/// The rows, from the crates without users to those that use none.
pub(super) fn layers(uses: &Uses) -> Vec<Vec<Place>> {
    let heights = heights(uses);
    let top = heights.values().max().map_or(0, |highest| highest + 1);
    let mut rows: Vec<Vec<Place>> = vec![Vec::new(); top];
    let row_of = |height: usize| top - 1 - height;
    let mut places: BTreeMap<&str, usize> = BTreeMap::new();
    for (name, height) in &heights {
        let row = &mut rows[row_of(*height)];
        places.insert(name, row.len());
        row.push(Place { name: Some((*name).to_owned()), below: Vec::new() });
    }
    for (user, used) in uses {
        for name in used {
            let Some(end) = heights.get(name.as_str()) else { continue };
            let mut place = places[user.as_str()];
            // A line has a place of its own in the rows between its crates.
            for row in row_of(heights[user.as_str()])..row_of(*end) - 1 {
                let next = rows[row + 1].len();
                rows[row][place].below.push(next);
                rows[row + 1].push(Place { name: None, below: Vec::new() });
                place = next;
            }
            rows[row_of(*end) - 1][place].below.push(places[name.as_str()]);
        }
    }
    // A few passes up and down; more have no effect.
    for _ in 0..8 {
        for row in 1..rows.len() {
            sort_by_above(&mut rows, row);
        }
        for row in (0..rows.len().saturating_sub(1)).rev() {
            sort_by_below(&mut rows, row);
        }
    }
    rows
}

/// Length of the longest chain of crates below each crate.
fn heights(uses: &Uses) -> BTreeMap<&str, usize> {
    let mut heights: BTreeMap<&str, usize> = uses.keys().map(|name| (name.as_str(), 0)).collect();
    // Cargo has no circles, so that nothing changes after as many rounds as there are crates.
    for _ in 0..uses.len() {
        for (user, used) in uses {
            let below = used.iter().filter_map(|name| heights.get(name.as_str())).max();
            let height = below.map_or(0, |below| below + 1);
            heights.insert(user, height);
        }
    }
    heights
}

/// Sorts the places of a row by the mean of those that lead to them.
fn sort_by_above(rows: &mut [Vec<Place>], row: usize) {
    let count = rows[row].len();
    let mut leading: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (above, place) in rows[row - 1].iter().enumerate() {
        for below in &place.below {
            leading[*below].push(above);
        }
    }
    let width = rows[row - 1].len();
    let keys: Vec<f64> =
        leading.iter().enumerate().map(|(own, above)| middle(above, width, own, count)).collect();
    reorder(rows, row, &keys);
}

/// Sorts the places of a row by the mean of those to which they lead.
fn sort_by_below(rows: &mut [Vec<Place>], row: usize) {
    let (count, width) = (rows[row].len(), rows[row + 1].len());
    let places = rows[row].iter().enumerate();
    let keys: Vec<f64> =
        places.map(|(own, place)| middle(&place.below, width, own, count)).collect();
    reorder(rows, row, &keys);
}

/// The mean of places in a row of `width`, relative to it; its own place if there are none.
fn middle(places: &[usize], width: usize, own: usize, count: usize) -> f64 {
    let part = |place: usize, width: usize| (place as f64 + 0.5) / width as f64;
    if places.is_empty() {
        return part(own, count);
    }
    places.iter().map(|place| part(*place, width)).sum::<f64>() / places.len() as f64
}

fn reorder(rows: &mut [Vec<Place>], row: usize, keys: &[f64]) {
    let mut order: Vec<usize> = (0..keys.len()).collect();
    order.sort_by(|a, b| keys[*a].total_cmp(&keys[*b]));
    let mut moved = vec![0; order.len()];
    for (new, old) in order.iter().enumerate() {
        moved[*old] = new;
    }
    rows[row] = order.iter().map(|old| rows[row][*old].clone()).collect();
    if row > 0 {
        for place in &mut rows[row - 1] {
            for below in &mut place.below {
                *below = moved[*below];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crate_stands_above_what_it_uses() {
        let mut uses = Uses::new();
        for (name, used) in [("a", &["b", "d"][..]), ("b", &["c"]), ("c", &[]), ("d", &[])] {
            uses.insert(name.into(), used.iter().map(ToString::to_string).collect());
        }
        let rows = layers(&uses);
        let names: Vec<Vec<Option<&str>>> = rows
            .iter()
            .map(|row| row.iter().map(|place| place.name.as_deref()).collect())
            .collect();
        assert_eq!(names[0], [Some("a")]);
        assert_eq!(names[1], [Some("b"), None]);
        assert_eq!(names[2], [Some("c"), Some("d")]);
        assert_eq!(rows[0][0].below, [0, 1]);
        assert_eq!(rows[1][1].below, [1]);
    }
}

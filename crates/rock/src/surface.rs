//! The surface that can be touched: nodes on faces with no rock beyond.

use serde::{Deserialize, Serialize};

use super::{
    edges::Edge,
    grid::{Grid, of_face},
};

/// No place in the list.
const NOWHERE: u32 = u32::MAX;

/// Nodes on faces with no rock beyond, in an order that depends on the history of the block alone.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Surface {
    /// Number of faces around a node that point to −x, +x, −y, +y, −z, +z.
    faces: Vec<[u8; 6]>,
    exposed: Vec<u32>,
    /// Index of a node among the exposed ones.
    place: Vec<u32>,
}

impl Surface {
    /// Of a block with elements where `is_rock`.
    pub fn new(grid: &Grid, edges: &[Edge; 6], is_rock: impl Fn([usize; 3]) -> bool) -> Self {
        let mut surface = Self {
            faces: vec![[0; 6]; grid.node_places()],
            exposed: Vec::new(),
            place: vec![NOWHERE; grid.node_places()],
        };
        for element in grid.each_element().filter(|&element| is_rock(element)) {
            for (face, edge) in edges.iter().enumerate() {
                let open = match grid.beyond(element, face) {
                    None => *edge == Edge::Free,
                    Some(beyond) => !is_rock(beyond),
                };
                if open {
                    surface.expose(of_face(grid.corners(element), face), face);
                }
            }
        }
        surface
    }

    /// Whether the same nodes are exposed by the same faces, in whatever order, and each is at the
    /// index of its place.
    pub fn is_like(&self, other: &Self) -> bool {
        let stands = |(node, place): (usize, &u32)| match *place {
            NOWHERE => true,
            place => self.exposed.get(place as usize) == Some(&(node as u32)),
        };
        let exposed = self.place.iter().filter(|place| **place != NOWHERE);
        self.faces == other.faces
            && self.place.len() == other.place.len()
            && exposed.count() == self.exposed.len()
            && self.exposed.len() == other.exposed.len()
            && self.place.iter().enumerate().all(stands)
            && self.exposed.iter().all(|node| other.is_exposed(*node as usize))
    }

    /// Names a node that is not there.
    #[cfg(test)]
    pub fn forge(&mut self) {
        self.exposed[0] = NOWHERE - 1;
    }

    /// Places of the exposed nodes.
    pub fn exposed(&self) -> &[u32] {
        &self.exposed
    }

    /// Whether a node is exposed.
    pub fn is_exposed(&self, node: usize) -> bool {
        self.place[node] != NOWHERE
    }

    /// Area of a node with its outward direction, m², in the rock at rest.
    pub fn area_m2(&self, grid: &Grid, node: usize) -> [f64; 3] {
        let faces = self.faces[node];
        let mut area_m2 = [0.0; 3];
        for (axis, area_m2) in area_m2.iter_mut().enumerate() {
            let net_faces = f64::from(faces[2 * axis + 1]) - f64::from(faces[2 * axis]);
            *area_m2 = 0.25 * net_faces * grid.area_m2(2 * axis);
        }
        area_m2
    }

    /// An element goes.
    pub fn remove(
        &mut self,
        grid: &Grid,
        edges: &[Edge; 6],
        element: [usize; 3],
        is_rock: impl Fn([usize; 3]) -> bool,
    ) {
        for (face, edge) in edges.iter().enumerate() {
            match grid.beyond(element, face) {
                Some(beyond) if is_rock(beyond) => {
                    self.expose(of_face(grid.corners(beyond), face ^ 1), face ^ 1);
                }
                None if *edge != Edge::Free => {}
                _ => self.cover(of_face(grid.corners(element), face), face),
            }
        }
    }

    fn expose(&mut self, nodes: [usize; 4], face: usize) {
        for node in nodes {
            self.faces[node][face] += 1;
            if self.place[node] == NOWHERE {
                self.place[node] = self.exposed.len() as u32;
                self.exposed.push(node as u32);
            }
        }
    }

    fn cover(&mut self, nodes: [usize; 4], face: usize) {
        for node in nodes {
            self.faces[node][face] -= 1;
            if self.faces[node] == [0; 6] {
                let place = self.place[node] as usize;
                self.exposed.swap_remove(place);
                if let Some(&moved) = self.exposed.get(place) {
                    self.place[moved as usize] = place as u32;
                }
                self.place[node] = NOWHERE;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The exposed surface of a block in which elements were removed one by one is that of the
    /// block that is left.
    #[test]
    fn a_surface_follows_the_elements_that_go() {
        let grid = Grid { cells: [5, 4, 3], size_m: [1.0, 2.0, 3.0] };
        let edges = [Edge::Open, Edge::Open, Edge::Held, Edge::Guided, Edge::Free, Edge::Open];
        let mut rock = vec![true; grid.element_places()];
        let mut surface = Surface::new(&grid, &edges, |_| true);
        let mut seed = 7_usize;
        for _ in 0..40 {
            seed = (seed * 1_103_515_245 + 12_345) % (1 << 31);
            let n = (seed >> 8) % grid.elements();
            let element = [n % 5, n / 5 % 4, n / 20];
            if !rock[grid.element(element)] {
                continue;
            }
            rock[grid.element(element)] = false;
            surface.remove(&grid, &edges, element, |b| rock[grid.element(b)]);
            let fresh = Surface::new(&grid, &edges, |b| rock[grid.element(b)]);
            assert_eq!(surface.faces, fresh.faces);
            let sorted = |s: &Surface| {
                let mut nodes = s.exposed.clone();
                nodes.sort_unstable();
                nodes
            };
            assert_eq!(sorted(&surface), sorted(&fresh));
        }
    }
}

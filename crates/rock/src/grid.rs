//! Memory layout of the elements and their nodes.

use serde::{Deserialize, Serialize};

/// Elements that are looked after together: the widest register.
pub const GROUP: usize = 8;

/// A grid of elements in rows along x, rows in layers along y, layers along z, which points down
/// the hole.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Elements along x, y and z.
    pub cells: [usize; 3],
    /// Edges of an element, m.
    pub size_m: [f64; 3],
}

impl Grid {
    /// Places of a row of elements: whole groups.
    pub fn element_row(&self) -> usize {
        self.cells[0].next_multiple_of(GROUP)
    }

    /// Places of a row of nodes: one node more than there are elements, and nothing that is read
    /// beyond the end.
    pub fn node_row(&self) -> usize {
        self.element_row() + GROUP
    }

    /// Rows of elements of a layer.
    pub fn element_rows(&self) -> usize {
        self.cells[1]
    }

    /// Places of a layer of elements.
    pub fn element_layer(&self) -> usize {
        self.element_row() * self.cells[1]
    }

    /// Places of a layer of nodes.
    pub fn node_layer(&self) -> usize {
        self.node_row() * (self.cells[1] + 1)
    }

    /// Places of all elements.
    pub fn element_places(&self) -> usize {
        self.element_layer() * self.cells[2]
    }

    /// Places of all nodes.
    pub fn node_places(&self) -> usize {
        self.node_layer() * (self.cells[2] + 1)
    }

    /// Elements.
    pub fn elements(&self) -> usize {
        self.cells.iter().product()
    }

    /// Place of an element.
    pub fn element(&self, [i, j, k]: [usize; 3]) -> usize {
        i + self.element_row() * j + self.element_layer() * k
    }

    /// Place of a node.
    pub fn node(&self, [i, j, k]: [usize; 3]) -> usize {
        i + self.node_row() * j + self.node_layer() * k
    }

    /// Which element is at a place.
    pub fn element_at(&self, place: usize) -> [usize; 3] {
        let (row, layer) = (self.element_row(), self.element_layer());
        [place % row, place % layer / row, place / layer]
    }

    /// Which node is at a place.
    pub fn node_at(&self, place: usize) -> [usize; 3] {
        // Nodes are fewer than 2³², and half as wide numbers are divided in half the time.
        let (place, row, rows) = (place as u32, self.node_row() as u32, self.cells[1] as u32 + 1);
        let over = place / row;
        [place % row, over % rows, over / rows].map(|at| at as usize)
    }

    /// Places of an element's corners; bits 0, 1, 2 of a corner's number show whether it is the far
    /// one in x, y, z.
    pub fn corners(&self, [i, j, k]: [usize; 3]) -> [usize; 8] {
        let first = self.node([i, j, k]);
        [0, 1, 2, 3, 4, 5, 6, 7].map(|corner| {
            first
                + (corner & 1)
                + (corner >> 1 & 1) * self.node_row()
                + (corner >> 2) * self.node_layer()
        })
    }

    /// All elements, in the order of their places.
    pub fn each_element(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [nx, ny, nz] = self.cells;
        (0..nz).flat_map(move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])))
    }

    /// All nodes, in the order of their places.
    pub fn each_node(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [nx, ny, nz] = self.cells;
        (0..=nz).flat_map(move |k| (0..=ny).flat_map(move |j| (0..=nx).map(move |i| [i, j, k])))
    }

    /// The element beyond a face, and none beyond the block. Faces are −x, +x, −y, +y, −z, +z.
    pub fn beyond(&self, mut element: [usize; 3], face: usize) -> Option<[usize; 3]> {
        let axis = face / 2;
        element[axis] =
            if face.is_multiple_of(2) { element[axis].checked_sub(1)? } else { element[axis] + 1 };
        (element[axis] < self.cells[axis]).then_some(element)
    }

    /// Volume of an element, m³.
    pub fn volume_m3(&self) -> f64 {
        self.size_m.iter().product()
    }

    /// Area of a face, m².
    pub fn area_m2(&self, face: usize) -> f64 {
        let [_, a, b] = [face / 2, (face / 2 + 1) % 3, (face / 2 + 2) % 3];
        self.size_m[a] * self.size_m[b]
    }
}

/// The corners of an element on a face.
pub fn of_face(corners: [usize; 8], face: usize) -> [usize; 4] {
    let (axis, side) = (face / 2, face % 2);
    let mut found = [0; 4];
    let on = (0..8).filter(|corner| corner >> axis & 1 == side);
    for (place, corner) in found.iter_mut().zip(on) {
        *place = corners[corner];
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_found_again() {
        let grid = Grid { cells: [9, 4, 3], size_m: [1.0; 3] };
        for node in grid.each_node() {
            assert_eq!(grid.node_at(grid.node(node)), node);
        }
        for element in grid.each_element() {
            assert_eq!(grid.element_at(grid.element(element)), element);
        }
    }
}

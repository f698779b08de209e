//! Where the bricks and their nodes stand in memory.

use serde::{Deserialize, Serialize};

/// Bricks that are looked after together: the widest register.
pub const GROUP: usize = 8;

/// A grid of bricks in rows along x, rows in layers along y, layers along z, which points down the hole.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Bricks along x, y and z.
    pub cells: [usize; 3],
    /// Edges of a brick, m.
    pub size_m: [f64; 3],
}

impl Grid {
    /// Places of a row of bricks: whole groups.
    pub fn brick_row(&self) -> usize {
        self.cells[0].next_multiple_of(GROUP)
    }

    /// Places of a row of nodes: one node more than there are bricks, and nothing that is read beyond the end.
    pub fn node_row(&self) -> usize {
        self.brick_row() + GROUP
    }

    /// Rows of bricks of a layer.
    pub fn brick_rows(&self) -> usize {
        self.cells[1]
    }

    /// Places of a layer of bricks.
    pub fn brick_layer(&self) -> usize {
        self.brick_row() * self.cells[1]
    }

    /// Places of a layer of nodes.
    pub fn node_layer(&self) -> usize {
        self.node_row() * (self.cells[1] + 1)
    }

    /// Places of all bricks.
    pub fn brick_places(&self) -> usize {
        self.brick_layer() * self.cells[2]
    }

    /// Places of all nodes.
    pub fn node_places(&self) -> usize {
        self.node_layer() * (self.cells[2] + 1)
    }

    /// Bricks.
    pub fn bricks(&self) -> usize {
        self.cells.iter().product()
    }

    /// Place of a brick.
    pub fn brick(&self, [i, j, k]: [usize; 3]) -> usize {
        i + self.brick_row() * j + self.brick_layer() * k
    }

    /// Place of a node.
    pub fn node(&self, [i, j, k]: [usize; 3]) -> usize {
        i + self.node_row() * j + self.node_layer() * k
    }

    /// Which brick is at a place.
    pub fn brick_at(&self, place: usize) -> [usize; 3] {
        let (row, layer) = (self.brick_row(), self.brick_layer());
        [place % row, place % layer / row, place / layer]
    }

    /// Which node is at a place.
    pub fn node_at(&self, place: usize) -> [usize; 3] {
        // Nodes are fewer than 2³², and half as wide numbers are divided in half the time.
        let (place, row, rows) = (
            place as u32,
            self.node_row() as u32,
            self.cells[1] as u32 + 1,
        );
        let over = place / row;
        [place % row, over % rows, over / rows].map(|at| at as usize)
    }

    /// Places of a brick's corners; bits 0, 1, 2 of a corner's number tell whether it is the far one in x, y, z.
    pub fn corners(&self, [i, j, k]: [usize; 3]) -> [usize; 8] {
        let first = self.node([i, j, k]);
        [0, 1, 2, 3, 4, 5, 6, 7].map(|corner| {
            first
                + (corner & 1)
                + (corner >> 1 & 1) * self.node_row()
                + (corner >> 2) * self.node_layer()
        })
    }

    /// All bricks, in the order of their places.
    pub fn each_brick(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [nx, ny, nz] = self.cells;
        (0..nz).flat_map(move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])))
    }

    /// All nodes, in the order of their places.
    pub fn each_node(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [nx, ny, nz] = self.cells;
        (0..=nz).flat_map(move |k| (0..=ny).flat_map(move |j| (0..=nx).map(move |i| [i, j, k])))
    }

    /// The brick beyond a face, and none beyond the block. Faces are −x, +x, −y, +y, −z, +z.
    pub fn beyond(&self, mut brick: [usize; 3], face: usize) -> Option<[usize; 3]> {
        let axis = face / 2;
        brick[axis] = if face.is_multiple_of(2) {
            brick[axis].checked_sub(1)?
        } else {
            brick[axis] + 1
        };
        (brick[axis] < self.cells[axis]).then_some(brick)
    }

    /// Volume of a brick, m³.
    pub fn volume_m3(&self) -> f64 {
        self.size_m.iter().product()
    }

    /// Area of a face, m².
    pub fn area_m2(&self, face: usize) -> f64 {
        let [_, a, b] = [face / 2, (face / 2 + 1) % 3, (face / 2 + 2) % 3];
        self.size_m[a] * self.size_m[b]
    }
}

/// The corners of a brick on a face.
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
        let grid = Grid {
            cells: [9, 4, 3],
            size_m: [1.0; 3],
        };
        for node in grid.each_node() {
            assert_eq!(grid.node_at(grid.node(node)), node);
        }
        for brick in grid.each_brick() {
            assert_eq!(grid.brick_at(grid.brick(brick)), brick);
        }
    }
}

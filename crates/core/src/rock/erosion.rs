//! Bricks that have failed go.

use super::{
    block::{Block, at},
    energy::Energies,
    grid::GROUP,
};

impl Block {
    /// Removes the bricks that the last step left without cohesion, or squeezed flat; how many.
    pub(super) fn erode(&mut self) -> usize {
        let rows = self.grid.brick_rows();
        let mut gone = 0;
        for row in 0..self.books.len() {
            if self.books[row].least_intact > 0.0 {
                continue;
            }
            for i in 0..self.grid.cells[0] {
                let brick = [i, row % rows, row / rows];
                if self.intact[self.grid.brick(brick)] == 0.0 {
                    self.remove(brick);
                    gone += 1;
                }
            }
            self.books[row].least_intact = 1.0;
        }
        gone
    }

    /// Takes a brick out. Its mass goes with it, and what it holds; its neighbours' faces are free.
    pub fn remove(&mut self, brick: [usize; 3]) {
        let place = self.grid.brick(brick);
        if self.intact[place] < 0.0 {
            return;
        }
        let Energies {
            elastic_J,
            hourglass_J,
            pressure_J,
            ..
        } = self.brick_energies(brick);
        self.energies.removed_J += elastic_J + hourglass_J;
        self.energies.pressure_J += pressure_J;
        self.intact[place] = -1.0;
        for field in &mut self.stress {
            field[place] = 0.0;
        }
        self.left[place / GROUP] -= 1;
        self.removed += 1;
        for corner in self.grid.corners(brick) {
            let v = at(&self.velocity, corner);
            let square: f64 = v.iter().map(|v| v * v).sum();
            self.energies.removed_J += self.constants.mass_kg / 16.0 * square;
            if !self.surface.is_exposed(corner) {
                // What it came with is not known any more.
                for (came, v) in self.came.iter_mut().zip(v) {
                    came[corner] = v;
                }
            }
            self.around[corner] -= 1;
            self.weigh(corner);
            if self.around[corner] == 0 {
                for field in &mut self.velocity {
                    field[corner] = 0.0;
                }
            }
        }
        let (grid, intact) = (self.grid, &self.intact);
        self.surface
            .remove(&grid, &self.edges, brick, |b| intact[grid.brick(b)] >= 0.0);
    }
}

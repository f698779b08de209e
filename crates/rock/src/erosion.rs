//! Elements that have failed go.

use super::{
    block::{Block, at},
    energy::Energies,
    grid::GROUP,
};

impl Block {
    /// Removes the elements that the last step left without cohesion, or squeezed flat; how many.
    pub(super) fn erode(&mut self) -> usize {
        let rows = self.grid.element_rows();
        let mut eroded = 0;
        for row in 0..self.books.len() {
            if self.books[row].min_intact > 0.0 {
                continue;
            }
            for i in 0..self.grid.cells[0] {
                let element = [i, row % rows, row / rows];
                if self.intact[self.grid.element(element)] == 0.0 {
                    self.remove(element);
                    eroded += 1;
                }
            }
            self.books[row].min_intact = 1.0;
        }
        eroded
    }

    /// Removes an element with its mass and its energy; the faces of its neighbours become free.
    pub fn remove(&mut self, element: [usize; 3]) {
        let place = self.grid.element(element);
        if self.intact[place] < 0.0 {
            return;
        }
        let Energies { elastic_J, hourglass_J, pressure_J, .. } = self.element_energies(element);
        self.energies.removed_J += elastic_J + hourglass_J;
        self.energies.pressure_J += pressure_J;
        self.intact[place] = -1.0;
        for field in &mut self.stress {
            field[place] = 0.0;
        }
        self.left[place / GROUP] -= 1;
        self.removed += 1;
        for corner in self.grid.corners(element) {
            let v = at(&self.velocity, corner);
            let square: f64 = v.iter().map(|v| v * v).sum();
            self.energies.removed_J += self.constants.mass_kg / 16.0 * square;
            if !self.surface.is_exposed(corner) {
                // Its previous velocity is no longer known.
                for (velocity_before, v) in self.velocity_before.iter_mut().zip(v) {
                    velocity_before[corner] = v;
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
        self.surface.remove(&grid, &self.edges, element, |b| intact[grid.element(b)] >= 0.0);
    }
}

//! A block that follows the bit down.

use super::{
    block::Block,
    grid::{GROUP, Grid},
    kernel::RowBook,
    surface::Surface,
};

/// Drops the first places of a field and puts a value behind the last.
fn shift<T: Copy>(field: &mut [T], places: usize, last: T) {
    field.copy_within(places.., 0);
    let remaining = field.len() - places;
    field[remaining..].fill(last);
}

/// The same with a field of nodes, the last layer of which continues below.
fn shift_on(field: &mut [f64], grid: &Grid, layers: usize) {
    let layer = grid.node_layer();
    field.copy_within(layers * layer.., 0);
    let remaining = field.len() - layers * layer;
    for below in 0..layers {
        field.copy_within(remaining - layer..remaining, remaining + below * layer);
    }
}

impl Block {
    /// Layers at the top of which nothing is left.
    pub fn spent_layers(&self) -> usize {
        let layer = self.grid.element_layer() / GROUP;
        self.left
            .chunks_exact(layer)
            .take_while(|layer| layer.iter().all(|&left| left == 0))
            .count()
    }

    /// Drops the layers at the top of which nothing is left, and puts as many of fresh rock below,
    /// which move with the last layer of nodes. How many. Indices of nodes are then others.
    pub fn follow(&mut self) -> usize {
        let grid = self.grid;
        let layers = self.spent_layers().min(grid.cells[2] - 1);
        if layers == 0 {
            return 0;
        }
        let without = self.energies().residual_J();
        for book in &mut self.books {
            self.energies.plastic_J += book.plastic_J;
            self.energies.viscous_J += book.viscous_J;
            *book = RowBook::default();
        }
        for field in
            self.displacement.iter_mut().chain(&mut self.velocity).chain(&mut self.velocity_before)
        {
            shift_on(field, &grid, layers);
        }
        let (nodes, elements) = (layers * grid.node_layer(), layers * grid.element_layer());
        shift(&mut self.around, nodes, 0);
        for field in &mut self.stress {
            shift(field, elements, 0.0);
        }
        shift(&mut self.intact, elements, -1.0);
        shift(&mut self.left, elements / GROUP, 0);
        self.fill(grid.cells[2] - layers);
        self.top_m += layers as f64 * grid.size_m[2];
        let intact = &self.intact;
        self.surface = Surface::new(&grid, &self.edges, |b| intact[grid.element(b)] >= 0.0);
        self.energies.entered_J += self.energies().residual_J() - without;
        layers
    }
}

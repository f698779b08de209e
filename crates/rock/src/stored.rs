//! A block that was stored, compared with its specification, because the loops of the kernel rely
//! on its lengths.

use super::{
    block::{Block, BlockSpec},
    grid::{GROUP, Grid},
    surface::Surface,
};
use wholestring_numbers::damage::{Damaged, ensure};

impl Block {
    /// Whether a stored block is one of this kind.
    ///
    /// # Errors
    /// The part that does not match.
    pub fn check(&self, spec: &BlockSpec) -> Result<(), Damaged> {
        let grid = Grid { cells: spec.cells, size_m: spec.size_m };
        let constants = spec.constants().map_err(|_| Damaged("the rock"))?;
        let same = self.grid == grid
            && self.rock == spec.rock
            && self.edges == spec.edges
            && self.layers_per_slab() == spec.layers_per_slab.max(1);
        ensure(same, "the block")?;
        let dt_s = self.constants.dt_s;
        let steps = self.constants.longest_dt_s == constants.longest_dt_s
            && self.constants.mass_kg == constants.mass_kg
            && dt_s > 0.0
            && dt_s <= constants.longest_dt_s * (1.0 + 1e-9);
        ensure(steps, "the step of the rock")?;
        let (nodes, elements) = (grid.node_places(), grid.element_places());
        let of_nodes = [&self.displacement, &self.velocity, &self.velocity_before];
        let lengths = of_nodes.iter().all(|field| field.iter().all(|field| field.len() == nodes))
            && self.inverse_mass.len() == nodes
            && self.around.len() == nodes
            && self.stress.iter().all(|stress| stress.len() == elements)
            && self.intact.len() == elements
            && self.left.len() == elements / GROUP
            && self.books.len() == grid.element_rows() * grid.cells[2];
        ensure(lengths, "the fields of the rock")?;
        self.check_counts()
    }

    /// Whether counts and surface are those of the elements that are left.
    fn check_counts(&self) -> Result<(), Damaged> {
        let grid = self.grid;
        let is_rock = |element: [usize; 3]| self.intact[grid.element(element)] >= 0.0;
        let mut around = vec![0_u8; grid.node_places()];
        let mut left = vec![0_u8; grid.element_places() / GROUP];
        let mut rock = vec![false; grid.element_places()];
        for element in grid.each_element().filter(|element| is_rock(*element)) {
            let place = grid.element(element);
            rock[place] = true;
            left[place / GROUP] += 1;
            for corner in grid.corners(element) {
                around[corner] += 1;
            }
        }
        // Places outside the elements of a row contain none.
        let beside = rock.iter().zip(&self.intact).all(|(rock, intact)| *rock || *intact < 0.0);
        ensure(beside && around == self.around && left == self.left, "the elements that are left")?;
        let fresh = Surface::new(&grid, &self.edges, is_rock);
        ensure(self.surface.is_like(&fresh), "the surface of the rock")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Alone, Rock, Stepper};

    fn block() -> (BlockSpec, Block) {
        let rock = Rock::of_strength(60e6);
        let mut spec = BlockSpec::new(rock, [5, 4, 6], 0.01);
        spec.layers_per_slab = 2;
        let mut block = Block::new(&spec).unwrap();
        for element in [[0, 0, 0], [2, 1, 0], [2, 1, 1]] {
            block.remove(element);
        }
        block.step(&Stepper::default(), &Alone);
        (spec, block)
    }

    #[test]
    fn a_block_that_was_stored_whole_is_sound() {
        let (spec, block) = block();
        assert_eq!(block.check(&spec), Ok(()));
        let stored = postcard::to_allocvec(&block).unwrap();
        let back: Block = postcard::from_bytes(&stored).unwrap();
        assert_eq!(back.check(&spec), Ok(()));
    }

    /// Each of these reached the kernel, which reads and writes by the grid\'s own lengths.
    #[test]
    fn a_block_with_a_length_or_a_place_that_does_not_fit_is_refused() {
        type Damage = fn(&mut Block);
        let damages: [(&str, Damage); 12] = [
            ("the block", |b| b.grid.cells[2] += 1),
            ("the block", |b| b.grid.cells = [15, 15, 9]),
            ("the step of the rock", |b| b.constants.dt_s = f64::NAN),
            ("the fields of the rock", |b| b.displacement[1].clear()),
            ("the fields of the rock", |b| b.velocity[2].clear()),
            ("the fields of the rock", |b| b.velocity_before[0].truncate(1)),
            ("the fields of the rock", |b| b.stress[5].clear()),
            ("the fields of the rock", |b| b.intact.clear()),
            ("the fields of the rock", |b| b.books.clear()),
            ("the elements that are left", |b| b.left[0] += 1),
            ("the elements that are left", |b| b.around[3] = 0),
            ("the surface of the rock", |b| b.surface.forge()),
        ];
        for (about, damage) in damages {
            let (spec, mut block) = block();
            damage(&mut block);
            assert_eq!(block.check(&spec), Err(Damaged(about)));
        }
    }
}

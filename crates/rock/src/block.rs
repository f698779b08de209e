//! A block of rock.

use serde::{Deserialize, Serialize};

use super::{
    constants::{Constants, Numerics},
    edges::{Edge, Edges},
    element::{Modes, Motion},
    energy::Energies,
    executor::Executor,
    grid::{GROUP, Grid},
    kernel::{Fields, RowBook, Slab, Stepper},
    material::{Rock, RockError},
    surface::Surface,
};

/// Value of the intact part of a removed element.
const REMOVED: f64 = -1.0;

/// Specification of a block.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BlockSpec {
    /// Elements along x, y and z, z pointing down the hole.
    pub cells: [usize; 3],
    /// Edges of an element, m.
    pub size_m: [f64; 3],
    /// The rock.
    pub rock: Rock,
    /// Faces −x, +x, −y, +y, −z, +z.
    pub edges: [Edge; 6],
    /// Pressure of the fluid in the hole, Pa: it acts on every free face, also on those that
    /// removed elements leave, and is the initial stress across z.
    pub pressure_Pa: f64,
    /// Initial pressure in the rock across x and y, Pa.
    pub confinement_Pa: f64,
    /// Settings of the integration.
    pub numerics: Numerics,
    /// Layers of elements that are worked on together; fewer let more threads work, and cost more.
    pub layers_per_slab: usize,
}

impl BlockSpec {
    /// A block of cubes without initial stress, free above, more rock around and below.
    pub fn new(rock: Rock, cells: [usize; 3], size_m: f64) -> Self {
        let mut edges = [Edge::Open; 6];
        edges[4] = Edge::Free;
        Self {
            cells,
            size_m: [size_m; 3],
            rock,
            edges,
            pressure_Pa: 0.0,
            confinement_Pa: 0.0,
            numerics: Numerics::default(),
            layers_per_slab: 8,
        }
    }

    /// Elements of the block.
    pub fn elements(&self) -> usize {
        self.cells.iter().product()
    }

    /// The longest step that is stable for the elements, s, without building them.
    ///
    /// # Errors
    /// Numbers that no rock has, or elements too large for its fracture energy.
    pub fn step_s(&self) -> Result<f64, RockError> {
        Ok(self.numbers()?.dt_s)
    }

    fn numbers(&self) -> Result<Constants, RockError> {
        Constants::new(&self.rock, self.size_m, self.pressure_Pa, &self.numerics)
    }

    /// Constants of all elements, if such a block is valid.
    pub(super) fn constants(&self) -> Result<Constants, RockError> {
        let [nx, ny, nz] = self.cells;
        let nodes = (nx as u128 + 16) * (ny as u128 + 1) * (nz as u128 + 1);
        if self.cells.contains(&0) || nodes >= u128::from(u32::MAX) {
            return Err(RockError::Cells(nx, ny, nz));
        }
        self.numbers()
    }
}

/// A node that can be touched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceNode {
    /// Which one, for [`Block::push`].
    pub index: usize,
    /// Position, m, from the corner of the block at rest.
    pub position_m: [f64; 3],
    /// Velocity without external force, m/s.
    pub velocity_m_per_s: [f64; 3],
    /// Velocity before the rock's own forces acted on it, m/s. Those forces are the difference
    /// times mass over step.
    pub before_m_per_s: [f64; 3],
    /// Its mass, kg.
    pub mass_kg: f64,
    /// Its part of the surface with the outward direction, m², in the rock at rest.
    pub area_m2: [f64; 3],
}

/// A block of rock: elements of one rock in a grid, some of which have failed and are gone.
///
/// It is plain data. Positions are those at the last step, velocities those half a step later, as
/// central differences have them.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Block {
    pub(super) grid: Grid,
    pub(super) rock: Rock,
    pub(super) edges: [Edge; 6],
    pub(super) constants: Constants,
    pub(super) initial_stress: [f64; 6],
    layers_per_slab: usize,
    /// Depth of the first layer of nodes at rest, m.
    pub(super) top_m: f64,
    pub(super) displacement: [Vec<f64>; 3],
    pub(super) velocity: [Vec<f64>; 3],
    /// Velocity of the exposed nodes before the last step, m/s.
    pub(super) velocity_before: [Vec<f64>; 3],
    pub(super) inverse_mass: Vec<f64>,
    /// Elements left around each node.
    pub(super) around: Vec<u8>,
    pub(super) stress: [Vec<f64>; 6],
    pub(super) intact: Vec<f64>,
    /// Elements left in each group.
    pub(super) left: Vec<u8>,
    pub(super) books: Vec<RowBook>,
    /// Elements that have gone.
    pub(super) removed: usize,
    pub(super) surface: Surface,
    /// Energy that has left the block and that was supplied; the losses of rows are in their own
    /// sums.
    pub(super) energies: Energies,
    /// Follow from the rest.
    #[serde(skip)]
    slabs: Vec<Slab>,
    #[serde(skip)]
    outside: Option<Edges>,
}

/// A field of vectors at a place.
pub(super) fn at(field: &[Vec<f64>; 3], place: usize) -> [f64; 3] {
    let [x, y, z] = field;
    [x[place], y[place], z[place]]
}

impl Block {
    /// A block at rest.
    ///
    /// # Errors
    /// Numbers that no rock has, elements too large for its fracture energy, or no elements at all.
    pub fn new(spec: &BlockSpec) -> Result<Self, RockError> {
        let constants = spec.constants()?;
        let [_, ny, nz] = spec.cells;
        let grid = Grid { cells: spec.cells, size_m: spec.size_m };
        let across = -spec.confinement_Pa;
        let initial_stress = [across, across, -spec.pressure_Pa, 0.0, 0.0, 0.0];
        let zeros = || vec![0.0; grid.node_places()];
        let mut block = Self {
            grid,
            rock: spec.rock,
            edges: spec.edges,
            constants,
            initial_stress,
            layers_per_slab: spec.layers_per_slab.max(1),
            top_m: 0.0,
            displacement: [zeros(), zeros(), zeros()],
            velocity: [zeros(), zeros(), zeros()],
            velocity_before: [zeros(), zeros(), zeros()],
            inverse_mass: zeros(),
            around: vec![0; grid.node_places()],
            stress: initial_stress.map(|_| vec![0.0; grid.element_places()]),
            intact: vec![REMOVED; grid.element_places()],
            left: vec![0; grid.element_places() / GROUP],
            books: vec![RowBook::default(); ny * nz],
            removed: 0,
            surface: Surface::new(&grid, &spec.edges, |_| true),
            energies: Energies::default(),
            slabs: Vec::new(),
            outside: None,
        };
        block.fill(0);
        block.energies.entered_J = block.energies().held_J();
        Ok(block)
    }

    /// Puts fresh rock in all layers from one on.
    pub(super) fn fill(&mut self, from: usize) {
        for element in self.grid.each_element().filter(|element| element[2] >= from) {
            let place = self.grid.element(element);
            for (field, stress) in self.stress.iter_mut().zip(self.initial_stress) {
                field[place] = stress;
            }
            self.intact[place] = 1.0;
            self.left[place / GROUP] += 1;
            for corner in self.grid.corners(element) {
                self.around[corner] += 1;
            }
        }
        for place in 0..self.grid.node_places() {
            self.weigh(place);
        }
    }

    /// Mass of a node from the elements around it.
    pub(super) fn weigh(&mut self, node: usize) {
        let around = f64::from(self.around[node]);
        self.inverse_mass[node] =
            if around > 0.0 { 8.0 / (around * self.constants.mass_kg) } else { 0.0 };
    }

    /// One step: nodes drift, element forces are computed, nodes receive their impulses, failed
    /// elements are removed. Contact forces act between two steps. Returns the number of removed
    /// elements.
    pub fn step(&mut self, stepper: &Stepper, executor: &impl Executor) -> usize {
        let (grid, constants) = (self.grid, self.constants);
        let dt = constants.dt_s;
        if self.slabs.is_empty() {
            let layers = grid.cells[2];
            self.slabs = (0..layers)
                .step_by(self.layers_per_slab)
                .map(|from| Slab::new(&grid, from, (from + self.layers_per_slab).min(layers)))
                .collect();
        }
        let mut outside = self.outside.take().unwrap_or_else(|| self.make_edges());
        outside.remember(&self.velocity);
        for &node in self.surface.exposed() {
            for (velocity_before, v) in self.velocity_before.iter_mut().zip(&self.velocity) {
                velocity_before[node as usize] = v[node as usize];
            }
        }
        let fields = self.fields();
        // SAFETY: the fields are this block's, which is borrowed for the whole step.
        unsafe {
            for slab in &self.slabs {
                stepper.begin(&fields, &grid, dt, slab);
            }
            super::executor::share(executor, &mut self.slabs, |slab| {
                stepper.work(&fields, &grid, &constants, slab);
            });
            let mut above = None;
            for slab in &self.slabs {
                stepper.end(&fields, &grid, dt, slab, above);
                above = Some(slab);
            }
        }
        let work = outside.act(&mut self.velocity, &self.inverse_mass, dt);
        self.energies.edges_J += work.done_J;
        self.energies.absorbed_J += work.absorbed_J;
        self.outside = Some(outside);
        self.erode()
    }

    fn make_edges(&self) -> Edges {
        let above = [0, 1, 2].map(|axis| self.initial_stress[axis] + self.constants.pressure_Pa);
        Edges::new(&self.grid, &self.edges, above, &self.constants)
    }

    fn fields(&mut self) -> Fields {
        let ends = |[x, y, z]: &mut [Vec<f64>; 3]| [x, y, z].map(|field| field.as_mut_ptr());
        let [xx, yy, zz, xy, yz, zx] = &mut self.stress;
        Fields {
            displacement: ends(&mut self.displacement),
            velocity: ends(&mut self.velocity),
            inverse_mass: self.inverse_mass.as_ptr(),
            stress: [xx, yy, zz, xy, yz, zx].map(|field| field.as_mut_ptr()),
            intact: self.intact.as_mut_ptr(),
            left: self.left.as_ptr(),
            books: self.books.as_mut_ptr(),
        }
    }

    /// Nodes that can be touched.
    pub fn exposed(&self) -> impl Iterator<Item = SurfaceNode> + '_ {
        self.surface.exposed().iter().map(|&index| {
            let index = index as usize;
            SurfaceNode {
                index,
                position_m: self.position_m(index),
                velocity_m_per_s: at(&self.velocity, index),
                before_m_per_s: at(&self.velocity_before, index),
                mass_kg: self.mass_kg(index),
                area_m2: self.surface.area_m2(&self.grid, index),
            }
        })
    }

    /// Pushes an exposed node with a force, N, through one step; the work that was done on the
    /// block, J. All that pushes a node goes into one force.
    ///
    /// The work is the force times the mean of the node's velocities before and after, like the
    /// work of the rock's own forces. The support of a node of an outer face carries the push, and
    /// its motion stays as prescribed.
    pub fn push(&mut self, index: usize, force_N: [f64; 3]) -> f64 {
        let inverse = self.inverse_mass[index];
        let mut work_J = 0.0;
        if inverse > 0.0 {
            let dt = self.constants.dt_s;
            let held = match &self.outside {
                Some(outside) => outside.held(index),
                None => self.make_edges().held(index),
            };
            for (axis, force) in force_N.into_iter().enumerate() {
                let v = &mut self.velocity[axis][index];
                if !held[axis] {
                    *v += dt * force * inverse;
                }
                let work = force * dt * 0.5 * (self.velocity_before[axis][index] + *v);
                if held[axis] {
                    self.energies.edges_J -= work;
                }
                work_J += work;
            }
        }
        self.energies.pushed_J += work_J;
        work_J
    }

    /// Tells a node of a held face how to move, m/s.
    pub fn tell(&mut self, index: usize, velocity_m_per_s: [f64; 3]) {
        for (axis, v) in velocity_m_per_s.into_iter().enumerate() {
            self.velocity[axis][index] = v;
        }
    }

    /// Leaves an element only a part of its cohesion and tensile strength.
    pub fn weaken(&mut self, element: [usize; 3], intact: f64) {
        let intact_now = &mut self.intact[self.grid.element(element)];
        if *intact_now > 0.0 {
            *intact_now = intact.clamp(f64::MIN_POSITIVE, 1.0);
        }
    }

    /// Layers of elements that are worked on together.
    pub(super) fn layers_per_slab(&self) -> usize {
        self.layers_per_slab
    }

    /// The grid of the elements.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The rock.
    pub fn rock(&self) -> &Rock {
        &self.rock
    }

    /// Step, s.
    pub fn dt_s(&self) -> f64 {
        self.constants.dt_s
    }

    /// Divides a time, s, into the longest equal steps that are stable for the rock. Returns their
    /// number.
    pub fn share(&mut self, time_s: f64) -> usize {
        self.constants.share(time_s)
    }

    /// Depth of the first layer of nodes at rest below that of the block at first, m.
    pub fn top_m(&self) -> f64 {
        self.top_m
    }

    /// Position of a node, m.
    pub fn position_m(&self, index: usize) -> [f64; 3] {
        let ([i, j, k], [dx, dy, dz]) = (self.grid.node_at(index), self.grid.size_m);
        let [u, v, w] = at(&self.displacement, index);
        [i as f64 * dx + u, j as f64 * dy + v, self.top_m + k as f64 * dz + w]
    }

    /// Displacement of a node, m.
    pub fn displacement_m(&self, index: usize) -> [f64; 3] {
        at(&self.displacement, index)
    }

    /// Velocity of a node, m/s.
    pub fn velocity_m_per_s(&self, index: usize) -> [f64; 3] {
        at(&self.velocity, index)
    }

    /// Mass of a node, kg, scaled as the density is.
    pub fn mass_kg(&self, index: usize) -> f64 {
        f64::from(self.around[index]) * self.constants.mass_kg / 8.0
    }

    /// Kirchhoff stress of an element, Pa: xx, yy, zz, xy, yz, zx.
    pub fn stress_Pa(&self, element: [usize; 3]) -> [f64; 6] {
        let place = self.grid.element(element);
        [0, 1, 2, 3, 4, 5].map(|i| self.stress[i][place])
    }

    /// Remaining fraction of an element's cohesion, 1 to 0; none once the element is removed.
    pub fn intact(&self, element: [usize; 3]) -> Option<f64> {
        let intact = self.intact[self.grid.element(element)];
        (intact >= 0.0).then_some(intact)
    }

    /// Elements that have gone, and their volume at rest, m³.
    pub fn removed(&self) -> (usize, f64) {
        (self.removed, self.removed as f64 * self.constants.volume_m3)
    }

    /// Energies of the block.
    pub fn energies(&self) -> Energies {
        let mut energies = self.energies;
        for book in &self.books {
            energies.plastic_J += book.plastic_J;
            energies.viscous_J += book.viscous_J;
        }
        for place in 0..self.grid.node_places() {
            let v = at(&self.velocity, place);
            let square: f64 = v.iter().map(|v| v * v).sum();
            energies.kinetic_J += 0.5 * self.mass_kg(place) * square;
        }
        for element in self.grid.each_element() {
            if self.intact[self.grid.element(element)] >= 0.0 {
                let element_energies = self.element_energies(element);
                energies.elastic_J += element_energies.elastic_J;
                energies.hourglass_J += element_energies.hourglass_J;
                energies.pressure_J += element_energies.pressure_J;
            }
        }
        energies
    }

    /// Energy stored in an element, and the work of the pressure on it.
    pub(super) fn element_energies(&self, element: [usize; 3]) -> Energies {
        let c = &self.constants;
        let half = 0.5 * c.dt_s;
        let corners = self.grid.corners(element);
        let velocity = self.velocity.each_ref().map(|v| corners.map(|i| v[i]));
        let middle = [0, 1, 2].map(|axis| {
            let u = &self.displacement[axis];
            [0, 1, 2, 3, 4, 5, 6, 7].map(|c| u[corners[c]] + half * velocity[axis][c])
        });
        let (velocity, middle) = (Modes::of(velocity, c), Modes::of(middle, c));
        let motion =
            Motion::of(middle.gradient, velocity.gradient.map(|row| row.map(|x| x * half)));
        let stress = c.law.predict(self.stress_Pa(element), motion.strain);
        let hourglass: f64 = middle.hourglass.as_flattened().iter().map(|x| x * x).sum();
        Energies {
            elastic_J: c.volume_m3 * c.law.elastic_J_per_m3(stress),
            hourglass_J: 0.5 * c.hourglass * hourglass,
            pressure_J: c.pressure_Pa * c.volume_m3 * (1.0 - motion.volume),
            ..Energies::default()
        }
    }
}

//! Computes the string at rest from a model and an operation.

use super::{
    StiffError, StiffProfile, StiffSettings,
    cascade::{NotFound, from_the_middle, released, settle, warm_start},
    equations::Equations,
    equilibrium::{Convergence, Equilibrium, FinerHelix},
    mesh_error,
    snake::of_least_energy,
    state::State,
    string_in_hole::StringInHole,
};
use crate::{
    model::Model,
    operation::Operation,
    rod::mesh::Mesh,
    sizing::{Accuracy, ElementLength, SizeReason, Sizing},
    statics::{
        buckling::{self, Pushed},
        soft::{self, SoftProfile, SoftSettings},
    },
};

/// Relative change of the largest bending moment below which the mesh is fine enough, and the
/// maximum number of halvings.
const FINE_ENOUGH: [(Accuracy, f64, usize); 2] =
    [(Accuracy::Standard, 0.02, 4), (Accuracy::Fine, 0.005, 6)];

/// Largest ratio of a compression to the soft string's where the string does not run away, and the
/// maximum number of halvings for it.
const GROWS: f64 = 2.0;
const HALVED: usize = 3;

/// Multiple of the helical load beyond which no search is made for a string that locks up by the
/// wall load of its helix: none of those in a thousand random wells has a stable equilibrium.
const FAR_BEYOND: f64 = 25.0;

/// Maximum number of updates of the elements that are on the wall.
const HANGS: usize = 4;

/// Steps of the initial soft string, m: it determines the positions of the nodes, and no force
/// follows from it.
const SOFT: SoftSettings = SoftSettings { step_m: 4.0, helix_side_force: false };

/// Computes torque and drag of one operation by the stiff string.
///
/// # Errors
/// Those of the [soft string](crate::statics::soft::solve), with which the solution begins, and an
/// equilibrium that was not found.
pub fn solve(
    model: &Model,
    operation: &Operation,
    settings: &StiffSettings,
) -> Result<StiffProfile, StiffError> {
    let equilibrium = equilibrium(model, operation, settings)?;
    Ok(StiffProfile::new(model, operation, &equilibrium))
}

/// The same on a given mesh, of the whole string or of its lower end alone, whose top then is on
/// the hole's axis. `soft` is the soft string of the operation.
///
/// # Errors
/// An equilibrium that was not found.
pub(crate) fn solve_on(
    model: &Model,
    operation: &Operation,
    settings: &StiffSettings,
    soft: &SoftProfile,
    mesh: Mesh,
) -> Result<StiffProfile, StiffError> {
    let found = Task { model, operation, settings, soft }.found(mesh, None)?;
    let equilibrium = found.within_its_hole()?;
    Ok(StiffProfile::new(model, operation, &equilibrium))
}

/// Computes the string at rest in one operation.
///
/// # Errors
/// As of [`solve`].
pub fn equilibrium(
    model: &Model,
    operation: &Operation,
    settings: &StiffSettings,
) -> Result<Equilibrium, StiffError> {
    let soft = soft::solve(model, operation, &SOFT)?;
    let task = Task { model, operation, settings, soft: &soft };
    task.on_finer_helix(task.refine(task.found(task.mesh()?, None)?)).within_its_hole()
}

/// Computes the string at rest from that of a neighbouring friction, load or depth (a warm start),
/// which is faster, and leads to the same result where there is only one equilibrium. Where it does
/// not converge, the solution starts again. A string of the same length and settings keeps the
/// neighbour's mesh and its error.
///
/// # Errors
/// As of [`solve`].
pub fn equilibrium_near(
    model: &Model,
    operation: &Operation,
    settings: &StiffSettings,
    near: &Equilibrium,
) -> Result<Equilibrium, StiffError> {
    let soft = soft::solve(model, operation, &SOFT)?;
    let task = Task { model, operation, settings, soft: &soft };
    if !near.is_like(model, settings) {
        let found = task.refine(task.found(task.mesh()?, Some(near))?);
        return task.on_finer_helix(found).within_its_hole();
    }
    // Refined for the neighbour: a mesh refined from one to the next would grow without limit.
    let mut found = task.found(near.mesh.clone(), Some(near))?;
    found.convergence.mesh_error = near.convergence.mesh_error;
    task.on_finer_helix(found).within_its_hole()
}

/// Computes the string at rest from that of a neighbouring friction, load or depth on the
/// neighbour's mesh, and from a cold start on its own mesh where that leads to no stable
/// equilibrium.
///
/// As [`equilibrium_near`], but a neighbour that does not help costs little, because no search is
/// made on a mesh that was made for another load.
///
/// # Errors
/// As of [`solve`].
pub fn equilibrium_beside(
    model: &Model,
    operation: &Operation,
    settings: &StiffSettings,
    near: &Equilibrium,
) -> Result<Equilibrium, StiffError> {
    let soft = soft::solve(model, operation, &SOFT)?;
    let task = Task { model, operation, settings, soft: &soft };
    if near.is_like(model, settings)
        && let Some(mut found) = task.found_beside(near)
    {
        found.convergence.mesh_error = near.convergence.mesh_error;
        return task.on_finer_helix(found).within_its_hole();
    }
    task.on_finer_helix(task.refine(task.found(task.mesh()?, None)?)).within_its_hole()
}

/// A string to be solved.
struct Task<'a> {
    model: &'a Model,
    operation: &'a Operation,
    settings: &'a StiffSettings,
    soft: &'a SoftProfile,
}

impl Task<'_> {
    /// The initial mesh, before the contacts of the string are known.
    fn mesh(&self) -> Result<Mesh, StiffError> {
        let sizing = match self.settings.element_length {
            ElementLength::Uniform(length_m) => Sizing::uniform(length_m),
            ElementLength::Auto(accuracy) => {
                Sizing::auto(self.model, &[*self.operation], accuracy)?
            }
        };
        Ok(Mesh::new(&self.model.string, &sizing.refined(self.settings.refinement)))
    }

    /// The equilibrium on a mesh, from another one where it is given, and from the middle of the
    /// hole where that does not converge.
    fn found(&self, mesh: Mesh, near: Option<&Equilibrium>) -> Result<Equilibrium, StiffError> {
        let mut string = self.string_in_hole(&mesh);
        let mut equations = Equations::new(string.nodes.len());
        let mut iterations = 0;
        let warm = near.and_then(|near| {
            let carried = near.carried_to(&string, &mesh);
            string.hang(|node| carried.normal_N[node] > 0.0);
            warm_start(&string, carried, &mut equations, &mut iterations)
        });
        let (convergence, state) = match warm {
            Some(found) => found,
            None => {
                string.hang(|_| true);
                if self.is_far_beyond() {
                    self.locks_up()?;
                }
                match from_the_middle(&string, &mut equations, iterations) {
                    Ok(found) => found,
                    Err(lost) => {
                        self.locks_up()?;
                        return self.found_finer(mesh, &string, lost);
                    }
                }
            }
        };
        let found = self.equilibrium(mesh, string, state, &mut equations, convergence);
        Ok(of_least_energy(found, &mut equations))
    }

    /// The same where the compression grew beyond that of the soft string, by which the mesh was
    /// made, and elements buckled between their nodes: on a mesh for the larger compression.
    fn found_finer(
        &self,
        mut mesh: Mesh,
        string: &StringInHole,
        lost: NotFound,
    ) -> Result<Equilibrium, StiffError> {
        let Some(buckles) = mesh_error::buckles(string, &lost.tension_N) else {
            return Err(lost.error);
        };
        let most_N = string.elements.iter().map(|element| -element.guess_N).fold(0.0, f64::max);
        let compression_N = -lost.tension_N[buckles];
        if let ElementLength::Uniform(_) = self.settings.element_length {
            let md_m = string.nodes[buckles].md_m;
            let length_m = string.elements[buckles].stiffness.length;
            return Err(StiffError::ElementBuckles { md_m, compression_N, length_m });
        }
        for _ in 0..HALVED {
            let at_most_N = compression_N.min(GROWS * most_N);
            let long = mesh_error::too_long(&self.string_in_hole(&mesh), at_most_N);
            if !long.contains(&true) {
                break;
            }
            mesh = mesh.halved(&self.model.string, &long, SizeReason::Compression);
        }
        let string = self.string_in_hole(&mesh);
        let mut equations = Equations::new(string.nodes.len());
        let (convergence, state) = released(&string, &mut equations).map_err(|lost| lost.error)?;
        let found = self.equilibrium(mesh, string, state, &mut equations, convergence);
        Ok(of_least_energy(found, &mut equations))
    }

    /// The same from another equilibrium alone.
    fn found_near(&self, mesh: Mesh, near: &Equilibrium) -> Option<Equilibrium> {
        let mut string = self.string_in_hole(&mesh);
        let mut equations = Equations::new(string.nodes.len());
        let carried = near.carried_to(&string, &mesh);
        string.hang(|node| carried.normal_N[node] > 0.0);
        let (convergence, state) = warm_start(&string, carried, &mut equations, &mut 0)?;
        Some(self.equilibrium(mesh, string, state, &mut equations, convergence))
    }

    /// The same on the mesh of the other one, and only where it is so near that few contacts
    /// change.
    fn found_beside(&self, near: &Equilibrium) -> Option<Equilibrium> {
        let mesh = near.mesh.clone();
        let mut string = self.string_in_hole(&mesh);
        let mut equations = Equations::new(string.nodes.len());
        let carried = near.carried_to(&string, &mesh);
        string.hang(|node| carried.normal_N[node] > 0.0);
        let (convergence, state) = settle(&string, carried, &mut equations, &mut 0)?;
        let found = self.equilibrium(mesh, string, state, &mut equations, convergence);
        Some(of_least_energy(found, &mut equations))
    }

    fn string_in_hole(&self, mesh: &Mesh) -> StringInHole {
        StringInHole::new(self.model, self.operation, self.settings, mesh, self.soft)
    }

    fn equilibrium(
        &self,
        mesh: Mesh,
        mut string: StringInHole,
        mut state: State,
        equations: &mut Equations,
        mut convergence: Convergence,
    ) -> Equilibrium {
        let mut hook_load_N = equations.hook_load_N;
        // The weight between nodes turns the nodes of hanging elements only.
        for _ in 0..HANGS {
            let mut next = string.clone();
            if !next.hang(|node| state.normal_N[node] > 0.0) {
                break;
            }
            let mut iterations = convergence.iterations;
            let settled = settle(&next, state.clone(), equations, &mut iterations);
            let Some((settled, moved)) = settled else { break };
            hook_load_N = equations.hook_load_N;
            (convergence, state, string) = (settled, moved, next);
        }
        let settings = *self.settings;
        let found = Equilibrium { settings, mesh, string, state, hook_load_N, convergence };
        found.with_buckled_element()
    }

    /// Whether the compression of the soft string exceeds its helical load so far that no search is
    /// made where it [locks up](Self::locks_up).
    fn is_far_beyond(&self) -> bool {
        let loads_N = self.soft.tension_N.iter().zip(&self.soft.helical_load_N);
        loads_N.into_iter().any(|(tension_N, load_N)| {
            load_N.is_some_and(|load_N| -tension_N > FAR_BEYOND * load_N)
        })
    }

    /// Returns an error where the string cannot be pushed that far by the wall load of its helix,
    /// so that there is no equilibrium.
    fn locks_up(&self) -> Result<(), StiffError> {
        if !self.operation.slides_down() {
            return Ok(());
        }
        let segments = buckling::segments(self.model, self.operation, &self.soft.md_m);
        let weight_N = self.operation.weight_on_bit_now_N();
        match buckling::push_through(&segments, weight_N, self.model.buckling) {
            Pushed::LocksUp(above_bit_m) => {
                Err(StiffError::LocksUp { md_m: self.operation.bit_depth_m - above_bit_m })
            }
            Pushed::Through(_) => Ok(()),
        }
    }

    /// The same with the answer on a mesh whose elements are half as long where the string is
    /// compressed, if it is pushed down as a helix: from a cold start, as another choice of lengths
    /// would find it.
    fn on_finer_helix(&self, mut found: Equilibrium) -> Equilibrium {
        if !self.operation.slides_down() {
            return found;
        }
        let in_helix = found.compressed_beyond(|md_m| {
            let row = self.soft.md_m.partition_point(|depth| *depth < md_m);
            *self.soft.helical_load_N.get(row)?
        });
        if in_helix.contains(&true) {
            let long = found.compressed_beyond(|_| Some(0.0));
            let mesh = found.mesh.halved(&self.model.string, &long, SizeReason::Refined);
            let finer = self.found(mesh, None).ok();
            let hook_load_N = finer.map(|finer| finer.hook_load_N);
            found.convergence.finer_helix = Some(FinerHelix { hook_load_N });
        }
        found
    }

    /// Halves the elements that are too long, as long as that changes the bending.
    fn refine(&self, mut found: Equilibrium) -> Equilibrium {
        let ElementLength::Auto(accuracy) = self.settings.element_length else { return found };
        let row = FINE_ENOUGH.iter().find(|(level, ..)| *level == accuracy);
        let Some((_, tolerance, rounds)) = row else { return found };
        for _ in 0..*rounds {
            let long = found.too_long(*tolerance);
            if !long.contains(&true) {
                break;
            }
            let string = &self.model.string;
            let mesh = found.mesh.halved(string, &long, SizeReason::Refined);
            let Some(mut finer) = self.found_near(mesh, &found) else { break };
            let error = finer.change_since(&found);
            finer.convergence.iterations += found.convergence.iterations;
            finer.convergence.mesh_error = Some(error);
            let largest_N_m = finer.largest_moment_N_m();
            found = finer;
            if error.bending_moment_N_m < tolerance * largest_N_m
                && !found.any_unresolved(*tolerance)
            {
                break;
            }
        }
        found
    }
}

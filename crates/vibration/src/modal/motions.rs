//! Small motions about the string at rest.

use nalgebra::{Complex, Matrix3, Vector3};
use wholestring::{
    dynamics::{DynamicsSettings, levers_kg_m},
    model::Model,
    operation::Operation,
    rod::in_fluid,
    statics::stiff::{self, AtRest, StiffSettings},
    string::BodySection,
};

use super::{
    ModalError,
    chain::Chain,
    factors::MOTIONS,
    family::{self, Family},
    mode::{Mode, Place, energy, farthest, precession},
    pull::{self, Bend},
    search::{self, RealMode},
    whirl::Turning,
};
use crate::complex;

/// Modes at rest beyond those that are wanted which a rotating string's are made of.
const BEYOND: usize = 6;

/// Small motions about the string at rest.
///
/// Nodes that touch the wall are held by how it gives way along the normal, and by contact force
/// over radius around the hole; nodes that do not touch are free. Friction does not hold: a string
/// that rotates slides.
#[derive(Debug, Clone)]
pub struct SmallMotions {
    pub(super) rest: AtRest,
    pub(super) chain: Chain,
    /// The chain of which the tool face has no energy: of a string that rotates, or is not bent,
    /// `chain` itself.
    averaged: Chain,
    pub(super) rotary_rad_per_s: f64,
    pub(super) dynamics: DynamicsSettings,
    /// Imbalance of each node, kg·m, towards the high side and to the right of it.
    pub(super) levers_kg_m: Vec<[f64; 2]>,
    /// Drag of the mud across each node: N·s/m, and N·s²/m².
    pub(super) drag: Vec<[f64; 2]>,
    /// The component of each element, and the inverse of its section modulus, 1/m³.
    pub(super) bodies: Vec<(String, f64)>,
}

impl SmallMotions {
    /// About the string of one operation at rest. The mesh, the wall and the ends are those of
    /// `settings`, hoist, rock and damping the dynamics'.
    ///
    /// # Errors
    /// Where the string has no state at rest.
    pub fn new(
        model: &Model,
        operation: &Operation,
        settings: &StiffSettings,
        dynamics: &DynamicsSettings,
    ) -> Result<Self, ModalError> {
        // As in the dynamics: on long elements the fixed-end moments of the weight would turn with the
        // twist, which lowers its frequencies.
        let settings = StiffSettings { lumped_weight: true, ..*settings };
        let rest = stiff::at_rest(model, operation, &settings)?;
        let pull = |bend| pull::chain(model, operation, dynamics, &rest, bend);
        let averaged = pull(Bend::AveragedOverATurn);
        let chain = if operation.kind.rotates() || !pull::has_bend(&rest) {
            averaged.clone()
        } else {
            pull(Bend::AtItsToolFace)
        };
        let mud = &model.mud;
        let in_fluid = in_fluid::along(model, &rest.mesh);
        let mut drag = vec![[0.0; 2]; rest.nodes.len()];
        let mut bodies = Vec::with_capacity(rest.elements.len());
        for (index, element) in rest.mesh.elements.iter().enumerate() {
            let half_m = 0.5 * element.length_m;
            let quadratic = 0.5
                * in_fluid[index].densities.annulus_kg_per_m3
                * mud.drag_coefficient
                * element.section.od_m;
            for end in &mut drag[index..=index + 1] {
                end[0] += half_m * mud.linear_drag_Pa_s;
                end[1] += half_m * quadratic;
            }
            let middle_m = rest.mesh.nodes[index].from_bit_m - half_m;
            let (_, component) = model.string.component_at(middle_m);
            bodies.push((component.name.clone(), BodySection::of(component).per_modulus_m3));
        }
        Ok(Self {
            levers_kg_m: levers_kg_m(model, &rest.mesh),
            rotary_rad_per_s: operation.rotation_rad_per_s(),
            dynamics: dynamics.clone(),
            chain,
            averaged,
            rest,
            drag,
            bodies,
        })
    }

    /// Nodes of the string.
    pub fn nodes(&self) -> usize {
        self.rest.nodes.len()
    }

    /// Measured depth of a node, from the top down, m.
    pub fn md_m(&self, node: usize) -> f64 {
        self.rest.nodes[node].md_m
    }

    /// Whether a node touches the wall.
    pub fn touches(&self, node: usize) -> bool {
        self.rest.nodes[node].normal_N > 0.0
    }

    /// Rotary speed of the operation, rad/s.
    pub fn rotary_rad_per_s(&self) -> f64 {
        self.rotary_rad_per_s
    }

    /// Whether every small motion costs energy, friction and torque apart.
    pub fn is_stable(&self) -> bool {
        self.keeps_its_shape() && !self.leaves_its_tool_face()
    }

    /// Whether every small motion costs energy that leaves the tool face as it is.
    pub fn keeps_its_shape(&self) -> bool {
        self.rest.stable
    }

    /// Whether anything of the string is eccentric.
    pub fn is_eccentric(&self) -> bool {
        self.levers_kg_m.iter().flatten().any(|lever| *lever != 0.0)
    }

    /// Natural frequencies below one, Hz, at the operation's rotary speed.
    pub fn count_below(&self, frequency_Hz: f64) -> usize {
        let omega = std::f64::consts::TAU * frequency_Hz;
        self.chain.count_below(omega, self.rotary_rad_per_s)
    }

    /// So many modes of any family from a frequency on, Hz, at the operation's rotary speed.
    ///
    /// # Errors
    /// Where they were not all found.
    pub fn modes(&self, from_Hz: f64, count: usize) -> Result<Vec<Mode>, ModalError> {
        self.turning_modes(&self.chain, from_Hz, count, self.rotary_rad_per_s)
    }

    /// Whether a bent string that does not rotate would turn away from its tool face, friction
    /// apart: a motion that has a restoring force where its tool face has no energy has none at
    /// this one.
    pub fn leaves_its_tool_face(&self) -> bool {
        let without_restoring = |chain: &Chain| chain.shifted(family::least_lambda()).negative;
        without_restoring(&self.chain) > without_restoring(&self.averaged)
    }

    /// The first modes of the axial or the torsional family that vibrate: a motion of less than
    /// 0.001 Hz or without restoring force is none of them. Rotation does not change them: its
    /// coupling is lateral.
    ///
    /// # Errors
    /// Where one of them was not found.
    ///
    /// # Panics
    /// Of the lateral family, which an [assembly](super::Assembly) has.
    pub fn family(&self, family: Family, count: usize) -> Result<Vec<Mode>, ModalError> {
        assert_ne!(family, Family::Lateral, "an assembly's");
        let found = family::modes(&self.chain, &self.averaged, family, count);
        let required = count.min(family::count(&self.chain, family) - found.others);
        let found = found.vibrating;
        if found.len() < required {
            return Err(ModalError::Lost {
                family: family.name(),
                count: required,
                found: found.len(),
            });
        }
        // A mode that shares its energy with lateral motion is of the family that it was found
        // from.
        Ok(found.iter().map(|mode| Mode { family, ..self.real(mode) }).collect())
    }

    fn real(&self, mode: &RealMode) -> Mode {
        let motion: Vec<Complex<f64>> = mode.motion.iter().map(|x| Complex::new(*x, 0.0)).collect();
        self.mode(&self.chain, mode.lambda.max(0.0).sqrt(), &motion, 0)
    }

    pub(super) fn turning_modes(
        &self,
        chain: &Chain,
        from_Hz: f64,
        count: usize,
        rotary_rad_per_s: f64,
    ) -> Result<Vec<Mode>, ModalError> {
        let omega = std::f64::consts::TAU * from_Hz;
        let incomplete = ModalError::Incomplete { count, from_Hz };
        let beyond = if rotary_rad_per_s == 0.0 { 0 } else { BEYOND };
        let rest = search::above(chain, omega, count + beyond).ok_or(incomplete)?;
        let turning = Turning::new(chain, &rest).at(rotary_rad_per_s);
        let modes = turning.iter().take(count);
        Ok(modes.map(|mode| self.mode(chain, mode.omega, &motion(&rest, &mode.parts), 0)).collect())
    }

    /// A mode of a chain that ends where the string does.
    pub(super) fn mode(
        &self,
        chain: &Chain,
        omega: f64,
        motion: &[Complex<f64>],
        assembly: usize,
    ) -> Mode {
        let first = self.nodes() - chain.nodes();
        let (energy, in_assembly) = energy(chain, motion, assembly.saturating_sub(first));
        let most = energy.iter().copied().fold(0.0, f64::max);
        let family = Family::ALL.into_iter().zip(energy).find(|(_, part)| *part == most);
        let family = family.map_or(Family::Lateral, |(family, _)| family);
        let mut shape = vec![[Complex::new(0.0, 0.0); MOTIONS]; self.nodes()];
        for (node, own) in motion.chunks_exact(MOTIONS).enumerate() {
            shape[first + node] = self.towards_high_side(own);
        }
        let size = |amplitudes: &[Complex<f64>; MOTIONS]| match family {
            Family::Torsional => complex::norm(amplitudes[5]),
            Family::Axial => complex::norm(amplitudes[2]),
            Family::Lateral => farthest(amplitudes[0], amplitudes[1]),
        };
        // In phase with the node that moves most.
        let largest = shape.iter().max_by(|a, b| size(a).total_cmp(&size(b)));
        let scale = largest.map_or(Complex::new(1.0, 0.0), |largest| {
            let lead = match family {
                Family::Torsional => largest[5],
                Family::Axial => largest[2],
                Family::Lateral if complex::norm(largest[0]) >= complex::norm(largest[1]) => {
                    largest[0]
                }
                Family::Lateral => largest[1],
            };
            lead.conj()
                / complex::norm(lead).max(f64::MIN_POSITIVE)
                / size(largest).max(f64::MIN_POSITIVE)
        });
        shape.iter_mut().flatten().for_each(|x| *x *= scale);
        let element = match family {
            Family::Lateral => self.most_bent(first, motion).0,
            Family::Axial => self.most_sheared(first, motion, 2),
            Family::Torsional => self.most_sheared(first, motion, 5),
        };
        Mode {
            frequency_Hz: omega / std::f64::consts::TAU,
            family,
            energy,
            in_assembly,
            precession: precession(chain, motion),
            most_strained: self.place(element),
            shape,
        }
    }

    /// A node's motion in the directions that people know.
    fn towards_high_side(&self, own: &[Complex<f64>]) -> [Complex<f64>; MOTIONS] {
        let (sine, cosine) = libm::sincos(self.rest.high_side_rad);
        let turn =
            |x: Complex<f64>, y: Complex<f64>| [x * cosine + y * sine, y * cosine - x * sine];
        let ([x, y], [tilt_x, tilt_y]) = (turn(own[0], own[1]), turn(own[3], own[4]));
        [x, y, own[2], tilt_x, tilt_y, own[5]]
    }

    /// The element that a motion of the nodes from `first` on bends most, and its bending stress,
    /// Pa.
    pub(super) fn most_bent(&self, first: usize, motion: &[Complex<f64>]) -> (usize, f64) {
        let nodes = motion.len() / MOTIONS;
        let turn = |node: usize| {
            let axes = Matrix3::from_columns(&self.rest.nodes[first + node].frame);
            // The motion that bends it: the rotation about its own axis does not.
            let motion = |k: usize| motion[node * MOTIONS + k];
            let part = |complex: fn(Complex<f64>) -> f64, a: Complex<f64>, b: Complex<f64>| {
                axes * Vector3::new(complex(a), complex(b), 0.0)
            };
            let (a, b) = (motion(3), motion(4));
            [part(|x| x.re, a, b), part(|x| x.im, a, b)]
        };
        let stress = |node: usize| {
            let (above, below) = (turn(node), turn(node + 1));
            let [re, im] = [below[0] - above[0], below[1] - above[1]];
            // The long half axis of the ellipse that the bend goes round.
            let (square, mixed) = (re.dot(&re) + im.dot(&im), re.dot(&im));
            let skew = libm::hypot(re.dot(&re) - im.dot(&im), 2.0 * mixed);
            let angle = (0.5 * (square + skew)).sqrt();
            let element = first + node;
            angle * self.rest.elements[element].stiffness.bending * self.bodies[element].1
        };
        let elements = (0..nodes - 1).map(|node| (first + node, stress(node)));
        elements.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((first, 0.0))
    }

    /// The element that a motion along the hole (2) or about the axis (5) strains most.
    fn most_sheared(&self, first: usize, motion: &[Complex<f64>], k: usize) -> usize {
        let strain = |node: usize| {
            let apart = motion[(node + 1) * MOTIONS + k] - motion[node * MOTIONS + k];
            let mesh = &self.rest.mesh.elements[first + node];
            // The surface of a thicker body turns farther.
            let radius_m = if k == 5 { 0.5 * mesh.section.od_m } else { 1.0 };
            complex::norm(apart) * radius_m / mesh.length_m
        };
        let nodes = motion.len() / MOTIONS;
        let most = (0..nodes - 1).max_by(|a, b| strain(*a).total_cmp(&strain(*b)));
        first + most.unwrap_or(0)
    }

    /// The middle of an element.
    pub(super) fn place(&self, element: usize) -> Place {
        let at = &self.rest.mesh.nodes;
        let middle_m = 0.5 * (at[element].from_bit_m + at[element + 1].from_bit_m);
        Place {
            md_m: 0.5 * (self.md_m(element) + self.md_m(element + 1)),
            from_bit_m: middle_m,
            component: self.bodies[element].0.clone(),
        }
    }
}

/// A motion made of modes.
pub(super) fn motion(modes: &[RealMode], parts: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let mut sum = vec![Complex::new(0.0, 0.0); modes.first().map_or(0, |mode| mode.motion.len())];
    for (mode, part) in modes.iter().zip(parts) {
        for (x, own) in sum.iter_mut().zip(&mode.motion) {
            *x += part * *own;
        }
    }
    sum
}

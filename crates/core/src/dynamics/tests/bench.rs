//! A straight vertical rod, weightless in air, that a test supports and loads as it likes.

use crate::{
    common::{self, arcs, mud, open_hole},
    dynamics::{
        assemble::chain,
        body::Body,
        kernel::{
            chain::{Chain, node},
            places::Border,
            step::{Abilities, Laws, MassDamping, StepInput, StepLosses, Stepper},
        },
    },
    model::Model,
    mud::Mud,
    rod::{
        element::Stiffness,
        mesh::Mesh,
        section::Section,
        stability::{self, StepPlan, Subcycling},
    },
    simd::vector::Vector,
    string::{ComponentLength, ComponentSpec, Material},
};

/// The steel of D09 and D10.
pub const STEEL: Material = Material {
    density_kg_per_m3: 7850.0,
    youngs_modulus_Pa: 206.84e9,
    shear_modulus_Pa: 79.3e9,
    ..Material::STEEL
};

const AIR: Mud = mud(0.0);

/// Their pipe: outside and inside diameter, m.
pub const PIPE_M: [f64; 2] = [0.127, 0.1086];

/// Their collar.
pub const COLLAR_M: [f64; 2] = [0.1715, 0.0714];

/// Constraints of a node.
#[derive(Clone, Copy)]
pub struct Support {
    pub axial: bool,
    pub lateral: bool,
    pub tilt: bool,
    pub spin: bool,
}

impl Support {
    pub const FREE: Self = Self { axial: true, lateral: true, tilt: true, spin: true };
    pub const PINNED: Self = Self { axial: false, lateral: false, tilt: true, spin: false };
    pub const ROLLER: Self = Self { axial: true, ..Self::PINNED };
    pub const CLAMPED: Self = Self { axial: false, lateral: false, tilt: false, spin: false };
}

/// The rod.
pub struct Bench {
    pub chain: Chain,
    pub mesh: Mesh,
    pub plan: StepPlan,
    pub input: StepInput,
    /// Mass-proportional damping to rest, 1/s: none, unless the test sets it.
    pub mass_damping_per_s: f64,
    /// Bends and eccentric masses that turn with the rod: none, unless the test adds them. Bends
    /// are all there from the start.
    pub body: Body,
    pub model: Model,
    stepper: Stepper,
}

impl Bench {
    /// A rod of `parts` (outside and inside diameter, length, m) from the lower end up, free at
    /// both ends and at rest, in air.
    pub fn new(parts: &[([f64; 2], f64)], element_length_m: f64, stiffness_damping_s: f64) -> Self {
        Self::in_mud(parts, element_length_m, stiffness_damping_s, AIR, 2.0)
    }

    /// The same full of `mud` and in it, in a hole of a diameter.
    pub fn in_mud(
        parts: &[([f64; 2], f64)],
        element_length_m: f64,
        stiffness_damping_s: f64,
        mud: Mud,
        hole_m: f64,
    ) -> Self {
        let parts: Vec<_> = parts.iter().map(|&(pipe, length)| (pipe, length, STEEL)).collect();
        Self::made_of(&parts, element_length_m, stiffness_damping_s, mud, hole_m)
    }

    /// A rod in air of parts that have their own metals, undamped.
    pub fn of(parts: &[([f64; 2], f64, Material)], element_length_m: f64) -> Self {
        Self::made_of(parts, element_length_m, 0.0, AIR, 2.0)
    }

    fn made_of(
        parts: &[([f64; 2], f64, Material)],
        element_length_m: f64,
        stiffness_damping_s: f64,
        mud: Mud,
        hole_m: f64,
    ) -> Self {
        let length_m: f64 = parts.iter().map(|(_, length, _)| length).sum();
        let components = parts
            .iter()
            .map(|&([od, id], length, metal)| {
                ComponentSpec::uniform("rod", od, id, ComponentLength::Metres(length), metal)
            })
            .collect();
        let path = arcs(&[[0.0; 3], [length_m, 0.0, 0.0]]);
        let hole = open_hole(hole_m, 0.0, length_m);
        let model = common::model(path, hole, components, mud, length_m);
        let mesh = Mesh::uniform(&model.string, element_length_m);
        let lateral = chain::lateral_mass_kg_per_m(&model, &mesh, length_m);
        let plan = stability::plan(&mesh, &lateral, stiffness_damping_s);
        Self::of_mesh(model, mesh, plan, stiffness_damping_s)
    }

    /// The string of `model` on a ready mesh, with the steps and the inertia of a plan.
    pub fn of_mesh(model: Model, mesh: Mesh, plan: StepPlan, stiffness_damping_s: f64) -> Self {
        let mut chain = chain::chain(&model, &mesh, &plan);
        for index in 0..chain.elements() {
            chain.set_anchor_chord(index, Vector(0.0, 0.0, mesh.elements[index].length_m));
        }
        for index in 0..chain.nodes() {
            chain.set_weight(index, Vector::zero());
        }
        let input = StepInput {
            dt: plan.dt_s,
            stiffness_damping: stiffness_damping_s,
            dissipation: 0.0,
            stribeck_speed: 0.1,
        };
        let full = model.mud.rheology.is_some();
        let mut bench = Self {
            model,
            chain,
            mesh,
            plan,
            input,
            mass_damping_per_s: 0.0,
            body: Body::default(),
            stepper: Stepper::new(Abilities { laws: Laws { hertz: true, vector: true }, full }),
        };
        bench.support(0, Support::FREE);
        bench
    }

    /// The same rod in the regions of its plan.
    pub fn divided(mut self) -> Self {
        let border = |s: Subcycling| Border { node: s.border_node, parts: s.parts };
        self.chain = self.chain.divided_at(self.plan.subcycling.map(border));
        self
    }

    /// A free rod of `parts` elements of one section, whose `steel_kg_per_m` and
    /// `polar_inertia_kg_m` it has, and a moment of inertia of its sections across the axis per
    /// length, kg·m: as it is, nothing added. It takes `0.9` of the longest stable step.
    pub fn of_section(section: &Section, rotary_kg_m: f64, length_m: f64, parts: usize) -> Self {
        let mut bench = Self::new(&[(PIPE_M, length_m)], length_m / parts as f64, 0.0);
        assert_eq!(bench.chain.elements(), parts);
        let length = length_m / parts as f64;
        let k = Stiffness::new(section, length);
        let inertia = stability::ElementInertia {
            axial_kg: section.steel_kg_per_m * length,
            lateral_kg: section.steel_kg_per_m * length,
            polar_kg_m2: section.polar_inertia_kg_m * length,
            rotary_kg_m2: 0.5 * rotary_kg_m * length,
        };
        bench.plan.inertia = vec![inertia; parts];
        for element in &mut bench.mesh.elements {
            element.section = *section;
        }
        for i in 0..=parts {
            let chain = &mut bench.chain;
            let ends = if i == 0 || i == parts { 0.5 } else { 1.0 };
            node!(chain, i, mass_axial = ends * inertia.axial_kg);
            node!(chain, i, mass_lateral = ends * inertia.lateral_kg);
            node!(chain, i, polar = ends * inertia.polar_kg_m2);
            if i < parts {
                chain.set_stiffness(i, &k);
            }
            bench.support(i, Support::FREE);
        }
        let (near, far, rotary) = (k.bending_near(), k.bending_far, inertia.rotary_kg_m2);
        let chord = 4.0 / (length * length * inertia.lateral_kg);
        let square = [
            4.0 * k.axial / inertia.axial_kg,
            4.0 * k.twist / inertia.polar_kg_m2,
            2.0 * (near + far) * (0.5 / rotary + chord),
            (near - far) / rotary,
        ];
        bench.input.dt = 1.8 / square.into_iter().fold(0.0, f64::max).sqrt();
        bench
    }

    /// Moment of inertia of a node across its director, kg·m².
    pub fn rotary_kg_m2(&self, index: usize) -> f64 {
        let inertia =
            |element: Option<&stability::ElementInertia>| element.map_or(0.0, |e| e.rotary_kg_m2);
        let above = index.checked_sub(1).and_then(|i| self.plan.inertia.get(i));
        inertia(above) + inertia(self.plan.inertia.get(index))
    }

    /// Lets a node move so and not otherwise.
    pub fn support(&mut self, index: usize, support: Support) {
        let rotary = self.rotary_kg_m2(index);
        let inverse = |free: bool, inertia: f64| if free { 1.0 / inertia } else { 0.0 };
        let chain = &mut self.chain;
        node!(
            chain,
            index,
            inv_mass_axial = inverse(support.axial, node!(chain, index, mass_axial))
        );
        node!(
            chain,
            index,
            inv_mass_lateral = inverse(support.lateral, node!(chain, index, mass_lateral))
        );
        node!(chain, index, inv_polar = inverse(support.spin, node!(chain, index, polar)));
        node!(chain, index, inv_rotary = inverse(support.tilt, rotary));
        node!(
            chain,
            index,
            gyroscopic = if support.tilt { node!(chain, index, polar) / rotary } else { 0.0 }
        );
    }

    /// Distance of a node from the upper end of the unloaded rod, m.
    pub fn z_m(&self, index: usize) -> f64 {
        self.mesh.length_m() - self.mesh.nodes[index].from_bit_m
    }

    /// Takes a step; returns the losses of the rod.
    pub fn step(&mut self) -> StepLosses {
        self.chain.find_drag(self.input.dt);
        let before = self.body.push(&mut self.chain, &self.input, 1.0);
        let mut losses = self.stepper.step(&mut self.chain, &self.input);
        let after = self.body.follow(&mut self.chain, &self.input);
        losses.damping += before.damping_loss_J;
        losses.mud += after.mud_loss_J;
        let time_s = self.input.dt;
        let mass_damping = MassDamping {
            time_s,
            dt: self.input.dt,
            left: (-self.mass_damping_per_s * time_s).exp(),
            rigid_velocity: 0.0,
            rigid_spin: 0.0,
        };
        losses.mud += self.stepper.damp(&mut self.chain, &mass_damping);
        losses
    }

    /// Frequency, Hz, of the values of `measure`: over `periods` from their first zero. Zeros are
    /// interpolated between steps, of which a period has thousands.
    pub fn frequency_Hz(&mut self, periods: usize, measure: impl Fn(&Self) -> f64) -> f64 {
        let mut zeros = Vec::new();
        let mut before = measure(self);
        let mut step = 0u32;
        while zeros.len() < 2 * periods + 1 {
            self.step();
            step += 1;
            assert!(step < 4_000_000, "it does not swing");
            let now = measure(self);
            if before * now < 0.0 {
                zeros.push((f64::from(step) - now / (now - before)) * self.input.dt);
            }
            before = now;
        }
        periods as f64 / (zeros[2 * periods] - zeros[0])
    }
}

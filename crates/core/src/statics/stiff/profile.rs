//! Results of the stiff string.

use std::ops::Deref;

use serde::{Deserialize, Serialize};

use super::{
    axis::StringAxis,
    bending::Bending,
    contact,
    equations::Equations,
    equilibrium::{Convergence, Equilibrium},
    state::State,
    string_in_hole::StringInHole,
};
use crate::{
    ends::BitEnd,
    finite,
    model::Model,
    mud::{Densities, Hydraulics},
    operation::Operation,
    outcome::{
        HOLE_STEP_M, HoleWear, Profile, Scalars, cutoff_in_build_m, hole_depths_m, hole_steps,
        neutral_point_m, spread,
    },
    rod::{
        contact_length,
        in_fluid::{HolePlace, free_elongation_m},
        mesh::Mesh,
    },
    statics::buckling::Place,
    string::BodySection,
};

/// Results of the stiff string: loads along the string, from the surface to the bit, and their
/// scalars.
///
/// The columns of its profile are available as its own: `stiff.tension_N`.
#[derive(Debug, Clone, PartialEq)]
pub struct StiffProfile {
    /// Along the string.
    pub profile: Profile,
    /// Along the hole.
    pub wear: HoleWear,
    /// The operation's scalars.
    pub scalars: Scalars,
    /// Effect of the mud; none without a rheology.
    pub hydraulics: Option<Hydraulics>,
    /// Side force of the bit on the rock or on its support, N, towards the high side and to the
    /// right of it, looking down the hole.
    pub bit_side_force_N: [f64; 2],
    /// Tilt of the bit against the hole's axis, rad, towards the high side and to the right of it.
    pub bit_tilt_rad: [f64; 2],
    /// Position of its axis in the hole, its forces on the wall and its bending.
    pub axis: StringAxis,
    /// Deepest penetration of the wall, m, and its measured depth, m; zeros where nothing touches.
    pub deepest_penetration_m: [f64; 2],
    /// Convergence of the equilibrium.
    pub convergence: Convergence,
}

impl Deref for StiffProfile {
    type Target = Profile;

    fn deref(&self) -> &Profile {
        &self.profile
    }
}

impl StiffProfile {
    pub(super) fn new(model: &Model, operation: &Operation, solution: &Equilibrium) -> Self {
        let Equilibrium { mesh, string, state, hook_load_N, convergence, .. } = solution;
        let torques_N_m = contact::torques_N_m(string, &state.normal_N);
        let mut profile = along(model, mesh, string, state, &torques_N_m);
        let last = string.nodes.len() - 1;
        let jet_N = string.hydraulics.map_or(0.0, |mud| mud.jet_thrust_N);
        // At the ends the elements' middles are half an element off; hook and bit are there.
        profile.tension_N[0] = *hook_load_N;
        profile.tension_N[last] = operation.tension_at_bit_N() - jet_N;
        let surface_torque_N_m = surface_torque_N_m(string, &torques_N_m);
        profile.torque_N_m[0] = surface_torque_N_m;
        profile.torque_N_m[last] = string.bit_torque_N_m;
        let bending = Bending::of(string, state, mesh);
        let mut axis = StringAxis::new(model, string, state, &bending);
        bear(model, operation, mesh, string, bending, &mut profile);
        deform(model, mesh, string, state, &torques_N_m, &mut profile);
        let rubbing = Rubbing { operation, string, state };
        press(model, mesh, &rubbing, &mut profile);
        for index in 0..string.nodes.len() {
            let place = Place::above(model, operation.bit_depth_m, profile.md_m[index]);
            let compression_N = -profile.tension_N[index];
            profile.push_buckling_loads(place.loads_N(model.buckling, compression_N));
        }
        let sum = |value: &dyn Fn(usize) -> f64| (0..string.nodes.len()).map(value).sum::<f64>();
        let scalars = Scalars {
            hook_load_N: *hook_load_N,
            surface_torque_N_m,
            friction_torque_N_m: sum(&|index| rubbing.torque_N_m(index)),
            axial_friction_N: sum(&|index| rubbing.drag_N(index)),
            side_force_total_N: sum(&|index| state.normal_N[index]),
            weight_on_bit_N: operation.weight_on_bit_now_N(),
            bit_torque_N_m: string.bit_torque_N_m,
            twist_rad: profile.twist_rad[0],
            stretch_m: profile.stretch_m[0],
            neutral_point_m: neutral_point_m(&profile.md_m, &profile.tension_N),
            cutoff_depth_m: cutoff_depth_m(model, operation, &profile, &axis),
        };
        let [bit_side_force_N, bit_tilt_rad] = at_bit(model, string, state, &torques_N_m);
        if let BitEnd::Pinned | BitEnd::Clamped = string.ends.bit {
            // Neither a wall nor a spring has this force: it is that of the constraint on the axis.
            axis.push_N[last] = bit_side_force_N;
        }
        Self {
            profile,
            wear: hole_wear(mesh, &rubbing),
            scalars,
            hydraulics: string.hydraulics,
            bit_side_force_N,
            bit_tilt_rad,
            axis,
            deepest_penetration_m: solution
                .deepest()
                .map_or([0.0; 2], |(depth_m, index)| [depth_m, string.nodes[index].md_m]),
            convergence: *convergence,
        }
    }
}

impl Equilibrium {
    /// Torque and drag of this equilibrium, for its model and operation.
    pub fn profile(&self, model: &Model, operation: &Operation) -> StiffProfile {
        StiffProfile::new(model, operation, self)
    }
}

/// Distance from the depth at which the side force changes sides within which the cut-off is
/// searched for, m: the length of the mean of [`cutoff_in_build_m`], to both sides.
const CUTOFF_WITHIN_M: f64 = 30.0;

/// The cut-off: the crossing of the string's axis and the hole's that is nearest to the change of
/// side of the mean side force. Between the last contact above and the first below it the string
/// hangs free over tens of metres, in which the mean of the contacts moves with every node of the
/// mesh.
fn cutoff_depth_m(
    model: &Model,
    operation: &Operation,
    profile: &Profile,
    axis: &StringAxis,
) -> Option<f64> {
    let (path, md_m) = (&model.well.path, &profile.md_m);
    let by_force_m =
        cutoff_in_build_m(path, operation.bit_depth_m, md_m, &profile.side_force_N_per_m)?;
    Some(axis.crossing_near_m(md_m, by_force_m, CUTOFF_WITHIN_M).unwrap_or(by_force_m))
}

/// Torque at the top from the torques in the elements, N·m.
fn surface_torque_N_m(string: &StringInHole, torques_N_m: &[f64]) -> f64 {
    torques_N_m[0] + 0.5 * string.elements[0].mud_torque_N_m
}

/// Hook load, N, and surface torque, N·m.
pub(super) fn hook_and_torque(solution: &Equilibrium) -> [f64; 2] {
    let torques_N_m = contact::torques_N_m(&solution.string, &solution.state.normal_N);
    [solution.hook_load_N, surface_torque_N_m(&solution.string, &torques_N_m)]
}

/// Sliding friction at the nodes.
struct Rubbing<'a> {
    operation: &'a Operation,
    string: &'a StringInHole,
    state: &'a State,
}

impl Rubbing<'_> {
    fn torque_N_m(&self, index: usize) -> f64 {
        contact::rubbed_N_m(&self.string.nodes[index], self.state.normal_N[index])
    }

    /// Axial friction at a node, N; positive where it adds to hook load.
    fn drag_N(&self, index: usize) -> f64 {
        self.string.nodes[index].friction[0] * self.state.normal_N[index]
    }

    /// Power of friction at a node, W: force times sliding speed, about and along the hole.
    fn power_W(&self, index: usize) -> f64 {
        self.operation.rotation_rad_per_s() * self.torque_N_m(index)
            - self.operation.axial_velocity_m_per_s() * self.drag_N(index)
    }
}

/// Sets the side forces, friction and wear per metre.
fn press(model: &Model, mesh: &Mesh, rubbing: &Rubbing<'_>, p: &mut Profile) {
    let (string, state) = (rubbing.string, rubbing.state);
    let spans = contact_length::contact_spans(mesh, |index| state.normal_N[index] > 0.0);
    let count = string.nodes.len();
    let per_m = |value: &dyn Fn(usize) -> f64| contact_length::spread(&spans, count, value);
    p.axial_friction_N_per_m = per_m(&|index| rubbing.drag_N(index));
    p.friction_torque_N_m_per_m = per_m(&|index| rubbing.torque_N_m(index));
    p.wear_power_W_per_m = per_m(&|index| rubbing.power_W(index));
    p.side_force_N_per_m = per_m(&|index| {
        let node = &string.nodes[index];
        let high = model.well.path.high_side_of(node.md_m, &node.axes[2]);
        let u = state.offset_m[index];
        let up = (node.axes[0] * u.x + node.axes[1] * u.y).dot(&high);
        if up > 0.0 { state.normal_N[index] } else { -state.normal_N[index] }
    });
    for (node, force_N_per_m) in mesh.nodes.iter().zip(&p.side_force_N_per_m) {
        let (_, component) = model.string.component_at(node.from_bit_m);
        let per_joint = component.joints.map(|joints| force_N_per_m * joints.spacing_m);
        p.side_force_per_joint_N.push(per_joint);
    }
}

/// Wear of the hole by friction; that of each node is spread over half of its two elements.
fn hole_wear(mesh: &Mesh, rubbing: &Rubbing<'_>) -> HoleWear {
    let mut hole_W = vec![0.0; hole_steps(rubbing.operation.bit_depth_m)];
    for (index, node) in rubbing.string.nodes.iter().enumerate() {
        let half_m = 0.5 * mesh.tributary_length_m(index);
        let (from_m, to_m) = (node.md_m - half_m, node.md_m + half_m);
        spread(&mut hole_W, from_m, to_m, rubbing.power_W(index));
    }
    HoleWear {
        md_m: hole_depths_m(hole_W.len()),
        wear_power_W_per_m: hole_W.iter().map(|power| power / HOLE_STEP_M).collect(),
        wear_work_J_per_m: Vec::new(),
    }
}

/// Side force of the bit and its tilt, towards the high side and to the right of it.
fn at_bit(
    model: &Model,
    string: &StringInHole,
    state: &State,
    torques_N_m: &[f64],
) -> [[f64; 2]; 2] {
    let last = string.nodes.len() - 1;
    let node = &string.nodes[last];
    let [e1, e2, tangent] = node.axes;
    let high = model.well.path.high_side_of(node.md_m, &tangent);
    let right = tangent.cross(&high);
    let u = state.offset_m[last];
    let off = e1 * u.x + e2 * u.y;
    let pushed = match string.ends.bit {
        BitEnd::Held => off * node.hold_N_per_m,
        BitEnd::Free => off.try_normalize(0.0).unwrap_or_default() * state.normal_N[last],
        // On the axis: the force of the string on the constraint.
        BitEnd::Pinned | BitEnd::Clamped => {
            let mut equations = Equations::new(string.nodes.len());
            equations.assemble(string, state, Some(torques_N_m));
            e1 * equations.bit_side_N.x + e2 * equations.bit_side_N.y
        }
    };
    let tilt = state.heading[last].along;
    [[pushed.dot(&high), pushed.dot(&right)], [tilt.dot(&high), tilt.dot(&right)]]
}

/// The columns that follow directly from the nodes.
fn along(
    model: &Model,
    mesh: &Mesh,
    string: &StringInHole,
    state: &State,
    torques_N_m: &[f64],
) -> Profile {
    let elements = string.elements.len();
    let at_node = |values: &[f64], index: usize| {
        0.5 * (values[index.saturating_sub(1)] + values[index.min(elements - 1)])
    };
    let mut p = Profile::default();
    for (index, node) in string.nodes.iter().enumerate() {
        let u = state.offset_m[index];
        let normal_N = state.normal_N[index];
        let element = &mesh.elements[index.min(elements - 1)];
        let offset = node.axes[0] * u.x + node.axes[1] * u.y;
        let high = model.well.path.high_side_of(node.md_m, &node.axes[2]);
        let right = node.axes[2].cross(&high);
        p.md_m.push(node.md_m + u.z);
        p.tension_N.push(at_node(&state.tension_N, index));
        p.torque_N_m.push(at_node(torques_N_m, index));
        p.contact_force_N.push(normal_N);
        p.contact_fraction.push(f64::from(u8::from(normal_N > 0.0)));
        p.climb_rad
            .push((normal_N > 0.0).then(|| libm::atan2(offset.dot(&right), -offset.dot(&high))));
        p.lateral_offset_m.push(offset.norm());
        p.element_length_m.push(element.length_m);
        p.element_size.push(element.reason);
    }
    p
}

/// Sets pressures, true tension, bending moments and stresses.
fn bear(
    model: &Model,
    operation: &Operation,
    mesh: &Mesh,
    string: &StringInHole,
    bending: Bending,
    p: &mut Profile,
) {
    let mud = model.mud_column();
    let flow_m3_per_s = string.hydraulics.map_or(0.0, |_| operation.flow_now_m3_per_s());
    for (index, node) in string.nodes.iter().enumerate() {
        let component = mesh.weakest_body(&model.string, index);
        let section = BodySection::of(component);
        let layers = mud.layers_at(node.md_m);
        let Densities { inside_kg_per_m3, .. } = layers.densities();
        let stream_N_m2 = inside_kg_per_m3 * flow_m3_per_s * flow_m3_per_s;
        // The flow's pressures are those at the lower end of the element above.
        let [mut outside_Pa, mut inside_Pa] =
            [&layers.annulus, &layers.inside].map(|layer| layer.pressure_Pa(node.anchor_m.z));
        let flow = &string.circulating[index.saturating_sub(1)];
        let up_m = if index == 0 { string.elements[0].stiffness.length } else { 0.0 };
        outside_Pa += flow.outer_Pa - flow.outer_fall_Pa_per_m * up_m;
        inside_Pa += flow.inner_Pa + flow.inner_rise_Pa_per_m * up_m;
        let burst_Pa = inside_Pa - outside_Pa;
        let tension_N = p.tension_N[index];
        let (_, own) = model.string.component_at(mesh.nodes[index].from_bit_m);
        p.outside_pressure_Pa.push(outside_Pa);
        p.inside_pressure_Pa.push(inside_Pa);
        p.true_tension_N.push(own.true_tension_N(tension_N, outside_Pa, inside_Pa, stream_N_m2));
        let bent_N_m = bending.at_node_N_m[index].max(bending.between_N_m[index]);
        let stress_Pa =
            section.von_mises_Pa(tension_N, bent_N_m, p.torque_N_m[index], burst_Pa * burst_Pa);
        p.bending_stress_Pa.push(bent_N_m * section.per_modulus_m3);
        p.von_mises_stress_Pa.push(stress_Pa);
        p.yield_use.push(component.yield_strength_Pa.map(|yields_Pa| stress_Pa / yields_Pa));
    }
    p.bending_moment_N_m = bending.at_node_N_m;
    p.bending_moment_between_N_m = bending.between_N_m;
    p.sag_m = bending.sag_m;
    p.body_contact_fraction = bending.touches;
}

/// Sets twist and elongation relative to the bit, from the bit up: by tension, by the mud at rest
/// and by its flow.
fn deform(
    model: &Model,
    mesh: &Mesh,
    string: &StringInHole,
    state: &State,
    torques_N_m: &[f64],
    p: &mut Profile,
) {
    let mud = model.mud_column();
    let nodes = string.nodes.len();
    (p.twist_rad, p.stretch_m) = (vec![0.0; nodes], vec![0.0; nodes]);
    for index in (0..nodes - 1).rev() {
        let (k, section) = (&string.elements[index].stiffness, &mesh.elements[index].section);
        let ends = [index, index + 1].map(|node| {
            let node = &string.nodes[node];
            HolePlace { md_m: node.md_m, tvd_m: node.anchor_m.z }
        });
        let element = (&mesh.elements[index], [&mesh.nodes[index], &mesh.nodes[index + 1]]);
        let strain = state.tension_N[index] / section.axial_stiffness_N
            + free_elongation_m(&model.string, &mud, element, ends, 1.0)
            + string.circulating[index].strain;
        p.twist_rad[index] = p.twist_rad[index + 1] + torques_N_m[index] / k.twist;
        p.stretch_m[index] = p.stretch_m[index + 1] + strain * k.length;
    }
}

// Summary of an equilibrium and of its bit.

/// Convergence and validity of an equilibrium, and the loads of its bit on the rock.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct EquilibriumSummary {
    /// Convergence of its solution.
    #[serde(flatten)]
    pub convergence: Convergence,
    /// Side force of the bit on the rock towards the high side, N: it builds inclination.
    #[serde(with = "finite")]
    pub bit_side_force_high_N: f64,
    /// To the right of it, looking down the hole, N.
    #[serde(with = "finite")]
    pub bit_side_force_right_N: f64,
    /// Tilt of the bit against the hole's axis towards the high side, rad.
    #[serde(with = "finite")]
    pub bit_tilt_high_rad: f64,
    /// To the right of it, rad.
    #[serde(with = "finite")]
    pub bit_tilt_right_rad: f64,
}

impl From<&StiffProfile> for EquilibriumSummary {
    fn from(profile: &StiffProfile) -> Self {
        let [bit_side_force_high_N, bit_side_force_right_N] = profile.bit_side_force_N;
        let [bit_tilt_high_rad, bit_tilt_right_rad] = profile.bit_tilt_rad;
        Self {
            convergence: profile.convergence,
            bit_side_force_high_N,
            bit_side_force_right_N,
            bit_tilt_high_rad,
            bit_tilt_right_rad,
        }
    }
}

//! Contact of the face with the nodes of a rock's surface.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::{face::BitFace, pose::Pose};

/// Contact force and friction of the face.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ContactLaw {
    /// Pressure per depth of penetration, Pa/m; times a node's area it is the stiffness that holds
    /// the node. It represents the rock that is crushed within an element. Any value is stable; a
    /// greater one allows less penetration.
    pub stiffness_Pa_per_m: f64,
    /// Damping against that of a node on this stiffness that does not swing. Default 0, because its
    /// dissipation grows with the speed and the density, also where that is scaled. A greater value
    /// keeps nodes from bouncing.
    pub damping_ratio: f64,
    /// Coefficient of friction between the face and the rock. Default 0.3.
    pub friction: f64,
}

impl ContactLaw {
    /// The defaults for a rock of this unconfined strength in elements of this size: the pressure
    /// is the strength at a 25th of an element. With a greater stiffness an element breaks as soon
    /// as a cutter meets it, however little of it is in the way, and carries less weight.
    pub fn for_rock(ucs_Pa: f64, element_m: f64) -> Self {
        Self { stiffness_Pa_per_m: 25.0 * ucs_Pa / element_m, damping_ratio: 0.0, friction: 0.3 }
    }
}

/// A node of the rock's surface at a step.
#[derive(Debug, Clone, Copy)]
pub struct RockNode {
    /// Position at the beginning of the step, m.
    pub position_m: Vector3<f64>,
    /// Velocity before the step's forces, m/s.
    pub velocity_m_per_s: Vector3<f64>,
    /// All forces of the step but those of the face, N.
    pub force_N: Vector3<f64>,
    /// Mass, kg: above zero and finite.
    pub mass_kg: f64,
}

/// Forces of the rock on the bit in a step, and the balance of energy. Works are exact for a step
/// that gives the velocities `dt F/m`: force times the mean of the velocities before and after. The
/// four sum to zero.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct BitLoad {
    /// Force on the bit, N.
    pub force_N: Vector3<f64>,
    /// Moment on the bit about its reference point, N·m.
    pub moment_N_m: Vector3<f64>,
    /// Work done on the bit, J, for the motion of its pose.
    pub work_on_bit_J: f64,
    /// Work done on the nodes, J.
    pub work_on_nodes_J: f64,
    /// Lost in friction, J.
    pub friction_loss_J: f64,
    /// Taken by penetration and its damping, J; negative where a node is pushed out.
    pub contact_loss_J: f64,
    /// Nodes that touch.
    pub touching: usize,
    /// Deepest penetration that was left, m.
    pub deepest_m: f64,
}

/// A node this far outside the cylinder around the face is not looked at, m: it would have to come
/// as far in one step, and would be met in the next.
const NEAR_M: f64 = 2e-3;

/// A face in a step of the rock, and the forces of the touched nodes on the bit.
///
/// With the penetration `α` and the closing speed `v` at the step's end without the face, the node's
/// mass `m` and area `A`, and the law's stiffness `K` and damping ratio `D`, the normal force is
///
#[doc = include_str!("../../equations/face-contact.html")]
///
/// and never more than removes all penetration. Friction is the smaller of `μ N` and the force that
/// stops the sliding. The motion of the bit within the step is taken to the first order. Theory:
/// `docs/src/theory/bit-face.md`.
#[derive(Debug, Clone, Copy)]
pub struct Contact<'a> {
    face: &'a BitFace,
    pose: &'a Pose,
    law: &'a ContactLaw,
    dt_s: f64,
    axis: Vector3<f64>,
    /// The cylinder around the face, with a margin for the motion in a step.
    z_m: [f64; 2],
    radius2_m2: f64,
    load: BitLoad,
}

impl<'a> Contact<'a> {
    /// A face that has met nothing yet.
    pub fn new(face: &'a BitFace, pose: &'a Pose, law: &'a ContactLaw, dt_s: f64) -> Self {
        let [high, low] = face.grid.z_m;
        Self {
            face,
            pose,
            law,
            dt_s,
            axis: pose.axis(),
            z_m: [high - NEAR_M, low + NEAR_M],
            radius2_m2: (face.grid.radius2_m2.sqrt() + NEAR_M).powi(2),
            load: BitLoad::default(),
        }
    }

    /// Whether a node at this place may touch.
    #[inline]
    pub fn reaches(&self, position_m: Vector3<f64>) -> bool {
        let arm = position_m - self.pose.position_m;
        let z = arm.dot(&self.axis);
        let [high, low] = self.z_m;
        z <= low && z >= high && arm.norm_squared() - z * z <= self.radius2_m2
    }

    /// The force of the face on a node, N, with its reaction booked; none on one that does not
    /// touch. Sums run in the order of the calls. For a node that touches, `area_m2` returns its
    /// part of the surface, m².
    #[inline]
    pub fn touch(
        &mut self,
        node: &RockNode,
        area_m2: impl FnOnce() -> f64,
    ) -> Option<Vector3<f64>> {
        let (pose, law, dt) = (self.pose, self.law, self.dt_s);
        let arm = node.position_m - pose.position_m;
        let mobility = dt / node.mass_kg;
        let carried = pose.velocity_m_per_s + pose.angular_velocity_rad_per_s.cross(&arm);
        let free = node.velocity_m_per_s + node.force_N * mobility;
        let slip = free - carried;
        let to_bit = pose.rotation.tr_mul(&(arm + slip * dt));
        let touch = self.face.holds(to_bit)?;

        let out = pose.rotation * touch.out;
        let closing = -slip.dot(&out);
        let stiffness = law.stiffness_Pa_per_m * area_m2();
        let damping = 2.0 * law.damping_ratio * (stiffness * node.mass_kg).sqrt();
        let push = (stiffness * touch.depth_m + damping * closing).max(0.0)
            / (1.0 + mobility * (stiffness * dt + damping));
        let push = push.min(touch.depth_m / (dt * mobility));

        let sliding = slip + out * closing;
        let speed = sliding.norm();
        let stop = speed / mobility;
        let friction = if stop <= law.friction * push {
            -sliding / mobility
        } else {
            sliding * (-law.friction * push / speed)
        };

        let normal = out * push;
        let force = normal + friction;
        let mean = (node.velocity_m_per_s + free + force * mobility) * 0.5;
        let load = &mut self.load;
        load.force_N -= force;
        load.moment_N_m -= arm.cross(&force);
        load.work_on_nodes_J += dt * force.dot(&mean);
        load.work_on_bit_J -= dt * force.dot(&carried);
        load.friction_loss_J += dt * friction.dot(&(carried - mean));
        load.contact_loss_J += dt * normal.dot(&(carried - mean));
        load.touching += 1;
        load.deepest_m = load.deepest_m.max(touch.depth_m - dt * mobility * push);
        Some(force)
    }

    /// Forces on the bit of the nodes that touched.
    pub fn load(&self) -> BitLoad {
        self.load
    }
}

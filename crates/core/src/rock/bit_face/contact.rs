//! Contact of the face with the nodes of a rock's surface.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::{face::BitFace, pose::Pose};

/// How the face pushes back and rubs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ContactLaw {
    /// Pressure per depth of penetration, Pa/m; times a node's area it is the stiffness that holds the node. It stands for the
    /// rock that is crushed within a brick. Any is stable; more lets less penetrate.
    pub stiffness_Pa_per_m: f64,
    /// Damping against that of a node on this stiffness that does not swing. Default 0: what it takes grows with the speed and
    /// the density, also where that is scaled. More keeps nodes from bouncing.
    pub damping_ratio: f64,
    /// Coefficient of friction between the face and the rock. Default 0.3.
    pub friction: f64,
}

impl ContactLaw {
    /// The defaults for a rock of this unconfined strength in elements of this size: the pressure is the strength at a 25th of
    /// an element. Stiffer, an element breaks as soon as a cutter meets it, however little of it is in the way, and bears less
    /// weight.
    pub fn for_rock(ucs_Pa: f64, element_m: f64) -> Self {
        Self {
            stiffness_Pa_per_m: 25.0 * ucs_Pa / element_m,
            damping_ratio: 0.0,
            friction: 0.3,
        }
    }
}

/// The nodes of a rock, component by component, and which of them are on its surface.
#[derive(Debug)]
pub struct SurfaceNodes<'a> {
    /// The nodes on the surface; the sums run in this order.
    pub surface: &'a [u32],
    /// Positions at the beginning of the step, m.
    pub position_m: [&'a [f64]; 3],
    /// Velocities before the step's forces, m/s.
    pub velocity_m_per_s: [&'a [f64]; 3],
    /// Masses, kg: above zero and finite.
    pub mass_kg: &'a [f64],
    /// Part of the surface that belongs to a node, m².
    pub area_m2: &'a [f64],
    /// All other forces of the step, N; those of the face are added.
    pub force_N: [&'a mut [f64]; 3],
}

/// What the rock does to the bit in a step, and where the energy goes. Works are exact for a step that gives the
/// velocities `dt F/m`: force times the mean of the velocities before and after. The four add up to nothing.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct BitLoad {
    /// Force on the bit, N.
    pub force_N: Vector3<f64>,
    /// Moment on the bit about its reference point, N·m.
    pub moment_N_m: Vector3<f64>,
    /// Work done on the bit, J, moving as its pose says.
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

/// A node this far outside the cylinder around the face is not looked at, m: it would have to come as far in one step, and
/// would be met in the next.
const NEAR_M: f64 = 2e-3;

/// A node that may touch.
#[derive(Debug, Clone, Copy)]
struct Node {
    /// Its position from the bit's reference point.
    arm: Vector3<f64>,
    velocity: Vector3<f64>,
    force: Vector3<f64>,
    mass: f64,
    area: f64,
}

/// The cylinder around a face, with what a step may bring in.
#[derive(Debug, Clone, Copy)]
pub(in crate::rock) struct Reach {
    axis: Vector3<f64>,
    z_m: [f64; 2],
    radius2_m2: f64,
}

impl Reach {
    /// Whether a node at this place from the bit's reference point may touch.
    #[inline]
    pub(in crate::rock) fn contains(&self, arm_m: Vector3<f64>) -> bool {
        let z = arm_m.dot(&self.axis);
        let [high, low] = self.z_m;
        z <= low && z >= high && arm_m.norm_squared() - z * z <= self.radius2_m2
    }
}

impl BitFace {
    /// Where nodes may touch.
    pub(in crate::rock) fn reach(&self, pose: &Pose) -> Reach {
        let [high, low] = self.grid.z_m;
        Reach {
            axis: pose.axis(),
            z_m: [high - NEAR_M, low + NEAR_M],
            radius2_m2: (self.grid.radius2_m2.sqrt() + NEAR_M).powi(2),
        }
    }

    /// Adds the forces of the face to those of the nodes and returns their reaction.
    ///
    /// Penetration `α` and closing speed `v` are those with which the step would end without the face; the force
    /// solves `N = k α' + c v'` with what it leaves of them,
    ///
    /// ```text
    /// N = max(0, k α + c v)/(1 + (dt/m)(k dt + c)),   k = stiffness · area,   c = 2 ζ √(k m)
    /// ```
    ///
    /// and never takes more than all penetration away, so that no stiffness limits the step and a node that has just come is
    /// not thrown back. Friction is the smaller of `μ N` and what stops the sliding, exactly. The
    /// motion of the bit within the step is taken to the first order.
    pub fn touch(
        &self,
        pose: &Pose,
        law: &ContactLaw,
        dt_s: f64,
        nodes: &mut SurfaceNodes<'_>,
    ) -> BitLoad {
        let mut load = BitLoad::default();
        let reach = self.reach(pose);
        for &index in nodes.surface {
            let i = index as usize;
            let at = |of: &[&[f64]; 3]| Vector3::new(of[0][i], of[1][i], of[2][i]);
            let arm = at(&nodes.position_m) - pose.position_m;
            if !reach.contains(arm) {
                continue;
            }
            let [fx, fy, fz] = &nodes.force_N;
            let node = Node {
                arm,
                velocity: at(&nodes.velocity_m_per_s),
                force: Vector3::new(fx[i], fy[i], fz[i]),
                mass: nodes.mass_kg[i],
                area: nodes.area_m2[i],
            };
            if let Some(force) = self.meet(pose, law, dt_s, &node, &mut load) {
                for (sum, part) in nodes.force_N.iter_mut().zip(force.iter()) {
                    sum[i] += part;
                }
            }
        }
        load
    }

    /// The force on one node, booked.
    #[inline]
    fn meet(
        &self,
        pose: &Pose,
        law: &ContactLaw,
        dt: f64,
        node: &Node,
        load: &mut BitLoad,
    ) -> Option<Vector3<f64>> {
        let mobility = dt / node.mass;
        let carried = pose.velocity_m_per_s + pose.angular_velocity_rad_per_s.cross(&node.arm);
        let free = node.velocity + node.force * mobility;
        let slip = free - carried;
        let touch = self.holds(pose.rotation.tr_mul(&(node.arm + slip * dt)))?;

        let out = pose.rotation * touch.out;
        let closing = -slip.dot(&out);
        let stiffness = law.stiffness_Pa_per_m * node.area;
        let damping = 2.0 * law.damping_ratio * (stiffness * node.mass).sqrt();
        let push = (stiffness * touch.depth_m + damping * closing).max(0.0)
            / (1.0 + mobility * (stiffness * dt + damping));
        let push = push.min(touch.depth_m / (dt * mobility));

        let sliding = slip + out * closing;
        let speed = sliding.norm();
        let stop = speed / mobility;
        let rub = if stop <= law.friction * push {
            -sliding / mobility
        } else {
            sliding * (-law.friction * push / speed)
        };

        let normal = out * push;
        let force = normal + rub;
        let mean = (node.velocity + free + force * mobility) * 0.5;
        load.force_N -= force;
        load.moment_N_m -= node.arm.cross(&force);
        load.work_on_nodes_J += dt * force.dot(&mean);
        load.work_on_bit_J -= dt * force.dot(&carried);
        load.friction_loss_J += dt * rub.dot(&(carried - mean));
        load.contact_loss_J += dt * normal.dot(&(carried - mean));
        load.touching += 1;
        load.deepest_m = load.deepest_m.max(touch.depth_m - dt * mobility * push);
        Some(force)
    }
}

//! The whole string at one moment.

use serde::Serialize;

use super::{
    probe::NodeSignal,
    record::{BlockSample, Strength},
};
use crate::{
    dynamics::{
        body::Body,
        boundary::anchor::Anchor,
        kernel::chain::{Chain, Rows, element, node},
    },
    named::named,
    outcome::{IN_TIME, columns},
    simd::{number::Real, vector::Vector},
};

named! {
    /// A group of quantities that a frame holds of every node.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
    pub enum Channel {
        /// Offset from the hole's axis towards the high side and to the right of it.
        Position = "position",
        /// North, east and vertical depth.
        Coordinates = "coordinates",
        /// Lateral and axial velocity.
        Velocity = "velocity",
        /// Rotary speed and turn against the bit.
        Rotation = "rotation",
        /// Angle of the pipe's axis with the hole's.
        Tilt = "tilt",
        /// Contact force.
        Contact = "contact",
        /// Friction on the wall.
        Friction = "friction",
        /// Tension and torque.
        Force = "force",
        /// Bending moment and von Mises stress.
        Stress = "stress",
    }
}

impl Channel {
    /// Those that are kept where nobody chooses.
    pub const USUAL: [Self; 5] =
        [Self::Position, Self::Velocity, Self::Rotation, Self::Contact, Self::Force];
}

columns! {
    /// The whole string at one moment: one number a node in each vector, from the surface down.
    /// High and right are those of a person who looks down the hole; contact and friction are
    /// averages over the sample that ends at this moment.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct Frame, "What a frame holds of every node, in the order of `frames.parquet`."
    FRAME {
        md_m: Vec<f64> => Depth, "Measured depth of the node", known_by IN_TIME;
        offset_high_m: Vec<f64> => Length,
            "Offset of the string's axis from the hole's towards the high side", known_by IN_TIME;
        offset_right_m: Vec<f64> => Length,
            "Offset to the right, looking down the hole", known_by IN_TIME;
        north_m: Vec<f64> => Length, "North of the node", known_by IN_TIME;
        east_m: Vec<f64> => Length, "East of the node", known_by IN_TIME;
        tvd_m: Vec<f64> => Depth, "True vertical depth of the node", known_by IN_TIME;
        velocity_high_m_per_s: Vec<f64> => Speed,
            "Velocity towards the high side", known_by IN_TIME;
        velocity_right_m_per_s: Vec<f64> => Speed, "Velocity to the right", known_by IN_TIME;
        axial_velocity_m_per_s: Vec<f64> => Speed, "Velocity down the hole", known_by IN_TIME;
        rotary_speed_rad_per_s: Vec<f64> => RotarySpeed,
            "Rotary speed of the node; positive clockwise looking down the hole", known_by IN_TIME;
        twist_rad: Vec<f64> => Angle,
            "Turn of the node against the bit; positive where it leads", known_by IN_TIME;
        tilt_high_rad: Vec<f64> => Angle,
            "Angle of the string's axis with the hole's towards the high side", known_by IN_TIME;
        tilt_right_rad: Vec<f64> => Angle, "Angle to the right", known_by IN_TIME;
        contact_force_N: Vec<f64> => Force,
            "Contact force of the node, averaged over the sample; positive on the high side",
            known_by IN_TIME;
        axial_friction_N: Vec<f64> => Force,
            "Wall friction along the string on the node, averaged over the sample; positive \
             adds to hook load", known_by IN_TIME;
        friction_torque_N_m: Vec<f64> => Torque,
            "Torque of wall friction on the node, averaged over the sample", known_by IN_TIME;
        tension_N: Vec<f64> => Force,
            "Effective tension; negative in compression", known_by IN_TIME;
        torque_N_m: Vec<f64> => Torque, "Torque that the string carries", known_by IN_TIME;
        bending_moment_N_m: Vec<f64> => Torque,
            "Bending moment, whatever its direction", known_by IN_TIME;
        von_mises_stress_Pa: Vec<f64> => Pressure,
            "Von Mises stress where the body's surface bears most", known_by IN_TIME;
    }
    beside {
        /// Time since the start, s.
        time_s: f64;
    }
}

impl Frame {
    /// The vectors of a channel by their names in results.
    pub fn channel(&self, channel: Channel) -> Vec<(&'static str, &[f64])> {
        match channel {
            Channel::Position => vec![
                ("offset_high_m", &self.offset_high_m),
                ("offset_right_m", &self.offset_right_m),
            ],
            Channel::Coordinates => {
                vec![("north_m", &self.north_m), ("east_m", &self.east_m), ("tvd_m", &self.tvd_m)]
            }
            Channel::Velocity => vec![
                ("velocity_high_m_per_s", &self.velocity_high_m_per_s),
                ("velocity_right_m_per_s", &self.velocity_right_m_per_s),
                ("axial_velocity_m_per_s", &self.axial_velocity_m_per_s),
            ],
            Channel::Rotation => vec![
                ("rotary_speed_rad_per_s", &self.rotary_speed_rad_per_s),
                ("twist_rad", &self.twist_rad),
            ],
            Channel::Tilt => vec![
                ("tilt_high_rad", &self.tilt_high_rad),
                ("tilt_right_rad", &self.tilt_right_rad),
            ],
            Channel::Contact => vec![("contact_force_N", &self.contact_force_N)],
            Channel::Friction => vec![
                ("axial_friction_N", &self.axial_friction_N),
                ("friction_torque_N_m", &self.friction_torque_N_m),
            ],
            Channel::Force => {
                vec![("tension_N", &self.tension_N), ("torque_N_m", &self.torque_N_m)]
            }
            Channel::Stress => vec![
                ("bending_moment_N_m", &self.bending_moment_N_m),
                ("von_mises_stress_Pa", &self.von_mises_stress_Pa),
            ],
        }
    }
}

/// What a frame is read from.
pub(in crate::dynamics) struct Scene<'a, R: Real> {
    pub chain: &'a Chain<R>,
    pub anchors: &'a [Anchor],
    pub high: &'a [Rows<f64>],
    pub body: &'a Body,
    pub strength: &'a Strength,
    pub time_s: f64,
    /// Steps that the chain's sums hold.
    pub summed_steps: u64,
}

/// A node of a scene.
struct View<'a, R: Real> {
    scene: &'a Scene<'a, R>,
    node: usize,
    /// The node's block.
    sample: &'a BlockSample,
    lane: usize,
}

impl<R: Real> Scene<'_, R> {
    pub(in crate::dynamics) fn frame(&self) -> Frame {
        let chain = self.chain;
        let last = chain.nodes() - 1;
        let mut frame = Frame { time_s: self.time_s, ..Frame::default() };
        let samples: Vec<BlockSample> =
            (0..chain.layout().blocks()).map(|block| self.sample(block)).collect();
        for i in 0..=last {
            let (block, lane) = chain.layout().place(i);
            let view = View { scene: self, node: i, sample: &samples[block], lane };
            let anchor = &self.anchors[i];
            let (tangent, high, right) = view.directions();
            let moved = chain.displacement(i);
            let along = moved.dot(tangent);
            // The hole's own direction where the node is, not at its anchor.
            let tilt = chain.director(i).minus(chain.curvature(i), along);
            frame.md_m.push(anchor.md_m + along);
            frame.north_m.push(anchor.position_m.x + moved.0);
            frame.east_m.push(anchor.position_m.y + moved.1);
            frame.tvd_m.push(anchor.position_m.z + moved.2);
            frame.tilt_high_rad.push(tilt.dot(high));
            frame.tilt_right_rad.push(tilt.dot(right));
            frame.axial_friction_N.push(-view.sample.axial[lane]);
            frame.friction_torque_N_m.push(view.sample.friction_torque[lane]);
            for (signal, values) in [
                (NodeSignal::OffsetHigh, &mut frame.offset_high_m),
                (NodeSignal::OffsetRight, &mut frame.offset_right_m),
                (NodeSignal::VelocityHigh, &mut frame.velocity_high_m_per_s),
                (NodeSignal::VelocityRight, &mut frame.velocity_right_m_per_s),
                (NodeSignal::AxialVelocity, &mut frame.axial_velocity_m_per_s),
                (NodeSignal::RotarySpeed, &mut frame.rotary_speed_rad_per_s),
                (NodeSignal::ContactForce, &mut frame.contact_force_N),
                (NodeSignal::Tension, &mut frame.tension_N),
                (NodeSignal::Torque, &mut frame.torque_N_m),
                (NodeSignal::BendingMoment, &mut frame.bending_moment_N_m),
                (NodeSignal::VonMisesStress, &mut frame.von_mises_stress_Pa),
            ] {
                values.push(view.signal(signal));
            }
        }
        frame.von_mises_stress_Pa[last] = frame.von_mises_stress_Pa[last - 1];
        frame.twist_rad = vec![0.0; last + 1];
        for i in (0..last).rev() {
            frame.twist_rad[i] = frame.twist_rad[i + 1] - element!(chain, i, twist);
        }
        frame
    }

    /// A signal of a node.
    pub(in crate::dynamics) fn signal(&self, node: usize, signal: NodeSignal) -> f64 {
        // Below the bit there is no element: it bears what the node above it does.
        let node = match signal {
            NodeSignal::VonMisesStress => node.min(self.chain.nodes() - 2),
            _ => node,
        };
        let (block, lane) = self.chain.layout().place(node);
        let view = View { scene: self, node, sample: &self.sample(block), lane };
        view.signal(signal)
    }

    fn sample(&self, block: usize) -> BlockSample {
        let per_step = 1.0 / self.summed_steps as f64;
        BlockSample::at(self.chain, self.high, self.body, self.strength, block, per_step)
    }
}

impl<R: Real> View<'_, R> {
    /// Along the hole, to its high side and to the right of it.
    fn directions(&self) -> (Vector<f64>, Vector<f64>, Vector<f64>) {
        let tangent = self.scene.chain.tangent(self.node);
        let high = self.scene.anchors[self.node].high_side.into();
        (tangent, high, tangent.cross(high))
    }

    fn signal(&self, signal: NodeSignal) -> f64 {
        let Self { scene, node, sample, lane } = *self;
        let chain = scene.chain;
        let (tangent, high, right) = self.directions();
        let velocity = chain.velocity(node);
        match signal {
            NodeSignal::Tension => self.at_ends(|i| element!(chain, i, tension)),
            NodeSignal::Torque => self.at_ends(|i| -element!(chain, i, torque)),
            NodeSignal::BendingMoment => sample.bending[lane],
            NodeSignal::VonMisesStress => sample.stress[lane],
            NodeSignal::ContactForce if sample.up[lane] < 0.0 => -sample.normal[lane],
            NodeSignal::ContactForce => sample.normal[lane],
            NodeSignal::OffsetHigh => sample.offset[lane] * sample.up[lane],
            NodeSignal::OffsetRight => sample.offset[lane] * sample.right[lane],
            NodeSignal::VelocityHigh => velocity.dot(high),
            NodeSignal::VelocityRight => velocity.dot(right),
            NodeSignal::AxialVelocity => velocity.dot(tangent),
            NodeSignal::RotarySpeed => node!(chain, node, spin),
        }
    }

    /// The mean of the two elements at the node; at the ends there is but one.
    fn at_ends(&self, of: impl Fn(usize) -> f64) -> f64 {
        let above = self.node.saturating_sub(1);
        let below = self.node.min(self.scene.chain.elements() - 1);
        0.5 * (of(above) + of(below))
    }
}

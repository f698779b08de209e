//! The whole string as it is at a moment, and the frame and the signals that are read from it.

use std::cell::LazyCell;

use super::{
    frame::Frame,
    probe::NodeSignal,
    record::{BentNode, Ends, NodeSample, Shapes, Source, Strength},
};
use crate::{
    dynamics::{
        body::Body,
        boundary::anchor::Anchor,
        kernel::chain::{Chain, Rows, element, node},
    },
    simd::{number::Real, vector::Vector},
};

/// Sources of a frame.
pub(in crate::dynamics) struct Scene<'a, R: Real> {
    pub chain: &'a Chain<R>,
    pub anchors: &'a [Anchor],
    pub high: &'a [Rows<f64>],
    pub body: &'a Body,
    pub strength: &'a Strength,
    pub shapes: &'a Shapes,
    pub time_s: f64,
    /// Steps that the chain's sums hold.
    pub summed_steps: u64,
}

/// A node of a scene.
struct View<'a, R: Real, F> {
    scene: &'a Scene<'a, R>,
    node: usize,
    /// Along the hole, to its high side and to the right of it.
    tangent: Vector<f64>,
    high: Vector<f64>,
    right: Vector<f64>,
    /// Values of a sample: not every signal is there.
    sample: LazyCell<NodeSample, F>,
}

impl<R: Real> Scene<'_, R> {
    pub(in crate::dynamics) fn frame(&self) -> Frame {
        let chain = self.chain;
        let last = chain.nodes() - 1;
        let mut frame = Frame { time_s: self.time_s, ..Frame::default() };
        let bent = BentNode::all(self.body, chain);
        for (i, sample) in self.source(&bent).nodes().into_iter().enumerate() {
            let view = View::new(self, i, LazyCell::new(|| sample));
            let anchor = &self.anchors[i];
            let View { tangent, high, right, .. } = view;
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
            frame.axial_friction_N.push(-sample.axial);
            frame.friction_torque_N_m.push(sample.friction_torque);
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
        // Below the bit there is no element: it has the loads of the node above it.
        let node = match signal {
            NodeSignal::VonMisesStress => node.min(self.chain.nodes() - 2),
            _ => node,
        };
        let sample =
            LazyCell::new(|| self.source(&BentNode::all(self.body, self.chain)).node(node));
        View::new(self, node, sample).signal(signal)
    }

    fn source<'a>(&'a self, bent: &'a [BentNode]) -> Source<'a, R> {
        let Self { chain, high, strength, shapes, summed_steps, .. } = *self;
        let per_step = 1.0 / summed_steps as f64;
        Source { ends: Ends { chain, bent }, high, strength, shapes, per_step }
    }
}

impl<'a, R: Real, F: FnOnce() -> NodeSample> View<'a, R, F> {
    fn new(scene: &'a Scene<'a, R>, node: usize, sample: LazyCell<NodeSample, F>) -> Self {
        let tangent = scene.chain.tangent(node);
        let high = scene.anchors[node].high_side.into();
        Self { scene, node, tangent, high, right: tangent.cross(high), sample }
    }

    fn signal(&self, signal: NodeSignal) -> f64 {
        let Self { scene, node, tangent, high, right, ref sample } = *self;
        let chain = scene.chain;
        match signal {
            NodeSignal::Tension => self.at_ends(|i| element!(chain, i, tension)),
            NodeSignal::Torque => self.at_ends(|i| -element!(chain, i, torque)),
            NodeSignal::BendingMoment => sample.bending,
            NodeSignal::VonMisesStress => sample.stress,
            NodeSignal::ContactForce if sample.up < 0.0 => -sample.normal,
            NodeSignal::ContactForce => sample.normal,
            NodeSignal::OffsetHigh => sample.offset * sample.up,
            NodeSignal::OffsetRight => sample.offset * sample.right,
            NodeSignal::VelocityHigh => chain.velocity(node).dot(high),
            NodeSignal::VelocityRight => chain.velocity(node).dot(right),
            NodeSignal::AxialVelocity => chain.velocity(node).dot(tangent),
            NodeSignal::RotarySpeed => node!(chain, node, spin),
        }
    }

    /// The mean of the two elements at the node; at the ends there is but one.
    fn at_ends(&self, value: impl Fn(usize) -> f64) -> f64 {
        let above = self.node.saturating_sub(1);
        let below = self.node.min(self.scene.chain.elements() - 1);
        0.5 * (value(above) + value(below))
    }
}

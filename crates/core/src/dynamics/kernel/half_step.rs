//! Half a step back in time.

use crate::{rod::element::Pose, simd::vector::Vector};

/// Pose of an element half a step before, where the velocities are.
pub fn half_a_step_before(mut pose: Pose<f64>, dt: f64) -> Pose<f64> {
    let half = 0.5 * dt;
    pose.displacement = pose.displacement.minus(pose.velocity, half);
    // One explicit half step back along the sphere, then back to unit length.
    let back = |d: Vector<f64>, w: Vector<f64>| {
        let turned = d.minus(w.cross(d), half);
        turned.scaled(1.0 / turned.dot(turned).sqrt())
    };
    pose.d1 = back(pose.d1, pose.w1);
    pose.d2 = back(pose.d2, pose.w2);
    // The stored twist is that of the step's beginning.
    let share = 1.0 / (1.0 + pose.d1.dot(pose.d2));
    pose.twist += half * (pose.spin + share * (pose.w2.dot(pose.d1) - pose.w1.dot(pose.d2)));
    pose
}

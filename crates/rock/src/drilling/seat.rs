//! A bit that begins in its own bottom.

use nalgebra::Vector3;

use super::Drilling;

/// Step of the search by which the bit is lowered to its bottom, as a fraction of an element's
/// height.
const FINE: f64 = 1.0 / 64.0;

/// Maximum distance of the search, in elements: no pattern of elements leaves more room under it.
const FAR: f64 = 4.0;

impl Drilling {
    /// Removes the elements in the way of the bit turned about its axis, with its nose as deep as
    /// the wall is high, and lowers it until the face in its present position touches. Removed
    /// elements count as dropped.
    pub(super) fn seat(&mut self) {
        let grid = *self.block.grid();
        let nose_m = self.pose.position_m + Vector3::z() * self.wall_m;
        let profile = self.bit.face().profile();
        let [core_m, gauge_m] = [profile.core_radius_m(), profile.radius_m()];
        let [dx, dy, dz] = grid.size_m;
        for element in grid.each_element() {
            let [x, y] =
                [(element[0], dx, nose_m.x), (element[1], dy, nose_m.y)].map(|(i, d, middle)| {
                    let [from, to] = [i as f64 * d - middle, (i + 1) as f64 * d - middle];
                    [from.max(-to).max(0.0), to.max(-from)]
                });
            let [near_m, far_m] = [libm::hypot(x[0], y[0]), libm::hypot(x[1], y[1])];
            if near_m >= gauge_m || far_m <= core_m {
                continue;
            }
            let lowest_m = profile.lowest_between_m(near_m.max(core_m), far_m.min(gauge_m));
            if nose_m.z + lowest_m > element[2] as f64 * dz {
                self.block.remove(element);
                self.dropped += 1;
            }
        }
        self.pose.position_m = nose_m;
        let mut lower = self.pose;
        for _ in 0..(FAR / FINE) as usize {
            lower.position_m.z += FINE * dz;
            let mut nodes = self.block.exposed();
            let face = self.bit.face();
            if nodes.any(|node| face.holds(lower.to_bit(node.position_m.into())).is_some()) {
                break;
            }
            self.pose = lower;
        }
    }
}

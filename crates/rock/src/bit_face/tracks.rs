//! Surfaces that the cutters sweep, and their cuts, while the bit turns about its axis.

use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;

use super::{bottom::BottomHole, cutter::Cutter, profile::Profile};

/// The tracks of a face: for each cutter and each ring of the bottom the lowest point that it
/// passes, and the angle at which it does.
///
/// Rings are of equal width from the axis, or the core, to the gauge; a track is known at the
/// middle of each.
#[derive(Debug, Clone)]
pub struct Tracks {
    core_radius_m: f64,
    width_m: f64,
    cutters: usize,
    /// Depth and angle, cutter by cutter of a ring; minus infinity where the cutter does not reach.
    passes: Vec<Pass>,
    /// Depth of the profile on each ring, m.
    profile_m: Vec<f64>,
    /// Direction of the profile's normal at each cutter's tip across the axis, in the bit's frame.
    sideways: Vec<[f64; 2]>,
}

/// Height at which a cutter passes the middle of a ring.
#[derive(Debug, Clone, Copy)]
struct Pass {
    z_m: f64,
    angle_rad: f64,
}

/// Cut of each cutter from the bottom in a revolution.
#[derive(Debug, Clone, PartialEq)]
pub struct Cut {
    /// Advance per revolution that it is for, m.
    pub depth_of_cut_m: f64,
    /// Rock that each cutter removes in a revolution, m³. They add up to the area of the bottom
    /// times the depth of cut.
    pub volume_m3: Vec<f64>,
    /// Section of each cutter's cut in the plane of radius and depth, m². They add up to the width
    /// of the bottom times the depth of cut.
    pub area_m2: Vec<f64>,
    /// Sum of the cutters' drag across the axis, in the bit's frame, if each is its cut's area
    /// times one specific energy: against the sum of its magnitudes.
    pub drag_imbalance: [f64; 2],
    /// The same of thrusts along the profile's normals.
    pub thrust_imbalance: [f64; 2],
}

/// Rings of the bottom.
const RINGS: usize = 512;

/// Distance from the axis, in half widths of a cutter that contains it, at which verticals are
/// tested, and their number around it.
const AXIS: f64 = 0.25;
const VERTICALS: usize = 120;

impl Tracks {
    pub(super) fn new(profile: &Profile, cutters: &[Cutter]) -> Self {
        let core_radius_m = profile.core_radius_m();
        let width_m = (profile.radius_m() - core_radius_m) / RINGS as f64;
        let none = Pass { z_m: f64::NEG_INFINITY, angle_rad: 0.0 };
        let mut tracks = Self {
            core_radius_m,
            width_m,
            cutters: cutters.len(),
            passes: vec![none; cutters.len() * RINGS],
            profile_m: Vec::new(),
            sideways: cutters.iter().map(|c| [c.normal.x, c.normal.y]).collect(),
        };
        tracks.profile_m = (0..RINGS).map(|ring| profile.z_m(tracks.radius_m(ring))).collect();
        for (index, cutter) in cutters.iter().enumerate() {
            tracks.sweep(index, cutter);
        }
        tracks
    }

    /// Turns the lines of a cutter about the bit's axis.
    fn sweep(&mut self, index: usize, cutter: &Cutter) {
        for pair in cutter.lines.iter().flat_map(|line| line.windows(2)) {
            let along = pair[1] - pair[0];
            // Short enough for a straight line past the axis.
            let pieces = (2.0 * along.norm() / self.width_m).ceil().max(1.0);
            let point = |piece: f64| pair[0] + along * (piece / pieces);
            for piece in 0..pieces as usize {
                let [a, b] = [point(piece as f64), point(piece as f64 + 1.0)];
                let [ra, rb] = [a, b].map(|p| libm::hypot(p.x, p.y));
                let first = (ra.min(rb) - self.core_radius_m) / self.width_m - 0.5;
                for ring in first.ceil().max(0.0) as usize..RINGS {
                    let r = self.radius_m(ring);
                    if r > ra.max(rb) {
                        break;
                    }
                    let share = if rb == ra { 0.0 } else { (r - ra) / (rb - ra) };
                    self.pass(index, ring, a + (b - a) * share);
                }
            }
        }
        self.fill_axis(index, cutter);
    }

    /// Near the axis, which its lines pass at a distance, the cutter itself is tested: along
    /// verticals.
    fn fill_axis(&mut self, index: usize, cutter: &Cutter) {
        if lowest_above(cutter, 0.0, 0.0).is_none() {
            return;
        }
        let (half_width, _) = cutter.solid.extent();
        for ring in 0..RINGS {
            let radius = self.radius_m(ring);
            if radius > AXIS * half_width {
                break;
            }
            for vertical in 0..VERTICALS {
                let (sin, cos) = libm::sincos(TAU * vertical as f64 / VERTICALS as f64);
                let (x, y) = (radius * cos, radius * sin);
                if let Some(z) = lowest_above(cutter, x, y) {
                    self.pass(index, ring, Vector3::new(x, y, z));
                }
            }
        }
    }

    fn pass(&mut self, cutter: usize, ring: usize, point: Vector3<f64>) {
        let pass = &mut self.passes[ring * self.cutters + cutter];
        if point.z > pass.z_m {
            *pass = Pass { z_m: point.z, angle_rad: libm::atan2(point.y, point.x) };
        }
    }

    /// Number of rings.
    pub fn rings(&self) -> usize {
        RINGS
    }

    /// Radius of the middle of a ring, m.
    pub fn radius_m(&self, ring: usize) -> f64 {
        self.core_radius_m + self.width_m * (ring as f64 + 0.5)
    }

    /// The passes of a ring, cutter by cutter.
    fn ring(&self, ring: usize) -> &[Pass] {
        &self.passes[ring * self.cutters..(ring + 1) * self.cutters]
    }

    /// Lowest point that a cutter passes on a ring, m below the reference point; `None` where it
    /// does not reach.
    pub fn track_m(&self, cutter: usize, ring: usize) -> Option<f64> {
        let z = self.ring(ring)[cutter].z_m;
        (z > f64::NEG_INFINITY).then_some(z)
    }

    /// Lowest point that any cutter passes on a ring, m below the reference point: the bottom at no
    /// advance.
    pub fn envelope_m(&self, ring: usize) -> f64 {
        let deeper = |z: f64, pass: &Pass| z.max(pass.z_m);
        self.ring(ring).iter().fold(f64::NEG_INFINITY, deeper)
    }

    /// Height of the rock above the profile on a ring without advance, m: the ridge between the
    /// tracks.
    pub fn ridge_m(&self, ring: usize) -> f64 {
        self.profile_m[ring] - self.envelope_m(ring)
    }

    /// Cutters that remove rock from a ring at an advance per revolution.
    pub fn engaged(&self, ring: usize, depth_of_cut_m: f64) -> usize {
        (0..self.cutters)
            .filter(|&cutter| self.thickness_m(ring, cutter, depth_of_cut_m) > 0.0)
            .count()
    }

    /// The first rings that no cutter reaches outside a body, given by the distance from it at a
    /// radius and a depth.
    pub(super) fn uncut(&self, from_body: impl Fn(f64, f64) -> f64) -> Option<[f64; 2]> {
        let stands = |&ring: &usize| {
            let z = self.envelope_m(ring);
            z == f64::NEG_INFINITY || from_body(self.radius_m(ring), z) <= 0.0
        };
        let first = (0..RINGS).find(stands)?;
        let last = (first..RINGS).take_while(stands).last().unwrap_or(first);
        let half = 0.5 * self.width_m;
        Some([self.radius_m(first) - half, self.radius_m(last) + half])
    }

    /// Thickness that a cutter removes on a ring: from the deepest surface that the others, and
    /// itself a revolution ago, have left.
    fn thickness_m(&self, ring: usize, cutter: usize, depth_of_cut_m: f64) -> f64 {
        let passes = self.ring(ring);
        let own = passes[cutter];
        if own.z_m == f64::NEG_INFINITY {
            return 0.0;
        }
        let left = passes.iter().enumerate().map(|(other, pass)| {
            let ahead = (pass.angle_rad - own.angle_rad).rem_euclid(TAU) / TAU;
            // Of two that pass together the first counts as ahead by nothing, the other by a whole
            // turn.
            let turns = if ahead == 0.0 && other >= cutter { 1.0 } else { ahead };
            pass.z_m - depth_of_cut_m * turns
        });
        (own.z_m - left.fold(f64::NEG_INFINITY, f64::max)).max(0.0)
    }

    /// Volume and area that each cutter removes while the bit drills straight along its axis at an
    /// advance per revolution.
    pub fn cut(&self, depth_of_cut_m: f64) -> Cut {
        let mut cut = Cut {
            depth_of_cut_m,
            volume_m3: vec![0.0; self.cutters],
            area_m2: vec![0.0; self.cutters],
            drag_imbalance: [0.0; 2],
            thrust_imbalance: [0.0; 2],
        };
        let mut total = 0.0;
        for ring in 0..RINGS {
            for cutter in 0..self.cutters {
                let area = self.thickness_m(ring, cutter, depth_of_cut_m) * self.width_m;
                cut.area_m2[cutter] += area;
                cut.volume_m3[cutter] += area * TAU * self.radius_m(ring);
                let (sin, cos) = libm::sincos(self.ring(ring)[cutter].angle_rad);
                cut.drag_imbalance[0] += area * sin;
                cut.drag_imbalance[1] -= area * cos;
                for (sum, across) in cut.thrust_imbalance.iter_mut().zip(self.sideways[cutter]) {
                    *sum -= area * across;
                }
                total += area;
            }
        }
        if total > 0.0 {
            let sums = cut.drag_imbalance.iter_mut().chain(&mut cut.thrust_imbalance);
            sums.for_each(|sum| *sum /= total);
        }
        cut
    }

    /// The bottom that a bit leaves at an advance per revolution, its angle being `angle_rad` and
    /// its reference point at zero: in each sector the deepest that a cutter has left since it
    /// passed there.
    pub fn bottom(&self, depth_of_cut_m: f64, angle_rad: f64, sectors: usize) -> BottomHole {
        let outer = self.core_radius_m + self.width_m * RINGS as f64;
        let mut bottom = BottomHole::new([self.core_radius_m, outer], RINGS, sectors);
        for ring in 0..RINGS {
            for sector in 0..sectors {
                let at = bottom.angle_rad(sector);
                let left = self.ring(ring).iter().map(|pass| {
                    let turns = (pass.angle_rad + angle_rad - at).rem_euclid(TAU) / TAU;
                    pass.z_m - depth_of_cut_m * turns
                });
                bottom.set_m(ring, sector, left.fold(f64::NEG_INFINITY, f64::max));
            }
        }
        bottom
    }

    /// Area of the bottom across the axis, m².
    pub fn area_m2(&self) -> f64 {
        let outer = self.core_radius_m + self.width_m * RINGS as f64;
        PI * (outer * outer - self.core_radius_m * self.core_radius_m)
    }
}

/// Height at which a vertical enters a cutter from below, m; `None` if it misses the cutter. Each
/// step has the length of the distance to the cutter, which cannot miss a convex solid.
fn lowest_above(cutter: &Cutter, x: f64, y: f64) -> Option<f64> {
    let [top, bottom] = cutter.bounds();
    let mut z = bottom.z;
    while z >= top.z {
        let (distance, _) = cutter.distance(Vector3::new(x, y, z));
        if distance <= 1e-9 {
            return Some(z);
        }
        z -= distance;
    }
    None
}

//! The profile of a bit: the line in the plane of radius and depth on which the tips of its cutters
//! are.

use std::f64::consts::FRAC_PI_2;

use super::error::{FaceError, FaceNumber, positive, within};

/// The profile from the axis to the gauge: a straight cone, the arc of the nose, the arc of the
/// shoulder, and the straight gauge, joined without a corner.
///
/// Depth `z` grows down the hole and is zero at the nose, the lowest point. The nose's arc goes
/// from `−α`, the cone's angle, to `β`, the shoulder's from there to the right angle; both centres
/// are on one line, `(R_n − R_s) sin β = R − R_s − r_n`. A core bit has an inner gauge in the
/// cone's place, `α = π/2`.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    radius_m: f64,
    core_radius_m: f64,
    cone_angle_rad: f64,
    nose_m: f64,
    nose_radius_m: f64,
    shoulder_radius_m: f64,
    gauge_length_m: f64,
    /// Angle at which the nose's arc ends and the shoulder's begins, rad from straight down.
    shoulder_angle_rad: f64,
    /// Tangents, outwards, where the nose's arc begins and ends.
    tangents: [[f64; 2]; 2],
    /// Point at which the nose's arc begins.
    cone_end: [f64; 2],
    /// Length of the cone.
    cone_length_m: f64,
    /// Centre of the shoulder's arc.
    shoulder_centre: [f64; 2],
}

/// A point of the profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// From the axis, m.
    pub radius_m: f64,
    /// Below the bit's reference point, m.
    pub z_m: f64,
    /// Direction into the rock, outwards and down.
    pub normal: [f64; 2],
}

/// The lengths that make a profile.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outline {
    pub diameter_m: f64,
    pub core_diameter_m: f64,
    pub cone_angle_rad: f64,
    pub nose_m: f64,
    pub nose_radius_m: f64,
    pub shoulder_radius_m: f64,
    pub gauge_length_m: f64,
}

impl Profile {
    pub(super) fn new(outline: Outline) -> Result<Self, FaceError> {
        let Outline {
            diameter_m,
            core_diameter_m,
            nose_m,
            nose_radius_m,
            shoulder_radius_m,
            gauge_length_m,
            ..
        } = outline;
        positive(FaceNumber::Diameter, diameter_m)?;
        let radius_m = 0.5 * diameter_m;
        within(
            FaceNumber::CoreDiameter,
            core_diameter_m,
            0.0..=0.9 * diameter_m,
            "none, or less than 0.9 of the diameter",
        )?;
        let core_radius_m = 0.5 * core_diameter_m;
        let is_core = core_radius_m > 0.0;
        within(
            FaceNumber::Nose,
            nose_m,
            core_radius_m..=radius_m,
            "between the axis, or the core, and the gauge",
        )?;
        positive(FaceNumber::NoseRadius, nose_radius_m)?;
        positive(FaceNumber::ShoulderRadius, shoulder_radius_m)?;
        within(FaceNumber::GaugeLength, gauge_length_m, 0.0..=f64::MAX, "not negative")?;
        let cone_angle_rad = if is_core {
            within(
                FaceNumber::CoreNoseRadius,
                nose_radius_m,
                (nose_m - core_radius_m) * (1.0 - 1e-9)..=(nose_m - core_radius_m) * (1.0 + 1e-9),
                "the nose's distance from the core",
            )?;
            FRAC_PI_2
        } else {
            within(
                FaceNumber::ConeAngle,
                outline.cone_angle_rad,
                0.0..=1.3,
                "0 to 1.3 rad (75 deg)",
            )?;
            outline.cone_angle_rad
        };
        let (sin, cos) = libm::sincos(cone_angle_rad);
        let cone_end = [nose_m - nose_radius_m * sin, -nose_radius_m * (1.0 - cos)];
        within(
            FaceNumber::NoseRadius,
            nose_radius_m,
            0.0..=(nose_m / sin.max(1e-9)) * (1.0 + 1e-9),
            "small enough to keep the nose's arc on its side of the axis",
        )?;
        let reach_m = radius_m - nose_m;
        let difference = nose_radius_m - shoulder_radius_m;
        let sine = if difference.abs() > 1e-9 * radius_m {
            (reach_m - shoulder_radius_m) / difference
        } else if (nose_radius_m - reach_m).abs() <= 2e-9 * radius_m {
            1.0
        } else {
            f64::NAN
        };
        if !(-1e-6..=1.0 + 1e-6).contains(&sine) {
            return Err(FaceError::Profile { nose_radius_m, shoulder_radius_m, reach_m });
        }
        let shoulder_angle_rad = libm::asin(sine.clamp(0.0, 1.0));
        let (sin_s, cos_s) = libm::sincos(shoulder_angle_rad);
        Ok(Self {
            radius_m,
            core_radius_m,
            cone_angle_rad,
            nose_m,
            nose_radius_m,
            shoulder_radius_m,
            gauge_length_m,
            shoulder_angle_rad,
            tangents: [[cos, sin], [cos_s, -sin_s]],
            cone_end,
            cone_length_m: if is_core { 0.0 } else { cone_end[0] / cos },
            shoulder_centre: [radius_m - shoulder_radius_m, -nose_radius_m + difference * cos_s],
        })
    }

    /// Radius of the gauge, half the bit's diameter, m.
    pub fn radius_m(&self) -> f64 {
        self.radius_m
    }

    /// Radius of the core that stays, m; zero but for a core bit.
    pub fn core_radius_m(&self) -> f64 {
        self.core_radius_m
    }

    /// Height at which the shoulder ends and the gauge begins, m below the reference point:
    /// negative.
    pub fn gauge_z_m(&self) -> f64 {
        self.shoulder_centre[1]
    }

    /// Height at which the gauge ends, m below the reference point: negative.
    pub fn top_z_m(&self) -> f64 {
        self.gauge_z_m() - self.gauge_length_m
    }

    /// Length of the profile from the axis (or the core) to where the gauge begins, m.
    pub fn length_m(&self) -> f64 {
        self.cone_length_m
            + self.nose_radius_m * (self.cone_angle_rad + self.shoulder_angle_rad)
            + self.shoulder_radius_m * (FRAC_PI_2 - self.shoulder_angle_rad)
    }

    /// The point at a length from the axis (or the core) along the profile, m.
    pub fn at(&self, length_m: f64) -> ProfilePoint {
        let on_nose = length_m - self.cone_length_m;
        if on_nose < 0.0 {
            let [t, _] = self.tangents;
            return ProfilePoint {
                radius_m: self.cone_end[0] + on_nose * t[0],
                z_m: self.cone_end[1] + on_nose * t[1],
                normal: [-t[1], t[0]],
            };
        }
        let angle = on_nose / self.nose_radius_m - self.cone_angle_rad;
        let (centre, radius, angle) = if angle <= self.shoulder_angle_rad {
            ([self.nose_m, -self.nose_radius_m], self.nose_radius_m, angle)
        } else {
            let past = (angle - self.shoulder_angle_rad) * self.nose_radius_m;
            let angle = self.shoulder_angle_rad + past / self.shoulder_radius_m;
            (self.shoulder_centre, self.shoulder_radius_m, angle.min(FRAC_PI_2))
        };
        let (sin, cos) = libm::sincos(angle);
        ProfilePoint {
            radius_m: centre[0] + radius * sin,
            z_m: centre[1] + radius * cos,
            normal: [sin, cos],
        }
    }

    /// Depth of the profile at a radius, m; that of the nearest end where there is none.
    pub fn z_m(&self, radius_m: f64) -> f64 {
        let [inner, _] = self.tangents;
        let outer = self.nose_m + self.nose_radius_m * libm::sin(self.shoulder_angle_rad);
        let arc = |centre: [f64; 2], arc: f64| {
            let off = (radius_m - centre[0]).clamp(-arc, arc);
            centre[1] + (arc * arc - off * off).sqrt()
        };
        if radius_m < self.cone_end[0] {
            if self.core_radius_m > 0.0 {
                self.cone_end[1]
            } else {
                self.cone_end[1] + (radius_m - self.cone_end[0]) * inner[1] / inner[0]
            }
        } else if radius_m <= outer {
            arc([self.nose_m, -self.nose_radius_m], self.nose_radius_m)
        } else {
            arc(self.shoulder_centre, self.shoulder_radius_m)
        }
    }

    /// Lowest point of the profile between two radii, m.
    pub(crate) fn lowest_between_m(&self, from_m: f64, to_m: f64) -> f64 {
        self.z_m(self.nose_m.clamp(from_m, to_m.max(from_m)))
    }

    /// Distance of a point from the profile, positive on the rock's side, m, and the direction in
    /// which it grows.
    pub(super) fn distance(&self, radius_m: f64, z_m: f64) -> (f64, [f64; 2]) {
        let [inner, outer] = self.tangents;
        let from_nose = [radius_m - self.nose_m, z_m + self.nose_radius_m];
        let before = from_nose[0] * inner[0] + from_nose[1] * inner[1] < 0.0;
        let beyond = from_nose[0] * outer[0] + from_nose[1] * outer[1] > 0.0;
        // Far inside, above the nose's centre, a point is outside both: the nearer one counts.
        let cone = before.then(|| self.cone_distance(radius_m, z_m));
        let shoulder = beyond.then(|| {
            let from = [radius_m - self.shoulder_centre[0], z_m - self.shoulder_centre[1]];
            if from[1] < 0.0 {
                (radius_m - self.radius_m, [1.0, 0.0])
            } else {
                arc_distance(from, self.shoulder_radius_m)
            }
        });
        match (cone, shoulder) {
            (Some(cone), Some(shoulder)) if cone.0 > shoulder.0 => cone,
            (_, Some(shoulder)) => shoulder,
            (Some(cone), None) => cone,
            (None, None) => arc_distance(from_nose, self.nose_radius_m),
        }
    }

    fn cone_distance(&self, radius_m: f64, z_m: f64) -> (f64, [f64; 2]) {
        let [t, _] = self.tangents;
        let from = [radius_m - self.cone_end[0], z_m - self.cone_end[1]];
        let past = -(from[0] * t[0] + from[1] * t[1]) - self.cone_length_m;
        if self.core_radius_m == 0.0 && past > 0.0 {
            // Inside the bit, nearest to the cone's apex on the axis.
            let apex = [radius_m, from[1] + self.cone_length_m * t[1]];
            let distance = libm::hypot(apex[0], apex[1]).max(f64::MIN_POSITIVE);
            return (-distance, [-apex[0] / distance, -apex[1] / distance]);
        }
        (t[0] * from[1] - t[1] * from[0], [-t[1], t[0]])
    }
}

/// Distance from an arc of a point given from its centre.
fn arc_distance(from: [f64; 2], arc: f64) -> (f64, [f64; 2]) {
    let distance = (from[0] * from[0] + from[1] * from[1]).sqrt();
    let inverse = 1.0 / distance.max(f64::MIN_POSITIVE);
    (distance - arc, [from[0] * inverse, from[1] * inverse])
}

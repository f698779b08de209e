//! Bits with inserts: the teeth of a roller cone, held still.

use std::f64::consts::{FRAC_PI_2, TAU};

use serde::{Deserialize, Serialize};

use super::{
    body::Body,
    cutter::{Cutter, OFF_AXIS},
    error::{FaceError, FaceNumber, positive, within},
    face::BitFace,
    profile::{Outline, Profile},
    revolved::Revolved,
};

/// Shape of an insert's tip.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum InsertShape {
    /// Half a ball of the insert's diameter.
    Hemisphere,
    /// A cone with a rounded tip.
    Cone {
        /// Between the cone's side and its axis, rad.
        half_angle_rad: f64,
        /// Radius of the rounded tip, m.
        tip_radius_m: f64,
    },
}

/// A face of carbide inserts in rows, by its numbers.
///
/// The cones of a roller bit do **not** roll here: the inserts are fixed on one body of revolution
/// and scrape, as those of an impregnated or percussion bit do. Weight and penetration of a row's
/// inserts are those of a roller bit; the torque of its rolling is not.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct InsertBit {
    /// Diameter of the hole that it cuts, m.
    pub diameter_m: f64,
    /// Diameter of an insert, m. Default: 0.065 of the bit's. Larger ones leave lower ridges.
    pub insert_diameter_m: f64,
    /// Protrusion of the inserts from the body, m. Default: half an insert's diameter.
    pub protrusion_m: f64,
    /// Shape of the tips. Default: hemispheres.
    pub shape: InsertShape,
    /// Rows of inserts from the axis to the gauge. Default: as many as leave no more than the
    /// inserts' own width between them.
    pub rows: usize,
    /// Distance between the inserts of a row, m, about. Default: 1.5 of an insert's diameter.
    pub pitch_m: f64,
    /// Angle of the inner cone against the plane across the axis, rad. Default: 10°.
    pub cone_angle_rad: f64,
    /// Radius at which the profile is lowest, m. Default: 0.6 of the bit's.
    pub nose_m: f64,
    /// Radius of the nose's arc, m. Default: 0.4 of the bit's.
    pub nose_radius_m: f64,
    /// Radius of the shoulder's arc, m. Default: 0.4 of the bit's.
    pub shoulder_radius_m: f64,
    /// Length of the gauge above the shoulder, m. Default: a quarter of the diameter.
    pub gauge_length_m: f64,
    /// Distance of the gauge pads behind the gauge, m. Default: 0.4 mm.
    pub gauge_relief_m: f64,
}

/// Turn of a row against the one inside it, of a pitch: the golden section, so that no two rows
/// line up.
const STAGGER: f64 = 0.618_033_988_749_894_8;

/// Points of a quarter of a tip's arc.
const ARC_POINTS: usize = 90;

impl InsertBit {
    /// A bit of this diameter with the defaults.
    pub fn for_diameter(diameter_m: f64) -> Self {
        let radius = 0.5 * diameter_m;
        let insert = 0.065 * diameter_m;
        let bit = Self {
            diameter_m,
            insert_diameter_m: insert,
            protrusion_m: 0.5 * insert,
            shape: InsertShape::Hemisphere,
            rows: 2,
            pitch_m: 1.5 * insert,
            cone_angle_rad: 10.0_f64.to_radians(),
            nose_m: 0.6 * radius,
            nose_radius_m: 0.4 * radius,
            shoulder_radius_m: 0.4 * radius,
            gauge_length_m: 0.25 * diameter_m,
            gauge_relief_m: 0.4e-3,
        };
        bit.filled()
    }

    /// With as many rows as leave no more than the inserts' own width between them. As it is where
    /// its other numbers make no profile.
    #[must_use]
    pub fn filled(mut self) -> Self {
        if let Ok(profile) = self.profile() {
            let rows = (profile.length_m() / self.insert_diameter_m + 1.0 - OFF_AXIS).ceil();
            self.rows = rows as usize;
        }
        self
    }

    fn profile(&self) -> Result<Profile, FaceError> {
        Profile::new(Outline {
            diameter_m: self.diameter_m,
            core_diameter_m: 0.0,
            cone_angle_rad: self.cone_angle_rad,
            nose_m: self.nose_m,
            nose_radius_m: self.nose_radius_m,
            shoulder_radius_m: self.shoulder_radius_m,
            gauge_length_m: self.gauge_length_m,
        })
    }

    /// The bit's face.
    ///
    /// # Errors
    ///
    /// A number out of its range; arcs that do not join nose and gauge; a ring of the bottom that
    /// no insert reaches.
    pub fn face(&self) -> Result<BitFace, FaceError> {
        let profile = self.profile()?;
        positive(FaceNumber::InsertDiameter, self.insert_diameter_m)?;
        within(
            FaceNumber::Protrusion,
            self.protrusion_m,
            1e-4..=self.insert_diameter_m,
            "0.1 mm up to the insert's diameter",
        )?;
        within(FaceNumber::Rows, self.rows as f64, 1.0..=200.0, "1 to 200")?;
        within(
            FaceNumber::Pitch,
            self.pitch_m,
            self.insert_diameter_m..=f64::MAX,
            "no less than the insert's diameter",
        )?;
        let relief = 0.0..=0.5 * self.insert_diameter_m;
        within(
            FaceNumber::GaugeRelief,
            self.gauge_relief_m,
            relief,
            "none, or up to an insert's radius",
        )?;
        let (solid, tip_radius, outline) = self.tip()?;
        let spacing = profile.length_m() / (self.rows as f64 - 1.0 + OFF_AXIS);
        let mut cutters = Vec::new();
        for row in 0..self.rows {
            let point = profile.at(spacing * (row as f64 + OFF_AXIS));
            let count = (TAU * point.radius_m / self.pitch_m).floor().max(1.0);
            let stagger = (STAGGER * row as f64).fract();
            for insert in 0..count as usize {
                let angle = TAU * (insert as f64 + stagger) / count;
                cutters.push(Cutter::upright(row, point, angle, solid, tip_radius, &outline));
            }
        }
        let body = Body {
            offset_m: self.protrusion_m,
            pad_radius_m: 0.5 * self.diameter_m - self.gauge_relief_m,
            blades: None,
        };
        BitFace::new(profile, cutters, self.insert_diameter_m, body)
    }

    /// The solid of an insert, its tip's radius, and its half section from the tip on.
    fn tip(&self) -> Result<(Revolved, f64, Vec<[f64; 2]>), FaceError> {
        let a = 0.5 * self.insert_diameter_m;
        let foot = -2.0 * self.insert_diameter_m;
        let (tip, half_angle) = match self.shape {
            InsertShape::Hemisphere => (a, 0.0),
            InsertShape::Cone { half_angle_rad, tip_radius_m } => {
                within(
                    FaceNumber::HalfAngle,
                    half_angle_rad,
                    0.1..=1.4,
                    "0.1 to 1.4 rad (80 deg)",
                )?;
                within(
                    FaceNumber::TipRadius,
                    tip_radius_m,
                    0.1 * a..=0.99 * a,
                    "0.1 to 0.99 of the insert's radius",
                )?;
                (tip_radius_m, half_angle_rad)
            }
        };
        let (rho, corner) = match self.shape {
            InsertShape::Hemisphere => (0.0, 0.0),
            InsertShape::Cone { .. } => (a - tip, -(a - tip) / libm::tan(half_angle)),
        };
        let foot = foot.min(corner - a);
        let turn = FRAC_PI_2 - half_angle;
        let arc = |centre: [f64; 2], from: f64, to: f64| {
            (0..=ARC_POINTS).map(move |i| {
                let (sin, cos) = libm::sincos(from + (to - from) * i as f64 / ARC_POINTS as f64);
                [centre[0] + tip * sin, centre[1] + tip * cos]
            })
        };
        let mut outline: Vec<_> = arc([0.0, 0.0], 0.0, turn).collect();
        outline.extend(arc([rho, corner], turn, FRAC_PI_2));
        outline.push([a, foot]);
        let solid = Revolved::new(&[[0.0, 0.0], [rho, corner], [rho, foot], [0.0, foot]], tip);
        Ok((solid, tip, outline))
    }
}

//! Drag bits with PDC cutters, core bits among them.

use serde::{Deserialize, Serialize};

use super::{
    body::{Blades, Body},
    cutter::{Cutter, Disc, OFF_AXIS},
    error::{FaceError, FaceNumber, positive, within},
    face::BitFace,
    profile::{Outline, Profile},
};

/// A drag bit with discs of polycrystalline diamond on blades, by its numbers.
///
/// Cutters are placed along the profile on *tracks*, one after the other on blades that are
/// opposite each other. The innermost one cuts the axis, the outermost one the gauge. Defaults are
/// those of [`PdcBit::for_diameter`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PdcBit {
    /// Diameter of the hole that it cuts, m.
    pub diameter_m: f64,
    /// Diameter of the core that it leaves, m; zero (default) of a bit that cuts the whole bottom.
    pub core_diameter_m: f64,
    /// Number of blades. Default: 5 below 165 mm, 6, 7 from 312 mm. More blades thin the cut of
    /// each.
    pub blades: usize,
    /// Cutters on a blade. Default: as many as leave half a cutter's width between them on average.
    /// More thin the cut of each and lower the ridges between the tracks.
    pub cutters_per_blade: usize,
    /// Cutters that follow each other on a track, spread evenly over the blades. Default 1. With 2
    /// or more the cutting forces of a track balance.
    pub cutters_per_track: usize,
    /// Diameter of a cutter, m. Default: 8 mm below 120 mm, 13 mm below 165 mm,
    /// 16 mm, 19 mm from 312 mm.
    pub cutter_diameter_m: f64,
    /// Length of a cutter, its carbide included, m. Default: 0.8 of its diameter.
    pub cutter_length_m: f64,
    /// Width of the chamfer at 45° around its face, m. Default: 0.4 mm. Zero: sharp.
    pub chamfer_m: f64,
    /// Back rake, rad: by how much the face leans so that its edge trails. Default: 17.5°. More
    /// takes more weight for the same torque.
    pub back_rake_rad: f64,
    /// Side rake, rad: by how much the face is turned to push cuttings outwards. Default: 5°.
    pub side_rake_rad: f64,
    /// Angle of the inner cone against the plane across the axis, rad. Default: 15°. No effect on a
    /// core bit.
    pub cone_angle_rad: f64,
    /// Radius at which the profile is lowest, m. Default: 0.6 of the bit's; of a core bit halfway
    /// across its face.
    pub nose_m: f64,
    /// Radius of the nose's arc, m. Default: 0.3 of the bit's; of a core bit half the width of its
    /// face.
    pub nose_radius_m: f64,
    /// Radius of the shoulder's arc, m. Default: 0.5 of the bit's; of a core bit half the width of
    /// its face. Of this and the nose's radius one must be no smaller and one no larger than the
    /// way from the nose to the gauge.
    pub shoulder_radius_m: f64,
    /// Length of the gauge above the shoulder, m. Default: a quarter of the diameter.
    pub gauge_length_m: f64,
    /// Distance of the gauge pads behind the gauge, m. Default: 0.4 mm.
    pub gauge_relief_m: f64,
    /// Angle by which a blade's outer end trails its inner one, rad. Default: 20°.
    pub spiral_rad: f64,
    /// Exposure of the cutters' tips in front of the blades, m. Default: half a cutter's diameter.
    /// With less, the blades carry weight from a smaller depth of cut.
    pub exposure_m: f64,
    /// Width of a blade behind its cutters, m. Default: a fifth of the diameter.
    pub blade_width_m: f64,
    /// Spacing of the tracks at the axis against that at the gauge, linear along the profile.
    /// Default 1.5, of a core bit
    /// 1. More gives the outer cutters, which run faster, less to cut.
    pub centre_spacing: f64,
}

/// Most cutters that a blade may carry.
const MAX_ON_A_BLADE: usize = 200;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

impl PdcBit {
    /// A bit of this diameter with the defaults.
    pub fn for_diameter(diameter_m: f64) -> Self {
        let radius = 0.5 * diameter_m;
        let (blades, cutter_diameter_m) = match diameter_m {
            ..0.12 => (5, 0.008),
            ..0.165 => (5, 0.013),
            ..0.312 => (6, 0.016),
            _ => (7, 0.019),
        };
        let bit = Self {
            diameter_m,
            core_diameter_m: 0.0,
            blades,
            cutters_per_blade: 1,
            cutters_per_track: 1,
            cutter_diameter_m,
            cutter_length_m: 0.8 * cutter_diameter_m,
            chamfer_m: 0.4e-3,
            back_rake_rad: 17.5 * DEGREE,
            side_rake_rad: 5.0 * DEGREE,
            cone_angle_rad: 15.0 * DEGREE,
            nose_m: 0.6 * radius,
            nose_radius_m: 0.3 * radius,
            shoulder_radius_m: 0.5 * radius,
            gauge_length_m: 0.25 * diameter_m,
            gauge_relief_m: 0.4e-3,
            spiral_rad: 20.0 * DEGREE,
            exposure_m: 0.5 * cutter_diameter_m,
            blade_width_m: 0.2 * diameter_m,
            centre_spacing: 1.5,
        };
        bit.filled()
    }

    /// A core bit of this diameter that leaves a core of `core_diameter_m`, with the defaults.
    pub fn core(diameter_m: f64, core_diameter_m: f64) -> Self {
        let arc = 0.25 * (diameter_m - core_diameter_m);
        let bit = Self {
            core_diameter_m,
            nose_m: 0.5 * core_diameter_m + arc,
            nose_radius_m: arc,
            shoulder_radius_m: arc,
            centre_spacing: 1.0,
            ..Self::for_diameter(diameter_m)
        };
        bit.filled()
    }

    /// With as many cutters on a blade as leave half a cutter's width between them on average, or
    /// fewer, until they have room at the sharpest bend of the profile. As it is where its other
    /// numbers make no profile.
    #[must_use]
    pub fn filled(mut self) -> Self {
        if let (Ok(profile), Ok(())) = (self.profile(), self.check()) {
            let room = profile.length_m() / (1.5 * self.cutter_diameter_m);
            self.cutters_per_blade = (room as usize).clamp(1, MAX_ON_A_BLADE);
            while self.cutters_per_blade > 1 && self.layout(&profile).is_err() {
                self.cutters_per_blade -= 1;
            }
        }
        self
    }

    fn profile(&self) -> Result<Profile, FaceError> {
        Profile::new(Outline {
            diameter_m: self.diameter_m,
            core_diameter_m: self.core_diameter_m,
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
    /// A number out of its range; arcs that do not join nose and gauge; cutters of a blade that
    /// overlap; a ring of the bottom that no cutter cuts.
    pub fn face(&self) -> Result<BitFace, FaceError> {
        let profile = self.profile()?;
        self.check()?;
        let cutters = self.layout(&profile)?;
        let body = Body {
            offset_m: self.exposure_m,
            pad_radius_m: 0.5 * self.diameter_m - self.gauge_relief_m,
            blades: Some(self.blades()),
        };
        BitFace::new(profile, cutters, self.cutter_diameter_m, body)
    }

    fn blades(&self) -> Blades {
        Blades {
            count: self.blades,
            width_m: self.blade_width_m,
            lag_rad_per_m: self.spiral_rad / (0.5 * self.diameter_m),
        }
    }

    /// The cutters on their blades, from the axis outwards.
    fn layout(&self, profile: &Profile) -> Result<Vec<Cutter>, FaceError> {
        let disc = Disc {
            radius_m: 0.5 * self.cutter_diameter_m,
            length_m: self.cutter_length_m,
            chamfer_m: self.chamfer_m,
        };
        let (blades, rake) = (self.blades(), [self.back_rake_rad, self.side_rake_rad]);
        let sets = self.blades / self.cutters_per_track;
        let tracks = self.cutters_per_blade * sets;
        let mut cutters = Vec::with_capacity(tracks * self.cutters_per_track);
        for (track, length) in self.spread(tracks, profile.length_m()).enumerate() {
            let point = profile.at(length);
            // Neighbouring tracks are placed on blades that are no neighbours.
            let turn = track % sets;
            let set = turn / 2 + (turn % 2) * sets.div_ceil(2);
            for blade in (set..self.blades).step_by(sets) {
                let angle = blades.front_rad(blade, point.radius_m);
                cutters.push(Cutter::disc(blade, point, angle, rake, disc));
            }
        }
        self.apart(&cutters)?;
        Ok(cutters)
    }

    fn check(&self) -> Result<(), FaceError> {
        for (number, count, most, expected) in [
            (FaceNumber::Blades, self.blades, 24.0, "1 to 24"),
            (FaceNumber::CuttersPerBlade, self.cutters_per_blade, 200.0, "1 to 200"),
            (FaceNumber::CuttersPerTrack, self.cutters_per_track, 24.0, "1 to 24"),
        ] {
            within(number, count as f64, 1.0..=most, expected)?;
        }
        if !self.blades.is_multiple_of(self.cutters_per_track) {
            return Err(FaceError::Unspread {
                cutters_per_track: self.cutters_per_track,
                blades: self.blades,
            });
        }
        let a = 0.5 * self.cutter_diameter_m;
        positive(FaceNumber::CutterDiameter, self.cutter_diameter_m)?;
        positive(FaceNumber::CutterLength, self.cutter_length_m)?;
        let chamfer = 0.0..=0.5 * a.min(self.cutter_length_m);
        within(
            FaceNumber::Chamfer,
            self.chamfer_m,
            chamfer,
            "none, or up to half of the cutter's radius and length",
        )?;
        within(FaceNumber::BackRake, self.back_rake_rad, 0.0..=0.75, "0 to 0.75 rad (43 deg)")?;
        within(
            FaceNumber::SideRake,
            self.side_rake_rad,
            -0.75..=0.75,
            "-0.75 to 0.75 rad (43 deg)",
        )?;
        within(
            FaceNumber::GaugeRelief,
            self.gauge_relief_m,
            0.0..=a,
            "none, or up to a cutter's radius",
        )?;
        within(FaceNumber::Spiral, self.spiral_rad, -3.2..=3.2, "at most half a turn")?;
        within(
            FaceNumber::Exposure,
            self.exposure_m,
            1e-4..=2.0 * a,
            "0.1 mm up to a cutter's diameter",
        )?;
        positive(FaceNumber::BladeWidth, self.blade_width_m)?;
        within(FaceNumber::CentreSpacing, self.centre_spacing, 0.2..=5.0, "0.2 to 5")
    }

    /// Positions of the tracks along a profile, m. The first is a quarter of a spacing from the
    /// axis (a core bit's on its core), the last on the gauge.
    fn spread(&self, tracks: usize, length_m: f64) -> impl Iterator<Item = f64> {
        let gaps = tracks.saturating_sub(1);
        let weight = |gap: usize| {
            let outwards = gap as f64 / gaps.saturating_sub(1).max(1) as f64;
            self.centre_spacing + (1.0 - self.centre_spacing) * outwards
        };
        let first = if self.core_diameter_m > 0.0 { 0.0 } else { OFF_AXIS * weight(0) };
        let sum: f64 = (0..gaps).map(weight).sum();
        let unit = length_m / (first + sum);
        let before: Vec<f64> = (0..gaps)
            .scan(first, |at, gap| {
                let here = *at;
                *at += weight(gap);
                Some(here * unit)
            })
            .collect();
        before.into_iter().chain([length_m])
    }

    /// Whether the cutters of each blade have room next to each other.
    fn apart(&self, cutters: &[Cutter]) -> Result<(), FaceError> {
        for (second, outer) in cutters.iter().enumerate() {
            let inner = (0..second).rev().find(|&i| cutters[i].blade == outer.blade);
            let Some(first) = inner else { continue };
            let distance_m = (cutters[first].origin - outer.origin).norm();
            if distance_m < self.cutter_diameter_m {
                return Err(FaceError::Overlap {
                    first,
                    second,
                    distance_m,
                    diameter_m: self.cutter_diameter_m,
                });
            }
        }
        Ok(())
    }
}

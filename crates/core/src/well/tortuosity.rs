//! Tortuosity of a planned path: the actual path to be expected for a plan's smooth curve.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use serde::Serialize;

use super::{Path, PathError, Station};
use crate::random::Random;

/// The form that a planned path's departures take.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum TortuosityKind {
    /// Random at each course length: inclination by up to the amplitude to either side, azimuth by
    /// half of that across the hole, so that it depends on the inclination.
    Random,
    /// Inclination as a sine of measured depth, azimuth in step with it by half as much across the
    /// hole.
    Sinusoidal,
    /// A helix about the plan, the hole always the amplitude off its direction.
    Helical,
}

/// Deviation of a planned path from its smooth curve, in angles: amplitude and period.
///
/// An angle `Δ` towards the high side goes with `Δ/2` across the hole, which is an azimuth of
/// `Δ/(2 sin θ)`, `θ` the inclination. Theory and sources: `docs/src/theory/tortuosity.md`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Tortuosity {
    /// Its form.
    pub kind: TortuosityKind,
    /// Largest angle towards the high side, of a helix to any side, rad.
    pub amplitude_rad: f64,
    /// Length of a wave, or the course length after which the next random angle is taken, m.
    pub period_m: f64,
    /// Measured depths between which it acts, m; it grows from nothing and dies away within a
    /// period of them.
    pub md_m: [f64; 2],
    /// Which of the random paths.
    pub seed: u64,
}

impl Tortuosity {
    /// Stations of a wave; more change the loads of a soft string by less than 2 %.
    pub const STATIONS: f64 = 16.0;

    /// Distance of the stations that it needs, m.
    pub fn spacing_m(&self) -> f64 {
        match self.kind {
            TortuosityKind::Random => self.period_m,
            TortuosityKind::Sinusoidal | TortuosityKind::Helical => self.period_m / Self::STATIONS,
        }
    }

    /// Angles towards the high side and to its right at a measured depth, rad. `draws` are the
    /// random numbers at each course length.
    fn angles_rad(&self, md_m: f64, draws: &[f64]) -> [f64; 2] {
        let [from_m, to_m] = self.md_m;
        let periods = (md_m - from_m) / self.period_m;
        let left = (to_m - md_m) / self.period_m;
        if periods <= 0.0 || left <= 0.0 {
            return [0.0; 2];
        }
        let amplitude_rad = self.amplitude_rad * periods.min(left).min(1.0);
        match self.kind {
            TortuosityKind::Random => {
                // Between two draws, evenly from one to the next; nothing at the ends.
                let index = periods as usize;
                let draw = |index: usize| match index.checked_sub(1) {
                    Some(index) => draws.get(index).copied().unwrap_or(0.0),
                    None => 0.0,
                };
                let part = periods - index as f64;
                let angle_rad =
                    self.amplitude_rad * ((1.0 - part) * draw(index) + part * draw(index + 1));
                [angle_rad, 0.5 * angle_rad]
            }
            TortuosityKind::Sinusoidal => {
                let angle_rad = amplitude_rad * libm::sin(TAU * periods);
                [angle_rad, 0.5 * angle_rad]
            }
            TortuosityKind::Helical => {
                let (sin, cos) = libm::sincos(TAU * periods);
                [amplitude_rad * cos, amplitude_rad * sin]
            }
        }
    }
}

/// Stations nearer than this part of the spacing are one.
const NEAR: f64 = 1e-3;

impl Path {
    /// The same path with tortuosity: with stations in between where it needs them, all turned by
    /// its angles. Measured depths, first and last direction are the plan's; of no amplitude it is
    /// the plan itself.
    ///
    /// # Errors
    /// Those of [`Path::new`].
    pub fn with_tortuosity(&self, tortuosity: &Tortuosity) -> Result<Self, PathError> {
        let [from_m, to_m] = tortuosity.md_m;
        let spacing_m = tortuosity.spacing_m();
        let is_there = tortuosity.amplitude_rad > 0.0 && spacing_m > 0.0 && to_m > from_m;
        if !is_there {
            return Ok(self.clone());
        }
        let mut depths: Vec<f64> = self.stations().iter().map(|station| station.md_m).collect();
        let count = ((to_m - from_m) / spacing_m).ceil() as usize;
        let between = (0..=count).map(|index| from_m + index as f64 * spacing_m);
        let inside = between.chain([to_m]).filter(|md_m| {
            let next = depths.partition_point(|station_m| station_m < md_m);
            let near = |index: usize| {
                depths.get(index).is_some_and(|depth| (depth - md_m).abs() < NEAR * spacing_m)
            };
            let is_known = near(next) || next.checked_sub(1).is_some_and(near);
            *md_m <= to_m && !is_known
        });
        let added: Vec<f64> = inside.collect();
        depths.extend(added);
        depths.sort_by(f64::total_cmp);
        depths.dedup_by(|next, before| *next - *before < NEAR * spacing_m);
        let mut random = Random::new(tortuosity.seed);
        let draws = ((to_m - from_m) / tortuosity.period_m).ceil() as usize;
        let draws: Vec<f64> = (0..draws.saturating_sub(1)).map(|_| random.signed()).collect();
        let (first_m, last_m) = (self.first_md_m(), self.last_md_m());
        let stations: Vec<Station> = depths
            .into_iter()
            .filter(|md_m| (first_m..=last_m).contains(md_m))
            .map(|md_m| self.turned(md_m, tortuosity.angles_rad(md_m, &draws)))
            .collect();
        let start_m = self.at(first_m).position_m;
        let tie_in = super::TieIn { north_m: start_m.x, east_m: start_m.y, tvd_m: start_m.z };
        Self::new(&stations, self.interpolation(), tie_in)
    }

    /// A station whose direction is turned by angles towards the high side and to its right, rad.
    fn turned(&self, md_m: f64, [high_rad, right_rad]: [f64; 2]) -> Station {
        let tangent = self.at(md_m).tangent;
        let angle_rad = libm::hypot(high_rad, right_rad);
        let index = self.stations().partition_point(|station| station.md_m < md_m);
        if angle_rad == 0.0
            && let Some(planned) = self.stations().get(index).filter(|station| station.md_m == md_m)
        {
            return *planned;
        }
        let high = self.high_side_at(md_m);
        let right = tangent.cross(&high);
        let towards = (high * high_rad + right * right_rad).try_normalize(0.0);
        let towards = towards.unwrap_or_else(Vector3::zeros);
        let t = tangent * libm::cos(angle_rad) + towards * libm::sin(angle_rad);
        Station {
            md_m,
            inclination_rad: libm::atan2(libm::hypot(t.x, t.y), t.z),
            azimuth_rad: libm::atan2(t.y, t.x).rem_euclid(TAU),
        }
    }

    /// Sum of the doglegs from station to station, rad.
    pub fn turn_rad(&self) -> f64 {
        self.stations().windows(2).map(|pair| pair[0].dogleg_rad(&pair[1])).sum()
    }
}

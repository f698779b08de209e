//! Natural frequencies against rotary speed, and where orders of the rotation meet them.

use std::f64::consts::TAU;

use super::{
    ModalError,
    assembly::{Assembly, Modes, is_own},
    family::Family,
    mode::{Mode, Place, Whirl},
    whirl::TurningMode,
};
use crate::complex;

/// Steps of the secant that bring a crossing to the last digits that count.
const SECANTS: usize = 6;

/// A natural frequency against rotary speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    /// Family with most of its kinetic energy.
    pub family: Family,
    /// Its number within the family, from one.
    pub number: usize,
    /// Which way it goes round at the highest speed, of lateral modes.
    pub whirl: Option<Whirl>,
    /// Natural frequency at each speed, Hz.
    pub frequency_Hz: Vec<f64>,
}

/// A rotary speed at which an order of the rotation meets a natural frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Critical {
    /// Times a turn.
    pub order: f64,
    /// Rotary speed, rad/s.
    pub rotary_rad_per_s: f64,
    /// Natural frequency there, Hz.
    pub frequency_Hz: f64,
    /// Number of its branch.
    pub branch: usize,
    /// Place of the greatest strain.
    pub most_strained: Place,
}

/// Natural frequencies against rotary speed, and where orders meet them.
#[derive(Debug, Clone, PartialEq)]
pub struct Campbell {
    /// Rotary speeds, rad/s.
    pub rotary_rad_per_s: Vec<f64>,
    /// The assembly's lateral modes, then axial and torsional ones.
    pub branches: Vec<Branch>,
    /// By rising speed.
    pub critical: Vec<Critical>,
}

/// Similarity of two motions.
fn alike(a: &TurningMode, b: &TurningMode) -> f64 {
    complex::norm(a.parts.iter().zip(&b.parts).map(|(x, y)| x.conj() * y).sum())
}

impl Assembly<'_> {
    /// The Campbell diagram of so many lateral modes of the assembly and of axial and torsional
    /// modes that are known, over rising rotary speeds, rad/s.
    ///
    /// The state at rest is that of the operation at every speed. Rotation changes the lateral
    /// modes alone.
    ///
    /// # Errors
    /// Where the modes were not all found.
    pub fn campbell(
        &self,
        count: usize,
        others: &[Mode],
        rotary_rad_per_s: &[f64],
        orders: &[f64],
    ) -> Result<Campbell, ModalError> {
        let modes = self.modes(0.0, count)?;
        let tracks = self.tracks(&modes, rotary_rad_per_s, count);
        let mut branches = Vec::new();
        let mut critical = Vec::new();
        for track in tracks {
            let fastest = track.last().map(|track| self.mode(&modes, track.omega, &track.parts));
            let frequency_Hz: Vec<f64> = track.iter().map(|track| track.omega / TAU).collect();
            for &order in orders {
                critical.extend(self.crossings(
                    &modes,
                    rotary_rad_per_s,
                    &track,
                    order,
                    branches.len(),
                ));
            }
            branches.push(Branch {
                family: Family::Lateral,
                number: branches.len() + 1,
                whirl: fastest.and_then(|mode| mode.whirl()),
                frequency_Hz,
            });
        }
        let range = || rotary_rad_per_s.first().zip(rotary_rad_per_s.last());
        for mode in others {
            for &order in orders {
                let at = TAU * mode.frequency_Hz / order;
                if range().is_some_and(|(from, to)| *from <= at && at <= *to) {
                    critical.push(Critical {
                        order,
                        rotary_rad_per_s: at,
                        frequency_Hz: mode.frequency_Hz,
                        branch: branches.len(),
                        most_strained: mode.most_strained.clone(),
                    });
                }
            }
            let alike = |branch: &&Branch| branch.family == mode.family;
            branches.push(Branch {
                family: mode.family,
                number: branches.iter().filter(alike).count() + 1,
                whirl: None,
                frequency_Hz: vec![mode.frequency_Hz; rotary_rad_per_s.len()],
            });
        }
        critical.sort_by(|a, b| a.rotary_rad_per_s.total_cmp(&b.rotary_rad_per_s));
        Ok(Campbell { rotary_rad_per_s: rotary_rad_per_s.to_vec(), branches, critical })
    }

    /// The assembly's own lateral modes, each followed from speed to speed by its similarity to the
    /// one before.
    fn tracks(&self, modes: &Modes, speeds: &[f64], count: usize) -> Vec<Vec<TurningMode>> {
        let mut tracks: Vec<Vec<TurningMode>> = Vec::new();
        for (step, speed) in speeds.iter().enumerate() {
            let mut there = modes.turning.at(*speed);
            if step == 0 {
                there.retain(|mode| is_own(&self.mode(modes, mode.omega, &mode.parts)));
                tracks = there.into_iter().take(count).map(|mode| vec![mode]).collect();
                continue;
            }
            for track in &mut tracks {
                let Some(before) = track.last() else { continue };
                let nearest = (0..there.len())
                    .max_by(|i, j| alike(before, &there[*i]).total_cmp(&alike(before, &there[*j])));
                if let Some(index) = nearest {
                    let next = there.swap_remove(index);
                    track.push(next);
                }
            }
        }
        tracks
    }

    fn crossings(
        &self,
        modes: &Modes,
        speeds: &[f64],
        track: &[TurningMode],
        order: f64,
        branch: usize,
    ) -> Vec<Critical> {
        let over = |mode: &TurningMode, speed: f64| mode.omega - order * speed;
        let mut found = Vec::new();
        for step in 1..speeds.len() {
            let (mut from, mut to) = (speeds[step - 1], speeds[step]);
            let (first, last) = (&track[step - 1], &track[step]);
            let (mut above, mut below) = (over(first, from), over(last, to));
            if above * below > 0.0 || above == below {
                continue;
            }
            let mut at = last.clone();
            for _ in 0..SECANTS {
                let speed = (from * below - to * above) / (below - above);
                let there = modes.turning.at(speed);
                let like = |mode: &&TurningMode| alike(first, mode);
                let Some(mode) = there.iter().max_by(|a, b| like(a).total_cmp(&like(b))) else {
                    break;
                };
                at = mode.clone();
                let left = over(&at, speed);
                (from, above, to, below) = (to, below, speed, left);
                if left.abs() < 1e-9 * at.omega || above == below {
                    break;
                }
            }
            let mode = self.mode(modes, at.omega, &at.parts);
            found.push(Critical {
                order,
                rotary_rad_per_s: to,
                frequency_Hz: mode.frequency_Hz,
                branch,
                most_strained: mode.most_strained,
            });
        }
        found
    }
}

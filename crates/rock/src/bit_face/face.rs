//! The face as one rigid body.

use nalgebra::Vector3;

use super::{
    body::{Blades, Body},
    cutter::Cutter,
    error::FaceError,
    grid::Grid,
    profile::Profile,
    tracks::Tracks,
};

/// The face of a bit: its cutters or inserts, the body that carries them, and the grid that finds
/// them.
///
/// Made by [`PdcBit::face`](super::PdcBit::face) or [`InsertBit::face`](super::InsertBit::face).
#[derive(Debug, Clone)]
pub struct BitFace {
    profile: Profile,
    cutters: Vec<Cutter>,
    body: Body,
    tracks: Tracks,
    pub(super) grid: Grid,
}

/// A part of the face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The cutter or insert of this index.
    Cutter(usize),
    /// The body that carries them.
    Body,
}

/// Position of a point inside the face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// The part that holds it deepest.
    pub part: Part,
    /// Depth, m.
    pub depth_m: f64,
    /// The shortest way out of that part, a unit vector of the bit's frame.
    pub out: Vector3<f64>,
}

/// Width of the grid's cells against the largest width of a cutter's solid.
const CELL: f64 = 0.25;

impl BitFace {
    /// A face of these parts, if it leaves no ring of the bottom uncut.
    pub(super) fn new(
        profile: Profile,
        mut cutters: Vec<Cutter>,
        cutter_diameter_m: f64,
        body: Body,
    ) -> Result<Self, FaceError> {
        let tracks = Tracks::new(&profile, &cutters);
        if let Some([from_m, to_m]) = tracks.uncut(|r, z| body.distance(&profile, r, z).0) {
            return Err(FaceError::UncutRing { from_m, to_m });
        }
        // Their tracks are known; the lines are thousands of points.
        cutters.iter_mut().for_each(|cutter| cutter.lines = Vec::new());
        let grid = Grid::new(&cutters, &body, &profile, CELL * cutter_diameter_m);
        Ok(Self { profile, cutters, body, tracks, grid })
    }

    /// The line on which the tips are.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// Cutters or inserts, from the axis outwards.
    pub fn cutters(&self) -> &[Cutter] {
        &self.cutters
    }

    /// Surfaces that the cutters sweep when the bit turns about its axis.
    pub fn tracks(&self) -> &Tracks {
        &self.tracks
    }

    /// Blades that carry the cutters; none of a bit with inserts.
    pub fn blades(&self) -> usize {
        self.body.blades.as_ref().map_or(0, |b: &Blades| b.count)
    }

    /// The part that holds a point of the bit's frame deepest; `None` outside the face. Of parts as
    /// deep the first.
    #[inline]
    pub fn holds(&self, position_m: Vector3<f64>) -> Option<Touch> {
        let (cutters, body) = self.grid.near(position_m)?;
        self.deepest(position_m, cutters.iter().map(|&c| usize::from(c)), body)
    }

    /// As [`holds`](Self::holds), by a search through all cutters: the reference for checks of the
    /// grid.
    pub fn holds_by_search(&self, position_m: Vector3<f64>) -> Option<Touch> {
        self.deepest(position_m, 0..self.cutters.len(), true)
    }

    #[inline]
    fn deepest(
        &self,
        position_m: Vector3<f64>,
        cutters: impl Iterator<Item = usize>,
        body: bool,
    ) -> Option<Touch> {
        let mut deepest: Option<Touch> = None;
        let mut consider = |part, found: Option<(f64, Vector3<f64>)>| {
            if let Some((depth_m, out)) = found
                && deepest.is_none_or(|d| depth_m > d.depth_m)
            {
                deepest = Some(Touch { part, depth_m, out });
            }
        };
        for index in cutters {
            consider(Part::Cutter(index), self.cutters[index].depth(position_m));
        }
        if body {
            consider(Part::Body, self.body.depth(&self.profile, position_m));
        }
        deepest
    }
}

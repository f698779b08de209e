//! Margins to each limit with the bit at one depth.

use wholestring::{
    model::Model,
    operation::Operation,
    statics::{
        buckling::{Place, Shape},
        soft::{SoftError, SoftProfile, SoftSettings, solve},
    },
};

use wholestring_judge::{DesignFactors, torque_capacity_N_m};

use super::{
    limit::Limit,
    settings::{ReachError, ReachSettings},
};
use crate::Setup;

/// Margin to one limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margin {
    /// The limit.
    pub limit: Limit,
    /// The load that is compared with the bound, in [`Limit::unit`]; NaN for a string that is
    /// locked up.
    pub load: f64,
    /// Upper bound of the load; NaN without compression.
    pub bound: f64,
    /// The margin: one or less, zero at the limit, negative beyond; minus infinity for a string
    /// that is locked up.
    pub margin: f64,
    /// Measured depth of the smallest margin, m; `None` for limits at the surface.
    pub at_md_m: Option<f64>,
}

/// Margins to the limits of an operation with the bit at one depth.
pub type Margins = Vec<Margin>;

/// Part of the buoyed weight by which the load at the bit is reduced, to compute the reduction of
/// the push at the top.
const LESS: f64 = 1e-3;

/// A distance larger than the rounding of a depth, m.
const JUST_M: f64 = 1e-6;

/// Relative difference by rounding of two ways to the same load.
const ROUNDING: f64 = 1e-9;

/// Returns the margins to the limits of an operation with the bit at its depth. A string that is
/// locked up would need infinite loads, so that its margins are infinite.
///
/// # Errors
/// A string that does not fit, or a soft string without a solution for another reason than lock-up.
pub fn margins(
    setup: &Setup,
    operation: &Operation,
    settings: &ReachSettings,
) -> Result<Margins, ReachError> {
    let (soft, factors) = (&settings.soft, &settings.factors);
    let model = setup.at(operation.bit_depth_m)?;
    let concerned = Limit::ALL.into_iter();
    let concerned = concerned.filter(|limit| limit.concerns(operation, &model.rig, &model.string));
    let has_vertical = has_vertical_hole(&model, operation.bit_depth_m);
    let is_vertical = |limit| matches!(limit, Limit::VerticalHelix | Limit::VerticalSinusoid);
    let concerned = concerned.filter(|limit| has_vertical || !is_vertical(*limit));
    let profile = match solve(&model, operation, soft) {
        Ok(profile) => profile,
        Err(SoftError::LocksUp { md_m }) => {
            return Ok(concerned.map(|limit| locked_up(limit, &model, factors, md_m)).collect());
        }
        Err(error) => return Err(error.into()),
    };
    let at = At { model: &model, operation, soft, factors, profile: &profile };
    concerned.map(|limit| at.margin(limit)).collect()
}

fn locked_up(limit: Limit, model: &Model, factors: &DesignFactors, md_m: f64) -> Margin {
    let bound = match limit {
        Limit::TopDrive => model
            .rig
            .top_drive_torque_N_m
            .map_or(f64::NAN, |rated_N_m| rated_N_m / factors.top_drive),
        Limit::Yield => 1.0 / factors.von_mises,
        Limit::MakeUp | Limit::Torsion => f64::NAN,
        Limit::HookLoadZero | Limit::PushSpent | Limit::PushAbsorbed => 0.0,
        Limit::Hoist
        | Limit::Helix
        | Limit::Sinusoid
        | Limit::VerticalHelix
        | Limit::VerticalSinusoid => f64::NAN,
    };
    let at_md_m = Some(md_m);
    Margin { limit, load: f64::NAN, bound, margin: f64::NEG_INFINITY, at_md_m }
}

/// A depth with its soft string.
struct At<'a> {
    model: &'a Model,
    operation: &'a Operation,
    soft: &'a SoftSettings,
    factors: &'a DesignFactors,
    profile: &'a SoftProfile,
}

impl At<'_> {
    fn margin(&self, limit: Limit) -> Result<Margin, ReachError> {
        let rig = &self.model.rig;
        let scalars = &self.profile.scalars;
        let margin_of = |load: f64, bound: f64, margin: f64| Margin {
            limit,
            load,
            bound,
            margin,
            at_md_m: None,
        };
        let below = |load: f64, bound: Option<f64>| {
            let bound = bound.unwrap_or(f64::INFINITY);
            margin_of(load, bound, 1.0 - load / bound)
        };
        Ok(match limit {
            Limit::TopDrive => {
                let allowed = |rated_N_m: f64| rated_N_m / self.factors.top_drive;
                below(scalars.surface_torque_N_m.abs(), rig.top_drive_torque_N_m.map(allowed))
            }
            Limit::Hoist => {
                let load_N = scalars.hook_load_N + rig.block_weight_N.unwrap_or(0.0);
                below(
                    load_N,
                    rig.hoist_capacity_N.map(|capacity_N| capacity_N / self.factors.hoist),
                )
            }
            Limit::HookLoadZero => {
                margin_of(scalars.hook_load_N, 0.0, share(scalars.hook_load_N, self.hangs_N()))
            }
            Limit::PushSpent => {
                let load_N = scalars.hook_load_N + rig.push_with_block_N();
                margin_of(load_N, 0.0, share(load_N, self.hangs_N() + rig.push_with_block_N()))
            }
            Limit::PushAbsorbed => {
                let arrives = self.arrives()?;
                margin_of(arrives, 0.0, arrives.min(1.0))
            }
            Limit::Yield => {
                let uses = self.profile.yield_use.iter().map(|use_of| use_of.unwrap_or(0.0));
                let (row, most) = worst(uses);
                let at_md_m = Some(self.profile.md_m[row]);
                let allowed = 1.0 / self.factors.von_mises;
                Margin { at_md_m, ..below(most, Some(allowed)) }
            }
            Limit::MakeUp | Limit::Torsion => self.torque(limit),
            Limit::Helix | Limit::Sinusoid => self.buckling(limit, false),
            Limit::VerticalHelix | Limit::VerticalSinusoid => self.buckling(limit, true),
        })
    }

    /// Returns the margin where torque over the capacity of pipe or connection is largest. A row
    /// between two components belongs to both.
    fn torque(&self, limit: Limit) -> Margin {
        let string = &self.model.string;
        let kind = limit.torque_check();
        let required = self.factors.required(kind);
        let capacities_N_m: Vec<Option<f64>> = string
            .components()
            .iter()
            .map(|component| Some(torque_capacity_N_m(component, kind)? / required))
            .collect();
        let mut worst = Margin { limit, load: 0.0, bound: f64::NAN, margin: 1.0, at_md_m: None };
        for (md_m, torque_N_m) in self.profile.md_m.iter().zip(&self.profile.torque_N_m) {
            let from_bit_m = self.operation.bit_depth_m - md_m;
            let places = [from_bit_m - JUST_M, from_bit_m + JUST_M];
            for (component, _) in places.map(|from_bit_m| string.component_at(from_bit_m)) {
                let Some(bound) = capacities_N_m[component] else { continue };
                let load = torque_N_m.abs();
                let margin = 1.0 - load / bound;
                if margin < worst.margin {
                    worst = Margin { limit, load, bound, margin, at_md_m: Some(*md_m) };
                }
            }
        }
        worst
    }

    /// Returns the hook load without friction and off bottom, N: the weight of the string along the
    /// hole, and the pull of the mud.
    fn hangs_N(&self) -> f64 {
        let scalars = &self.profile.scalars;
        scalars.hook_load_N - scalars.axial_friction_N - self.operation.tension_at_bit_N()
    }

    /// Returns the margin where compression over the critical load is largest, among the places
    /// where the wall holds the pipe straight or among those where only its weight does.
    fn buckling(&self, limit: Limit, vertical: bool) -> Margin {
        let is_helix = matches!(limit, Limit::Helix | Limit::VerticalHelix);
        let shape = usize::from(is_helix);
        let rows = 0..self.profile.md_m.len();
        let along = rows.filter_map(|row| {
            let loads_N = [&self.profile.sinusoidal_load_N, &self.profile.helical_load_N];
            Some((row, loads_N[shape][row]?))
        });
        let below = self.below_jumps().map(|(row, loads_N)| (row, loads_N[shape]));
        let mut worst = Margin { limit, load: 0.0, bound: f64::NAN, margin: 1.0, at_md_m: None };
        for (row, critical_N) in along.chain(below) {
            let load = -self.profile.tension_N[row];
            let margin = 1.0 - load / critical_N;
            if margin < worst.margin && self.is_vertical(row, shape, critical_N) == vertical {
                let at_md_m = Some(self.profile.md_m[row]);
                worst = Margin { limit, load, bound: critical_N, margin, at_md_m };
            }
        }
        worst
    }

    /// Returns the rows where curvature, hole or component may jump, with the critical loads just
    /// below, because the profile has those of the stretch above.
    fn below_jumps(&self) -> impl Iterator<Item = (usize, [f64; 2])> {
        let bit_depth_m = self.operation.bit_depth_m;
        let well = &self.model.well;
        let stations = well.path.stations().iter().map(|station| station.md_m);
        let sections = well.hole.sections().iter().map(|section| section.to_md_m);
        let components = self.model.string.spans().map(move |span| bit_depth_m - span.to_bit_m);
        let jumps = stations.chain(sections).chain(components);
        let inside = jumps.filter(move |md_m| *md_m > 0.0 && *md_m < bit_depth_m - JUST_M);
        inside.filter_map(move |md_m| {
            let row = self.profile.md_m.partition_point(|row_m| *row_m < md_m - JUST_M);
            let compression_N = -*self.profile.tension_N.get(row)?;
            if compression_N <= 0.0 {
                return None;
            }
            let place = Place::of(self.model, bit_depth_m, md_m + JUST_M);
            Some((row, place.loads_N(self.model.buckling, compression_N)?))
        })
    }

    /// Whether a critical load is that of a vertical hole, which results from the weight alone: it
    /// is the largest there, and the hole is so steep that the weight across it does not hold the
    /// pipe better. In a level hole whose curvature lifts the pipe off the wall the same load is
    /// the governing minimum, but the hole is not vertical.
    fn is_vertical(&self, row: usize, shape: usize, critical_N: f64) -> bool {
        let md_m = self.profile.md_m[row];
        let place = Place::above(self.model, self.operation.bit_depth_m, md_m);
        let shape = self.model.buckling.shapes()[shape];
        critical_N <= place.vertical_load_N(shape) * (1.0 + ROUNDING) && is_steep(&place, shape)
    }

    /// Returns the part of an added push at the top that reaches the bit; more than one where it
    /// reduces tension, and thus friction, in a bend. It is found from a slightly smaller load at
    /// the bit, with which the string does not lock up either.
    fn arrives(&self) -> Result<f64, ReachError> {
        let less_N = LESS * self.model.buoyed_weight_N();
        let pushed = match self.operation.kind.on_bottom() {
            true => self.operation.weight_on_bit_N(self.operation.weight_on_bit_N - less_N),
            false => self.operation.bit_pull_N(self.operation.bit_pull_N + less_N),
        };
        let less = solve(self.model, &pushed, self.soft)?;
        Ok(less_N / (less.scalars.hook_load_N - self.profile.scalars.hook_load_N))
    }
}

/// Whether the weight across the hole does not hold a pipe better than a vertical hole does.
fn is_steep(place: &Place, shape: Shape) -> bool {
    let held_N = place.vertical_load_N(shape) * (1.0 + ROUNDING);
    place.threshold_N(shape, place.weight_across_N_per_m) <= held_N
}

/// Whether a well has a vertical stretch above the bit: without one no string can be a helix in it.
fn has_vertical_hole(model: &Model, bit_depth_m: f64) -> bool {
    let shape = model.buckling.helix();
    let stations = model.well.path.stations().iter().map(|station| station.md_m);
    let mut depths = stations.filter(|md_m| *md_m <= bit_depth_m).chain([JUST_M, bit_depth_m]);
    depths.any(|md_m| is_steep(&Place::above(model, bit_depth_m, md_m), shape))
}

/// Returns a load as a part of the hanging weight; where that is not positive, its sign.
fn share(load_N: f64, hangs_N: f64) -> f64 {
    if hangs_N > 0.0 { load_N / hangs_N } else { load_N.signum() }
}

/// Returns the index of the largest of some numbers and its value; zeros where none is positive.
fn worst(values: impl Iterator<Item = f64>) -> (usize, f64) {
    let mut most = (0, 0.0);
    for (row, value) in values.enumerate() {
        if value > most.1 {
            most = (row, value);
        }
    }
    most
}

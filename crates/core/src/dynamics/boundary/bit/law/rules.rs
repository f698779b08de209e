//! What every law of the bit tells the engine.

use crate::{
    damage::Damaged,
    dynamics::{
        assemble::error::SetupError,
        boundary::{
            bit::{
                cutters::SteadyCut,
                motor::Drive,
                step::{Approach, RockReaction},
                table::TableUse,
            },
            extension::AnotherExtension,
        },
    },
    operation::Operation,
};

/// How a bit begins a run.
pub(in crate::dynamics::boundary::bit) struct CutStart<'a> {
    pub(in crate::dynamics::boundary::bit) operation: &'a Operation,
    pub(in crate::dynamics::boundary::bit) drive: &'a Drive,
    /// Measured depth of the bit, m.
    pub(in crate::dynamics::boundary::bit) depth_m: f64,
    /// Seed of what shakes the bit.
    pub(in crate::dynamics::boundary::bit) seed: u64,
}

/// A law with its numbers, before the first step.
pub(in crate::dynamics::boundary::bit) trait LawRules {
    /// The rock under a bit that follows the law.
    type Cut: CutState<Law = Self>;

    /// Refuses numbers that no run can use.
    fn check(&self) -> Result<(), SetupError>;

    /// Stiffness of the rock under the bit, N/m.
    fn stiffness_N_per_m(&self) -> f64;

    /// How a bit drills steadily under a weight on bit, turning at a speed; none of a law that
    /// takes the operation's.
    fn steady_cut(&self, weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> Option<SteadyCut>;

    /// Whether the bit's angle counts, and with it the speed of a motor that turns the bit.
    fn counts_angle(&self) -> bool {
        true
    }

    /// The rock under a bit that drills steadily; none where it comes under the bit later.
    fn begin(&self, start: &CutStart<'_>) -> Option<Self::Cut>;
}

/// The rock under a bit in a run.
pub(in crate::dynamics::boundary::bit) trait CutState {
    /// The law that the bit follows.
    type Law;

    /// Whether stored rock is one of this law.
    fn check(&self, law: &Self::Law) -> Result<(), Damaged>;

    /// Gives what the caller has made to rock that has been read back.
    fn attach(&mut self, _law: &Self::Law) -> Result<(), AnotherExtension> {
        Ok(())
    }

    /// What the rock answers to the bit's node, which the step has moved without it; none of rock
    /// that takes the node through the step by itself.
    fn meet(&mut self, at: &Approach, drive: &mut Drive) -> Option<RockReaction>;

    /// How often the bit was where its table is not, and how far.
    fn table_use(&self) -> Option<TableUse> {
        None
    }

    /// Counts [`Self::table_use`] anew.
    fn restart(&mut self) {}
}

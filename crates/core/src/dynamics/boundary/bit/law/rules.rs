//! Interface between the laws of the bit and the engine.

use crate::{
    damage::Damaged,
    dynamics::{
        assemble::SetupError,
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

/// Initial conditions of a bit in a run.
pub(in crate::dynamics::boundary::bit) struct CutStart<'a> {
    pub(in crate::dynamics::boundary::bit) operation: &'a Operation,
    pub(in crate::dynamics::boundary::bit) drive: &'a Drive,
    /// Measured depth of the bit, m.
    pub(in crate::dynamics::boundary::bit) depth_m: f64,
    /// Seed of the excitation.
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

    /// Steady drilling under a weight on bit, at a speed; none for a law that takes the operation's
    /// torque and rate.
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

    /// Attaches the caller's extensions to rock that has been read back.
    fn attach(&mut self, _law: &Self::Law) -> Result<(), AnotherExtension> {
        Ok(())
    }

    /// Reaction of the rock on the bit's node, which the step has moved without it; none for rock
    /// that moves the node through the step by itself.
    fn meet(&mut self, at: &Approach, drive: &mut Drive) -> Option<RockReaction>;

    /// Count and extent of the bit's excursions outside its table.
    fn table_use(&self) -> Option<TableUse> {
        None
    }

    /// Counts [`Self::table_use`] anew.
    fn restart(&mut self) {}
}

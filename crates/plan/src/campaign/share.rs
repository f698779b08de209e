//! What a solved operation does of a campaign.

use wholestring::{model::Model, operation::Operation, outcome::Solution};

use super::Campaign;
use crate::{Stage, fatigue::Damage, wear::CasingWear};

/// What operations take of string and casing.
#[derive(Debug, Clone, PartialEq)]
pub struct Share {
    /// Of the string.
    pub damage: Damage,
    /// Of the casings.
    pub wear: CasingWear,
}

impl Share {
    /// Adds another one.
    pub fn merge(&mut self, other: &Self) {
        self.damage.merge(&other.damage);
        self.wear.merge(&other.wear);
    }
}

impl Campaign {
    /// What a solved operation does of the campaign; none where it is no part of it.
    pub fn share(
        &self,
        model: &Model,
        operation: &Operation,
        solution: &Solution<'_>,
    ) -> Option<Share> {
        let duration_s = self.duration_s(operation)?;
        let stage = Stage { model, operation, solution: *solution, duration_s };
        let mut share = Share { damage: Damage::default(), wear: self.new.clone() };
        share.damage.add(&stage, &self.fatigue);
        share.wear.add(&stage);
        Some(share)
    }
}

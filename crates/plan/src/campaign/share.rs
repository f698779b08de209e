//! What a solved operation does of a campaign.

use serde::{Deserialize, Serialize};
use wholestring::{model::Model, operation::Operation, outcome::Solution};

use super::Campaign;
use crate::{
    Stage,
    fatigue::{Damage, FatigueRow, rows},
    wear::{WearRow, Worn},
};

/// What operations take of string and casing.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Share {
    /// Of the string.
    pub damage: Damage,
    /// Of the casings.
    pub worn: Worn,
    /// Of what drills at the deepest depth: for each component the place where an hour costs most, from the
    /// bit up.
    pub rates: Vec<FatigueRow>,
}

impl Share {
    /// Adds another one of the same campaign.
    pub fn merge(&mut self, other: &Self) {
        self.damage.merge(&other.damage);
        self.worn.merge(&other.worn);
        self.rates.extend(&other.rates);
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
        let mut share = Share::default();
        share.damage.add(&stage, &self.fatigue);
        let mut wear = self.new.clone();
        wear.add(&stage);
        share.worn = wear.worn();
        if self.is_last_drilling(operation) {
            share.rates = worst(&rows(model, operation, solution, &self.fatigue));
        }
        Some(share)
    }

    /// What a solved operation takes of the casings by its work of friction. It stands for all depths of the
    /// campaign that are nearest to its own, among these, m; none where it is no part of the campaign.
    pub fn share_by_work(
        &self,
        model: &Model,
        operation: &Operation,
        solution: &Solution<'_>,
        among_m: &[f64],
    ) -> Option<Share> {
        let duration_s = self.duration_near_s(operation, among_m)?;
        let mut wear = self.new.clone();
        wear.add_by_work(&Stage { model, operation, solution: *solution, duration_s });
        Some(Share { worn: wear.worn(), ..Share::default() })
    }

    /// What is left of the casings, from the surface down.
    pub fn casings(&self, share: &Share) -> Vec<WearRow> {
        self.new.clone().with(&share.worn).rows()
    }
}

/// Of each component the row where an hour costs most, or where nothing is damaged the one that bends most.
fn worst(rows: &[FatigueRow]) -> Vec<FatigueRow> {
    let mut found: Vec<FatigueRow> = Vec::new();
    let key = |of: &FatigueRow| (of.damage_per_hour, of.equivalent_Pa);
    for row in rows {
        match found.iter_mut().find(|of| of.component == row.component) {
            Some(of) if key(row) > key(of) => *of = *row,
            Some(_) => {}
            None => found.push(*row),
        }
    }
    found.sort_by_key(|of| of.component);
    found
}

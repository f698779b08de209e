//! Share of a solved operation in a campaign.

use serde::{Deserialize, Serialize};
use wholestring::{model::Model, operation::Operation, outcome::Solution};

use super::Campaign;
use crate::{
    Stage,
    fatigue::{Damage, FatigueRow, rows},
    wear::{WearRow, Worn},
};

/// Damage of the string and wear of the casings from operations.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Share {
    /// Damage of the string.
    pub damage: Damage,
    /// Wear of the casings.
    pub worn: Worn,
    /// Fatigue rates of the drilling operation at the deepest depth: for each component the place
    /// with the highest rate, from the bit up.
    pub rates: Vec<FatigueRow>,
}

impl Share {
    /// Adds another share of the same campaign.
    pub fn merge(&mut self, other: &Self) {
        self.damage.merge(&other.damage);
        self.worn.merge(&other.worn);
        self.rates.extend(&other.rates);
    }
}

impl Campaign {
    /// Returns the share of a solved operation; `None` where it is no part of the campaign.
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

    /// Returns the casing wear of a solved operation from its friction work. It represents all
    /// depths of the campaign that are nearest to its own, among these, m; `None` where it is no
    /// part of the campaign.
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

    /// Returns the remaining casings, from the surface down.
    pub fn casings(&self, share: &Share) -> Vec<WearRow> {
        self.new.clone().with(&share.worn).rows()
    }
}

/// Returns for each component the row with the highest rate, or without any damage the one with the
/// largest bending.
fn worst(rows: &[FatigueRow]) -> Vec<FatigueRow> {
    let mut found: Vec<FatigueRow> = Vec::new();
    let key = |row: &FatigueRow| (row.damage_per_hour, row.equivalent_Pa);
    for row in rows {
        match found.iter_mut().find(|worst_row| worst_row.component == row.component) {
            Some(worst_row) if key(row) > key(worst_row) => *worst_row = *row,
            Some(_) => {}
            None => found.push(*row),
        }
    }
    found.sort_by_key(|worst_row| worst_row.component);
    found
}

//! Damage over a campaign, by Miner's rule.

use serde::{Deserialize, Serialize};

use super::FatigueSettings;
use crate::Stage;

/// Length of string that one number represents, m: about a joint of pipe.
pub const CELL_M: f64 = 10.0;

/// Part of the life of each part of a string that a campaign uses.
///
/// A place of the string is identified by its component and its distance from the lower end of that
/// component: pipe is added at the surface, so that the same metal passes one dogleg after the
/// other.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Damage {
    /// By component, from the bit, and cell, from its lower end.
    cells: Vec<Vec<f64>>,
}

/// Damage of a part of the string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DamageRow {
    /// Component, counted from the bit.
    pub component: usize,
    /// Distance of the part's lower end from that of the component, m.
    pub from_lower_end_m: f64,
    /// Part of its life that is used; at one it fails.
    pub damage: f64,
}

impl Damage {
    /// Adds an operation with its duration: its revolutions over those to failure, of the worst
    /// place in each cell.
    pub fn add(&mut self, stage: &Stage<'_>, settings: &FatigueSettings) {
        let revolutions = stage.revolutions();
        let string = &stage.model.string;
        let profile = stage.solution.profile;
        let component_at = |md_m: f64| string.component_at(stage.operation.bit_depth_m - md_m).0;
        if self.cells.len() < string.components().len() {
            self.cells.resize(string.components().len(), Vec::new());
        }
        for (index, span) in string.spans().enumerate() {
            let component = span.component;
            let tensile_Pa = settings.tensile_strength_of_Pa(component);
            let Some(tensile_Pa) = tensile_Pa.filter(|_| !component.is_bit()) else {
                continue;
            };
            let count = (component.length_m / CELL_M).ceil() as usize;
            let mut worst = vec![0.0_f64; count];
            for row in 1..profile.md_m.len() {
                let [above_m, below_m] = [profile.md_m[row - 1], profile.md_m[row]];
                if component_at(0.5 * (above_m + below_m)) != index {
                    continue;
                }
                let mut cost = settings.cost(component, tensile_Pa, profile, row).cycles.recip();
                if component_at(above_m) == index {
                    let above = settings.cost(component, tensile_Pa, profile, row - 1);
                    cost = cost.max(above.cycles.recip());
                }
                let cell = |md_m: f64| {
                    let up_m = stage.operation.bit_depth_m - md_m - span.from_bit_m;
                    ((up_m / CELL_M).max(0.0) as usize).min(count - 1)
                };
                for worst in &mut worst[cell(below_m)..=cell(above_m)] {
                    *worst = worst.max(cost);
                }
            }
            let cells = &mut self.cells[index];
            if cells.len() < count {
                cells.resize(count, 0.0);
            }
            for (sum, cost) in cells.iter_mut().zip(worst) {
                *sum += revolutions * cost;
            }
        }
    }

    /// Adds the damage of other operations to the same string.
    pub fn merge(&mut self, other: &Self) {
        if self.cells.len() < other.cells.len() {
            self.cells.resize(other.cells.len(), Vec::new());
        }
        for (cells, other) in self.cells.iter_mut().zip(&other.cells) {
            if cells.len() < other.len() {
                cells.resize(other.len(), 0.0);
            }
            for (sum, damage) in cells.iter_mut().zip(other) {
                *sum += damage;
            }
        }
    }

    /// Returns all cells, from the bit up.
    pub fn rows(&self) -> impl Iterator<Item = DamageRow> + '_ {
        self.cells.iter().enumerate().flat_map(|(component, cells)| {
            cells.iter().enumerate().map(move |(cell, damage)| DamageRow {
                component,
                from_lower_end_m: cell as f64 * CELL_M,
                damage: *damage,
            })
        })
    }

    /// Returns the cell of a component with the most damage; `None` where nothing is known of it.
    pub fn worst(&self, component: usize) -> Option<DamageRow> {
        let rows = self.rows().filter(|row| row.component == component);
        rows.max_by(|a, b| a.damage.total_cmp(&b.damage))
    }
}

//! Sources and sinks of the energy of a run.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::{
    GRAVITY_M_PER_S2,
    dynamics::{
        body::Body,
        boundary::{
            anchor::{Anchor, middle_m},
            mud::viscous::Viscous,
        },
        kernel::{
            chain::{Chain, node},
            half_step::half_a_step_before,
            step::StepLosses,
        },
    },
    rod::{element, mesh::Mesh},
    simd::number::Real,
};

/// Energies at the middle of the last step, J.
///
/// Velocities live there already; positions and twist are brought back by half a step, so that the
/// sums are second-order accurate in the step. Where regions have steps of their own, each is read
/// at the middle of its own: energy that crosses the border meanwhile is counted in the lower
/// region.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Energies {
    pub kinetic: f64,
    pub elastic: f64,
    pub gravity: f64,
}

impl Energies {
    pub fn of(
        chain: &Chain<impl Real>,
        anchors: &[Anchor],
        body: &Body,
        viscous: Option<&Viscous>,
        dt: f64,
    ) -> Self {
        let last = chain.nodes() - 1;
        // The mud's pull is included in the weights.
        let pull = viscous.map_or(0.0, |mud| mud.pull_potential_J(chain, anchors, dt));
        Self {
            kinetic: kinetic_J(chain) + body.imbalances_J(chain),
            elastic: elastic_J(chain, dt) + body.bends_J(chain, chain.step_s(last, dt)),
            gravity: weight_J(chain, anchors, dt) + pull,
        }
    }

    /// All of them, J.
    pub fn total(&self) -> f64 {
        self.kinetic + self.elastic + self.gravity
    }
}

/// Kinetic energy at the middle of the last step, J.
pub fn kinetic_J(chain: &Chain<impl Real>) -> f64 {
    let mut sum = 0.0;
    for i in 0..chain.nodes() {
        let v = chain.velocity(i);
        let along = v.dot(chain.tangent(i));
        let (ml, ma) = (node!(chain, i, mass_lateral), node!(chain, i, mass_axial));
        let spin = node!(chain, i, spin);
        let w = chain.turning(i);
        let inverse = node!(chain, i, inv_rotary);
        let rotary = if inverse > 0.0 { w.dot(w) / inverse } else { 0.0 };
        sum += ml * v.dot(v)
            + (ma - ml) * along * along
            + node!(chain, i, polar) * spin * spin
            + rotary;
    }
    0.5 * sum
}

fn elastic_J(chain: &Chain<impl Real>, dt: f64) -> f64 {
    let mut sum = 0.0;
    for i in 0..chain.elements() {
        let pose = half_a_step_before(chain.pose(i), chain.step_s(i, dt));
        sum += element::energy(&chain.stiffness(i), &pose);
    }
    sum
}

fn weight_J(chain: &Chain<impl Real>, anchors: &[Anchor], dt: f64) -> f64 {
    -(0..anchors.len())
        .map(|i| Vector3::from(chain.weight(i)).dot(&middle_m(chain, anchors, i, dt)))
        .sum::<f64>()
}

/// Rise of the string, m, that gives the least energy with which a residual is compared.
const MIN_RISE_M: f64 = 1e-3;

/// Energy that lifts the string of `mesh` in air by a millimetre, J.
pub fn min_J(mesh: &Mesh) -> f64 {
    let steel_kg: f64 = mesh.elements.iter().map(|e| e.section.steel_kg_per_m * e.length_m).sum();
    steel_kg * GRAVITY_M_PER_S2 * MIN_RISE_M
}

/// The energy of a run since its window began, J: `work = loss + change`, up to the residual.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergyBalance {
    /// Work of the top drive on the string.
    #[serde(with = "crate::finite")]
    pub top_drive_work_J: f64,
    /// Work of the hoist on the string: negative while the string goes down.
    #[serde(with = "crate::finite")]
    pub hoist_work_J: f64,
    /// Work of bit and rock on the string: negative while the bit cuts.
    #[serde(with = "crate::finite")]
    pub bit_work_J: f64,
    /// Work of bends while they are put in: zero once a prepared start has done so.
    #[serde(with = "crate::finite")]
    pub bend_work_J: f64,
    /// Work of the streaming mud's pull and of the bit's jets on the string.
    #[serde(with = "crate::finite")]
    pub flow_work_J: f64,
    /// Lost to friction on the wall.
    #[serde(with = "crate::finite")]
    pub friction_loss_J: f64,
    /// Lost in impacts on the wall.
    #[serde(with = "crate::finite")]
    pub contact_loss_J: f64,
    /// Lost to the mud's drag and to mass-proportional damping.
    #[serde(with = "crate::finite")]
    pub mud_loss_J: f64,
    /// Lost to stiffness-proportional damping.
    #[serde(with = "crate::finite")]
    pub damping_loss_J: f64,
    /// Gain of kinetic energy.
    #[serde(with = "crate::finite")]
    pub kinetic_change_J: f64,
    /// Gain of elastic energy.
    #[serde(with = "crate::finite")]
    pub elastic_change_J: f64,
    /// Gain of potential energy: the buoyed weight, lifted.
    #[serde(with = "crate::finite")]
    pub gravity_change_J: f64,
    /// Energy gained or lost by the integration itself: work less losses less changes.
    #[serde(with = "crate::finite")]
    pub residual_J: f64,
}

impl EnergyBalance {
    /// All work on the string, J.
    pub fn work_J(&self) -> f64 {
        self.top_drive_work_J
            + self.hoist_work_J
            + self.bit_work_J
            + self.bend_work_J
            + self.flow_work_J
    }

    /// All losses, J.
    pub fn loss_J(&self) -> f64 {
        self.friction_loss_J + self.contact_loss_J + self.mud_loss_J + self.damping_loss_J
    }

    /// Gain of the string's energy, J.
    pub fn change_J(&self) -> f64 {
        self.kinetic_change_J + self.elastic_change_J + self.gravity_change_J
    }
}

/// Who did work on the string in a step, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct StepWork {
    pub top_drive: f64,
    pub hoist: f64,
    pub bit: f64,
    pub body: f64,
}

/// Work and losses since the window began.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Ledger {
    start: Energies,
    flow_at_start_J: f64,
    booked: EnergyBalance,
}

impl Ledger {
    /// Opens the books with the string's energies and the work that the mud's pull has done so far.
    pub fn open(start: Energies, flow_J: f64) -> Self {
        Self { start, flow_at_start_J: flow_J, booked: EnergyBalance::default() }
    }

    /// Books a step.
    pub fn book(&mut self, work: &StepWork, losses: &StepLosses) {
        let sum = &mut self.booked;
        sum.top_drive_work_J += work.top_drive;
        sum.hoist_work_J += work.hoist;
        sum.bit_work_J += work.bit;
        sum.bend_work_J += work.body;
        sum.contact_loss_J += losses.contact;
        sum.mud_loss_J += losses.mud;
        sum.damping_loss_J += losses.damping;
    }

    /// Books the loss to friction, J.
    pub fn book_friction(&mut self, taken: f64) {
        self.booked.friction_loss_J += taken;
    }

    /// Books the loss to mass-proportional damping, J.
    pub fn book_mass_damping(&mut self, taken: f64) {
        self.booked.mud_loss_J += taken;
    }

    /// The balance and its residual over the largest of work, losses, change of energy, kinetic
    /// energy and `min_J`; none where a number is none, as in a run that diverged.
    ///
    /// Of a string at rest all but the last are rounding, and so is the residual: without an energy
    /// that is something to the string it would be all of it.
    pub fn balance(&self, now: &Energies, flow_J: f64, min_J: f64) -> Option<(EnergyBalance, f64)> {
        let mut balance = EnergyBalance {
            flow_work_J: flow_J - self.flow_at_start_J,
            kinetic_change_J: now.kinetic - self.start.kinetic,
            elastic_change_J: now.elastic - self.start.elastic,
            gravity_change_J: now.gravity - self.start.gravity,
            ..self.booked
        };
        let (work, loss, change) = (balance.work_J(), balance.loss_J(), balance.change_J());
        balance.residual_J = work - loss - change;
        let largest = [work, loss, change, now.kinetic]
            .iter()
            .fold(min_J, |largest, part| largest.max(part.abs()));
        let relative = balance.residual_J / largest;
        relative.is_finite().then_some((balance, relative))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a string at rest nothing but rounding is booked: its residual is compared with the energy
    /// that lifts the string by a millimetre and not against itself. Where something moves, the
    /// larger counts, as ever.
    #[test]
    fn a_residual_of_rounding_is_small() {
        let min_J = 1000.0;
        let hung = Energies { gravity: -4e9, ..Energies::default() };
        let rounded = Energies { gravity: hung.gravity + 1e-6, ..hung };
        let ledger = Ledger::open(hung, 0.0);
        let (balance, relative) = ledger.balance(&rounded, 0.0, min_J).unwrap();
        assert!(balance.residual_J != 0.0);
        assert_eq!(relative, balance.residual_J / min_J);
        let moving = Energies { kinetic: 5000.0, ..hung };
        assert_eq!(ledger.balance(&moving, 0.0, min_J).unwrap().1, -1.0);
        let lost = Energies { kinetic: f64::NAN, ..hung };
        assert!(ledger.balance(&lost, 0.0, min_J).is_none());
    }
}

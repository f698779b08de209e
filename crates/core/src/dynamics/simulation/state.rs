//! How a run stands.

use serde::{Deserialize, Serialize};

use super::sampling::SinceSample;
use crate::dynamics::{
    assembly::Anchor, bit::Bit, body::Body, chain::Rows, energy::Ledger, hoist::Hoist,
    record::Record, schedule::SetPoints, settling::Settled, top_drive::TopDrive, viscous::Viscous,
    wear::Wear,
};

/// Everything of a run, beside its chain, that changes while it goes on: plain data, which a checkpoint holds as it
/// is. What the model, the operation and the settings determine is found anew.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct State {
    pub(super) anchors: Vec<Anchor>,
    pub(super) set_points: SetPoints,
    pub(super) top_drive: TopDrive,
    pub(super) hoist: Hoist,
    pub(super) body: Body,
    pub(super) bit: Bit,
    pub(super) viscous: Option<Viscous>,
    /// What the pressure of mud at rest shortens the string against the unloaded one, by `(1 − 2ν)p/E`, m.
    pub(super) squeezed_m: f64,
    /// What the pumps deliver, m³/s.
    pub(super) flow_m3_per_s: f64,
    pub(super) rigid_velocity_m_per_s: f64,
    /// Time over which the extra damping of the start fades, s.
    pub(super) fading_s: f64,
    pub(super) steps: u64,
    pub(super) since_sample: SinceSample,
    pub(super) record: Record,
    pub(super) wear: Wear,
    /// High side at each node, block by block.
    pub(super) high: Vec<Rows<f64>>,
    pub(super) ledger: Ledger,
    pub(super) window_open: bool,
    /// How settling ended that was to end by itself; none as long as it goes on.
    pub(super) settled: Option<Settled>,
}

//! State of a run.

use serde::{Deserialize, Serialize};

use super::settling::Settled;
use crate::{
    damage::{Damaged, ensure},
    dynamics::{
        body::Body,
        boundary::{
            anchor::Anchor,
            bit::{Bit, BitStep},
            extension::AnotherExtension,
            hoist::Hoist,
            hole_friction::HoleFriction,
            mud::{Squeezed, viscous::Viscous},
            top_drive::TopDrive,
            wall_friction::WallFriction,
        },
        kernel::chain::{Chain, Rows},
        output::{energy::Ledger, record::Record, wear::Wear},
        settings::{DynamicsSettings, schedule::SetPoints},
    },
    model::Model,
    rod::mesh::Mesh,
    simd::{number::Real, vector::Vector},
};

/// All data of a run, apart from its chain, that change while it continues: plain data, which a
/// checkpoint contains unchanged. Data that follow from the model, the operation and the settings
/// are computed anew.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct State {
    pub(super) anchors: Vec<Anchor>,
    pub(super) set_points: SetPoints,
    pub(super) top_drive: TopDrive,
    pub(super) hoist: Hoist,
    pub(super) body: Body,
    pub(super) bit: Bit,
    pub(super) viscous: Option<Viscous>,
    /// Shortening of the string by the pressure of mud at rest.
    pub(super) squeezed: Squeezed,
    /// Flow rate of the pumps, m³/s.
    pub(super) flow_m3_per_s: f64,
    pub(super) rigid_velocity_m_per_s: f64,
    /// Time over which the extra damping of the start fades, s.
    pub(super) fading_s: f64,
    pub(super) steps: u64,
    /// Part of a sample that was requested and is not computed yet, s; negative where more was
    /// computed than requested.
    pub(super) remainder_s: f64,
    pub(super) since_sample: SinceSample,
    pub(super) record: Record,
    pub(super) wear: Wear,
    /// High side at each node, block by block.
    pub(super) high: Vec<Rows<f64>>,
    pub(super) ledger: Ledger,
    pub(super) window_open: bool,
    /// End of a settling that was to end by itself; none as long as it continues.
    pub(super) settled: Option<Settled>,
    /// The coefficient of friction where that is the caller's.
    pub(super) friction: Option<WallFriction>,
    /// The hole's friction where the run has changed it.
    pub(super) hole_friction: Option<HoleFriction>,
}

impl State {
    /// Gives a state that has been read back the caller's laws of the settings.
    pub(super) fn attach(&mut self, settings: &DynamicsSettings) -> Result<(), AnotherExtension> {
        self.bit.attach(&settings.bit)?;
        if let (Some(friction), Some(custom)) = (&mut self.friction, &settings.friction_coefficient)
        {
            friction.attach(custom, self.anchors.len())?;
        }
        self.top_drive.attach(&settings.top_drive)
    }

    /// Whether a stored state is one of a run of this model: its lengths fit and its places are
    /// there.
    pub(super) fn check(
        &self,
        model: &Model,
        settings: &DynamicsSettings,
        mesh: &Mesh,
        chain: &Chain<impl Real>,
    ) -> Result<(), Damaged> {
        let layout = chain.layout();
        let nodes = mesh.nodes.len();
        ensure(self.anchors.len() == nodes, "the anchors")?;
        ensure(
            self.squeezed.each_m.len() == mesh.elements.len(),
            "the pressure of the mud at rest",
        )?;
        ensure(self.high.len() == layout.blocks(), "the high side")?;
        ensure(self.viscous.is_some() == model.has_rheology(), "the mud")?;
        let most_s = settings.sample_interval_s.max(1.0);
        ensure(self.remainder_s.abs() <= most_s, "the time that is left of a sample")?;
        self.set_points.check(&settings.schedule)?;
        self.body.check(chain, &Body::new(model, mesh))?;
        self.top_drive.check(&settings.top_drive)?;
        self.bit.check(&settings.bit)?;
        let same = self.friction.is_some() == settings.friction_coefficient.is_some();
        ensure(same, "the coefficient of friction")?;
        if let Some(friction) = &self.friction {
            friction.check(nodes, layout)?;
        }
        if let Some(friction) = &self.hole_friction {
            friction.check(&model.well.hole)?;
        }
        if let Some(viscous) = &self.viscous {
            viscous.check(mesh)?;
        }
        let hole_end_m = model.well.hole.sections().last().map_or(0.0, |s| s.to_md_m);
        self.wear.check(nodes, hole_end_m)?;
        self.record.check(nodes)
    }
}

// Sums between two samples.

/// Scalars summed since the last sample.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub(super) struct SinceSample {
    pub(super) steps: u64,
    pub(super) hook_load: f64,
    pub(super) surface_torque: f64,
    pub(super) weight_on_bit: f64,
    pub(super) bit_torque: f64,
    pub(super) bit_high: f64,
    pub(super) bit_right: f64,
    pub(super) bit_moment: f64,
    pub(super) depth_of_cut: f64,
    pub(super) rate_of_penetration: f64,
    pub(super) motor_speed: f64,
}

impl SinceSample {
    /// Adds the bit's results in `part` of a step; `high` and `right` are the directions across the
    /// hole there.
    pub(super) fn add_bit(
        &mut self,
        bit: &BitStep,
        high: Vector<f64>,
        right: Vector<f64>,
        part: f64,
    ) {
        self.weight_on_bit += part * bit.weight_on_bit_N;
        self.bit_torque += part * bit.torque_N_m;
        self.bit_high += part * bit.force_N.dot(high);
        self.bit_right += part * bit.force_N.dot(right);
        self.bit_moment += part * bit.moment_N_m;
        self.depth_of_cut += part * bit.depth_of_cut_m;
        self.rate_of_penetration += part * bit.rate_of_penetration_m_per_s;
        self.motor_speed += part * bit.motor_speed_rad_per_s;
    }
}

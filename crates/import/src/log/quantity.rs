//! Quantity that a channel of a log measures.

use wholestring_units::Dimension;

use super::record::Record;

/// The quantities of a [`Record`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Quantity {
    /// Time, the index of the log.
    Time,
    /// Measured depth of the bit.
    BitDepth,
    /// Measured depth of the hole.
    HoleDepth,
    /// Height of the travelling block.
    BlockPosition,
    /// Hook load.
    HookLoad,
    /// Weight on bit.
    WeightOnBit,
    /// Torque at the surface.
    Torque,
    /// Rotary speed at the surface.
    RotarySpeed,
    /// Flow rate of the pumps.
    FlowRate,
    /// Pressure at the standpipe.
    StandpipePressure,
}

impl Quantity {
    /// Every quantity, in the order of a [`Record`].
    pub const ALL: [Quantity; 10] = [
        Quantity::Time,
        Quantity::BitDepth,
        Quantity::HoleDepth,
        Quantity::BlockPosition,
        Quantity::HookLoad,
        Quantity::WeightOnBit,
        Quantity::Torque,
        Quantity::RotarySpeed,
        Quantity::FlowRate,
        Quantity::StandpipePressure,
    ];

    /// Its name in `--pick` and `--unit`.
    pub fn name(self) -> &'static str {
        self.declared().0
    }

    /// Its name in a sentence.
    pub fn words(self) -> &'static str {
        self.declared().1
    }

    /// Dimension that its unit must have.
    pub fn dimension(self) -> Dimension {
        self.declared().2
    }

    fn declared(self) -> (&'static str, &'static str, Dimension) {
        match self {
            Quantity::Time => ("time", "time", Dimension::Time),
            Quantity::BitDepth => ("bit-depth", "bit depth", Dimension::Length),
            Quantity::HoleDepth => ("hole-depth", "hole depth", Dimension::Length),
            Quantity::BlockPosition => ("block-position", "block position", Dimension::Length),
            Quantity::HookLoad => ("hookload", "hook load", Dimension::Force),
            Quantity::WeightOnBit => ("wob", "weight on bit", Dimension::Force),
            Quantity::Torque => ("torque", "torque", Dimension::Torque),
            Quantity::RotarySpeed => ("rpm", "rotary speed", Dimension::RotarySpeed),
            Quantity::FlowRate => ("flow", "flow rate", Dimension::FlowRate),
            Quantity::StandpipePressure => ("spp", "standpipe pressure", Dimension::Pressure),
        }
    }

    /// Whether its sensor often reads 0: a string that does not turn, pumps that are off, a block
    /// on the floor.
    pub(crate) fn is_often_zero(self) -> bool {
        !matches!(
            self,
            Quantity::Time | Quantity::BitDepth | Quantity::HoleDepth | Quantity::HookLoad
        )
    }

    /// Its field in a record.
    pub(crate) fn field(self, record: &mut Record) -> &mut f64 {
        match self {
            Quantity::Time => &mut record.time_s,
            Quantity::BitDepth => &mut record.bit_depth_m,
            Quantity::HoleDepth => &mut record.hole_depth_m,
            Quantity::BlockPosition => &mut record.block_position_m,
            Quantity::HookLoad => &mut record.hook_load_N,
            Quantity::WeightOnBit => &mut record.weight_on_bit_N,
            Quantity::Torque => &mut record.torque_N_m,
            Quantity::RotarySpeed => &mut record.rotary_speed_rad_per_s,
            Quantity::FlowRate => &mut record.flow_rate_m3_per_s,
            Quantity::StandpipePressure => &mut record.standpipe_pressure_Pa,
        }
    }
}

//! Thresholds for steady, still, turning and off-bottom states.

/// Thresholds of rig states and windows.
///
/// Rig states follow from block position, bit and hole depth, hook load and rotary speed by
/// thresholds, as in programs at the rig (Innova Drilling, *Rig States Guide*). The hook load in
/// slips is not a threshold: it is determined from the log.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thresholds {
    /// Minimum time in slips, s: setting, breaking out and making up take longer; a shorter drop of
    /// the hook load is a sensor dropout.
    pub slips_s: f64,
    /// Minimum travel of the block in slips that makes a connection, m: a joint has 9 m, and the
    /// block moves to or from its top position.
    pub connection_m: f64,
    /// Time excluded before and after slips, s: the load transfers between slips and hook.
    pub beside_slips_s: f64,
    /// Minimum speed of a moving block, m/s: 3 m/min, slower than anybody trips.
    pub moves_m_per_s: f64,
    /// Maximum speed of a stationary block, m/s: a 5 in pipe that turns at 60 rev/min slides at 0.4
    /// m/s around, so that 0.01 m/s along takes 2.5 % of the friction.
    pub stands_m_per_s: f64,
    /// Relative variation of the speed within which it is steady.
    pub steady_part: f64,
    /// Variation of the speed that is always allowed, m/s: the resolution of a position in
    /// centimetres.
    pub steady_m_per_s: f64,
    /// Minimum speed of a turning string, rad/s: 10 rev/min.
    pub turns_rad_per_s: f64,
    /// Maximum speed of a string that does not turn, rad/s: 3 rev/min, for an encoder that never
    /// reads exactly zero.
    pub still_rad_per_s: f64,
    /// Minimum height of the bit above bottom that is off bottom, m: bit depth is computed from the
    /// block position as if the string did not stretch.
    pub off_bottom_m: f64,
    /// Maximum height above bottom that is on bottom, m.
    pub on_bottom_m: f64,
    /// Depth of the bit below the bottom of the hole beyond which the two depths contradict each
    /// other, m: a string in a hole stretches by less.
    pub below_bottom_m: f64,
    /// Time excluded after the string begins to move, s: acceleration.
    pub settle_s: f64,
    /// Travel of the block excluded there, m: it stretches the string before the bit moves and
    /// breaks static friction.
    pub settle_m: f64,
    /// Time excluded after the string begins to turn off bottom, s: some turns, which remove the
    /// axial friction.
    pub settle_turning_s: f64,
    /// Time excluded after the bit reaches bottom, s: the weight is applied.
    pub settle_drilling_s: f64,
    /// Time excluded at the end of a window, s.
    pub end_s: f64,
    /// Minimum duration of a window of pick-up or slack-off, s.
    pub moving_s: f64,
    /// Minimum duration of a window of rotation off bottom, s: three swings of a string in
    /// stick-slip, which last about 5 s each.
    pub turning_s: f64,
    /// Minimum duration of a window of drilling, s.
    pub drilling_s: f64,
    /// Maximum duration of a window, s; longer stretches are divided so that each belongs to one
    /// depth.
    pub longest_s: f64,
    /// Minimum number of rows of a window.
    pub rows: usize,
    /// Maximum spread of the weights in a window, over the weight of the string.
    pub spread: f64,
    /// Maximum change of the weight from the first third of its window to the last, over the
    /// string's weight and beyond the change from string length: a larger change means that the
    /// string is still settling.
    pub change: f64,
    /// Maximum swing of the torque in a window, over its mean: a larger swing means that the string
    /// stops at times, so that its torque is not the friction of a turning string.
    pub swing: f64,
    /// Weight on bit, over the weight of the string, above which a string is not off bottom.
    pub weight_on_bit: f64,
    /// Depth difference within which picks of a stand share a row, m: 3 m of pipe weigh about 1 kN.
    pub same_depth_m: f64,
    /// Maximum time between rows of a log from which weights are picked, s.
    pub slowest_s: f64,
}

/// One revolution per minute, rad/s.
const RPM: f64 = std::f64::consts::TAU / 60.0;

impl Default for Thresholds {
    fn default() -> Self {
        Self {
            slips_s: 10.0,
            connection_m: 5.0,
            beside_slips_s: 5.0,
            moves_m_per_s: 0.05,
            stands_m_per_s: 0.01,
            steady_part: 0.25,
            steady_m_per_s: 0.02,
            turns_rad_per_s: 10.0 * RPM,
            still_rad_per_s: 3.0 * RPM,
            off_bottom_m: 1.0,
            on_bottom_m: 0.3,
            below_bottom_m: 10.0,
            settle_s: 5.0,
            settle_m: 1.5,
            settle_turning_s: 10.0,
            settle_drilling_s: 30.0,
            end_s: 2.0,
            moving_s: 10.0,
            turning_s: 15.0,
            drilling_s: 60.0,
            longest_s: 900.0,
            rows: 3,
            spread: 0.05,
            change: 0.02,
            swing: 1.0,
            weight_on_bit: 0.03,
            same_depth_m: 3.0,
            slowest_s: 15.0,
        }
    }
}

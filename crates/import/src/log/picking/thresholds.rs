//! What counts as steady, still, turning and off bottom.

/// What the state of the rig and the windows are told by.
///
/// Rig states are told from block, bit and hole depth, hook load and rotary speed by thresholds, as
/// programs at the rig do it (Innova Drilling, *Rig States Guide*). The hook load in slips is no
/// threshold: it is found in the log.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thresholds {
    /// Shortest time in slips, s: setting, breaking out and making up take longer; a shorter fall of
    /// the hook load is a sensor that drops out.
    pub slips_s: f64,
    /// Least way of the block in slips that makes a connection of it, m: a joint has 9 m, and the
    /// block goes to its top or comes from there.
    pub connection_m: f64,
    /// Beside slips so much of the log is passed over, s: the load goes over from slips to hook.
    pub beside_slips_s: f64,
    /// From this speed the block moves, m/s: 3 m/min, slower than anybody trips.
    pub moves_m_per_s: f64,
    /// To this speed it stands, m/s: a pipe of 5 in that turns at 60 rev/min slides 0.4 m/s around,
    /// so that 0.01 m/s along takes 2.5 % of the friction.
    pub stands_m_per_s: f64,
    /// Part of the speed by which it may vary where it is steady.
    pub steady_part: f64,
    /// Speed by which it may always vary, m/s: what a position in centimetres leaves.
    pub steady_m_per_s: f64,
    /// From this speed the string turns, rad/s: 10 rev/min.
    pub turns_rad_per_s: f64,
    /// To this speed it does not, rad/s: 3 rev/min, for an encoder that is never quite at zero.
    pub still_rad_per_s: f64,
    /// From this height over the bottom the bit is off bottom, m: the depth of the bit is reckoned
    /// from the block, as if the string did not stretch.
    pub off_bottom_m: f64,
    /// To this height it is on bottom, m.
    pub on_bottom_m: f64,
    /// Time cut off where the string begins to move, s: acceleration.
    pub settle_s: f64,
    /// Way of the block cut off there, m: it stretches the string before the bit moves, and breaks
    /// static friction.
    pub settle_m: f64,
    /// Time cut off where the string begins to turn off bottom, s: some turns, which take the
    /// axial friction away.
    pub settle_turning_s: f64,
    /// Time cut off where the bit comes on bottom, s: the weight is brought up.
    pub settle_drilling_s: f64,
    /// Time cut off at the end of a window, s.
    pub end_s: f64,
    /// Shortest window of pick-up or slack-off, s.
    pub moving_s: f64,
    /// Shortest window of rotation off bottom, s: three swings of a string that sticks and slips,
    /// which last some 5 s each.
    pub turning_s: f64,
    /// Shortest window of drilling, s.
    pub drilling_s: f64,
    /// Longest window, s: what lasts longer makes several, so that each belongs to a depth.
    pub longest_s: f64,
    /// Least rows of a window.
    pub rows: usize,
    /// Largest spread of the weights in a window, over the weight of the string.
    pub spread: f64,
    /// Part of the string's weight by which a weight may change from the first third of its window to
    /// the last, beyond what the string gained or lost in length: more is a string that still
    /// settles.
    pub change: f64,
    /// Largest swing of the torque in a window, over its mean: more is a string that stands still at
    /// times, whose torque is no friction of a turning one.
    pub swing: f64,
    /// Weight on bit, over the weight of the string, beyond which a string is not off bottom.
    pub weight_on_bit: f64,
    /// Picks of a stand whose depths differ by less share a row, m: 3 m of pipe weigh about 1 kN.
    pub same_depth_m: f64,
    /// Slowest log from which weights are picked: time between rows, s.
    pub slowest_s: f64,
}

/// One revolution a minute, rad/s.
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

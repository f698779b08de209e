//! Logs of a rig whose weights and torques are known.

#[allow(dead_code, reason = "not every test that includes this writes a file")]
mod las;

use std::f64::consts::TAU;

use wholestring_import::{ImportError, Record};

/// True weights and torques of the string by bit depth, without the block, N and N·m.
#[derive(Debug, Clone, Copy)]
pub struct Truth<Of = fn(f64) -> f64> {
    pub pick_up_N: Of,
    pub slack_off_N: Of,
    pub rotating_N: Of,
    pub torque_N_m: Of,
    pub torque_on_bottom_N_m: Of,
}

/// A string of 250 N/m in a well whose friction adds or removes a fifth of its weight.
pub const TRUTH: Truth = Truth {
    pick_up_N: |depth| 1.2 * 250.0 * depth,
    slack_off_N: |depth| 0.8 * 250.0 * depth,
    rotating_N: |depth| 250.0 * depth,
    torque_N_m: |depth| 4.0 * depth,
    torque_on_bottom_N_m: |depth| 4.0 * depth + 6e3,
};

/// Properties of the log.
#[derive(Debug, Clone, Copy)]
pub struct Manner {
    pub step_s: f64,
    pub seed: u64,
    /// Standard deviation of a hook load, N.
    pub weight_noise_N: f64,
    /// Standard deviation of a torque, N·m.
    pub torque_noise_N_m: f64,
    /// Swing of the torque where the string turns, over its mean.
    pub stick_slip: f64,
    /// Swing of the hook load with the sea, N, and its period, s.
    pub heave: (f64, f64),
    /// Interval of faults in rows: one row in this many has a spike, one a missing value, one the
    /// start of a long gap.
    pub faults: Option<u64>,
    pub block_N: f64,
    /// Whether the sensor was zeroed with the block on it.
    pub zeroed: bool,
}

impl Default for Manner {
    fn default() -> Self {
        Self {
            step_s: 1.0,
            seed: 1,
            weight_noise_N: 5e3,
            torque_noise_N_m: 300.0,
            stick_slip: 0.0,
            heave: (0.0, 10.0),
            faults: None,
            block_N: 245e3,
            zeroed: false,
        }
    }
}

/// A rig that writes its log.
pub struct Rig<Of = fn(f64) -> f64> {
    pub manner: Manner,
    pub truth: Truth<Of>,
    pub records: Vec<Record>,
    /// Periods in which the string hung in slips, s.
    pub slips: Vec<(f64, f64)>,
    time_s: f64,
    bit_m: f64,
    hole_m: f64,
    block_m: f64,
    random: u64,
    /// Number of rows for which a sensor has no value, and which sensor.
    silent: (u64, u64),
}

/// Height of a stand, m.
pub const STAND_M: f64 = 27.0;

impl<Of: Fn(f64) -> f64> Rig<Of> {
    pub fn new(manner: Manner, truth: Truth<Of>, bit_m: f64, hole_m: f64) -> Self {
        let random = manner.seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        let (records, slips) = (Vec::new(), Vec::new());
        Self {
            manner,
            truth,
            records,
            slips,
            time_s: 0.0,
            bit_m,
            hole_m,
            block_m: 2.0,
            random,
            silent: (0, 0),
        }
    }

    /// The log as a reader gives it.
    pub fn log(&self) -> impl Iterator<Item = Result<Record, ImportError>> {
        self.records.iter().map(|record| Ok(*record))
    }

    fn next(&mut self) -> u64 {
        // Marsaglia's xorshift.
        self.random ^= self.random << 13;
        self.random ^= self.random >> 7;
        self.random ^= self.random << 17;
        self.random
    }

    fn normal(&mut self) -> f64 {
        let unit = |bits: u64| ((bits >> 11) as f64 + 0.5) / (1u64 << 53) as f64;
        let (a, b) = (unit(self.next()), unit(self.next()));
        (-2.0 * a.ln()).sqrt() * (TAU * b).cos()
    }

    /// Writes a row of the sensors' values.
    fn write(&mut self, string_N: f64, torque_N_m: f64, rotary_rad_per_s: f64) {
        let manner = self.manner;
        let block_N = if manner.zeroed { 0.0 } else { manner.block_N };
        let hangs = string_N > 0.0;
        let heave =
            if hangs { manner.heave.0 * (TAU * self.time_s / manner.heave.1).sin() } else { 0.0 };
        // A wave with a harmonic, so that its median is not its mean.
        let phase = TAU * self.time_s / 4.3;
        let swing = manner.stick_slip * (phase.sin() + 0.3 * (2.0 * phase).cos());
        let noise =
            if rotary_rad_per_s > 0.0 { manner.torque_noise_N_m * self.normal() } else { 0.0 };
        let mut record = Record {
            time_s: self.time_s,
            bit_depth_m: self.bit_m,
            hole_depth_m: self.hole_m,
            block_position_m: self.block_m + 0.003 * self.normal(),
            hook_load_N: block_N + string_N + heave + manner.weight_noise_N * self.normal(),
            torque_N_m: torque_N_m * (1.0 + swing) + noise,
            rotary_speed_rad_per_s: rotary_rad_per_s,
            ..Record::NONE
        };
        if let Some(one_in) = manner.faults {
            match self.next() % one_in {
                0 => record.hook_load_N *= 3.0,
                1 => record.hook_load_N = 0.0,
                2 => record.block_position_m += 4.0,
                3 => record.torque_N_m = 9e4,
                4 => record.hook_load_N = f64::NAN,
                5 => self.silent = (8, self.next() % 4),
                _ => {}
            }
            if self.silent.0 > 0 {
                self.silent.0 -= 1;
                match self.silent.1 {
                    0 => record.hook_load_N = -999.25 * 4448.0,
                    1 => record.torque_N_m = f64::NAN,
                    2 => record.rotary_speed_rad_per_s = -999.25,
                    _ => record.block_position_m = -999.25,
                }
            }
        }
        self.records.push(record);
        self.time_s += manner.step_s;
    }

    /// Waits on the hook without motion.
    pub fn wait(&mut self, time_s: f64) {
        let end = self.time_s + time_s;
        while self.time_s < end {
            let string_N = (self.truth.rotating_N)(self.bit_m);
            self.write(string_N, 0.0, 0.0);
        }
    }

    /// Hangs the string in slips while the block moves to another height.
    pub fn slips(&mut self, block_m: f64, time_s: f64) {
        let (from_s, from_m) = (self.time_s, self.block_m);
        while self.time_s < from_s + time_s {
            let part = (self.time_s - from_s) / time_s;
            // It waits a quarter, moves half, and waits a quarter.
            self.block_m = from_m + (2.0 * part - 0.5).clamp(0.0, 1.0) * (block_m - from_m);
            self.write(0.0, 0.0, 0.0);
        }
        self.block_m = block_m;
        self.slips.push((from_s, self.time_s));
    }

    /// Moves the block without rotation, upwards or, for a negative travel, downwards.
    pub fn moves(&mut self, way_m: f64, speed_m_per_s: f64) {
        const ACCELERATION_M_PER_S2: f64 = 0.1;
        let (from_block_m, from_bit_m, from_s) = (self.block_m, self.bit_m, self.time_s);
        let ramp_s = speed_m_per_s / ACCELERATION_M_PER_S2;
        let lasts_s = way_m.abs() / speed_m_per_s + ramp_s;
        while self.time_s < from_s + lasts_s {
            let at_s = self.time_s - from_s;
            let ramp = |at_s: f64| 0.5 * ACCELERATION_M_PER_S2 * at_s.min(ramp_s).powi(2);
            let full_s = (at_s - ramp_s).clamp(0.0, lasts_s - 2.0 * ramp_s);
            let slows_s = (at_s - lasts_s + ramp_s).max(0.0);
            let way = ramp(at_s) + speed_m_per_s * (full_s + slows_s) - ramp(slows_s);
            self.block_m = from_block_m + way * way_m.signum();
            self.bit_m = from_bit_m - way * way_m.signum();
            let weight = if way_m > 0.0 { &self.truth.pick_up_N } else { &self.truth.slack_off_N };
            let (moving_N, still_N) = (weight(self.bit_m), (self.truth.rotating_N)(self.bit_m));
            // The string stretches over the first half metre; static friction breaks in the next.
            let stretched = (way / 0.5).min(1.0);
            let sticks = 0.08 * (way / 0.25).min(1.0) * (-way / 0.3).exp();
            let drag_N = moving_N - still_N;
            let string_N = still_N + drag_N * stretched + drag_N.signum() * sticks * still_N;
            self.write(string_N, 0.0, 0.0);
        }
        self.block_m = from_block_m + way_m;
        self.bit_m = from_bit_m - way_m;
    }

    /// Turns off bottom; axial friction vanishes with the first turns.
    pub fn rotates(&mut self, time_s: f64) {
        let from_s = self.time_s;
        while self.time_s < from_s + time_s {
            let at_s = self.time_s - from_s;
            let left = 0.1 * (-at_s / 1.5).exp();
            let string_N = (1.0 - left) * (self.truth.rotating_N)(self.bit_m);
            let torque = (self.truth.torque_N_m)(self.bit_m) * (1.0 - (-at_s / 1.5).exp());
            self.write(string_N, torque, 12.0);
        }
    }

    /// Drills this distance.
    pub fn drills(&mut self, way_m: f64, speed_m_per_s: f64) {
        let end_m = self.hole_m + way_m;
        // Down to bottom, turning.
        while self.bit_m < self.hole_m {
            let step_m = (0.05 * self.manner.step_s).min(self.hole_m - self.bit_m);
            (self.bit_m, self.block_m) = (self.bit_m + step_m, self.block_m - step_m);
            self.write(
                (self.truth.rotating_N)(self.bit_m),
                (self.truth.torque_N_m)(self.bit_m),
                12.0,
            );
        }
        let from_s = self.time_s;
        while self.hole_m < end_m {
            let step_m = speed_m_per_s * self.manner.step_s;
            (self.bit_m, self.block_m) = (self.bit_m + step_m, self.block_m - step_m);
            self.hole_m = self.bit_m;
            let weighs = 1.0 - (-(self.time_s - from_s) / 6.0).exp();
            let off = (self.truth.torque_N_m)(self.bit_m);
            let on = (self.truth.torque_on_bottom_N_m)(self.bit_m);
            let string_N = (self.truth.rotating_N)(self.bit_m) - 80e3 * weighs;
            self.write(string_N, off + weighs * (on - off), 12.0);
        }
    }

    /// Pulls this many stands, with a connection after each.
    pub fn trips_out(&mut self, stands: usize) {
        for _ in 0..stands {
            self.wait(6.0);
            self.moves(STAND_M, 0.4);
            self.wait(6.0);
            self.slips(self.block_m - STAND_M, 120.0);
        }
    }

    /// Runs this many stands, with a connection before each.
    pub fn trips_in(&mut self, stands: usize) {
        for _ in 0..stands {
            self.slips(self.block_m + STAND_M, 120.0);
            self.wait(6.0);
            self.moves(-STAND_M, 0.4);
            self.wait(6.0);
        }
    }

    /// Drills a stand, then moves the string up and down and rotates it off bottom.
    pub fn drills_a_stand(&mut self) {
        self.slips(self.block_m + STAND_M, 180.0);
        self.wait(6.0);
        self.rotates(20.0);
        self.drills(STAND_M, 60.0 / 3600.0);
        self.wait(20.0);
        self.moves(10.0, 0.15);
        self.wait(15.0);
        self.moves(-7.0, 0.15);
        self.wait(5.0);
        self.rotates(90.0);
        self.wait(10.0);
    }
}

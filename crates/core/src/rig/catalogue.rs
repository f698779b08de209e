//! Common ranges of top drives and hoists by class.
//!
//! Makers print their own ratings, which differ within a class by a third and by gear and motor:
//! these ranges show whether a number is usual, and are those of no particular rig. Typical, from
//! memory of makers' public data sheets.

/// Source of the ranges.
pub const SOURCE: &str = "typical ranges of makers' public data sheets, from memory: take your own \
                          rig's";

const POUND_FORCE_N: f64 = 4.448_221_615_260_5;
const SHORT_TON_N: f64 = 2000.0 * POUND_FORCE_N;
const FOOT_POUND_N_M: f64 = 0.3048 * POUND_FORCE_N;
const RPM_RAD_PER_S: f64 = std::f64::consts::PI / 30.0;

/// From the least to the most that is common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Least.
    pub least: f64,
    /// Most.
    pub most: f64,
}

impl Span {
    fn of([least, most]: [f64; 2], unit: f64) -> Self {
        Self { least: least * unit, most: most * unit }
    }
}

/// Top drives that carry the same load.
#[derive(Debug, Clone, PartialEq)]
pub struct TopDriveClass {
    /// Name: `top drive 500 t`, by the short tons that it carries.
    pub designation: String,
    /// Load that it carries, N.
    pub capacity_N: f64,
    /// Rated (continuous) torque, N·m.
    pub torque_N_m: Span,
    /// Torque for a short time, drilling or breaking out, N·m.
    pub peak_torque_N_m: Span,
    /// Highest rotary speed, rad/s.
    pub highest_speed_rad_per_s: Span,
}

/// Hoists of one class.
#[derive(Debug, Clone, PartialEq)]
pub struct HoistClass {
    /// Name: `drawworks 1500 hp`, `injector head 80 klbf`.
    pub designation: String,
    /// Load that mast and hoist carry, or the pull of an injector head, N.
    pub capacity_N: Span,
    /// Force with which it pushes the string into the hole, N; none of a drawworks.
    pub snubbing_force_N: Option<Span>,
    /// Weight of travelling block and top drive, N; none of an injector head.
    pub block_weight_N: Option<Span>,
}

/// Short tons; in 1000 ft·lbf and rev/min: continuous torque, peak torque, highest speed.
type TopDriveRow = (f64, [f64; 2], [f64; 2], [f64; 2]);

const TOP_DRIVES: [TopDriveRow; 5] = [
    (150.0, [10.0, 20.0], [15.0, 35.0], [150.0, 200.0]),
    (250.0, [20.0, 30.0], [30.0, 55.0], [150.0, 220.0]),
    (500.0, [30.0, 52.0], [50.0, 85.0], [180.0, 265.0]),
    (750.0, [50.0, 70.0], [85.0, 120.0], [200.0, 270.0]),
    (1000.0, [65.0, 100.0], [100.0, 160.0], [220.0, 275.0]),
];

/// Horsepower, and in short tons: load of the mast, and weight of block and top drive.
const DRAWWORKS: [(f64, [f64; 2], [f64; 2]); 4] = [
    (1000.0, [175.0, 350.0], [10.0, 25.0]),
    (1500.0, [250.0, 500.0], [15.0, 35.0]),
    (2000.0, [375.0, 650.0], [20.0, 45.0]),
    (3000.0, [600.0, 1000.0], [30.0, 80.0]),
];

/// Pull in 1000 lbf, which names the injector head; it pushes with a half of that, more or less.
const INJECTOR_HEADS: [f64; 4] = [60.0, 80.0, 100.0, 130.0];
const PUSH: [f64; 2] = [0.35, 0.5];

/// Top drives by the load that they carry.
pub fn top_drives() -> Vec<TopDriveClass> {
    let class =
        |&(tons, torque, peak, speed): &(f64, [f64; 2], [f64; 2], [f64; 2])| TopDriveClass {
            designation: format!("top drive {tons} t"),
            capacity_N: tons * SHORT_TON_N,
            torque_N_m: Span::of(torque, 1e3 * FOOT_POUND_N_M),
            peak_torque_N_m: Span::of(peak, 1e3 * FOOT_POUND_N_M),
            highest_speed_rad_per_s: Span::of(speed, RPM_RAD_PER_S),
        };
    TOP_DRIVES.iter().map(class).collect()
}

/// Drawworks by their power, injector heads by their pull.
pub fn hoists() -> Vec<HoistClass> {
    let drawworks = DRAWWORKS.iter().map(|&(power, capacity, block)| HoistClass {
        designation: format!("drawworks {power} hp"),
        capacity_N: Span::of(capacity, SHORT_TON_N),
        snubbing_force_N: None,
        block_weight_N: Some(Span::of(block, SHORT_TON_N)),
    });
    let heads = INJECTOR_HEADS.iter().map(|&pull| HoistClass {
        designation: format!("injector head {pull} klbf"),
        capacity_N: Span::of([pull; 2], 1e3 * POUND_FORCE_N),
        snubbing_force_N: Some(Span::of(PUSH, pull * 1e3 * POUND_FORCE_N)),
        block_weight_N: None,
    });
    drawworks.chain(heads).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_have_their_order() {
        for class in top_drives() {
            let Span { least, most } = class.torque_N_m;
            assert!(least < most && most < class.peak_torque_N_m.most, "{class:?}");
            assert!(least < class.peak_torque_N_m.least, "{class:?}");
        }
        for class in hoists() {
            assert!(class.capacity_N.least <= class.capacity_N.most, "{class:?}");
        }
    }
}

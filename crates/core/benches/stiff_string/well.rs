//! Random but sensible wells: 300 m to 12 km with doglegs to 20 deg/30 m, spline and arcs; motors
//! with and without a bend at three tool faces, none to three blades, friction from 0 to 0.6, every
//! operation.

use wholestring::{
    operation::OperationKind,
    prelude::*,
    string::{Blades, BodyBend, ComponentLength, ComponentSpec, ToolJoints},
    well::Interpolation,
};

use crate::{
    HOLE_M,
    common::{model, mud, open_hole, operation, path, steel},
};

/// Steele, Lea and Flood's SplitMix64.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn one_of<T: Copy, const N: usize>(&mut self, all: [T; N]) -> T {
        all[((self.unit() * N as f64) as usize).min(N - 1)]
    }
}

/// A random well, its string and its operation.
pub fn well(seed: u64, weight_N: f64) -> (Model, Operation) {
    let mut random = Random(1000 + seed);
    let depth_m = 300.0 * 40.0_f64.powf(random.unit());
    let stations = stations(&mut random, depth_m);
    let between = random.one_of([Interpolation::Spline, Interpolation::MinimumCurvature]);
    let path = path(&stations, between);
    let hole = open_hole(HOLE_M, random.between(0.0, 0.6), depth_m);
    let parts = components(&mut random, depth_m);
    let model = model(path, hole, parts, mud(1200.0), depth_m);
    let operation = operation(random.one_of(OperationKind::ALL), depth_m)
        .weight_on_bit_N(weight_N)
        .bit_torque_N_m(3000.0)
        .rate_of_penetration_m_per_s(0.005);
    (model, Operation { trip_speed_m_per_s: 0.3, ..operation })
}

/// MD, m, inclination and azimuth, deg, every 30 m.
fn stations(random: &mut Random, depth_m: f64) -> Vec<[f64; 3]> {
    let kick_off_m = depth_m * random.between(0.05, 0.4);
    let steepest_deg = random.between(1.0, if depth_m < 3000.0 { 20.0 } else { 8.0 });
    let held_deg = random.between(20.0, 90.0);
    let (mut md_m, mut inclination, mut azimuth) = (0.0, 0.0_f64, random.between(0.0, 360.0));
    let mut stations = vec![[md_m, inclination, azimuth]];
    while md_m < depth_m {
        md_m += 30.0;
        if md_m > kick_off_m {
            inclination = (inclination + random.unit() * steepest_deg).min(held_deg);
            if inclination >= held_deg {
                let wanders = random.between(-0.2, 0.2) * steepest_deg;
                inclination = (inclination + wanders).clamp(0.0, 100.0);
            }
            let sine = inclination.to_radians().sin().max(0.2);
            azimuth += random.between(-0.5, 0.5) * steepest_deg / sine;
        }
        stations.push([md_m, inclination, azimuth.rem_euclid(360.0)]);
    }
    stations
}

/// Bit, motor, blades between collars, heavy-weight pipe and drill pipe.
fn components(random: &mut Random, depth_m: f64) -> Vec<ComponentSpec> {
    use ComponentLength::{Metres, ToSurface};
    let tool = |name: &str, od_m, id_m, length_m| {
        ComponentSpec::uniform(name, od_m, id_m, Metres(length_m), steel())
    };
    let collar = |length_m| tool("collar", 0.165, 0.0714, length_m);
    let jointed = |spacing_m| Some(ToolJoints { od_m: 0.165, spacing_m });
    let mut motor = tool("motor", 0.172, 0.06, 8.0);
    if random.unit() < 0.4 {
        let [angle_deg, toolface_deg] =
            [random.between(0.5, 2.0), random.one_of([0.0, 90.0, 180.0])];
        motor.bend = Some(BodyBend {
            from_lower_end_m: 2.0,
            angle_rad: f64::to_radians(angle_deg),
            toolface_rad: f64::to_radians(toolface_deg),
        });
    }
    let mut parts = vec![tool("bit", HOLE_M, 0.06, 0.3), motor];
    for _ in 0..random.one_of([0, 1, 2, 3]) {
        let od_m = HOLE_M - random.between(0.0005, 0.012);
        let blades = Some(Blades { od_m, length_m: 0.4 });
        parts.push(ComponentSpec { blades, ..collar(1.5) });
        parts.push(collar(random.between(3.0, 10.0)));
    }
    let heavy = tool("heavy-weight pipe", 0.127, 0.0762, (0.1 * depth_m).min(120.0));
    parts.push(ComponentSpec { joints: jointed(9.4), ..heavy });
    let joints = if random.unit() < 0.8 { jointed(9.6) } else { None };
    let pipe = ComponentSpec::uniform("drill pipe", 0.127, 0.1086, ToSurface, steel());
    parts.push(ComponentSpec { joints, ..pipe });
    parts
}

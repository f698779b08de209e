//! A case in other units, in another order, or with other last digits has the same results.

mod common;

use common::read;
use fastrand::Rng;
use wholestring::statics::soft::{SoftProfile, soft_string};

/// Tolerance, as a part of the largest force, torque or length: the effect of inputs that differ in
/// their last digits.
const TOLERANCE: f64 = 1e-9;

/// The soft string of every operation of a case.
fn answers(text: &str) -> Vec<SoftProfile> {
    let case = read(text).unwrap_or_else(|report| panic!("{text}\n{report}"));
    let operations = case.operations.iter();
    operations.map(|operation| soft_string(&case.model, operation).expect("an answer")).collect()
}

#[track_caller]
fn assert_same(what: &str, a: &str, b: &str) {
    let (a, b) = (answers(a), answers(b));
    assert_eq!(a.len(), b.len(), "{what}");
    for (index, (a, b)) in a.iter().zip(&b).enumerate() {
        assert_eq!(a.md_m.len(), b.md_m.len(), "{what} {index}: as many steps");
        let (x, y) = (&a.scalars, &b.scalars);
        let force_N = x.hook_load_N.abs().max(x.side_force_total_N);
        for (quantity, x, y, scale) in [
            ("hook load", x.hook_load_N, y.hook_load_N, force_N),
            ("side force", x.side_force_total_N, y.side_force_total_N, force_N),
            ("drag", x.axial_friction_N, y.axial_friction_N, force_N),
            ("torque", x.surface_torque_N_m, y.surface_torque_N_m, x.surface_torque_N_m.abs()),
            ("twist", x.twist_rad, y.twist_rad, x.twist_rad.abs()),
            ("stretch", x.stretch_m, y.stretch_m, 1e-4 * a.md_m[a.md_m.len() - 1]),
        ] {
            let apart = (x - y).abs() / scale.max(1e-2);
            assert!(apart < TOLERANCE, "{what} {index}: {quantity} {x} for {y}, {apart:.1e} apart");
        }
    }
}

/// In feet the stretch from 363.5 m to 371.5 m, which is a kick-off of a spline, had nine steps
/// instead of eight, which changed the torque by 3e-5.
#[test]
fn field_units_are_si() {
    assert_same("units", include_str!("units/si.toml"), include_str!("units/field.toml"));
}

/// The last station is 5e-10 m above the bit, where the path continues straight: the curvature of
/// the last metre was lost at its lower end, 1.5e-4 of the torque.
#[test]
fn a_bit_below_the_last_station_by_a_last_digit() {
    let [at, below] =
        [include_str!("units/bit-at-station.toml"), include_str!("units/bit-below-station.toml")];
    assert_same("last digit", at, below);
}

/// A random case, written in SI or in field units, its tables in one order or another.
struct Drawn {
    stations: Vec<[f64; 3]>,
    spline: bool,
    shoe_m: f64,
    collar_m: f64,
    mud_kg_per_m3: f64,
    wob_N: f64,
    depth_m: f64,
}

impl Drawn {
    fn new(random: &mut Rng) -> Self {
        let mut tenths =
            |from: f64, to: f64| (10.0 * (from + (to - from) * random.f64())).round() / 10.0;
        let mut station = [0.0, 0.0, tenths(0.0, 359.0)];
        let mut stations = vec![station];
        for _ in 0..3 + tenths(0.0, 6.0) as usize {
            let length_m = tenths(8.0, 120.0);
            let most = length_m / 8.0;
            station[0] = (10.0 * (station[0] + length_m)).round() / 10.0;
            if tenths(0.0, 1.0) > 0.3 {
                station[1] = (station[1] + tenths(-0.3 * most, most)).clamp(0.0, 90.0);
                station[2] = (station[2] + tenths(-most, most)).clamp(0.0, 359.0);
            }
            stations.push(station);
        }
        let last_m = station[0];
        Self {
            spline: tenths(0.0, 1.0) > 0.5,
            shoe_m: (0.3 * last_m).round().max(2.0),
            collar_m: tenths(1.0, 0.2 * last_m),
            mud_kg_per_m3: 10.0 * tenths(100.0, 180.0),
            wob_N: 1e3 * tenths(1.0, 60.0),
            depth_m: if tenths(0.0, 1.0) > 0.5 { last_m } else { tenths(0.8 * last_m, last_m) },
            stations,
        }
    }

    fn text(&self, field: bool, other_way_round: bool) -> String {
        let length = |m: f64| match field {
            true => format!("\"{} ft\"", m / 0.3048),
            false => format!("{m}"),
        };
        let diameter = |m: f64| match field {
            true => format!("\"{} in\"", m / 0.0254),
            false => format!("{m}"),
        };
        let stations: Vec<String> = self
            .stations
            .iter()
            .map(|[md_m, inc, azi]| format!("[{}, {inc}, {azi}]", length(*md_m)))
            .collect();
        let path = if self.spline { "spline" } else { "minimum-curvature" };
        let last_m = self.stations[self.stations.len() - 1][0];
        let (mud, wob) = match field {
            true => (
                format!("\"{} ppg\"", self.mud_kg_per_m3 / 119.826_427_316_896_88),
                format!("\"{} lbf\"", self.wob_N / 4.448_221_615_260_5),
            ),
            false => (format!("{}", self.mud_kg_per_m3), format!("{}", self.wob_N)),
        };
        let mut tables = [
            format!("[well]\nstations = [{}]\npath = \"{path}\"\n", stations.join(", ")),
            format!(
                "[[well.hole]]\nkind = \"casing\"\nto = {}\ndiameter = {}\nfriction = 0.2\n\
                 [[well.hole]]\nkind = \"open\"\nto = {}\ndiameter = {}\nfriction = 0.3\n",
                length(self.shoe_m),
                diameter(0.2245),
                length(last_m),
                diameter(0.2159)
            ),
            format!("[mud]\ndensity = {mud}\n"),
            format!(
                "[[string]]\ncomponent = \"bit\"\nod = {}\nid = {}\nlength = {}\n\
                 [[string]]\ncomponent = \"collar\"\nod = {}\nid = {}\nlength = {}\n\
                 [[string]]\ncomponent = \"pipe\"\nod = {}\nid = {}\nlength = \"to surface\"\n",
                diameter(0.2159),
                diameter(0.05),
                length(0.3),
                diameter(0.165),
                diameter(0.07),
                length(self.collar_m),
                diameter(0.127),
                diameter(0.1086)
            ),
            format!(
                "[operation]\nkind = [\"trip_out\", \"slide\", \"drill\"]\nrpm = 120\nwob = {wob}\n\
                 rop = 0.005\nbit_depth = {}\n",
                length(self.depth_m)
            ),
            "[bit]\ntorque = 2000\n".to_owned(),
        ];
        if other_way_round {
            tables.reverse();
        }
        format!("name = \"m\"\nmodel = \"soft\"\n{}", tables.concat())
    }
}

#[test]
fn random_cases_in_other_units_and_in_another_order() {
    let mut random = Rng::with_seed(24);
    for round in 0..150 {
        let random_case = Drawn::new(&mut random);
        let plain = random_case.text(false, false);
        assert_same(&format!("{round} units"), &plain, &random_case.text(true, false));
        assert_same(&format!("{round} order"), &plain, &random_case.text(false, true));
    }
}

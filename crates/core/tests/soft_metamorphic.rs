//! Changes of a case that change nothing: other units, the axes that the survey is read in, where
//! components, sections and survey are cut, the course of the hole below the bit, and the step.
//!
//! 2,000 random wells, each changed in every way. Tolerance 1e-9 of the largest force, torque or
//! length: rounding of inputs is 1e-15, a kink costs 2e-12 of a hook load, and the default step errs
//! by up to 8e-10 in the sharpest transitions of a spline.

mod common;

use common::*;
use wholestring::{
    model::Model,
    mud::Rheology,
    operation::{Operation, OperationKind, OperationKind::*},
    random::Random,
    statics::soft::{SoftProfile, SoftSettings, solve},
    string::{Blades, ComponentLength, ComponentSpec, ToolJoints},
    well::{Hole, HoleSection, Interpolation, Path, Station, TieIn},
};

const WELLS: u64 = 2000;

/// The default step.
const STEP_M: f64 = 1.0;

const FOOT_M: f64 = 0.3048;

/// A random case: everything that a metamorphosis changes.
#[derive(Debug, Clone)]
struct Drawn {
    stations_m_deg: Vec<[f64; 3]>,
    interpolation: Interpolation,
    tie_in: TieIn,
    /// Lower end, m, diameter, m, and friction.
    sections: Vec<[f64; 3]>,
    /// From the bit up, the topmost to the surface.
    components: Vec<ComponentSpec>,
    mud_kg_per_m3: f64,
    rheology: Option<Rheology>,
    operation: Operation,
    step_m: f64,
}

const KINDS: [OperationKind; 7] = [TripOut, TripIn, RotateOffBottom, Drill, Slide, Ream, BackReam];

impl Drawn {
    fn new(seed: u64) -> Self {
        let mut random = Random::new(seed);
        // Round numbers, as people write them: whole steps, stations and ends that meet.
        let mut tenths =
            |from: f64, to: f64| (10.0 * (from + (to - from) * random.unit())).round() / 10.0;
        let count = 2 + tenths(0.0, 7.0) as usize;
        let (mut md_m, mut inclination, mut azimuth) = (0.0, 0.0, tenths(0.0, 360.0));
        let mut stations_m_deg = vec![[md_m, inclination, azimuth]];
        for _ in 0..count {
            let length_m = tenths(8.0, 80.0);
            md_m += length_m;
            // At most 5 deg/30 m, a third of the stretches straight, some of them in a plane.
            if tenths(0.0, 3.0) > 1.0 {
                let most = 5.0 * length_m / 30.0;
                inclination = (inclination + tenths(-0.4 * most, most)).clamp(0.0, 95.0);
                if tenths(0.0, 1.0) > 0.5 {
                    azimuth += tenths(-most, most);
                }
            }
            stations_m_deg.push([md_m, inclination, azimuth]);
        }
        let shoe_m = (0.3 * md_m).round() + 1.0;
        let component = |name: &str, od_m: f64, id_m: f64, length: ComponentLength| {
            ComponentSpec::uniform(name, od_m, id_m, length, steel())
        };
        let metres = ComponentLength::Metres;
        let mut components = vec![
            component("bit", 0.2159, 0.05, metres(0.3)),
            component("collar", 0.165, 0.07, metres(tenths(2.0, 0.2 * md_m))),
        ];
        if tenths(0.0, 1.0) > 0.5 {
            components.push(ComponentSpec {
                blades: Some(Blades { od_m: 0.21, length_m: 0.6 }),
                ..component("stabiliser", 0.165, 0.07, metres(1.8))
            });
        }
        components.push(ComponentSpec {
            joints: Some(ToolJoints { od_m: 0.168, spacing_m: 9.6 }),
            ..component("pipe", 0.127, 0.1086, ComponentLength::ToSurface)
        });
        let kind = KINDS[tenths(0.0, 6.9) as usize];
        let depth_m = if tenths(0.0, 1.0) > 0.5 { md_m } else { tenths(0.8 * md_m, md_m) };
        let operation = Operation::new(kind, depth_m)
            .rotary_speed_rad_per_s(rpm(tenths(20.0, 180.0)))
            .weight_on_bit_N(if kind.on_bottom() { 1e3 * tenths(0.0, 60.0) } else { 0.0 })
            .flow_rate_m3_per_s(0.03);
        let rheology =
            (tenths(0.0, 1.0) > 0.7).then_some(Rheology::Newtonian { viscosity_Pa_s: 0.02 });
        Self {
            interpolation: if tenths(0.0, 1.0) > 0.5 {
                Interpolation::Spline
            } else {
                Interpolation::MinimumCurvature
            },
            stations_m_deg,
            tie_in: TieIn::default(),
            sections: vec![[shoe_m, 0.2245, 0.2], [md_m, 0.2159, tenths(0.0, 5.0) / 10.0]],
            components,
            mud_kg_per_m3: 10.0 * tenths(90.0, 200.0),
            rheology,
            operation,
            step_m: STEP_M,
        }
    }

    fn solve(&self) -> SoftProfile {
        let stations: Vec<Station> = self
            .stations_m_deg
            .iter()
            .map(|[md_m, inclination, azimuth]| {
                Station::from_degrees(*md_m, *inclination, *azimuth)
            })
            .collect();
        let path = Path::new(&stations, self.interpolation, self.tie_in).expect("a path");
        let mut from_m = 0.0;
        let sections = self.sections.iter().map(|[to_m, diameter_m, friction]| {
            let section = HoleSection::open(from_m..*to_m, *diameter_m, *friction);
            from_m = *to_m;
            section
        });
        let hole = Hole::new(sections.collect()).expect("a hole");
        let depth_m = self.operation.bit_depth_m;
        let mut model: Model =
            model(path, hole, self.components.clone(), mud(self.mud_kg_per_m3), depth_m);
        model.mud.rheology = self.rheology;
        let settings = SoftSettings { step_m: self.step_m, ..SoftSettings::default() };
        solve(&model, &self.operation, &settings).expect("an answer")
    }

    /// Every length through a function.
    fn lengths(mut self, change: impl Fn(f64) -> f64) -> Self {
        for station in &mut self.stations_m_deg {
            station[0] = change(station[0]);
        }
        for section in &mut self.sections {
            (section[0], section[1]) = (change(section[0]), change(section[1]));
        }
        for component in &mut self.components {
            if let ComponentLength::Metres(length_m) = &mut component.length {
                *length_m = change(*length_m);
            }
        }
        self.operation.bit_depth_m = change(self.operation.bit_depth_m);
        self
    }

    fn azimuths(mut self, change: impl Fn(f64) -> f64) -> Self {
        for station in &mut self.stations_m_deg {
            station[2] = change(station[2]);
        }
        self
    }

    /// Components and sections cut in two, and the arc from one station to the next.
    fn split(mut self, random: &mut Random) -> Self {
        let parts = self.components.iter().flat_map(|component| match component.length {
            // Blades and joints are counted from an end.
            ComponentLength::Metres(length_m) if component.blades.is_none() => {
                let part = 0.2 + 0.6 * random.unit();
                [part * length_m, (1.0 - part) * length_m]
                    .map(|length_m| ComponentSpec {
                        length: ComponentLength::Metres(length_m),
                        ..component.clone()
                    })
                    .to_vec()
            }
            _ => vec![component.clone()],
        });
        self.components = parts.collect();
        let [first, second] = [self.sections[0], self.sections[1]];
        let cut_m = first[0] + (second[0] - first[0]) * random.unit();
        self.sections = vec![first, [cut_m, second[1], second[2]], second];
        if self.interpolation == Interpolation::MinimumCurvature {
            let stations: Vec<Station> = self
                .stations_m_deg
                .iter()
                .map(|[md_m, inc, azi]| Station::from_degrees(*md_m, *inc, *azi))
                .collect();
            let path = Path::minimum_curvature(&stations).expect("a path");
            let last = self.stations_m_deg.len() - 1;
            let at = 1 + (random.unit() * last as f64) as usize;
            let [from, to] = [self.stations_m_deg[at - 1], self.stations_m_deg[at]];
            let md_m = from[0] + (to[0] - from[0]) * (0.2 + 0.6 * random.unit());
            let point = path.at(md_m);
            let degrees = [point.inclination_rad(), point.azimuth_rad()].map(f64::to_degrees);
            self.stations_m_deg.insert(at, [md_m, degrees[0], degrees[1]]);
        }
        self
    }

    /// Another station and another section below the bit. A spline is another one then.
    fn deeper(mut self) -> Self {
        let [md_m, inclination, azimuth] = self.stations_m_deg[self.stations_m_deg.len() - 1];
        if self.interpolation == Interpolation::MinimumCurvature {
            self.stations_m_deg.push([md_m + 50.0, inclination + 4.0, azimuth + 3.0]);
        }
        self.sections.push([md_m + 50.0, 0.311, 0.9]);
        self
    }
}

/// The largest part by which a result differs from another one, and the name of the quantity.
fn apart(a: &SoftProfile, b: &SoftProfile) -> (f64, &'static str) {
    let (x, y) = (&a.scalars, &b.scalars);
    let force_N = x.hook_load_N.abs().max(x.side_force_total_N).max(1e3);
    let torque_N_m = x.surface_torque_N_m.abs().max(1.0);
    let depth_m = a.md_m[a.md_m.len() - 1];
    let neutral =
        |profile: &SoftProfile| profile.scalars.neutral_point_m.unwrap_or(f64::NEG_INFINITY);
    let neutral_m = if neutral(a) == neutral(b) { 0.0 } else { neutral(a) - neutral(b) };
    let pump_Pa =
        |profile: &SoftProfile| profile.hydraulics.map_or(0.0, |mud| mud.pump_pressure_Pa);
    let all = [
        ("hook load", (x.hook_load_N - y.hook_load_N) / force_N),
        ("axial friction", (x.axial_friction_N - y.axial_friction_N) / force_N),
        ("side force", (x.side_force_total_N - y.side_force_total_N) / force_N),
        ("surface torque", (x.surface_torque_N_m - y.surface_torque_N_m) / torque_N_m),
        ("friction torque", (x.friction_torque_N_m - y.friction_torque_N_m) / torque_N_m),
        ("twist", (x.twist_rad - y.twist_rad) / x.twist_rad.abs().max(1e-2)),
        ("stretch", (x.stretch_m - y.stretch_m) / (1e-4 * depth_m)),
        ("pump pressure", (pump_Pa(a) - pump_Pa(b)) / pump_Pa(a).max(1e3)),
        // Where a level string hardly changes its tension, 1e-9 of the tension is a metre in a
        // kilometre.
        ("neutral point", 1e-3 * neutral_m / depth_m),
    ];
    let size = |part: f64| if part.is_nan() { f64::INFINITY } else { part.abs() };
    all.into_iter()
        .map(|(what, part)| (size(part), what))
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .expect("one of them")
}

#[test]
fn what_changes_nothing_changes_nothing() {
    const TOLERANCE: f64 = 1e-9;
    let mut worst = (0.0, String::new());
    let mut failed = Vec::new();
    for seed in 0..WELLS {
        let sample = Drawn::new(seed);
        let mut random = Random::new(seed ^ 0x5eed);
        let plain = sample.solve();
        let turn = 360.0 * random.unit();
        let tie_in = TieIn { north_m: 6e6, east_m: -4e5, tvd_m: -30.0 };
        let changed = [
            ("units", sample.clone().lengths(|m| (m / FOOT_M) * FOOT_M)),
            ("last digits", sample.clone().lengths(|m| m * (1.0 - 1e-13))),
            ("rotation", sample.clone().azimuths(|azimuth| azimuth + turn)),
            ("mirror", sample.clone().azimuths(|azimuth| -azimuth)),
            ("split", sample.clone().split(&mut random)),
            ("tie-in", Drawn { tie_in, ..sample.clone() }),
            ("deeper hole", sample.clone().deeper()),
            ("steps", Drawn { step_m: STEP_M * (0.4 + 0.6 * random.unit()), ..sample.clone() }),
        ];
        for (name, case) in changed {
            let (part, what) = apart(&plain, &case.solve());
            let place = format!("{seed} {name}: {what} {part:.1e} apart");
            if part > worst.0 {
                worst = (part, place.clone());
            }
            if part > TOLERANCE {
                failed.push(place);
            }
        }
    }
    println!("worst: {}", worst.1);
    assert!(failed.is_empty(), "{} of them, {:#?}", failed.len(), &failed[..failed.len().min(40)]);
}

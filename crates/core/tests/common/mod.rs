//! Common parts of the tests, including those inside the crate: steel, simple strings and wells,
//! verification files.
// Every test file uses its own part of this module.
#![allow(dead_code, unreachable_pub, unused_imports)]

pub mod beam;
pub mod np13;
pub mod rigid;
pub mod whirl;

use serde_json::Value;
use wholestring::{
    GRAVITY_M_PER_S2,
    dynamics::{Band, Cutters, Excitation, MudMotor, RegenerativeLaw},
    ends::Ends,
    mud::{Fluids, Rheology},
    prelude::*,
    well::{Interpolation, TieIn},
};
pub use wholestring_verification::{
    Row, Tolerance, file as verification, relative_error, report_worst, verify,
};

/// A number of such a file.
#[track_caller]
pub fn number(value: &Value) -> f64 {
    let number = value.as_f64();
    number.unwrap_or_else(|| panic!("no number: {value}"))
}

/// Fails with the obtained and expected values where they differ by more than a relative tolerance.
#[track_caller]
pub fn assert_close(what: &str, obtained: f64, expected: f64, tolerance: f64) {
    let error = relative_error(obtained, expected);
    assert!(error <= tolerance, "{what}: {obtained} for {expected}, {error:.2e} apart");
}

/// Steel of 7850 kg/m³, 210 GPa and 80 GPa.
pub fn steel() -> Material {
    Material {
        density_kg_per_m3: 7850.0,
        youngs_modulus_Pa: 210e9,
        shear_modulus_Pa: 80e9,
        ..Material::STEEL
    }
}

/// A path of circular arcs through stations of MD in m, inclination and azimuth in degrees.
pub fn arcs(stations_m_deg: &[[f64; 3]]) -> Path {
    path(stations_m_deg, Interpolation::MinimumCurvature)
}

/// A path through stations of MD in m, inclination and azimuth in degrees.
pub fn path(stations_m_deg: &[[f64; 3]], interpolation: Interpolation) -> Path {
    let in_rad = |&[md_m, inclination_deg, azimuth_deg]: &[f64; 3]| {
        [md_m, inclination_deg.to_radians(), azimuth_deg.to_radians()]
    };
    let stations: Vec<[f64; 3]> = stations_m_deg.iter().map(in_rad).collect();
    path_in_rad(&stations, interpolation)
}

/// A path through stations of MD in m, inclination and azimuth in radians.
pub fn path_in_rad(stations_m_rad: &[[f64; 3]], interpolation: Interpolation) -> Path {
    let station = |[md_m, inclination_rad, azimuth_rad]: &[f64; 3]| Station {
        md_m: *md_m,
        inclination_rad: *inclination_rad,
        azimuth_rad: *azimuth_rad,
    };
    let stations: Vec<Station> = stations_m_rad.iter().map(station).collect();
    Path::new(&stations, interpolation, TieIn::default()).expect("a sound survey")
}

/// An open hole of 0.3 m with the same friction all the way down.
pub fn hole(friction: f64, to_md_m: f64) -> Hole {
    hole_of(&[(friction, to_md_m)])
}

/// An open hole of 0.3 m with a kinetic friction coefficient down to each measured depth.
pub fn hole_of(frictions: &[(f64, f64)]) -> Hole {
    let mut from_md_m = 0.0;
    let sections = frictions.iter().map(|&(friction, to_md_m)| {
        let section = HoleSection { from_md_m, ..open_section(0.3, friction, to_md_m) };
        from_md_m = to_md_m;
        section
    });
    Hole::new(sections.collect()).expect("a sound hole")
}

/// An open hole of a diameter with the same friction all the way down.
pub fn open_hole(diameter_m: f64, friction: f64, to_md_m: f64) -> Hole {
    Hole::new(vec![open_section(diameter_m, friction, to_md_m)]).expect("a sound hole")
}

/// The same in the rock of the article, with any friction.
pub fn article_hole(diameter_m: f64, friction: Friction, to_md_m: f64) -> Hole {
    let section = HoleSection { friction, ..HoleSection::open(0.0..to_md_m, diameter_m, 0.0) };
    Hole::new(vec![section]).expect("a sound hole")
}

/// A section of open hole from the surface down, in rock of 50 GPa.
pub fn open_section(diameter_m: f64, friction: f64, to_md_m: f64) -> HoleSection {
    HoleSection {
        youngs_modulus_Pa: 50e9,
        poisson_ratio: 0.3,
        ..HoleSection::open(0.0..to_md_m, diameter_m, friction)
    }
}

/// Mud of 1.2 sg that drags on lateral motion.
pub const fn mud_with_drag() -> Mud {
    Mud { linear_drag_Pa_s: 5.0, drag_coefficient: 1.0, ..mud(1200.0) }
}

/// Mud of a density and a rheology, without lateral drag.
pub fn viscous_mud(density_kg_per_m3: f64, rheology: Rheology) -> Mud {
    Mud { rheology: Some(rheology), ..mud(density_kg_per_m3) }
}

/// Mud of a density, without drag.
pub const fn mud(density_kg_per_m3: f64) -> Mud {
    Mud { density_kg_per_m3, linear_drag_Pa_s: 0.0, drag_coefficient: 0.0, rheology: None }
}

/// Plain pipe of a weight per length in air and a contact radius, its wall a tenth of its diameter.
pub fn pipe(weight_N_per_m: f64, radius_m: f64, length: ComponentLength) -> ComponentSpec {
    ComponentSpec {
        mass_per_length_kg_per_m: weight_N_per_m / GRAVITY_M_PER_S2,
        ..ComponentSpec::uniform("pipe", 2.0 * radius_m, 1.6 * radius_m, length, steel())
    }
}

/// A model of a path, a hole, components from the bit up and a mud, with the bit at a depth.
pub fn model(
    path: Path,
    hole: Hole,
    components: Vec<ComponentSpec>,
    mud: Mud,
    bit_depth_m: f64,
) -> Model {
    Model {
        well: Well { path, hole },
        string: StringSpec { components }.assemble(bit_depth_m).expect("a sound string"),
        mud,
        fluids: Fluids::default(),
        rig: Rig::default(),
        ends: Ends::default(),
        buckling: wholestring::statics::buckling::Criterion::default(),
    }
}

/// A model of arcs through stations, one friction, components from the bit up and a mud, with the
/// bit at the last station.
pub fn along(stations_m_deg: &[[f64; 3]], mu: f64, specs: Vec<ComponentSpec>, mud: Mud) -> Model {
    let path = arcs(stations_m_deg);
    let bit_depth_m = path.last_md_m();
    model(path, hole(mu, bit_depth_m), specs, mud, bit_depth_m)
}

/// A uniform plain string in air in one hole, the bit at the last station.
pub fn uniform_model(stations_m_deg: &[[f64; 3]], w_N_per_m: f64, r_m: f64, mu: f64) -> Model {
    along(stations_m_deg, mu, vec![pipe(w_N_per_m, r_m, ComponentLength::ToSurface)], mud(0.0))
}

/// The same in a straight hole of an inclination, deg.
pub fn straight_model(inc_deg: f64, length_m: f64, w_N_per_m: f64, r_m: f64, mu: f64) -> Model {
    let stations = [[0.0, inc_deg, 0.0], [length_m, inc_deg, 0.0]];
    uniform_model(&stations, w_N_per_m, r_m, mu)
}

/// An operation with the bit at a depth: 70 rev/min, off bottom or without weight, no advance.
pub const fn operation(kind: OperationKind, bit_depth_m: f64) -> Operation {
    Operation::new(kind, bit_depth_m).rotary_speed_rad_per_s(rpm(70.0))
}

/// The same with a weight on the bit.
pub const fn pressing(kind: OperationKind, bit_depth_m: f64, weight_on_bit_N: f64) -> Operation {
    operation(kind, bit_depth_m).weight_on_bit_N(weight_on_bit_N)
}

/// Revolutions per minute in rad/s.
pub const fn rpm(revolutions_per_minute: f64) -> f64 {
    revolutions_per_minute * std::f64::consts::TAU / 60.0
}

/// A mud motor of 12 L per revolution, rated at 150 rev/min.
pub const MOTOR: MudMotor = MudMotor {
    displacement_m3: 12e-3,
    rated_flow_m3_per_s: 30e-3,
    max_pressure_Pa: 6e6,
    slip: 0.1,
    efficiency: 0.8,
    stall_torque_N_m: 14e3,
};

/// Three lobes of no height on a smooth bottom.
pub const SMOOTH: Excitation = Excitation {
    lobes: 3,
    amplitude_m: 0.0,
    roughness_m: 0.0,
    torque_fluctuation: 0.0,
    band: Band::PerRevolution(8.0),
};

/// The bit of Richard, Germay and Detournay's examples, four blades with flats of 1.2 mm in all.
pub const DRAG_BIT: RegenerativeLaw = RegenerativeLaw {
    cutters: Cutters {
        radius_m: 0.108,
        core_radius_m: 0.0,
        intrinsic_specific_energy_Pa: 60e6,
        cutter_inclination: 0.6,
        wear_flat_m: 1.2e-3,
        contact_strength_Pa: 60e6,
        bit_geometry: 1.0,
        friction: 0.6,
    },
    blades: 4,
};

/// Length of the arc of a [`capstan_model`], m.
pub const CAPSTAN_ARC_M: f64 = 500.0;

/// An arc between two directions (inclination and azimuth in degrees) through which a weightless
/// string runs under a tension at its lower end.
///
/// The pipe in the arc is as dense as the mud, so it weighs nothing there; the tension is the
/// weight of denser pipe in a straight, frictionless hole of 100 m below the arc.
pub fn capstan_model(
    top_deg: [f64; 2],
    bottom_deg: [f64; 2],
    mu: f64,
    radius_m: f64,
    tension_N: f64,
) -> Model {
    let tail_m = 100.0;
    let depth_m = CAPSTAN_ARC_M + tail_m;
    let light = steel();
    let dense = Material { density_kg_per_m3: 2.0 * light.density_kg_per_m3, ..light };
    // Half of its weight in air is left in a mud half as dense.
    let weight = 2.0 * tension_N / (tail_m * bottom_deg[0].to_radians().cos());
    let tail = ComponentSpec {
        material: dense,
        ..pipe(weight, radius_m, ComponentLength::Metres(tail_m))
    };
    let [[top_inc, top_azi], [inc, azi]] = [top_deg, bottom_deg];
    model(
        arcs(&[[0.0, top_inc, top_azi], [CAPSTAN_ARC_M, inc, azi], [depth_m, inc, azi]]),
        hole_of(&[(mu, CAPSTAN_ARC_M), (0.0, depth_m)]),
        vec![tail, pipe(300.0, radius_m, ComponentLength::ToSurface)],
        mud(light.density_kg_per_m3),
        depth_m,
    )
}

//! The well of S4 for the program.

use wholestring::{prelude::*, string::ComponentLength};
use wholestring_plan::{
    Setup,
    calibration::{Assembly, Channel, Factors, Parameter, Reading, Settings, State},
};

use crate::oracle::Oracle;

pub const PARAMETERS: [Parameter; 3] = [Parameter::Cased, Parameter::Open, Parameter::BlockWeight];
pub const CHANNELS: [Channel; 4] =
    [Channel::PickUp, Channel::SlackOff, Channel::Rotating, Channel::OffBottomTorque];

/// The well and the string of the file.
pub fn assembly(oracle: &Oracle) -> Assembly {
    let steel = Material {
        density_kg_per_m3: 7850.0,
        youngs_modulus_Pa: 210e9,
        shear_modulus_Pa: 80e9,
        ..Material::STEEL
    };
    let path = Path::minimum_curvature(&[
        Station::from_degrees(0.0, 0.0, 0.0),
        Station::from_degrees(500.0, 0.0, 0.0),
        Station::from_degrees(1150.0, 65.0, 0.0),
        Station::from_degrees(4500.0, 65.0, 0.0),
    ]);
    let pipe = |name: &str, number: usize, length| {
        let (_, weight_N_per_m, radius_m) = oracle.string[number];
        let spec = ComponentSpec::uniform(name, 2.0 * radius_m, radius_m, length, steel);
        let buoyancy = 1.0 - oracle.mud_kg_per_m3 / 7850.0;
        let mass_per_length_kg_per_m = weight_N_per_m / buoyancy / wholestring::GRAVITY_M_PER_S2;
        ComponentSpec { mass_per_length_kg_per_m, ..spec }
    };
    let length = |number: usize| ComponentLength::Metres(oracle.string[number].0);
    let components = vec![
        pipe("collars", 0, length(0)),
        pipe("heavy-weight pipe", 1, length(1)),
        pipe("drill pipe", 2, ComponentLength::ToSurface),
    ];
    let hole = Hole::new(vec![
        HoleSection::casing(0.0..oracle.casing_to_m, 0.3, 0.2),
        HoleSection::open(oracle.casing_to_m..4500.0, 0.3, 0.2),
    ]);
    let setup = Setup {
        well: Well { path: path.expect("a path"), hole: hole.expect("a hole") },
        string: StringSpec { components },
        mud: Mud::of_density(oracle.mud_kg_per_m3),
        fluids: Default::default(),
        rig: Rig::default(),
        ends: wholestring::ends::Ends::default(),
        buckling: wholestring::statics::buckling::Criterion::default(),
    };
    Assembly::new(setup, &[])
}

pub fn settings() -> Settings {
    let factors = Factors::of_walls(0.2, 0.2);
    let held = State { factors, block_weight_N: 0.0, bit_torque_N_m: 0.0 };
    let errors = [Some(12e3), Some(6e3), Some(500.0)];
    Settings { errors, ..Settings::new(PARAMETERS.to_vec(), held) }
}

pub fn readings(rows: &[[f64; 5]]) -> Vec<Reading> {
    let row = |row: &[f64; 5]| {
        let [bit_depth_m, values @ ..] = *row;
        let reading = |(channel, value)| Reading { setup: 0, bit_depth_m, channel, value };
        CHANNELS.into_iter().zip(values).map(reading).collect::<Vec<_>>()
    };
    rows.iter().flat_map(row).collect()
}

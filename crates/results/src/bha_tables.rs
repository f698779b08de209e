//! The tables of a static BHA analysis.

use wholestring::statics::assembly::{AssemblyNode, Contact};

use crate::{BHA, BHA_CONTACTS, BHA_SWEEP, BhaPoint, Table};

/// `bha.parquet`: a row for each node. `name` is that of a component, counted from the bit.
pub fn bha_table<'a>(nodes: &[AssemblyNode], name: impl Fn(usize) -> &'a str) -> Table {
    let mut table = Table::with_columns(BHA);
    for node in nodes {
        table.append(
            &[("component", &[name(node.component)])],
            &[
                ("from_bit_m", &[node.from_bit_m]),
                ("md_m", &[node.md_m]),
                ("hole_radius_m", &[node.hole_radius_m]),
                ("offset_high_m", &[node.offset_m[0]]),
                ("offset_right_m", &[node.offset_m[1]]),
                ("tilt_high_rad", &[node.tilt_rad[0]]),
                ("tilt_right_rad", &[node.tilt_rad[1]]),
                ("push_high_N", &[node.push_N[0]]),
                ("push_right_N", &[node.push_N[1]]),
                ("bending_moment_high_N_m", &[node.moment_N_m[0]]),
                ("bending_moment_right_N_m", &[node.moment_N_m[1]]),
                ("bending_moment_N_m", &[node.bending_moment_N_m()]),
                ("tension_N", &[node.tension_N]),
                ("torque_N_m", &[node.torque_N_m]),
                ("bending_stress_Pa", &[node.bending_stress_Pa]),
                ("von_mises_stress_Pa", &[node.von_mises_stress_Pa]),
            ],
        );
    }
    table
}

/// `bha_contacts.parquet`: a row for each contact.
pub fn bha_contacts_table(contacts: &[Contact]) -> Table {
    let mut table = Table::with_columns(BHA_CONTACTS);
    for contact in contacts {
        table.append(
            &[("touching", &[contact.touching.name()]), ("component", &[&contact.name])],
            &[
                ("md_m", &[contact.md_m]),
                ("from_bit_m", &[contact.from_bit_m[0]]),
                ("to_bit_m", &[contact.from_bit_m[1]]),
                ("force_high_N", &[contact.force_N[0]]),
                ("force_right_N", &[contact.force_N[1]]),
                ("force_N", &[contact.size_N()]),
                ("side_rad", &[contact.side_rad]),
            ],
        );
    }
    table
}

/// `bha_sweep.parquet`: a row for each point.
pub fn bha_sweep_table(points: &[BhaPoint]) -> Table {
    let mut table = Table::with_columns(BHA_SWEEP);
    for point in points {
        let found = point.found.as_ref();
        let number = |value: Option<f64>| [value.unwrap_or(f64::NAN)];
        let pair = |values: Option<[f64; 2]>, side: usize| number(values.map(|both| both[side]));
        let force = found.map(|point| point.side_force_N);
        let tilt = found.map(|point| point.tilt_rad);
        table.append(
            &[("varied", &[point.varied.name()]), ("message", &[&point.message])],
            &[
                ("toolface_rad", &number(point.toolface_rad)),
                ("weight_on_bit_N", &[point.weight_on_bit_N]),
                ("inclination_rad", &[point.inclination_rad]),
                ("side_force_high_N", &pair(force, 0)),
                ("side_force_right_N", &pair(force, 1)),
                ("tilt_high_rad", &pair(tilt, 0)),
                ("tilt_right_rad", &pair(tilt, 1)),
                (
                    "largest_bending_moment_N_m",
                    &number(found.map(|point| point.largest_bending_moment_N_m)),
                ),
                (
                    "largest_von_mises_stress_Pa",
                    &number(found.map(|point| point.largest_von_mises_stress_Pa)),
                ),
                ("sag_inclination_rad", &number(found.and_then(|point| point.sag_inclination_rad))),
                ("sag_azimuth_rad", &number(found.and_then(|point| point.sag_azimuth_rad))),
            ],
        );
    }
    table
}

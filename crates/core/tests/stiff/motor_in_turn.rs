//! M01: a bent-motor assembly in a level turn of 10°/100 ft, node by node.

use wholestring::{
    prelude::*,
    statics::{
        assembly::{self, AssemblyNode, AssemblySettings, Contact, Extent},
        stiff::StiffSettings,
    },
    string::{Blades, BodyBend, ComponentLength, ComponentSpec, Material},
};

use crate::{
    common,
    common::{report_worst, verify},
    pressed,
};

const FOOT: f64 = 0.3048;
const INCH: f64 = 0.0254;
const POUND_N: f64 = 4.448_221_615_26;
const PSI: f64 = POUND_N / (INCH * INCH);

/// Rows of numbers of a file; empty cells are not numbers.
fn rows(name: &str) -> Vec<Vec<f64>> {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../verification");
    let text = std::fs::read_to_string(path.join(name)).expect(name);
    let numbers = |line: &str| -> Vec<f64> {
        line.split(',').map(|cell| cell.trim().parse().unwrap_or(f64::NAN)).collect()
    };
    text.lines().skip(1).map(numbers).collect()
}

/// Length of collar added above the file's assembly, m, because the file supports its top
/// otherwise.
const ABOVE_M: f64 = 45.0;

fn model() -> (Model, Operation, AssemblySettings) {
    let steel_kg_per_m3 = 65.5 * 119.826_427;
    let elements = rows("M01_bent_motor_elements.csv");
    // Between two places the section is constant; blades have a short one of their own.
    let blades_m = [2.75 * FOOT, 36.75 * FOOT];
    let half_m = 0.02;
    let mut parts: Vec<ComponentSpec> = Vec::new();
    let edges_m = blades_m.map(|at| [at - half_m, at + half_m]).concat();
    let mut to_m = 0.0;
    let part = |row: &[f64], length_m: f64| {
        let youngs_modulus_Pa = row[5] * PSI;
        let material = Material {
            density_kg_per_m3: steel_kg_per_m3,
            youngs_modulus_Pa,
            shear_modulus_Pa: youngs_modulus_Pa / (2.0 * (1.0 + row[6])),
            ..Material::STEEL
        };
        let [od_m, id_m] = [row[1] * INCH, row[2] * INCH];
        let length = ComponentLength::Metres(length_m);
        ComponentSpec {
            mass_per_length_kg_per_m: row[4] * 0.453_592_37 / FOOT,
            ..ComponentSpec::uniform("collar", od_m, id_m, length, material)
        }
    };
    for (index, row) in elements.iter().enumerate() {
        let last = index + 1 == elements.len();
        let end_m = to_m + row[3] * FOOT + if last { ABOVE_M } else { 0.0 };
        // Cut where blades begin and end.
        let mut cuts: Vec<f64> = edges_m.clone();
        cuts.retain(|edge| (to_m..end_m).contains(edge));
        cuts.push(end_m);
        for cut_m in cuts {
            let middle_m = 0.5 * (to_m + cut_m);
            let bladed = blades_m.iter().any(|at| (at - middle_m).abs() < half_m);
            let blades = bladed.then_some(Blades { od_m: 8.25 * INCH, length_m: cut_m - to_m });
            parts.push(ComponentSpec { blades, ..part(row, cut_m - to_m) });
            to_m = cut_m;
        }
    }
    // Half-way between the file's nodes at 4.75 and 5.75 ft, towards the high side, as its offsets
    // show.
    let mut low_m = 0.0;
    for one in &mut parts {
        let ComponentLength::Metres(length_m) = one.length else { unreachable!() };
        let at_m = 5.25 * FOOT - low_m;
        if (0.0..length_m).contains(&at_m) {
            one.bend = Some(BodyBend {
                from_lower_end_m: at_m,
                angle_rad: 1.75_f64.to_radians(),
                toolface_rad: 0.0,
            });
        }
        low_m += length_m;
    }
    let depth_m = to_m;
    let turn = 10.0 / (100.0 * FOOT);
    let stations = [
        [0.0, 90.0, 191.0 - turn * depth_m],
        [0.5 * depth_m, 90.0, 191.0 - 0.5 * turn * depth_m],
        [depth_m, 90.0, 191.0],
    ];
    let hole = common::open_hole(8.5 * INCH, 0.0, depth_m);
    let mud = common::mud(10.0 * 119.826_427);
    let model = common::model(common::arcs(&stations), hole, parts, mud, depth_m);
    let operation =
        Operation { bit_torque_N_m: 3500.0 * POUND_N * FOOT, ..pressed(depth_m, 30e3 * POUND_N) };
    // From the penetrations and forces of the file's nodes.
    let wall_N_per_m = 751e3 * POUND_N / INCH;
    let stiff = StiffSettings {
        contact_law: wholestring::dynamics::ContactLaw::Linear {
            stiffness_N_per_m: wall_N_per_m,
            damping_ratio: 0.0,
        },
        bit_lateral_stiffness_N_per_m: wall_N_per_m,
        ..StiffSettings::default()
    };
    let settings = AssemblySettings { stiff, extent: Extent::Whole, element_length_m: 0.5 * FOOT };
    (model, operation, settings)
}

/// A value of the nodes, interpolated at a distance from the bit.
fn at(nodes: &[AssemblyNode], from_bit_m: f64, value: impl Fn(&AssemblyNode) -> f64) -> f64 {
    let above = nodes.partition_point(|node| node.from_bit_m < from_bit_m);
    let above = above.clamp(1, nodes.len() - 1);
    let (low, high) = (&nodes[above - 1], &nodes[above]);
    let part = (from_bit_m - low.from_bit_m) / (high.from_bit_m - low.from_bit_m);
    value(low) + part * (value(high) - value(low))
}

/// Forces of bit and blades, offsets and bending moments in both planes against the file's, as far
/// as its upper blades. The difference is mostly due to its top, at 105 ft, which it holds at the
/// wall with a moment of its own, where the pipe here continues; elements half as long change 6e-4.
#[test]
fn m01_a_bent_motor_in_a_turn() {
    const TO_FT: f64 = 38.0;
    let (model, operation, settings) = model();
    let found = assembly::solve(&model, &operation, &settings).expect("an equilibrium");
    let errors = found.errors.expect("an estimate");
    let table = rows("M01_bent_motor_in_turn.csv");
    assert_eq!(table.len(), 106);
    let force = |name: &str| {
        verify("M01", name.to_owned())
            .absolute(1e-2, "the file holds its top otherwise; elements half as long change 6e-4")
    };
    let bit_N = table[0][9] * POUND_N;
    assert!(errors.side_force_N < 1e-3 * bit_N, "{errors:?}");
    let places = [(0.0, "the bit"), (2.75, "the lower blades"), (36.75, "the upper blades")];
    for (from_bit_ft, name) in places {
        let row = table.iter().find(|row| (row[0] - from_bit_ft).abs() < 1e-6).expect("a node");
        let near = |contact: &&Contact| (contact.from_bit_m[0] / FOOT - from_bit_ft).abs() < 0.1;
        let contact = found.contacts.iter().find(near).expect("a contact");
        for (side, plane) in [(0, "high side"), (1, "right")] {
            // The file has the force of the wall.
            let expected = -row[7 + side] * POUND_N / bit_N;
            force(&format!("force of {name} over that of the bit: to the {plane}"))
                .report(expected, contact.force_N[side] / bit_N);
        }
    }
    let within = || table.iter().filter(|row| row[0] < TO_FT);
    let largest = within().map(|row| row[12]).fold(0.0, f64::max);
    for (side, plane) in [(0, "high side"), (1, "right")] {
        let moment = |row: &Vec<f64>| {
            let here = at(&found.nodes, row[0] * FOOT, |node| node.moment_N_m[side]);
            verify("M01", format!("worst node: bending moment to the {plane} over the largest"))
                .absolute(1.5e-2, "as above; 1.1 % next to the bend")
                .row(row[10 + side] / largest, here / (POUND_N * FOOT) / largest)
        };
        report_worst(within().map(moment));
        let offset = |row: &Vec<f64>| {
            let here = at(&found.nodes, row[0] * FOOT, |node| node.offset_m[side]);
            verify("M01", format!("worst node: offset to the {plane}, in"))
                .absolute(2e-2, "as above; the collar has 1 in of room")
                .row(row[1 + 2 * side], here / INCH)
        };
        report_worst(within().map(offset));
    }
}

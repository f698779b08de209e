//! S1a: elements from tool joint to tool joint have the moments of the pipe that hangs between
//! them.

use serde_json::Value;

use super::*;
use crate::{
    common::{number, report_worst, verify},
    dynamics::kernel::places::Border,
    rod::{
        mesh::{MeshElement, MeshNode},
        section::Section,
    },
    sizing::SizeReason,
    string::{Material, ToolJoints},
};

const DOWN: &str = "S1a_tool_joints_in_build.json";
const SPACING_M: f64 = 9.6;

/// A string with joints at distances from its top, and a mesh with a node at each and at its ends.
struct Piece {
    model: Model,
    mesh: Mesh,
    chain: Chain,
    hole_m: f64,
    joint_m: f64,
}

impl Piece {
    /// Of the file's pipe.
    fn new(data: &Value, from_top_m: &[f64]) -> Self {
        let inputs = &data["inputs"];
        let pipe = |key: &str| number(&inputs["pipe"][key]);
        let joint_m = number(&inputs["tool_joint_od_m"]);
        let length_m = from_top_m[from_top_m.len() - 1];
        let steel =
            Material { youngs_modulus_Pa: pipe("E"), shear_modulus_Pa: pipe("G"), ..steel() };
        let part = ComponentSpec {
            joints: Some(ToolJoints { od_m: joint_m, spacing_m: SPACING_M }),
            mass_per_length_kg_per_m: pipe("w") / crate::GRAVITY_M_PER_S2,
            ..ComponentSpec::uniform(
                "pipe",
                pipe("od"),
                pipe("id"),
                ComponentLength::Metres(length_m),
                steel,
            )
        };
        let path = arcs(&[[0.0; 3], [length_m, 0.0, 0.0]]);
        let hole_m = number(&inputs["hole_m"]);
        let hole = open_hole(hole_m, 0.0, length_m);
        let model = common::model(path, hole, vec![part], mud(0.0), length_m);
        let nodes = from_top_m
            .iter()
            .map(|at_m| MeshNode { from_bit_m: length_m - at_m, contact_radius_m: 0.5 * joint_m });
        let elements = from_top_m.windows(2).map(|ends| MeshElement {
            length_m: ends[1] - ends[0],
            section: Section::between(&model.string, length_m - ends[1], length_m - ends[0]),
            reason: SizeReason::Given,
        });
        let mesh = Mesh { nodes: nodes.collect(), elements: elements.collect() };
        let lateral = chain::lateral_mass_kg_per_m(&model, &mesh, length_m);
        let plan = stability::plan(&mesh, &lateral, 0.0);
        let chain = chain::chain(&model, &mesh, &plan);
        Self { model, mesh, chain, hole_m, joint_m }
    }

    /// Puts the anchors on an arc of a curvature that has an inclination at its top, the nodes off
    /// them by so much to the high side, and directors that lean to it by angles from the arc.
    fn lie(&mut self, hole_per_m: f64, top_rad: f64, high_m: &[f64], lean_rad: &[f64]) {
        let length_m = self.mesh.length_m();
        let anchor = |index: usize| {
            let at_m = length_m - self.mesh.nodes[index].from_bit_m;
            let (sin, cos) = (top_rad + hole_per_m * at_m).sin_cos();
            [Vector(sin, 0.0, cos), Vector(cos, 0.0, -sin)]
        };
        for index in 0..self.mesh.nodes.len() {
            let [along, high] = anchor(index);
            let chain = &mut self.chain;
            chain.set_tangent(index, along);
            chain.set_curvature(index, high.scaled(hole_per_m));
            chain.set_displacement(index, high.scaled(high_m[index]));
            let (sin, cos) = lean_rad[index].sin_cos();
            chain.set_director(index, along.scaled(cos).plus(high, sin));
            node!(chain, index, clearance = 0.5 * (self.hole_m - self.joint_m));
            node!(chain, index, radius = 0.5 * self.joint_m);
            if index > 0 {
                // The centre of the arc is to the high side.
                let [_, above] = anchor(index - 1);
                chain.set_anchor_chord(index - 1, (above - high).scaled(1.0 / hole_per_m));
            }
        }
    }

    fn record(&self) -> Record {
        self.record_of(&mut self.chain.clone())
    }

    fn record_of(&self, chain: &mut Chain<impl Real>) -> Record {
        let mut record = Record::new(&self.model, &self.mesh, chain.layout(), 1);
        chain.close();
        let high = vec![[Row::filled(0.0); 3]; chain.layout().blocks()];
        record.sample(chain, &high, &Body::default(), 1);
        record
    }
}

/// One element a joint: moment at the joints and half-way, sag, and whether the body touches, as a
/// pipe of any mesh has them, whatever of it touches. Left is that arcs are parabolas here, by
/// `(κL)²/12` = 4e-4 at 12 deg/30 m, and four times as much of a moment half-way that is the small
/// difference of the hole's and the load's: 0.2 % found.
#[test]
fn s1a_elements_from_joint_to_joint() {
    let data = verification(DOWN);
    let stiffness = number(&data["inputs"]["pipe"]["EI"]);
    let mut compared = Vec::new();
    let rows = data["periodic"].as_array().expect("rows");
    assert_eq!(rows.len(), 24);
    for row in rows {
        let (input, expected) = (|key: &str| number(&row["inputs"][key]), &row["expected"]);
        assert_eq!(2.0 * input("half_spacing_m"), SPACING_M);
        let hole_per_m = input("dls_deg_30m").to_radians() / 30.0;
        // With the file's inclination so many elements down.
        let at = |elements: f64| {
            let nodes: Vec<f64> = (0..9).map(|i| SPACING_M * f64::from(i)).collect();
            let mut piece = Piece::new(&data, &nodes);
            let top_rad = input("inc_deg").to_radians() - hole_per_m * elements * SPACING_M;
            let wall_m = 0.5 * (piece.hole_m - piece.joint_m);
            piece.lie(hole_per_m, top_rad, &[wall_m; 9], &[0.0; 9]);
            for index in 0..8 {
                element!(piece.chain, index, tension = input("T_N"));
            }
            piece.record()
        };
        let (joint, record) = (at(4.0), at(4.5));
        let inputs = &data["inputs"];
        let standoff_m = 0.5 * (number(&inputs["tool_joint_od_m"]) - number(&inputs["pipe"]["od"]));
        let number = |key: &str| number(&expected[key]);
        let touches = expected["body_contact"].as_bool().expect("a truth");
        assert_eq!(record.shapes().touched(4), f64::from(u8::from(touches)), "{row}");
        let name = format!(
            "{:.0} kN in {} deg/30 m at {} deg, one element",
            input("T_N") / 1e3,
            input("dls_deg_30m"),
            input("inc_deg")
        );
        let sag_m = number("body_relative_sag_towards_wall_m").min(standoff_m);
        for (what, found, expected) in [
            ("curvature at the joints", joint.bending(4) / stiffness, number("curvature_at_TJ")),
            ("curvature half-way", record.between(4) / stiffness, number("curvature_mid")),
            ("sag", record.shapes().sag_m(4), sag_m),
        ] {
            let unit = if what == "sag" { "m" } else { "1/m" };
            compared.push((format!("{what} at {name}, {unit}"), found, expected));
        }
    }
    report_worst(compared.iter().map(|(what, computed, expected)| {
        verify("S1a", what)
            .relative(3e-3, "arcs are parabolas, by (κL)²/12; small differences half-way")
            .row(*expected, *computed)
    }));
}

/// A string that is divided has the same loads at every node as the undivided string, in either
/// precision: to rounding, of the chords' in single precision.
#[test]
fn a_divided_string_bears_what_the_whole_does() {
    let data = verification(DOWN);
    let nodes: Vec<f64> = (0..9).map(|i| SPACING_M * f64::from(i)).collect();
    let mut piece = Piece::new(&data, &nodes);
    let lean_rad: Vec<f64> = (0..9).map(|i| 1e-3 * f64::from(i * i % 5)).collect();
    piece.lie(6f64.to_radians() / 30.0, 0.5, &[0.02; 9], &lean_rad);
    for index in 0..8 {
        element!(piece.chain, index, tension = 3e5 + 1e3 * index as f64);
    }
    let whole = piece.record();
    let compare = |divided: &Record, most: f64| {
        for index in 0..9 {
            for (found, expected) in [
                (divided.bending(index), whole.bending(index)),
                (divided.between(index), whole.between(index)),
                (divided.shapes().sag_m(index), whole.shapes().sag_m(index)),
            ] {
                assert!((found - expected).abs() <= most * expected, "{index}: {found} {expected}");
            }
        }
    };
    for node in [1, 4, 6] {
        let border = Some(Border { node, parts: 2 });
        compare(&piece.record_of(&mut piece.chain.divided_at::<f64>(border)), 1e-12);
        compare(&piece.record_of(&mut piece.chain.divided_at::<f32>(border)), 1e-4);
    }
}

/// A piece of twelve joints whose ends are pinned, its joints where the file has them and its
/// directors where the coarse chain's own moments balance, without those that the load has between
/// the joints: they are out by as much as the load changes from element to element, which is the
/// moment that a node distributes. Most at the ends, where half an element meets a whole one, and
/// where moment distribution takes a second step: without it the joint before the last was 2.9 %
/// out. Found are 0.22 % under 400 kN, 0.70 % under 20 kN.
#[test]
fn s1a_a_piece_of_twelve_elements() {
    let data = verification(DOWN);
    let inputs = &data["inputs"]["pipe"];
    let (stiffness, weight) = (number(&inputs["EI"]), number(&inputs["w"]));
    let mut compared = Vec::new();
    for (piece, most) in data["finite"].as_array().expect("pieces").iter().zip([3e-3, 8e-3]) {
        let input = |key: &str| number(&piece["inputs"][key]);
        let joints = piece["expected"]["tool_joints"].as_array().expect("joints");
        let at = |key: &str| joints.iter().map(|joint| number(&joint[key])).collect::<Vec<f64>>();
        let (hole_per_m, top_rad) =
            (input("dls_deg_30m").to_radians() / 30.0, input("inc_top_deg").to_radians());
        let nodes_m = [&[0.0], &at("s_m")[..], &[input("length_m")]].concat();
        let high_m = [&[0.0], &at("y_m")[..], &[0.0]].concat();
        let mut twelve = Piece::new(&data, &nodes_m);
        for (index, ends) in nodes_m.windows(2).enumerate() {
            let middle_rad = top_rad + hole_per_m * 0.5 * (ends[0] + ends[1]);
            let lost_N = weight * (middle_rad.sin() - top_rad.sin()) / hole_per_m;
            element!(twelve.chain, index, tension = input("T_top_N") - lost_N);
        }
        // The top is pinned.
        node!(twelve.chain, 0, inv_rotary = 1.0);
        let lean_rad = balanced(&twelve.chain, hole_per_m, &nodes_m, &high_m);
        twelve.lie(hole_per_m, top_rad, &high_m, &lean_rad);
        let record = twelve.record();
        for (index, expected) in (1..).zip(at("curvature_rad_m")) {
            let what = format!(
                "curvature at the joint {:.1} m down a piece of twelve elements under {:.0} kN, 1/m",
                nodes_m[index],
                input("T_top_N") / 1e3
            );
            compared.push((what, record.bending(index) / stiffness, expected, most));
        }
        // The file's is from the hole's axis.
        let sag_m = number(&piece["expected"]["body_sag_mid_joint_6_7_m"]) - high_m[6];
        let what =
            format!("sag at the sixth joint of twelve under {:.0} kN, m", input("T_top_N") / 1e3);
        let bent_per_m = record.shapes().sag_m(6).copysign(sag_m);
        compared.push((what, bent_per_m, sag_m, 2e-2));
    }
    report_worst(compared.iter().map(|(what, computed, expected, most)| {
        verify("S1a", what)
            .relative(
                *most,
                "the directors of a coarse chain: a step of moment distribution, two at the ends",
            )
            .row(*expected, *computed)
    }));
}

/// Angles of the directors from the arc where the moments of a chain's elements balance, without
/// moments on the nodes: three unknowns a row.
fn balanced(chain: &Chain, hole_per_m: f64, nodes_m: &[f64], high_m: &[f64]) -> Vec<f64> {
    let many = nodes_m.len();
    let [mut diagonal, mut beside, mut right] = [0.0; 3].map(|zero| vec![zero; many]);
    for index in 0..many - 1 {
        let k = chain.stiffness(index);
        let tension = element!(chain, index, tension);
        let near = k.bending_near() + 2.0 * k.half_bow_near * tension;
        let far = k.bending_far - k.bow_far * tension;
        let length_m = nodes_m[index + 1] - nodes_m[index];
        let chord = (high_m[index + 1] - high_m[index]) / length_m;
        let turned = 0.5 * hole_per_m * length_m;
        // Of the arc against the chord, at either end.
        let (above, below) = (-chord - turned, turned - chord);
        diagonal[index] += near;
        diagonal[index + 1] += near;
        beside[index] = far;
        right[index] -= near * above + far * below;
        right[index + 1] -= near * below + far * above;
    }
    for index in 1..many {
        let part = beside[index - 1] / diagonal[index - 1];
        diagonal[index] -= part * beside[index - 1];
        right[index] -= part * right[index - 1];
    }
    let mut lean_rad = vec![0.0; many];
    for index in (0..many).rev() {
        let below = lean_rad.get(index + 1).copied().unwrap_or(0.0);
        lean_rad[index] = (right[index] - beside[index] * below) / diagonal[index];
    }
    lean_rad
}

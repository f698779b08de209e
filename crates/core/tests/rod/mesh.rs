//! The cut of the string: positions of nodes, and sections of elements.

use proptest::prelude::*;
use wholestring::{
    rod::mesh::{Mesh, MeshNode},
    string::{Blades, ComponentLength, ComponentSpec, DrillString, StringSpec, ToolJoints},
};

use crate::common::{assert_close, np13::components, steel};

fn tube(od_m: f64, length: ComponentLength) -> ComponentSpec {
    ComponentSpec::uniform("tube", od_m, 0.4 * od_m, length, steel())
}

fn string(components: Vec<ComponentSpec>, length_m: f64) -> DrillString {
    StringSpec { components }.assemble(length_m).expect("a sound string")
}

use ComponentLength::{Metres, ToSurface};

/// The string of `cases/np13-x1042.toml`.
pub fn np13() -> DrillString {
    string(components(), 4305.0)
}

fn node_at(mesh: &Mesh, from_bit_m: f64) -> Option<f64> {
    mesh.nodes.iter().find(|n| (n.from_bit_m - from_bit_m).abs() < 1e-6).map(|n| n.contact_radius_m)
}

/// Joints every 9.6 m are every sixth, third or second node at these elements, whatever the
/// assembly below; plain pipe has none.
#[test]
fn joints_come_after_as_many_nodes() {
    let string = np13();
    let found = [1.6, 3.2, 4.8].map(|length| Mesh::uniform(&string, length).nodes_per_joint());
    assert_eq!(found, [6, 3, 2]);
    let plain = self::string(vec![tube(0.127, ToSurface)], 300.0);
    assert_eq!(Mesh::uniform(&plain, 3.2).nodes_per_joint(), 1);
}

/// Stabiliser, jar and every joint of the heavy-weight and of the drill pipe carry a node with
/// their own radius; between them the body's.
#[test]
fn nodes_of_a_bottom_hole_assembly_stand_where_it_touches() {
    let string = np13();
    for element_length in [1.6, 3.2, 4.8] {
        let mesh = Mesh::uniform(&string, element_length);
        assert_eq!(node_at(&mesh, 0.0), Some(0.10795));
        assert_eq!(node_at(&mesh, 0.34 + 7.69 + 0.5 + 0.765), Some(0.103));
        let jar = 0.34 + 7.69 + 0.5 + 1.53 + 9.09 + 2.17 + 9.47 + 84.53;
        // The jar is no thicker than the joint above it by a millimetre: it has no node of its own,
        // the joints at its ends have, or where elements are longer than it, a node between them.
        let above = jar + 3.57;
        let touches = |n: &&MeshNode| n.contact_radius_m == 0.0889;
        let at_jar = |n: &&MeshNode| (jar - 1.6..=above + 1e-6).contains(&n.from_bit_m);
        assert!(mesh.nodes.iter().filter(at_jar).any(|n| touches(&n)), "{element_length}");
        for joint in 0..8 {
            assert_eq!(node_at(&mesh, jar - 84.53 + 9.39 * f64::from(joint)), Some(0.0889));
        }
        for joint in 1..9 {
            assert_eq!(node_at(&mesh, above + 9.39 * f64::from(joint)), Some(0.0889));
        }
        // The uppermost joint of the heavy-weight, 0.02 m below the first of the drill pipe, shares
        // its node.
        let pipe = above + 84.53;
        for joint in 1..420 {
            assert_eq!(node_at(&mesh, pipe + 9.6 * f64::from(joint)), Some(0.0889));
        }
        // The last, 2.38 m below the top, gives way where that is less than 0.8 of an element.
        let bodies = mesh.nodes.iter().filter(|n| n.contact_radius_m == 0.06985).count();
        assert!(bodies * 3 > mesh.nodes.len());
    }
}

/// An element over several components is as soft as its parts in a row, and as heavy as all of
/// them.
#[test]
fn an_element_of_several_components_is_their_row() {
    // None is wider than both its neighbours: that would be a stabiliser, with a node.
    let parts = [(0.20, 0.3), (0.10, 0.9), (0.12, 0.5), (0.15, 4.5)];
    let length: f64 = 6.2;
    let components = parts.iter().map(|&(od, length)| tube(od, Metres(length))).collect();
    let string = string(components, length);
    let mesh = Mesh::uniform(&string, length);
    assert_eq!(mesh.elements.len(), 1);
    let section = &mesh.elements[0].section;
    let sum = |f: &dyn Fn(f64, f64) -> f64| parts.iter().map(|&(od, l)| f(od, l)).sum::<f64>();
    let area = |od: f64| std::f64::consts::PI / 4.0 * od * od * (1.0 - 0.16);
    let second = |od: f64| std::f64::consts::PI / 64.0 * od.powi(4) * (1.0 - 0.0256);
    let (e, g) = (210e9, 80e9);
    let row = |stiffness: f64| length / stiffness;
    assert_close("EA", row(section.axial_stiffness_N), sum(&|od, l| l / (e * area(od))), 1e-12);
    assert_close(
        "EI",
        row(section.bending_stiffness_N_m2),
        sum(&|od, l| l / (e * second(od))),
        1e-12,
    );
    assert_close(
        "GJ",
        row(section.torsional_stiffness_N_m2),
        sum(&|od, l| l / (2.0 * g * second(od))),
        1e-12,
    );
    assert_close(
        "steel",
        section.steel_kg_per_m * length,
        sum(&|od, l| 7850.0 * area(od) * l),
        1e-12,
    );
    let polar = sum(&|od, l| 7850.0 * 2.0 * second(od) * l);
    assert_close("polar", section.polar_inertia_kg_m * length, polar, 1e-12);
    // Archimedes: the buoyed weight is that of the steel less that of the mud in its place.
    let weight = 9.80665 * sum(&|od, l| (7850.0 - 1200.0) * area(od) * l);
    assert_close("weight", section.buoyed_weight_N_per_m(1200.0) * length, weight, 1e-12);
}

/// Everything that any string must fulfil.
fn is_sound(string: &DrillString, element_length: f64) -> Result<(), TestCaseError> {
    let mesh = Mesh::uniform(string, element_length);
    let length = string.length_m();
    prop_assert_eq!(mesh.nodes.len(), mesh.elements.len() + 1);
    prop_assert_eq!(mesh.nodes[mesh.elements.len()].from_bit_m, 0.0);
    prop_assert!((mesh.length_m() - length).abs() < 1e-9 * length);
    let sum: f64 = mesh.elements.iter().map(|e| e.length_m).sum();
    prop_assert!((sum - length).abs() < 1e-9 * length);
    let (mut steel, mut tributary) = (0.0, 0.0);
    for (i, e) in mesh.elements.iter().enumerate() {
        prop_assert!(e.length_m > 0.0);
        // A stretch of more than 1.25 elements is cut.
        prop_assert!(e.length_m <= 1.25 * element_length * (1.0 + 1e-9), "{}", e.length_m);
        let s = &e.section;
        for value in [
            s.axial_stiffness_N,
            s.shear_stiffness_N,
            s.bending_stiffness_N_m2,
            s.torsional_stiffness_N_m2,
            s.polar_inertia_kg_m,
        ] {
            prop_assert!(value.is_finite() && value > 0.0);
        }
        steel += s.steel_kg_per_m * e.length_m;
        prop_assert!(mesh.nodes[i].from_bit_m > mesh.nodes[i + 1].from_bit_m);
    }
    for i in 0..mesh.nodes.len() {
        tributary += mesh.tributary_length_m(i);
    }
    prop_assert!((tributary - length).abs() < 1e-9 * length);
    prop_assert!((steel - string.mass_kg()).abs() < 1e-9 * steel);

    // Every node touches with the radius of a component at it, or where a joint gave way in one of
    // the elements next to it.
    for (i, node) in mesh.nodes.iter().enumerate() {
        let highest = mesh.nodes[i.saturating_sub(1)].from_bit_m + 1e-6;
        let lowest = mesh.nodes[(i + 1).min(mesh.elements.len())].from_bit_m - 1e-6;
        let mut bottom = 0.0;
        let known = string.components().iter().any(|c| {
            let top = bottom + c.length_m;
            let within = bottom <= highest && top >= lowest;
            bottom = top;
            within && [c.contact_radius_m(), c.od_m / 2.0].contains(&node.contact_radius_m)
        });
        prop_assert!(known, "{node:?}");
    }
    Ok(())
}

fn component() -> impl Strategy<Value = ComponentSpec> {
    let joints =
        prop_oneof![Just(None), (1.0..1.5, prop_oneof![0.05..1.0, 1.0..50.0]).prop_map(Some),];
    let length = prop_oneof![0.001..0.1, 0.1..5.0, 5.0..400.0];
    (0.05..0.4, 0.0..0.95, length, joints).prop_map(|(od_m, bore, length_m, joints)| {
        ComponentSpec {
            joints: joints.map(|(part, spacing_m)| ToolJoints { od_m: part * od_m, spacing_m }),
            ..ComponentSpec::uniform("any", od_m, bore * od_m, Metres(length_m), steel())
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_string_is_cut_soundly(
        components in proptest::collection::vec(component(), 1..12),
        element_length in prop_oneof![0.2..2.0, 2.0..10.0, 10.0..2000.0],
    ) {
        let length = components.iter().map(|c| match c.length {
            Metres(length) => length,
            ToSurface => 0.0,
        }).sum();
        is_sound(&string(components, length), element_length)?;
    }
}

#[test]
fn the_shipped_string_is_cut_soundly() {
    for element_length in [0.8, 1.6, 3.2, 4.8, 9.6, 1e4] {
        is_sound(&np13(), element_length).unwrap();
    }
}

/// Whatever remains of a joint at the top and however long a jar is: no element of pipe is shorter
/// than 0.8 of those that a joint of it is cut into, and none longer than 1.25 of the requested
/// length, except for those between the bit and the stabiliser, which are fixed.
#[test]
fn no_joint_makes_a_short_element() {
    let above_stabiliser_m = 0.34 + 7.69 + 0.5 + 0.765 - 1e-6;
    for tenth in 0..=96 {
        let length_m = 4300.0 + 0.1 * f64::from(tenth);
        for jar in 0..=12 {
            let mut parts = components();
            let is_jar = |part: &&mut ComponentSpec| part.name == "jar";
            parts.iter_mut().find(is_jar).expect("a jar").length =
                Metres(0.8 * f64::from(jar) + 0.3);
            let string = string(parts, length_m);
            for element_m in [2.4, 3.2, 4.8, 9.6, 12.0] {
                let mesh = Mesh::uniform(&string, element_m);
                let unit_m = 9.39 / (9.39_f64 / element_m).round().max(1.0);
                for (i, element) in mesh.elements.iter().enumerate() {
                    if mesh.nodes[i + 1].from_bit_m < above_stabiliser_m {
                        continue;
                    }
                    let within =
                        0.8 * unit_m * (1.0 - 1e-9)..=1.25 * element_m.min(9.6) * (1.0 + 1e-9);
                    assert!(
                        within.contains(&element.length_m),
                        "{length_m} m, jar {jar}, {element_m} m: {} m at {} m",
                        element.length_m,
                        mesh.nodes[i + 1].from_bit_m
                    );
                }
            }
        }
    }
}

/// A joint that gives way touches at the node in its place: between two that are a jar apart one
/// node with their radius.
#[test]
fn a_joint_that_gives_way_touches_beside() {
    let mesh = Mesh::uniform(&np13(), 9.6);
    let jar_m = 0.34 + 7.69 + 0.5 + 1.53 + 9.09 + 2.17 + 9.47 + 84.53;
    let near = |n: &&MeshNode| (jar_m - 5.0..jar_m + 8.0).contains(&n.from_bit_m);
    let nodes: Vec<&MeshNode> = mesh.nodes.iter().filter(near).collect();
    // 9.39 + 3.59 + 9.39 m in two elements.
    assert_eq!(nodes.len(), 1);
    assert_close("node at the jar", nodes[0].from_bit_m, jar_m - 0.02 + 3.59 / 2.0, 1e-6);
    // The jar itself, 0.1 mm more than the joints.
    assert_eq!(nodes[0].contact_radius_m, 0.089);
}

/// Blades touch at both edges where the mesh resolves them, at their middle where it does not;
/// between the edges, and only there, a node carries their radius.
#[test]
fn blades_touch_at_their_edges() {
    let stabiliser = |blade_m: f64, length_m: f64| ComponentSpec {
        blades: Some(Blades { od_m: 0.2127, length_m: blade_m }),
        ..tube(0.165, Metres(length_m))
    };
    let string_of = |blade_m: f64| {
        string(
            vec![
                tube(0.2159, Metres(0.4)),
                tube(0.172, Metres(9.6)),
                stabiliser(blade_m, 2.0),
                tube(0.165, Metres(18.0)),
                tube(0.127, ToSurface),
            ],
            200.0,
        )
    };
    let blades = |mesh: &Mesh| -> Vec<f64> {
        let mut places: Vec<f64> = mesh
            .nodes
            .iter()
            .filter(|n| n.contact_radius_m == 0.10635)
            .map(|n| (n.from_bit_m * 1e6).round() / 1e6)
            .collect();
        places.reverse();
        places
    };
    assert_eq!(blades(&Mesh::uniform(&string_of(1.2), 3.2)), [11.0]);
    assert_eq!(blades(&Mesh::uniform(&string_of(0.4), 0.5)), [11.0]);
    assert_eq!(blades(&Mesh::uniform(&string_of(1.2), 1.6)), [10.4, 11.6]);
    assert_eq!(blades(&Mesh::uniform(&string_of(1.2), 0.4)), [10.4, 10.8, 11.2, 11.6]);
    // Two stabilisers on each other: their blades' edges are one node.
    let double = string(
        vec![
            tube(0.2159, Metres(0.4)),
            tube(0.172, Metres(9.6)),
            stabiliser(2.0, 2.0),
            stabiliser(2.0, 2.0),
            tube(0.127, ToSurface),
        ],
        200.0,
    );
    let mesh = Mesh::uniform(&double, 3.2);
    assert_eq!(blades(&mesh), [10.0, 12.0, 14.0]);
    assert!(mesh.elements.iter().all(|e| e.length_m > 0.3));
}

#[test]
fn blades_belong_into_their_component() {
    let spec = |blades: Blades, joints: Option<ToolJoints>| StringSpec {
        components: vec![ComponentSpec {
            blades: Some(blades),
            joints,
            ..tube(0.165, Metres(2.0))
        }],
    };
    let blades = |od_m: f64, length_m: f64| Blades { od_m, length_m };
    assert!(spec(blades(0.2127, 2.0), None).assemble(2.0).is_ok());
    for (blades, joints) in [
        (blades(0.16, 1.0), None),
        (blades(0.2127, 2.1), None),
        (blades(0.2127, 0.0), None),
        (blades(f64::NAN, 1.0), None),
        (blades(0.2127, 1.0), Some(ToolJoints { od_m: 0.18, spacing_m: 1.0 })),
    ] {
        let error = spec(blades, joints).assemble(2.0).unwrap_err();
        assert!(error.to_string().contains("blade_"), "{error}");
    }
}

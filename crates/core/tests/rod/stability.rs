//! The planned step of a shipped string.

use wholestring::rod::{mesh::Mesh, stability};

use crate::mesh::np13;

/// The short elements of the bottom-hole assembly are given mass, drill pipe and heavy-weight none:
/// their waves keep their speed. Lateral mass of steel alone.
#[test]
fn ordinary_pipe_is_lent_nothing() {
    for element_length in [1.6, 3.2, 4.8] {
        let mesh = Mesh::new(&np13(), element_length);
        let lateral: Vec<f64> = mesh.elements.iter().map(|e| e.section.steel_kg_per_m).collect();
        let plan = stability::plan(&mesh, &lateral, 1e-5);
        assert!(plan.added_axial_mass_fraction <= 0.003);
        let (mut steel, mut axial) = (0.0, 0.0);
        for (element, inertia) in mesh.elements.iter().zip(&plan.inertia) {
            let own = element.section.steel_kg_per_m * element.length_m;
            steel += own;
            axial += inertia.axial_kg;
            assert!(inertia.axial_kg >= own * (1.0 - 1e-12));
        }
        let reported = plan.added_axial_mass_fraction;
        assert!((axial / steel - 1.0 - reported).abs() < 1e-12);
        // From 300 m above the bit it is drill pipe, joint after joint the same, but for what is
        // left of the uppermost joint at the surface.
        for i in 0..mesh.nodes.len() - 1 {
            let below_the_rest = mesh.nodes[i].from_bit_m < mesh.length_m() - 9.6;
            if mesh.nodes[i + 1].from_bit_m > 300.0 && below_the_rest {
                let (element, inertia) = (&mesh.elements[i], &plan.inertia[i]);
                let own = element.section.steel_kg_per_m * element.length_m;
                assert!(inertia.axial_kg <= own * (1.0 + 1e-9), "{}", inertia.axial_kg / own);
            }
        }
    }
}

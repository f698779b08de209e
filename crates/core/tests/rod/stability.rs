//! The planned step of a shipped string.

use wholestring::{
    rod::{
        mesh::Mesh,
        stability::{self, Motion},
    },
    string::{Blades, ComponentLength, ComponentSpec, StringSpec},
};

use crate::{
    common::{assert_close, steel},
    mesh::np13,
};

/// The short elements of the bottom-hole assembly are given mass, drill pipe and heavy-weight none:
/// their waves keep their speed. Lateral mass of steel alone.
#[test]
fn ordinary_pipe_is_lent_nothing() {
    for element_length in [1.6, 3.2, 4.8] {
        let mesh = Mesh::uniform(&np13(), element_length);
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
        // From 300 m above the bit it is drill pipe, joint after joint the same, except for the
        // rest of the uppermost joint at the surface.
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

/// Joint to joint, the string of the article steps 1.9 ms: nothing but its motor, 1.8 % of it, is
/// given mass. With a joint of 2.38 m left at the top and a jar of 3.57 m cut as an element of its
/// own it was 0.82 ms.
#[test]
fn no_remainder_holds_the_step() {
    let mesh = Mesh::uniform(&np13(), 9.6);
    let lateral: Vec<f64> = mesh.elements.iter().map(|e| e.section.steel_kg_per_m).collect();
    let plan = stability::plan(&mesh, &lateral, 1e-5);
    assert!(plan.dt_s > 1.9e-3, "{}", plan.dt_s);
    let holder = plan.holder.expect("an element that holds it");
    assert_eq!(holder.element, mesh.elements.len() - 1);
    assert_eq!(holder.motion, Motion::Axial);
    assert!(holder.scaled);
}

/// Pipe of 2000 m with a blade 1 m below its top: the torsion of that metre holds the step, for no
/// polar inertia is added, at `L √(ρ/G)` less the safety of 1 %. Where there is no blade, the pipe
/// itself holds it, at `L √(ρ/E)`.
#[test]
fn a_short_element_is_named() {
    let pipe =
        |length: ComponentLength| ComponentSpec::uniform("pipe", 0.127, 0.1, length, steel());
    let blade = ComponentSpec {
        blades: Some(Blades { od_m: 0.2, length_m: 0.4 }),
        ..pipe(ComponentLength::Metres(0.5))
    };
    let planned = |components: Vec<ComponentSpec>| {
        let string = StringSpec { components }.assemble(2000.0).expect("a sound string");
        let mesh = Mesh::uniform(&string, 10.0);
        let lateral: Vec<f64> = mesh.elements.iter().map(|e| e.section.steel_kg_per_m).collect();
        (stability::plan(&mesh, &lateral, 0.0), mesh)
    };
    let (plan, mesh) = planned(vec![
        pipe(ComponentLength::Metres(1998.75)),
        blade,
        pipe(ComponentLength::Metres(0.75)),
    ]);
    let holder = plan.holder.expect("an element that holds it");
    assert_eq!(holder.element, 0);
    assert_eq!(holder.motion, Motion::Torsion);
    let metal = steel();
    let wave_s = (metal.density_kg_per_m3 / metal.shear_modulus_Pa).sqrt();
    assert_close("step", plan.dt_s, 0.99 * mesh.elements[0].length_m * wave_s, 1e-9);
    let (plan, _) = planned(vec![pipe(ComponentLength::Metres(2000.0))]);
    let wave_s = (metal.density_kg_per_m3 / metal.youngs_modulus_Pa).sqrt();
    assert_close("step", plan.dt_s, 0.99 * 10.0 * wave_s, 1e-9);
    let holder = plan.holder.expect("an element that holds it");
    assert_eq!((holder.motion, holder.scaled), (Motion::Axial, false));
}

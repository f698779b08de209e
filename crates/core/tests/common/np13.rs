//! The string of `cases/np13-x1042.toml`: the engine reads no case files. A test of `crates/case`
//! holds the two against each other.

use wholestring::string::{ComponentLength, ComponentSpec, Material, ToolJoints};

/// The steel of the article's Table 1.
pub fn steel() -> Material {
    Material {
        density_kg_per_m3: 7860.0,
        youngs_modulus_Pa: 210e9,
        shear_modulus_Pa: 76.923e9,
        ..Material::STEEL
    }
}

/// A component without joints.
pub fn tool(name: &str, length: ComponentLength, od_m: f64, id_m: f64) -> ComponentSpec {
    ComponentSpec::uniform(name, od_m, id_m, length, steel())
}

/// Pipe of 139.7 mm with tool joints of 177.8 mm.
fn jointed(
    name: &str,
    length: ComponentLength,
    id_m: f64,
    spacing_m: f64,
    mass_per_length_kg_per_m: f64,
) -> ComponentSpec {
    ComponentSpec {
        mass_per_length_kg_per_m,
        joints: Some(ToolJoints { od_m: 0.1778, spacing_m }),
        ..tool(name, length, 0.1397, id_m)
    }
}

/// Heavy-weight drill pipe.
pub fn heavy_weight(length_m: f64) -> ComponentSpec {
    let length = ComponentLength::Metres(length_m);
    jointed("heavy-weight drill pipe", length, 0.0921, 9.39, 79.3)
}

/// Drill pipe of 5-1/2 in and 21.90 lb/ft up to the surface.
pub fn drill_pipe() -> ComponentSpec {
    jointed("drill pipe", ComponentLength::ToSurface, 0.12136, 9.6, 35.8)
}

/// The components from the bit up.
pub fn components() -> Vec<ComponentSpec> {
    use ComponentLength::Metres;
    vec![
        tool("bit", Metres(0.34), 0.2159, 0.060),
        tool("motor", Metres(7.69), 0.172, 0.057),
        tool("check valve", Metres(0.50), 0.165, 0.0714),
        tool("stabiliser", Metres(1.53), 0.206, 0.0714),
        tool("drill collar", Metres(9.09), 0.165, 0.0714),
        tool("MWD", Metres(2.17), 0.165, 0.0714),
        tool("drill collar", Metres(9.47), 0.165, 0.0714),
        heavy_weight(84.53),
        tool("jar", Metres(3.57), 0.178, 0.0714),
        heavy_weight(84.53),
        drill_pipe(),
    ]
}

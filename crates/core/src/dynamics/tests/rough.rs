//! The rough wall as the nodes of a chain take it up.

use crate::{
    common::{self, article_hole, mud, path_in_rad},
    dynamics::{
        assemble::chain,
        boundary::{anchor::Anchor, hole::Borehole},
        kernel::{chain::node, step},
        settings::DynamicsSettings,
    },
    model::Model,
    mud::Mud,
    rod::{mesh::Mesh, stability},
    simd::vector::Vector,
    string::{ComponentLength, ComponentSpec},
    well::{Friction, Interpolation, Roughness},
};

const LENGTH_M: f64 = 300.0;

fn model() -> Model {
    let stations = [[0.0, 20.0, 0.4], [LENGTH_M, 60.0, 0.4]]
        .map(|[md, inc, azi]| [md, f64::to_radians(inc), azi]);
    let hole = article_hole(0.2159, Friction::uniform(0.3), LENGTH_M + 20.0);
    let roughness = Roughness {
        radius_rms_m: 0.002,
        tortuosity_rms_m: 0.005,
        shortest_m: 2.0,
        longest_m: 30.0,
        seed: 7,
    };
    let pipe = ComponentSpec::uniform(
        "pipe",
        0.1397,
        0.1186,
        ComponentLength::ToSurface,
        super::bench::STEEL,
    );
    let mud = Mud { drag_coefficient: 1.0, ..mud(1200.0) };
    common::model(
        path_in_rad(&stations, Interpolation::Spline),
        hole.with_roughness(Some(roughness)).expect("a sound hole"),
        vec![pipe],
        mud,
        LENGTH_M,
    )
}

/// Radius, slope, position of the axis and its direction at a depth, as node 10 of a mesh meets
/// them.
fn met(model: &Model, element_length_m: f64, md_m: f64, along_m: f64) -> [f64; 8] {
    let mesh = Mesh::uniform(&model.string, element_length_m);
    let settings = DynamicsSettings::default();
    let lateral = chain::lateral_mass_kg_per_m(model, &mesh, LENGTH_M);
    let plan = stability::plan(&mesh, &lateral, settings.damping.stiffness_s);
    let mut chain = chain::chain(model, &mesh, &plan);
    let borehole = Borehole::new(model, &mesh, settings.contact_law);
    assert!(borehole.intricate);
    let anchor = Anchor {
        md_m: 0.0,
        position_m: nalgebra::Vector3::zeros(),
        high_side: nalgebra::Vector3::x(),
    };
    let mut anchors = vec![anchor; mesh.nodes.len()];
    borehole.place(&mut chain, &mut anchors, 10, md_m);
    let tangent = chain.tangent(10);
    // The wall `along_m` further on, as the step finds it from this anchor, for a node that is off
    // the axis.
    let aside = tangent.cross(Vector(0.3, 0.5, 0.8)).scaled(0.02);
    let place = tangent.scaled(along_m) + aside;
    chain.set_displacement(10, place);
    let (offset, clearance) = step::met(&chain, 10);
    let axis = anchors[10].position_m + nalgebra::Vector3::from(place - offset);
    let slope = node!(chain, 10, clearance_slope);
    let radius = clearance + 0.06985;
    [radius, slope, axis.x, axis.y, axis.z, tangent.0, tangent.1, tangent.2]
}

/// The same seed gives the same wall to nodes of any mesh, to the last digit.
#[test]
fn a_wall_does_not_know_the_mesh() {
    let model = model();
    for md in [3.0, 47.1, 155.55, 299.0] {
        assert_eq!(met(&model, 3.2, md, 0.0), met(&model, 0.8, md, 0.0));
    }
}

/// A node that gets a new anchor at its reach finds the wall at the same position: within 1e-4 of
/// the rms for the radius, 2e-6 of it for the axis.
///
/// The truncation error at the reach is `(k z)²/2` of the shortest waves' radius and `(k z)³/6` of
/// their offset, 1e-4 and 5e-7 by its choice; the sum of 32 waves has less of it than its rms, and
/// three times that at its worst.
#[test]
fn taking_up_an_anchor_moves_no_wall() {
    let model = model();
    let bore = crate::wall::Bore::new(&model.well.hole);
    let reach = bore.reach_m();
    let (mut radius, mut axis) = (0.0f64, 0.0f64);
    for i in 0..400 {
        let md = 10.0 + 0.7 * f64::from(i);
        let before = met(&model, 3.2, md, reach);
        // Along the axis, which is a little longer than the path that depth is measured on.
        let pace = {
            let point = |md| bore.at(&model.well.path, md).axis.position_m;
            (point(md + 1e-3) - point(md)).norm() / 1e-3
        };
        let after = met(&model, 3.2, md + reach / pace, 0.0);
        radius = radius.max((after[0] - before[0]).abs());
        let shift: f64 = (2..5).map(|i| (after[i] - before[i]).powi(2)).sum();
        axis = axis.max(shift.sqrt());
    }
    assert!(radius < 1e-4 * 0.002, "{radius}");
    assert!(axis < 2e-6 * 0.005, "{axis}");
}

//! Different fluids inside the string and around it, by depth: against the balance of forces on the
//! metal, Lamé's tube and sums over the fluids.

mod common;

use std::f64::consts::FRAC_PI_4;

use common::*;
use wholestring::{
    GRAVITY_M_PER_S2,
    model::Model,
    mud::{Annulus, FluidInterval, Fluids, Motion, Mud, Rheology, bore},
    operation::{Operation, OperationKind},
    statics::{
        soft::{SoftProfile, soft_string},
        stiff::{self, StiffSettings},
    },
    string::{ComponentLength, ComponentSpec, REFERENCE_TEMPERATURE_K},
};

const LENGTH_M: f64 = 1000.0;
const HOLE_M: f64 = 0.2159;
const MUD_KG_PER_M3: f64 = 1200.0;

/// Top of the collars, m, and outer and inner diameters of pipe and collars, m.
const COLLARS_MD_M: f64 = 900.0;
const PIPE_M: [f64; 2] = [0.127, 0.1086];
const COLLAR_M: [f64; 2] = [0.1651, 0.0714];

/// Lower ends and densities of the fluids, from the surface down.
const INSIDE: [[f64; 2]; 3] = [[400.0, 0.0], [700.0, 1000.0], [LENGTH_M, MUD_KG_PER_M3]];
const AROUND: [[f64; 2]; 2] = [[600.0, MUD_KG_PER_M3], [LENGTH_M, 1900.0]];

/// Depths between which pressures and tension are linear, m.
const LINEAR_M: [f64; 6] = [0.0, 400.0, 600.0, 700.0, COLLARS_MD_M, LENGTH_M];

/// Air above water above mud inside; mud above cement outside.
fn layered() -> Fluids {
    Fluids {
        inside: vec![FluidInterval::air(400.0), FluidInterval::of_density(400.0, 700.0, 1000.0)],
        annulus: vec![FluidInterval::of_density(600.0, LENGTH_M, 1900.0)],
    }
}

/// Pipe on collars in a vertical hole without friction.
fn vertical(fluids: Fluids) -> Model {
    let part = |name: &str, [od_m, id_m]: [f64; 2], length| {
        ComponentSpec::uniform(name, od_m, id_m, length, steel())
    };
    let components = vec![
        part("collars", COLLAR_M, ComponentLength::Metres(LENGTH_M - COLLARS_MD_M)),
        part("pipe", PIPE_M, ComponentLength::ToSurface),
    ];
    let path = arcs(&[[0.0, 0.0, 0.0], [LENGTH_M, 0.0, 0.0]]);
    let hole = open_hole(HOLE_M, 0.0, LENGTH_M);
    Model { fluids, ..model(path, hole, components, mud(MUD_KG_PER_M3), LENGTH_M) }
}

fn rotating() -> Operation {
    operation(OperationKind::RotateOffBottom, LENGTH_M)
}

fn soft(model: &Model) -> SoftProfile {
    soft_string(model, &rotating()).unwrap_or_else(|error| panic!("{error}"))
}

/// Pressure of fluids at a vertical depth, Pa.
fn pressure_Pa(layers: &[[f64; 2]], depth_m: f64) -> f64 {
    let mut top_m = 0.0;
    let weights = layers.iter().map(|[to_m, density]| {
        let within_m = (depth_m.min(*to_m) - top_m).max(0.0);
        top_m = *to_m;
        density * within_m
    });
    GRAVITY_M_PER_S2 * weights.sum::<f64>()
}

fn areas_m2([od_m, id_m]: [f64; 2]) -> [f64; 2] {
    [od_m, id_m].map(|diameter_m| FRAC_PI_4 * diameter_m * diameter_m)
}

/// Force in the metal of the pipe or of the collars at a depth, N, by the balance of everything
/// below: weight in air, and the pressures on the closed lower end and on the shoulders.
fn metal_N(depth_m: f64, in_collars: bool) -> f64 {
    let [[pipe_o, pipe_i], [collar_o, collar_i]] = [PIPE_M, COLLAR_M].map(areas_m2);
    let per_m3 = steel().density_kg_per_m3 * GRAVITY_M_PER_S2;
    let weight_N = |area_m2: f64, length_m: f64| per_m3 * area_m2 * length_m;
    let [around_Pa, inside_Pa] = [pressure_Pa(&AROUND, LENGTH_M), pressure_Pa(&INSIDE, LENGTH_M)];
    let end_N = inside_Pa * collar_i - around_Pa * collar_o;
    if in_collars {
        return end_N + weight_N(collar_o - collar_i, LENGTH_M - depth_m);
    }
    let shoulders_N = pressure_Pa(&AROUND, COLLARS_MD_M) * (collar_o - pipe_o)
        + pressure_Pa(&INSIDE, COLLARS_MD_M) * (pipe_i - collar_i);
    end_N
        + shoulders_N
        + weight_N(collar_o - collar_i, LENGTH_M - COLLARS_MD_M)
        + weight_N(pipe_o - pipe_i, COLLARS_MD_M - depth_m)
}

/// Elongation of the string, m, by Hooke's law of Lamé's tube, whose radial and hoop stresses add up
/// to `2 (p_i A_i − p_o A_o)/A`: all is linear between [`LINEAR_M`].
fn elongation_m() -> f64 {
    let steel = steel();
    let strain = |depth_m: f64, in_collars: bool| {
        let [outer, inner] = areas_m2(if in_collars { COLLAR_M } else { PIPE_M });
        let burst_N = pressure_Pa(&INSIDE, depth_m) * inner - pressure_Pa(&AROUND, depth_m) * outer;
        let stress_N = metal_N(depth_m, in_collars) - steel.poisson_ratio() * 2.0 * burst_N;
        stress_N / ((outer - inner) * steel.youngs_modulus_Pa)
    };
    let stretches = LINEAR_M.windows(2).map(|ends| {
        let in_collars = ends[0] >= COLLARS_MD_M;
        0.5 * (ends[1] - ends[0]) * (strain(ends[0], in_collars) + strain(ends[1], in_collars))
    });
    stretches.sum()
}

/// Hook load, pressures and the force in the metal everywhere: to the rounding of 200 steps.
#[test]
fn the_metal_bears_the_balance_of_all_forces() {
    let profile = soft(&vertical(layered()));
    assert_close("hook load", profile.scalars.hook_load_N, metal_N(0.0, false), 1e-12);
    let scale_N = metal_N(0.0, false);
    for (row, md_m) in profile.md_m.iter().enumerate() {
        let outside_Pa = pressure_Pa(&AROUND, *md_m);
        let inside_Pa = pressure_Pa(&INSIDE, *md_m);
        for (found_Pa, expected_Pa) in [
            (profile.outside_pressure_Pa[row], outside_Pa),
            (profile.inside_pressure_Pa[row], inside_Pa),
        ] {
            assert!((found_Pa - expected_Pa).abs() < 1e-4, "{found_Pa} for {expected_Pa} Pa");
        }
        let expected_N = metal_N(*md_m, *md_m > COLLARS_MD_M);
        let error_N = (profile.true_tension_N[row] - expected_N).abs();
        assert!(error_N < 1e-11 * scale_N, "force in the metal at {md_m} m: {error_N} N apart");
    }
}

/// The weight that effective tension balances is Archimedes': steel, less the fluid displaced
/// outside, and the fluid inside.
#[test]
fn buoyed_weight_is_that_of_steel_and_fluids() {
    let model = vertical(layered());
    let parts = [(COLLAR_M, COLLARS_MD_M, LENGTH_M), (PIPE_M, 0.0, COLLARS_MD_M)];
    let weights_N = parts.map(|(diameters_m, from_m, to_m)| {
        let [outer, inner] = areas_m2(diameters_m);
        let below = |layers: &[[f64; 2]]| pressure_Pa(layers, to_m) - pressure_Pa(layers, from_m);
        let steel_N = steel().density_kg_per_m3 * GRAVITY_M_PER_S2 * (outer - inner);
        steel_N * (to_m - from_m) + below(&INSIDE) * inner - below(&AROUND) * outer
    });
    assert_close("weight", model.buoyed_weight_N(), weights_N.iter().sum(), 1e-12);
    assert_close("hook load", soft(&model).scalars.hook_load_N, weights_N.iter().sum(), 1e-12);
}

/// Elongation by weight, pressures and ballooning in the soft string, to rounding, and in the stiff
/// string. Its nodes are where its tension has stretched it to, up to 0.4 m higher of a kilometre, so
/// that its lower part is in other fluids at each boundary: 1e-5 of the elongation; and the weight
/// within an element in which a fluid ends is lumped to its nodes, 1e-6 of it.
#[test]
fn elongation_is_that_of_a_tube_under_pressure() {
    let model = vertical(layered());
    assert_close("soft", soft(&model).scalars.stretch_m, elongation_m(), 1e-11);
    let found = stiff::solve(&model, &rotating(), &StiffSettings::default())
        .unwrap_or_else(|error| panic!("{error}"));
    assert_close("stiff: hook load", found.scalars.hook_load_N, metal_N(0.0, false), 1e-10);
    assert_close("stiff: elongation", found.scalars.stretch_m, elongation_m(), 2e-5);
}

/// Temperature lengthens the string by `α (T − T_ref)` along it and changes no force. The metal has
/// the mean of the temperatures of both sides, or the only known one. The stiff string, stretched by
/// up to 0.4 m, has as much of its pipe beyond each boundary, where the temperature jumps by up to
/// 50 K: 2e-4 of the elongation.
#[test]
fn temperature_lengthens_the_string() {
    let cold = layered();
    let mut warm = cold.clone();
    warm.annulus.insert(
        0,
        FluidInterval {
            temperatures_K: Some([290.0, 350.0]),
            ..FluidInterval::of_density(0.0, 600.0, MUD_KG_PER_M3)
        },
    );
    warm.annulus[1].temperatures_K = Some([350.0, 400.0]);
    warm.inside[1].temperatures_K = Some([300.0, 330.0]);
    let [cold, warm] = [cold, warm].map(vertical);
    // The annulus's means, of which half counts where the inside is known, from 400 m to 700 m.
    let upper_K = 290.0 + 60.0 * 200.0 / 600.0;
    let above_K = 290.0 + 60.0 * 500.0 / 600.0;
    let below_K = 350.0 + 50.0 * 50.0 / 400.0;
    let lowest_K = 350.0 + 50.0 * 250.0 / 400.0;
    let means_K = [
        (400.0, upper_K),
        (200.0, 0.5 * (above_K + 310.0)),
        (100.0, 0.5 * (below_K + 325.0)),
        (300.0, lowest_K),
    ];
    let sum_K_m: f64 = means_K
        .iter()
        .map(|(length_m, kelvin)| length_m * (kelvin - REFERENCE_TEMPERATURE_K))
        .sum();
    let expected_m = steel().thermal_expansion_per_K * sum_K_m;
    let [before, after] = [&cold, &warm].map(soft);
    let lengthened_m = after.scalars.stretch_m - before.scalars.stretch_m;
    assert_close("soft", lengthened_m, expected_m, 1e-11);
    assert_eq!(before.scalars.hook_load_N, after.scalars.hook_load_N);
    let [before, after] = [&cold, &warm].map(|model| {
        stiff::solve(model, &rotating(), &StiffSettings::default())
            .unwrap_or_else(|error| panic!("{error}"))
    });
    let lengthened_m = after.scalars.stretch_m - before.scalars.stretch_m;
    assert_close("stiff", lengthened_m, expected_m, 3e-4);
}

/// In a curved hole whose end rises the pressure is the integral of `ρ g` over vertical depth,
/// summed up in steps of 10 mm: 1e-9 is left of the rounding of 180,000 of them and of their error.
/// Where the hole rises it falls.
#[test]
fn pressure_follows_vertical_depth() {
    let to_m = 1800.0;
    let path = arcs(&[
        [0.0, 0.0, 0.0],
        [500.0, 0.0, 0.0],
        [1000.0, 60.0, 20.0],
        [1500.0, 100.0, 20.0],
        [to_m, 100.0, 20.0],
    ]);
    let fluids = Fluids {
        inside: vec![FluidInterval::air(250.0), FluidInterval::of_density(700.0, 1600.0, 900.0)],
        annulus: vec![FluidInterval::of_density(600.0, 1650.0, 1900.0)],
    };
    let specs = vec![pipe(300.0, 0.07, ComponentLength::ToSurface)];
    let model = Model { fluids, ..model(path, hole(0.2, to_m), specs, mud(MUD_KG_PER_M3), to_m) };
    let (column, path) = (model.mud_column(), &model.well.path);
    let step_m = 0.01;
    for side in [&column.inside, &column.annulus] {
        let mut sum_Pa = 0.0;
        let mut highest_Pa = 0.0_f64;
        for step in 0..(to_m / step_m).round() as usize {
            let md_m = step as f64 * step_m;
            let [from_m, to_m] = [md_m, md_m + step_m].map(|md_m| path.at(md_m).position_m.z);
            sum_Pa += side.density_at(md_m + 0.5 * step_m) * GRAVITY_M_PER_S2 * (to_m - from_m);
            let found_Pa = side.hydrostatic_pressure_Pa(md_m + step_m, to_m);
            let error_Pa = (found_Pa - sum_Pa).abs();
            assert!(error_Pa < 1e-9 * 2e7, "at {md_m} m: {found_Pa} for {sum_Pa} Pa");
            highest_Pa = highest_Pa.max(found_Pa);
        }
        assert!(highest_Pa > sum_Pa, "the end rises");
        let mean = side.mean_density([200.0, to_m]);
        let masses = (20000..180_000).map(|step| side.density_at((f64::from(step) + 0.5) * step_m));
        assert_close("mean density", mean, masses.sum::<f64>() / 160e3, 1e-12);
    }
}

/// Intervals of the mud's own density are no change but for rounding, along the whole profile and
/// with friction.
#[test]
fn mud_between_boundaries_is_mud() {
    let stations = [[0.0, 0.0, 0.0], [400.0, 0.0, 0.0], [1000.0, 70.0, 50.0], [1600.0, 70.0, 50.0]];
    let specs = vec![pipe(300.0, 0.07, ComponentLength::ToSurface)];
    let uniform = along(&stations, 0.3, specs, mud(MUD_KG_PER_M3));
    let cut = |from_m, to_m| FluidInterval::of_density(from_m, to_m, MUD_KG_PER_M3);
    let fluids = Fluids {
        inside: vec![cut(0.0, 700.0)],
        annulus: vec![cut(100.0, 450.0), cut(450.0, 1234.5)],
    };
    let layered = Model { fluids, ..uniform.clone() };
    let trip = operation(OperationKind::TripOut, 1600.0);
    let [one, other] = [&uniform, &layered]
        .map(|model| soft_string(model, &trip).unwrap_or_else(|error| panic!("{error}")).scalars);
    assert_close("hook load", other.hook_load_N, one.hook_load_N, 1e-9);
    assert_close("stretch", other.stretch_m, one.stretch_m, 1e-9);
    let [one, other] = [&uniform, &layered].map(|model| {
        stiff::solve(model, &trip, &StiffSettings::default())
            .unwrap_or_else(|error| panic!("{error}"))
            .scalars
    });
    assert_close("stiff: hook load", other.hook_load_N, one.hook_load_N, 1e-6);
    assert_close("stiff: stretch", other.stretch_m, one.stretch_m, 1e-6);
}

/// Each fluid flows by its own density and rheology; the jets have that at the bit.
#[test]
fn losses_are_the_sums_over_the_fluids() {
    let cement = Rheology::Bingham { plastic_viscosity_Pa_s: 0.04, yield_point_Pa: 8.0 };
    let water = Rheology::Newtonian { viscosity_Pa_s: 1e-3 };
    let mut fluids = layered();
    fluids.inside = vec![FluidInterval {
        rheology: Some(water),
        ..FluidInterval::of_density(0.0, LENGTH_M, 1000.0)
    }];
    fluids.annulus[0].rheology = Some(cement);
    let mud = Mud {
        rheology: Some(Rheology::Newtonian { viscosity_Pa_s: 0.02 }),
        ..Mud::of_density(MUD_KG_PER_M3)
    };
    let model = Model { mud, ..vertical(fluids) };
    let (flow, bit_loss_Pa) = (0.025, 5e6);
    let operation = rotating().flow_rate_m3_per_s(flow).bit_pressure_drop_Pa(bit_loss_Pa);
    let profile = soft_string(&model, &operation).unwrap_or_else(|error| panic!("{error}"));
    let found = profile.hydraulics.expect("rheologies");
    let motion = Motion {
        axial_m_per_s: 0.0,
        spin_rad_per_s: operation.rotation_rad_per_s(),
        flow_m3_per_s: flow,
    };
    let slurry = Mud { density_kg_per_m3: 1900.0, rheology: Some(cement), ..mud };
    let annulus_Pa: f64 =
        [(600.0, PIPE_M, mud), (300.0, PIPE_M, slurry), (100.0, COLLAR_M, slurry)]
            .map(|(length_m, [od_m, _], fluid)| {
                length_m * Annulus::new(od_m, HOLE_M).drag(&fluid, &motion).gradient_Pa_per_m
            })
            .iter()
            .sum();
    let thin = Mud { density_kg_per_m3: 1000.0, rheology: Some(water), ..mud };
    let bore_Pa: f64 = [(900.0, PIPE_M), (100.0, COLLAR_M)]
        .map(|(length_m, diameters_m)| {
            length_m * bore::gradient_Pa_per_m(&thin, areas_m2(diameters_m)[1], flow)
        })
        .iter()
        .sum();
    assert_close("annulus", found.annulus_loss_Pa, annulus_Pa, 1e-12);
    assert_close("bore", found.bore_loss_Pa, bore_Pa, 1e-12);
    let thrust_N = flow * (2.0 * 1000.0 * bit_loss_Pa).sqrt();
    assert_close("jets", found.jet_thrust_N, thrust_N, 1e-12);
}

/// Intervals that overlap, and fluids that do not exist, are refused with their depth.
#[test]
fn impossible_columns_are_refused() {
    let interval = FluidInterval::of_density;
    let hot =
        |kelvin| FluidInterval { temperatures_K: Some([300.0, kelvin]), ..interval(0.0, 9.0, 1.0) };
    for (inside, message) in [
        (
            vec![interval(0.0, 500.0, 1e3), interval(400.0, 600.0, 1e3)],
            "fluid from MD 400 m to 600 m: intervals must be longer than zero, begin at 500 m or \
             deeper and be finite",
        ),
        (
            vec![interval(5.0, 5.0, 1e3)],
            "fluid from MD 5 m to 5 m: intervals must be longer than zero, begin at 0 m or deeper \
             and be finite",
        ),
        (
            vec![interval(5.0, f64::NAN, 1e3)],
            "fluid from MD 5 m to NaN m: intervals must be longer than zero, begin at 0 m or \
             deeper and be finite",
        ),
        (
            vec![interval(5.0, 6.0, -1.0)],
            "fluid from MD 5 m: the density must be zero or more, got -1 kg/m³",
        ),
        (vec![hot(0.0)], "fluid from MD 0 m: the temperature must be above 0 K, got 0 K"),
    ] {
        let model = vertical(Fluids { inside, annulus: Vec::new() });
        let refused = soft_string(&model, &rotating()).expect_err("no column");
        assert_eq!(refused.to_string(), message);
    }
}

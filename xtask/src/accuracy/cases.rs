//! Measured cases, meshes and values of each run.

/// A mesh, as settings of a case.
pub(super) struct Mesh {
    pub(super) name: &'static str,
    pub(super) settings: &'static [&'static str],
}

/// The others are compared with the first, which is the last but one with halved elements.
pub(super) const MESHES: [Mesh; 5] = [
    Mesh {
        name: "halved",
        settings: &["mesh.element_length=\"auto\"", "mesh.accuracy=\"fine\"", "mesh.refinement=2"],
    },
    Mesh { name: "fine", settings: &["mesh.element_length=\"auto\"", "mesh.accuracy=\"fine\""] },
    Mesh {
        name: "standard",
        settings: &["mesh.element_length=\"auto\"", "mesh.accuracy=\"standard\""],
    },
    Mesh {
        name: "coarse",
        settings: &["mesh.element_length=\"auto\"", "mesh.accuracy=\"coarse\""],
    },
    Mesh { name: "3.2 m", settings: &["mesh.element_length=3.2m"] },
];

/// A number of a run, and its format.
#[derive(Clone, Copy)]
pub(super) struct Quantity {
    /// Its name with unit.
    pub(super) label: &'static str,
    /// Its path in the operation's part of `summary.json`.
    pub(super) pointer: &'static str,
    /// Factor from SI to the unit shown.
    pub(super) scale: f64,
    /// Decimals of the value, and of the error.
    pub(super) decimals: [usize; 2],
    pub(super) error: Error,
}

/// Form of an error.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Error {
    /// In percent of the converged value.
    Percent,
    /// A difference, in the quantity's unit.
    Difference,
}

/// A case of which runs are compared.
pub(super) struct Case {
    pub(super) title: &'static str,
    pub(super) file: &'static str,
    pub(super) settings: &'static [&'static str],
    /// Number of runs with seeds from 1 on, whose mean is used.
    pub(super) seeds: u32,
    pub(super) quantities: &'static [Quantity],
}

/// A mean over the window.
const fn mean(label: &'static str, pointer: &'static str, scale: f64, digits: usize) -> Quantity {
    Quantity { label, pointer, scale, decimals: [digits, 2], error: Error::Percent }
}

/// A quantity with scatter: a deviation, a peak, a period.
const fn loose(label: &'static str, pointer: &'static str, scale: f64, digits: usize) -> Quantity {
    Quantity { label, pointer, scale, decimals: [digits, 1], error: Error::Percent }
}

const HOOK_LOAD: Quantity = mean("hook load, kN", "/statistics/hook_load_N/mean", 1e-3, 2);
const HOOK_LOAD_STD: Quantity = loose("– its std, kN", "/statistics/hook_load_N/std", 1e-3, 3);
const TORQUE: Quantity =
    mean("surface torque, kN·m", "/statistics/surface_torque_N_m/mean", 1e-3, 3);
const TORQUE_STD: Quantity =
    loose("– its std, kN·m", "/statistics/surface_torque_N_m/std", 1e-3, 3);
const TORQUE_MAX: Quantity =
    loose("– its largest, kN·m", "/statistics/surface_torque_N_m/max", 1e-3, 2);
const FRICTION_TORQUE: Quantity =
    mean("friction torque, kN·m", "/statistics/friction_torque_N_m/mean", 1e-3, 3);
const FRICTION_TORQUE_STD: Quantity =
    loose("– its std, kN·m", "/statistics/friction_torque_N_m/std", 1e-3, 3);
const AXIAL_FRICTION: Quantity =
    mean("axial friction, kN", "/statistics/axial_friction_N/mean", 1e-3, 2);
const SIDE_FORCE: Quantity = mean("side force, kN", "/statistics/side_force_total_N/mean", 1e-3, 1);
const SIDE_FORCE_STD: Quantity =
    loose("– its std, kN", "/statistics/side_force_total_N/std", 1e-3, 1);
const WEIGHT: Quantity = mean("weight on bit, kN", "/statistics/weight_on_bit_N/mean", 1e-3, 3);
const WEIGHT_STD: Quantity = loose("– its std, kN", "/statistics/weight_on_bit_N/std", 1e-3, 3);
const WEIGHT_MAX: Quantity = loose("– its largest, kN", "/statistics/weight_on_bit_N/max", 1e-3, 1);
const CUT_OFF: Quantity = Quantity {
    label: "cut-off depth, m",
    pointer: "/cutoff_depth_m",
    scale: 1.0,
    decimals: [2, 2],
    error: Error::Difference,
};
const RPM: f64 = 30.0 / std::f64::consts::PI;
const BIT_SPEED_STD: Quantity =
    loose("bit speed, std, rev/min", "/statistics/bit_rotary_speed_rad_per_s/std", RPM, 2);
const BIT_SPEED_MAX: Quantity =
    loose("– its largest, rev/min", "/statistics/bit_rotary_speed_rad_per_s/max", RPM, 1);

pub(super) const CASES: [Case; 8] = [
    Case {
        title: "NP13-X1042, drilling, quiet",
        file: "cases/np13-x1042.toml",
        settings: &["model=\"dynamic\""],
        seeds: 1,
        quantities: &[HOOK_LOAD, TORQUE, FRICTION_TORQUE, SIDE_FORCE, WEIGHT, CUT_OFF],
    },
    Case {
        title: "NP13-X1042, drilling, excited",
        file: "cases/np13-x1042.toml",
        settings: &[
            "model=\"dynamic\"",
            "dynamics.settle=30s",
            "bit.excitation.roughness=0.3mm",
            "bit.excitation.torque_fluctuation=0.2",
        ],
        seeds: 4,
        quantities: &[
            HOOK_LOAD,
            HOOK_LOAD_STD,
            TORQUE,
            TORQUE_STD,
            SIDE_FORCE,
            WEIGHT,
            WEIGHT_STD,
            WEIGHT_MAX,
            BIT_SPEED_STD,
            BIT_SPEED_MAX,
            CUT_OFF,
        ],
    },
    Case {
        title: "Well B at 1714 m, stick-slip",
        file: "cases/well-b-1714.toml",
        settings: &[],
        seeds: 1,
        quantities: &[
            HOOK_LOAD,
            TORQUE,
            TORQUE_STD,
            TORQUE_MAX,
            FRICTION_TORQUE,
            SIDE_FORCE,
            BIT_SPEED_STD,
            BIT_SPEED_MAX,
            loose("stick-slip period, s", "/indicators/stick_slip/period_s", 1.0, 3),
        ],
    },
    Case {
        title: "Lateral, sliding, buckled",
        file: "benchmarks/accuracy/sliding.toml",
        settings: &[],
        seeds: 1,
        quantities: &[HOOK_LOAD, AXIAL_FRICTION, SIDE_FORCE, WEIGHT],
    },
    Case {
        title: "Tripping out, stop, on again",
        file: "benchmarks/accuracy/trip-with-a-stop.toml",
        settings: &[],
        seeds: 1,
        quantities: &[
            HOOK_LOAD,
            HOOK_LOAD_STD,
            loose("– its largest, kN", "/statistics/hook_load_N/max", 1e-3, 1),
            AXIAL_FRICTION,
            SIDE_FORCE,
        ],
    },
    Case {
        title: "Extended reach, 10 km, drilling",
        file: "benchmarks/accuracy/extended-reach.toml",
        settings: &[],
        seeds: 1,
        quantities: &[HOOK_LOAD, TORQUE, FRICTION_TORQUE, SIDE_FORCE, WEIGHT],
    },
    Case {
        title: "Bent motor, rotary drilling",
        file: "benchmarks/accuracy/rotating-bend.toml",
        settings: &[],
        seeds: 3,
        quantities: &[
            HOOK_LOAD,
            HOOK_LOAD_STD,
            TORQUE,
            TORQUE_STD,
            FRICTION_TORQUE,
            FRICTION_TORQUE_STD,
            SIDE_FORCE,
            SIDE_FORCE_STD,
            WEIGHT,
            WEIGHT_STD,
            BIT_SPEED_STD,
        ],
    },
    Case {
        title: "Eccentric collar, excited",
        file: "benchmarks/accuracy/eccentric-collar.toml",
        settings: &[],
        seeds: 3,
        quantities: &[
            HOOK_LOAD,
            HOOK_LOAD_STD,
            TORQUE,
            TORQUE_STD,
            WEIGHT,
            WEIGHT_STD,
            BIT_SPEED_STD,
        ],
    },
];

/// Case whose natural frequencies are compared.
pub(super) const RINGING: &Case = &CASES[0];

/// Motions of a string, and the paths of their frequencies in the results.
pub(super) const MOTIONS: [[&str; 2]; 3] = [
    ["along the string", "axial_Hz"],
    ["about its axis", "torsional_Hz"],
    ["across, three joints pinned", "lateral_Hz"],
];

/// Frequencies of each motion.
pub(super) const MODES: usize = 3;

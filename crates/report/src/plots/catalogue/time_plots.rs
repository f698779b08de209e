//! Quantities drawn against time.

use serde::Serialize;
use wholestring::outcome::{PROFILE, Quantity, Scalar, TIME_SERIES};

use super::{declared, shown_dimension};

/// Quantities against time.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct TimePlot {
    /// Name of its file.
    #[serde(skip)]
    pub(crate) name: &'static str,
    pub(crate) title: String,
    pub(crate) dimension: &'static str,
    /// Minimum span of the axis, SI: smaller changes do not matter to an engineer.
    pub(crate) min_span: f64,
    /// Columns of the history, with the name of each.
    pub(crate) columns: Vec<(&'static str, String)>,
    /// Column of a profile in equilibrium whose value at the surface is drawn with them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) at_surface: Option<&'static str>,
    /// Whether it is single points, on an axis that grows down: depths.
    pub(crate) points: bool,
}

/// A column against time, and the name of its curve where that differs from its own.
type Curve = (&'static Quantity, Option<&'static str>);

/// A curve with the name of its column.
const fn own(quantity: &'static Quantity) -> Curve {
    (quantity, None)
}

/// A curve that this word distinguishes from the others of its plot.
const fn called(quantity: &'static Quantity, word: &'static str) -> Curve {
    (quantity, Some(word))
}

impl TimePlot {
    /// A plot of related columns, titled as the first.
    fn of(name: &'static str, min_span: f64, curves: &[Curve]) -> Self {
        let (first, _) = curves[0];
        let named = |(quantity, word): &Curve| {
            (quantity.name, word.map_or_else(|| quantity.words(), String::from))
        };
        Self {
            name,
            title: first.label(),
            dimension: shown_dimension(first.kind),
            min_span,
            columns: curves.iter().map(named).collect(),
            at_surface: None,
            points: false,
        }
    }

    fn titled(self, title: &str) -> Self {
        Self { title: title.into(), ..self }
    }
}

macro_rules! series {
    ($column:ident) => {
        declared!(TIME_SERIES, $column)
    };
}

const HOOK_LOAD: &Scalar = Scalar::declared("hook_load_N");

/// The histories of a run.
pub(crate) fn time_plots() -> Vec<TimePlot> {
    vec![
        TimePlot {
            at_surface: Some(declared!(PROFILE, tension_N).name),
            ..TimePlot::of("time-hook-load", 2e4, &[own(series!(hook_load_N))])
                .titled(HOOK_LOAD.label)
        },
        TimePlot {
            at_surface: Some(declared!(PROFILE, torque_N_m).name),
            ..TimePlot::of(
                "time-torque",
                1e3,
                &[
                    called(series!(surface_torque_N_m), "surface"),
                    called(series!(friction_torque_N_m), "friction"),
                    called(series!(bit_torque_N_m), "bit"),
                ],
            )
            .titled("Torque")
        },
        TimePlot::of(
            "time-rotary-speed",
            1.0,
            &[
                called(series!(rotary_speed_rad_per_s), "top"),
                called(series!(bit_rotary_speed_rad_per_s), "bit"),
                called(series!(rotary_speed_set_rad_per_s), "set"),
            ],
        ),
        TimePlot::of(
            "time-block-velocity",
            0.02,
            &[
                called(series!(block_velocity_m_per_s), "block"),
                called(series!(block_velocity_set_m_per_s), "set"),
            ],
        )
        .titled("Block velocity, down"),
        TimePlot::of(
            "time-axial-friction",
            1e4,
            &[called(series!(axial_friction_N), "along the string")],
        ),
        TimePlot {
            points: true,
            ..TimePlot::of(
                "time-depths",
                20.0,
                &[own(series!(neutral_point_m)), called(series!(cutoff_depth_m), "cut-off depth")],
            )
            .titled("Neutral point and cut-off depth")
        },
    ]
}

/// Quantities of the bit, for a run that drills.
pub(crate) fn bit_plots() -> Vec<TimePlot> {
    vec![
        TimePlot::of("bit-rate-of-penetration", 5e-4, &[own(series!(rate_of_penetration_m_per_s))]),
        TimePlot::of(
            "bit-depth-of-cut",
            2e-4,
            &[called(series!(depth_of_cut_m), "per revolution")],
        ),
        TimePlot::of(
            "bit-weight",
            1e4,
            &[
                called(series!(weight_on_bit_N), "on bit"),
                called(series!(weight_on_bit_set_N), "set"),
            ],
        ),
        TimePlot::of("bit-torque", 500.0, &[called(series!(bit_torque_N_m), "torque on bit")])
            .titled("Torque on bit"),
        TimePlot::of(
            "bit-speed",
            1.0,
            &[
                called(series!(bit_rotary_speed_rad_per_s), "string"),
                called(series!(motor_speed_rad_per_s), "motor"),
            ],
        )
        .titled("Speed at the bit"),
        TimePlot::of(
            "bit-motor-pressure",
            2e5,
            &[called(series!(motor_pressure_Pa), "pressure drop")],
        ),
        TimePlot::of(
            "bit-force-across",
            1e3,
            &[
                called(series!(bit_force_high_N), "to the high side"),
                called(series!(bit_force_right_N), "to the right"),
            ],
        )
        .titled("Force across"),
        TimePlot::of(
            "bit-bending-moment",
            200.0,
            &[called(series!(bit_moment_N_m), "bending moment")],
        )
        .titled("Bending moment"),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All quantities on one axis have one dimension.
    #[test]
    fn a_plot_shows_one_dimension() {
        let kind = |name: &str| {
            let all = TIME_SERIES.iter().map(|series| series.quantity);
            let mut all = all.chain(PROFILE.iter().map(|column| column.quantity));
            all.find(|quantity| quantity.name == name)
                .map(|quantity| shown_dimension(quantity.kind))
        };
        for plot in [time_plots(), bit_plots()].concat() {
            assert_ne!(plot.title, "", "{}", plot.name);
            for name in plot.columns.iter().map(|(name, _)| *name).chain(plot.at_surface) {
                assert_eq!(kind(name), Some(plot.dimension), "{name}");
            }
        }
    }
}

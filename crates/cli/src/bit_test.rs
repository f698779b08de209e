//! `wholestring bit-test`: the bit alone on its rock, at every weight and every speed.

use clap::Args;
use wholestring::rock::TrialOutcome;
use wholestring_results::BitTestSummary;
use wholestring_runner::job::{Job, Work};
use wholestring_units::{Dimension, UnitSet, without_trailing_zeros};

use crate::{
    screen::Table,
    shared_args::{BatchArgs, CaseArgs},
};

// Arguments of `wholestring bit-test`.

#[derive(Debug, Args)]
pub(crate) struct BitTestArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Units on the screen [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Exit with status 4 if a check of the points is an error
    #[arg(long)]
    pub(crate) strict: bool,

    #[command(flatten)]
    pub(crate) batch: BatchArgs,
}

impl BitTestArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::BitTest { shard: self.batch.shard.clone(), csv: self.batch.csv };
        self.batch.applied_to(Job { units: self.units, ..self.case.job(work) })
    }
}

// Output of a bit test on the screen.

/// A column: the common name of the quantity, its dimension, and its value with its error, if it
/// has one.
type Column = (&'static str, Dimension, fn(&TrialOutcome) -> Option<Value>);
type Value = (f64, Option<f64>);

const COLUMNS: [Column; 7] = [
    ("weight on bit", Dimension::Force, |outcome| Some((outcome.weight_on_bit_N, None))),
    ("rotary speed", Dimension::RotarySpeed, |outcome| {
        Some((outcome.rotary_speed_rad_per_s, None))
    }),
    ("rate of penetration", Dimension::RateOfPenetration, |outcome| {
        Some((outcome.rate_of_penetration_m_per_s, outcome.rate_of_penetration_error_m_per_s))
    }),
    ("depth of cut", Dimension::Diameter, |outcome| Some((outcome.depth_of_cut_m, None))),
    ("torque", Dimension::Torque, |outcome| Some((outcome.torque_N_m, outcome.torque_error_N_m))),
    ("its deviation", Dimension::Torque, |outcome| Some((outcome.torque_std_N_m, None))),
    ("specific energy", Dimension::Stress, |outcome| Some((outcome.specific_energy_Pa?, None))),
];

/// The finished points as a table, properties common to all points, and warnings.
pub(crate) fn text(summary: &BitTestSummary, units: UnitSet) -> String {
    let title = format!(
        "{}: a bit of {} on rock of {}",
        summary.case,
        Dimension::Diameter.format(2.0 * summary.bit_radius_m, units),
        Dimension::Stress.format(summary.rock_strength_Pa, units)
    );
    let headings = COLUMNS.map(|(label, dimension, _)| {
        let symbol = dimension.unit_in(units).symbol;
        format!("{label}, {symbol}")
    });
    let mut table = Table::new(&title, 0, &headings.each_ref().map(String::as_str));
    let mut any = false;
    for outcome in summary.points.iter().filter_map(|point| point.outcome) {
        any = true;
        let cell = |(_, dimension, value): Column| {
            let unit = dimension.unit_in(units);
            match value(&outcome) {
                Some((value, None)) => number(unit.from_si(value)),
                Some((value, Some(error))) => {
                    format!("{} ± {}", number(unit.from_si(value)), number(unit.from_si(error)))
                }
                None => "–".to_owned(),
            }
        };
        table.row(COLUMNS.map(cell).into());
    }
    if !any {
        return String::new();
    }
    let warnings = summary.warnings().into_iter().map(|text| format!("warning: {text}\n"));
    format!("{}{}{}\n", table.text(), common(summary), warnings.collect::<String>())
}

/// Lines about all points together.
fn common(summary: &BitTestSummary) -> String {
    let response = &summary.response;
    let mut text = String::new();
    text += &match response.torque_over_weight_and_radius {
        Some(slope) => {
            format!("Torque over weight times radius, slope of all points: {slope:.2}\n")
        }
        None => "Torque over weight times radius: one weight has no slope, give two under wob of \
                 [bit_test]\n"
            .to_owned(),
    };
    if let Some(ratio) = response.specific_energy_over_strength {
        text += &format!("Specific energy over the rock's strength, all points: {ratio:.2}\n");
    }
    if let Some(stiffness) = response.bottom_stiffness_N_per_m {
        text += &format!(
            "Weight over a blade's depth of cut, all points: rock_stiffness = \"{stiffness:.2e} \
             N/m\" with the table\n"
        );
    }
    text
}

/// Three significant digits; integers without decimals.
fn number(value: f64) -> String {
    const DIGITS: i32 = 3;
    let size = value.abs();
    if size < 1e-9 {
        return "0".to_owned();
    }
    let decimals = (DIGITS - 1 - libm::log10(size).floor() as i32).clamp(0, 6) as usize;
    let text = format!("{value:.decimals$}");
    without_trailing_zeros(&text).to_owned()
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_have_three_digits() {
        for (value, text) in [
            (120.000000000001, "120"),
            (1234.5, "1234"),
            (0.012345, "0.0123"),
            (-2.5, "-2.5"),
            (0.0, "0"),
            (-1e-15, "0"),
            (9.999, "10"),
        ] {
            assert_eq!(number(value), text);
        }
    }
}

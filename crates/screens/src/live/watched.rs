//! Motion of a live string over the last seconds, for its alarms and lamps.

use std::collections::VecDeque;

use wholestring::{
    dynamics::{Frame, Indicators, Simulation, StickSlip, TorsionalString, Whirl},
    outcome::Profile,
};
use wholestring_case::Case;
use wholestring_judge::{Check, Checks, Recent};
use wholestring_units::UnitSet;

use super::live_string::LiveString;

/// Number of torsional periods over which the motion is measured.
const PERIODS: f64 = 2.0;

/// Minimum and maximum of that time, s.
const MEASURED_S: [f64; 2] = [5.0, 60.0];

/// Shortest time from which stick-slip and whirl are measured, s.
pub(super) const MOVES_S: f64 = 2.0;

/// Time over which the largest loads along the string are kept, s: at least once, at most twice.
const LARGEST_S: f64 = 5.0;

/// Columns of the samples that are kept.
#[derive(Debug, Clone, Copy)]
enum Column {
    HookLoad,
    Torque,
    Speed,
    SetSpeed,
    BitSpeed,
    Pressure,
    Weight,
    SetWeight,
}

const COLUMNS: usize = 8;

/// The last samples of a live string, the largest loads along it, and its whirl.
#[derive(Debug)]
pub(super) struct Watched {
    most: usize,
    sample_s: f64,
    rotates: bool,
    columns: [VecDeque<f64>; COLUMNS],
    whirl: [Option<Whirl>; 2],
    /// Largest loads along the string since the first time, s, and in the interval before.
    largest: Largest,
    before: Option<Largest>,
    tension_N: Vec<f64>,
}

#[derive(Debug, Clone, Default)]
struct Largest {
    from_s: f64,
    along: Profile,
}

impl Largest {
    /// The larger of both, node by node, at the depths of the other.
    fn add(&mut self, md_m: &[f64], columns: [&[f64]; 3]) {
        let along = &mut self.along;
        along.md_m.clear();
        along.md_m.extend_from_slice(md_m);
        let kept =
            [&mut along.tension_N, &mut along.torque_N_m, &mut along.von_mises_stress_max_Pa];
        for (kept, new) in kept.into_iter().zip(columns) {
            kept.resize(new.len(), f64::NEG_INFINITY);
            for (kept, new) in kept.iter_mut().zip(new) {
                *kept = kept.max(*new);
            }
        }
    }

    fn of_frame(&mut self, frame: &Frame) {
        let torque_N_m: Vec<f64> = frame.torque_N_m.iter().map(|torque| torque.abs()).collect();
        self.add(&frame.md_m, [&frame.tension_N, &torque_N_m, &frame.von_mises_stress_Pa]);
    }
}

impl Watched {
    pub(super) fn new(simulation: &Simulation, string: &LiveString) -> Self {
        let period_s = 1.0 / TorsionalString::of(simulation.mesh()).frequency_Hz;
        let [least_s, most_s] = MEASURED_S;
        let measured_s = (PERIODS * period_s).clamp(least_s, most_s);
        let sample_s = simulation.sample_interval_s();
        Self {
            most: (measured_s / sample_s).ceil() as usize,
            sample_s,
            rotates: string.operation.kind.rotates(),
            columns: Default::default(),
            whirl: [None; 2],
            largest: Largest::default(),
            before: None,
            tension_N: Vec::new(),
        }
    }

    /// Adds the samples from a row of the series on.
    pub(super) fn add(&mut self, simulation: &Simulation, row: usize) {
        let series = simulation.series();
        let known = |values: &[Option<f64>]| -> Vec<f64> {
            values[row..].iter().map(|value| value.unwrap_or(f64::NAN)).collect()
        };
        let pressures = known(&series.pump_pressure_Pa);
        let set_weights = known(&series.weight_on_bit_set_N);
        // In the order of `Column`.
        let news: [&[f64]; COLUMNS] = [
            &series.hook_load_N[row..],
            &series.surface_torque_N_m[row..],
            &series.rotary_speed_rad_per_s[row..],
            &series.rotary_speed_set_rad_per_s[row..],
            &series.bit_rotary_speed_rad_per_s[row..],
            &pressures,
            &series.weight_on_bit_N[row..],
            &set_weights,
        ];
        for (column, new) in self.columns.iter_mut().zip(news) {
            let new = &new[new.len().saturating_sub(self.most)..];
            let over = (column.len() + new.len()).saturating_sub(self.most);
            column.drain(..over);
            column.extend(new);
        }
    }

    /// Adds the present loads along the string.
    pub(super) fn add_frame(&mut self, frame: &Frame, time_s: f64) {
        if time_s - self.largest.from_s >= LARGEST_S {
            let empty = Largest { from_s: time_s, along: Profile::default() };
            self.before = Some(std::mem::replace(&mut self.largest, empty));
        }
        self.largest.of_frame(frame);
        self.tension_N.clone_from(&frame.tension_N);
    }

    /// Measured time, s.
    pub(super) fn measured_s(&self) -> f64 {
        self.columns[Column::Torque as usize].len() as f64 * self.sample_s
    }

    pub(super) fn rotates(&self) -> bool {
        self.rotates
    }

    /// Largest magnitude of the surface torque, N·m.
    pub(super) fn largest_torque_N_m(&self) -> f64 {
        let torques_N_m = self.columns[Column::Torque as usize].iter();
        torques_N_m.fold(0.0_f64, |most, torque_N_m| most.max(torque_N_m.abs()))
    }

    /// Stick-slip and whirl; none before enough time is measured.
    pub(super) fn indicators(&mut self, simulation: &Simulation) -> Indicators {
        let series = simulation.series();
        if let [first, .., last] = series.time_s[..]
            && last - first >= MOVES_S
        {
            let found = simulation.indicators();
            self.whirl = [found.backward_whirl, found.forward_whirl];
        }
        if self.measured_s() < MOVES_S {
            return Indicators::default();
        }
        for column in &mut self.columns {
            column.make_contiguous();
        }
        let column = |column: Column| self.columns[column as usize].as_slices().0;
        let stick_slip =
            StickSlip::of(column(Column::BitSpeed), column(Column::Torque), self.sample_s);
        let [backward_whirl, forward_whirl] = self.whirl;
        Indicators {
            stick_slip: stick_slip.filter(|_| self.rotates),
            backward_whirl,
            forward_whirl,
            top_drive: None,
        }
    }

    /// The judge's checks of this motion that need attention.
    pub(super) fn alarms(
        &mut self,
        case: &Case,
        string: &LiveString,
        indicators: &Indicators,
    ) -> Vec<Check> {
        for column in &mut self.columns {
            column.make_contiguous();
        }
        let mut largest = self.largest.along.clone();
        if let Some(before) = &self.before
            && before.along.md_m.len() == largest.md_m.len()
        {
            let along = &before.along;
            let mut both = Largest { from_s: 0.0, along: largest };
            let depths = both.along.md_m.clone();
            both.add(
                &depths,
                [&along.tension_N, &along.torque_N_m, &along.von_mises_stress_max_Pa],
            );
            largest = both.along;
        }
        let column = |column: Column| self.columns[column as usize].as_slices().0;
        let recent = Recent {
            largest: &largest,
            tension_N: &self.tension_N,
            hook_load_N: column(Column::HookLoad),
            surface_torque_N_m: column(Column::Torque),
            rotary_speed_rad_per_s: column(Column::Speed),
            rotary_speed_set_rad_per_s: column(Column::SetSpeed),
            pump_pressure_Pa: column(Column::Pressure),
            weight_on_bit_N: column(Column::Weight),
            weight_on_bit_set_N: column(Column::SetWeight),
            sample_s: self.sample_s,
            indicators,
        };
        let judge = case.judge(UnitSet::Si);
        let Checks { checks, .. } =
            judge.live(&case.model, &string.operation, &case.dynamics, &recent);
        checks
    }
}

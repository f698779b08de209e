//! Results of a model as rows of the tables.

use std::time::Duration;

use wholestring::{
    dynamics::{ScheduleStep, Simulation, TunedHookLoad},
    operation::Operation,
    outcome::{
        CONTACT_MAP, Column, HOLE_WEAR, InTime, ModelKind, PROFILE, Profile, Samples, Scalars,
        Solution, TIME_SERIES, TimeSeries, samples::ends,
    },
    rock::bit_face::BottomHole,
};
use wholestring_results::{
    BottomHoleCell, Friction, Numerics, OperationSummary, ResultsError, ResultsFolder, Row as _,
    Spectrum, SpectrumRow, Status,
};

use super::{Record, friction, handed_over::PART_ROWS};

/// Cost of a dynamic run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Effort {
    /// Wall-clock time.
    pub(crate) took: Duration,
    /// Number of runs from start to end, including those that search a lift.
    pub(crate) runs: usize,
}

/// Solution of an operation by any method, apart from its profile.
pub(crate) struct CarriedOut<'a> {
    /// Completion.
    pub(crate) status: Status,
    /// Lift found for it, if there is one.
    pub(crate) lift: Option<TunedHookLoad>,
    /// Bottom hole on solid rock, if there is one.
    pub(crate) bottom: Option<&'a BottomHole>,
    /// Cost.
    pub(crate) effort: Effort,
}

impl CarriedOut<'_> {
    /// Complete, in negligible time.
    pub(crate) const AT_ONCE: Self = Self {
        status: Status::Complete,
        lift: None,
        bottom: None,
        effort: Effort { took: Duration::ZERO, runs: 1 },
    };
}

impl Record {
    /// Adds the results of a method for an operation to the summary and to every table.
    pub(crate) fn add(
        &mut self,
        operation: &Operation,
        solution: &Solution<'_>,
        carried_out: CarriedOut<'_>,
    ) {
        let Solution { model, scalars, hydraulics, profile, wear, at_rest, in_time } = *solution;
        let CarriedOut { status, lift, bottom, effort } = carried_out;
        let statistics = |time: InTime<'_>| {
            let named = time.statistics.iter();
            named.map(|(name, statistic)| ((*name).to_owned(), *statistic)).collect()
        };
        self.summary.operations.push(OperationSummary {
            model,
            operation: operation.kind,
            status,
            friction: Friction::of(&friction(&self.hole)),
            bit_depth_m: operation.bit_depth_m,
            checks: Vec::new(),
            unchecked: Vec::new(),
            scalars,
            lift,
            hydraulics,
            at_rest,
            statistics: in_time.map(statistics),
            indicators: in_time.map(|time| *time.indicators),
            bit_table: in_time.and_then(|time| time.bit_table),
            numerics: in_time.map(|time| numerics(&time, effort)),
        });
        let name = operation.kind.name();
        let whose: [(&str, &[&str]); 2] = [("model", &[model.name()]), ("operation", &[name])];
        self.tables.nodes.append_declared(&whose, PROFILE, profile, model);
        self.tables.wear.append_declared(&whose, HOLE_WEAR, wear, model);
        if let Some(bottom) = bottom {
            BottomHoleCell::append_to(&mut self.tables.bottom_hole, bottom_cells(bottom, name));
        }
        if let Some(InTime { contact, history, .. }) = in_time {
            // Earlier rows are already in the table.
            let series = history.series();
            let whose: (&str, &[&str]) = ("operation", &[name]);
            self.tables.contact.append_declared(&[whose], CONTACT_MAP, contact, model);
            let notes = notes(&self.schedule, &series.schedule_line);
            self.tables.time.append_declared(
                &[whose, ("note", &notes)],
                TIME_SERIES,
                series,
                model,
            );
        }
        if let Some(in_time) = in_time {
            self.add_spectra(operation, &in_time, profile);
        }
    }

    /// Moves rows of a time history from a running operation to the disk as long as they fill a
    /// part, so that a run of hours needs no more memory than one of minutes.
    ///
    /// # Errors
    /// A part that cannot be written.
    pub(crate) fn take_rows(
        &mut self,
        folder: &ResultsFolder,
        operation: &Operation,
        simulation: &mut Simulation,
    ) -> Result<(), ResultsError> {
        while simulation.spare_rows() >= PART_ROWS {
            let series = simulation.series();
            let notes = notes(&self.schedule, &series.schedule_line[..PART_ROWS]);
            let words: [(&str, &[&str]); 2] =
                [("operation", &[operation.kind.name()]), ("note", &notes)];
            let model = ModelKind::Dynamic;
            self.tables.time.append_part(folder, |table| {
                table.append_first_declared(&words, TIME_SERIES, series, model, PART_ROWS);
            })?;
            simulation.hand_over(PART_ROWS);
        }
        Ok(())
    }

    /// Adds an operation without a solution, which has an entry without numbers in the summary and
    /// no rows in the tables.
    pub(crate) fn add_unsolved(&mut self, model: ModelKind, operation: &Operation, why: String) {
        self.summary.operations.push(OperationSummary {
            model,
            operation: operation.kind,
            status: Status::Failed(why),
            friction: Friction::of(&friction(&self.hole)),
            bit_depth_m: operation.bit_depth_m,
            checks: Vec::new(),
            unchecked: Vec::new(),
            scalars: Scalars::UNKNOWN,
            lift: None,
            hydraulics: None,
            at_rest: None,
            statistics: None,
            indicators: None,
            bit_table: None,
            numerics: None,
        });
    }

    /// Operations without a solution and the reasons, a line each; `None` if all are solved.
    pub(crate) fn unsolved(&self) -> Option<String> {
        let failed =
            self.summary.operations.iter().filter_map(|operation| match &operation.status {
                Status::Failed(why) => Some(format!("{}: {why}", operation.operation)),
                Status::Complete | Status::Interrupted => None,
            });
        let lines: Vec<String> = failed.collect();
        (!lines.is_empty()).then(|| lines.join("\n"))
    }

    /// Adds the spectra that the case requires; a window that ended before its first segment was
    /// full is one segment.
    fn add_spectra(&mut self, operation: &Operation, time: &InTime<'_>, profile: &Profile) {
        let history = time.history;
        let from = history.row_at(time.numerics.settle_s);
        let times = history.scalar(TIME, from);
        let count = times.count();
        let Some([first_s, last_s]) = ends(&times).filter(|_| count > 1) else {
            return;
        };
        let interval_s = (last_s - first_s) / (count - 1) as f64;
        // Rounding to whole steps may make the window one sample shorter.
        let segment = (self.records.spectrum_segment_s / interval_s).round() as usize;
        let spectra = &mut self.tables.spectra;
        let mut add = |name: &str, unit: &str, md_m: Option<f64>, samples: &dyn Samples| {
            let segment = segment.min(samples.count());
            if let Some(spectrum) = Spectrum::welch(samples, interval_s, segment) {
                let points = spectrum.frequency_Hz.iter().zip(&spectrum.density);
                spectra.append_rows(points.map(|(frequency_Hz, density)| SpectrumRow {
                    operation: operation.kind,
                    signal: name.to_owned(),
                    md_m,
                    unit: unit.to_owned(),
                    frequency_Hz: *frequency_Hz,
                    density: *density,
                }));
            }
        };
        for signal in &self.records.spectra {
            let samples = history.scalar(signal.column(), from);
            add(signal.name(), signal.unit(), None, &samples);
        }
        for probe in &history.series().probes {
            let md_m = profile.md_m[probe.node];
            let samples = &probe.samples[from..];
            add(probe.signal.name(), probe.signal.unit(), Some(md_m), &samples);
        }
    }
}

const TIME: &Column<TimeSeries> = Column::named(TIME_SERIES, "time_s");

/// Numerical settings and cost of a solution in time.
fn numerics(time: &InTime<'_>, effort: Effort) -> Numerics {
    let last_s = time.history.series().time_s.last().copied().unwrap_or(0.0);
    let simulated_s = last_s * effort.runs as f64;
    let wall_time_s = effort.took.as_secs_f64();
    Numerics {
        run: time.numerics.clone(),
        wall_time_s,
        real_time_factor: simulated_s / wall_time_s,
    }
}

/// Every cell of the bottom of an operation, ring after ring.
pub(crate) fn bottom_cells(
    bottom: &BottomHole,
    operation: &str,
) -> impl Iterator<Item = BottomHoleCell> {
    let cells = (0..bottom.rings())
        .flat_map(|ring| (0..bottom.sectors()).map(move |sector| (ring, sector)));
    cells.map(move |(ring, sector)| BottomHoleCell {
        operation: operation.to_owned(),
        radius_m: bottom.radius_m(ring),
        angle_rad: bottom.angle_rad(sector),
        depth_m: bottom.z_m(ring, sector),
    })
}

/// Note of the schedule line in effect at each row.
fn notes<'a>(schedule: &'a [ScheduleStep], lines: &[usize]) -> Vec<&'a str> {
    let note = |line: &usize| {
        let begun = schedule.get(..*line).unwrap_or_default();
        let notes = begun.iter().rev().map(|step| step.note.as_deref());
        notes.flatten().next().unwrap_or_default()
    };
    lines.iter().map(note).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cells_of_a_bottom_follow_each_other_ring_after_ring() {
        let mut bottom = BottomHole::new([0.02, 0.10], 4, 6);
        bottom.set_m(1, 2, -0.03);
        let cells: Vec<BottomHoleCell> = bottom_cells(&bottom, "drill").collect();
        assert_eq!(cells.len(), 24);
        assert_eq!(cells[6].radius_m, bottom.radius_m(1));
        assert_eq!(cells[8].angle_rad, bottom.angle_rad(2));
        let known: Vec<usize> = (0..24).filter(|cell| cells[*cell].depth_m.is_some()).collect();
        assert_eq!((known, cells[8].depth_m), (vec![8], Some(-0.03)));
    }
}

//! `[[operation.schedule]]`: set points against time.

use std::f64::consts::PI;

use wholestring::{
    dynamics::{HoistSetPoint, Schedule, ScheduleFault, ScheduleStep},
    operation::OperationKind,
    outcome::ModelKind,
};
use wholestring_config::prelude::*;

table! {
    /// A line of the schedule: a change, its time and its ramp. Set points that it does not name
    /// are unchanged.
    StepTable in "[[operation.schedule]]" {
        /// Time at which it begins, from time zero of the run (`settle` and `duration` are counted
        /// from there, too). Set points of lines at 0 s without a ramp apply from the start: the
        /// string is initialised with that motion.
        at: f64 = required(Quantity::si(
            Dimension::Time,
            Range::from_to(0.0, 172_800.0),
            "30 s",
        ));
        /// Time in which the set points change to their new values, linearly. Raising it starts and
        /// stops more gently.
        ramp: f64 = default(ramp_rule(), 0.0);
        /// Rotary speed at surface; a bare number is in rev/min.
        rpm: f64 = optional(rotary_speed_rule());
        /// Speed of the block, positive downwards.
        block_velocity: f64 = optional(block_velocity_rule());
        /// Weight on bit of the autodriller, with the gain, filter and limits of [hoist].
        wob: f64 = optional(weight_rule());
        /// Flow rate of the pumps; the pressure drop of the bit changes with its square. It acts on
        /// a mud with a rheology.
        flow_rate: f64 = optional(flow_rate_rule());
        /// Name of the line in the table against time.
        note: String = optional(Text);
    }
}

fn ramp_rule() -> Quantity {
    Quantity::si(Dimension::Time, Range::from_to(0.0, 86_400.0), "10 s")
}

fn rotary_speed_rule() -> Quantity {
    let range = Range::from_to(0.0, 1000.0 * PI / 30.0);
    Quantity::si(Dimension::RotarySpeed, range, "60 rpm").bare("rev/min", PI / 30.0)
}

fn block_velocity_rule() -> Quantity {
    Quantity::si(Dimension::TripSpeed, Range::from_to(-10.0, 10.0), "-0.3 m/s")
}

fn weight_rule() -> Quantity {
    Quantity::si(Dimension::Force, Range::from_to(0.0, 5e6).usual(1e3, 7e5), "80 kN")
}

fn flow_rate_rule() -> Quantity {
    let range = Range::from_to(0.0, 0.5).usual(5e-4, 0.15);
    Quantity::si(Dimension::FlowRate, range, "2000 L/min")
}

/// Returns the reason why a line that is added to the schedule of a run in progress is refused: a
/// set point or a ramp that a case could not have. It is checked by the rule of the case's own key,
/// so that both have the same limits.
///
/// ```
/// use wholestring::dynamics::ScheduleStep;
/// use wholestring_case::refused_set_point;
///
/// let fast = ScheduleStep { rotary_speed_rad_per_s: Some(120.0), ..ScheduleStep::default() };
/// assert_eq!(
///     refused_set_point(&fast).as_deref(),
///     Some("rotary speed of 1145.916 rev/min: expected 0 to 1000 rev/min"),
/// );
/// ```
pub fn refused_set_point(line: &ScheduleStep) -> Option<String> {
    let (velocity, weight) = match line.hoist {
        Some(HoistSetPoint::BlockVelocity(velocity)) => (Some(velocity), None),
        Some(HoistSetPoint::WeightOnBit(weight)) => (None, Some(weight)),
        None => (None, None),
    };
    [
        ("ramp", Some(line.ramp_s), ramp_rule()),
        ("rotary speed", line.rotary_speed_rad_per_s, rotary_speed_rule()),
        ("block velocity", velocity, block_velocity_rule()),
        ("weight on bit", weight, weight_rule()),
        ("flow rate", line.flow_rate_m3_per_s, flow_rate_rule()),
    ]
    .into_iter()
    .find_map(|(name, value, rule)| Some(format!("{name} of {}", rule.refusal(value?)?)))
}

/// Inputs that a schedule is checked against.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Around<'a> {
    /// The operations that it may belong to.
    pub(crate) kinds: &'a [Spanned<OperationKind>],
    /// The models that solve them.
    pub(crate) models: &'a [ModelKind],
    /// The operation's weight on bit, N.
    pub(crate) wob_N: Option<f64>,
    /// End of the run, s.
    pub(crate) end_s: Option<f64>,
}

/// Builds the schedule of the lines.
pub(crate) fn build(
    lines: &Spanned<Vec<Spanned<StepTable>>>,
    around: &Around<'_>,
    reader: &mut Reader,
) -> Option<Schedule> {
    let mut valid = true;
    let mut steps = Vec::new();
    for line in &lines.value {
        match step(line, around, reader) {
            Some(step) => steps.push(step),
            None => valid = false,
        }
    }
    if let [_, second, ..] = around.kinds {
        Diagnostic::error("a schedule belongs to one operation")
            .at(second.place, "this is another one")
            .at(lines.value[0].place, "the schedule")
            .help("put each operation with its schedule into a case of its own")
            .report(reader);
        valid = false;
    }
    if !valid {
        return None;
    }
    let schedule = Schedule { steps };
    if let Some((index, fault)) = schedule.fault() {
        return fault_at(index, fault, &lines.value).refuse(reader);
    }
    if let Some(at_rest) = around.models.iter().find(|model| !model.in_time()) {
        let name = at_rest.method().long_name;
        let message = match ModelKind::any_in_time(around.models) {
            true => format!("the {name} does not follow the schedule"),
            false => "the schedule has no effect here".to_owned(),
        };
        Diagnostic::warning(message)
            .at(lines.value[0].place, "used by the dynamic model")
            .help(format!("the {name} solves the operation with its own set points"))
            .report(reader);
    }
    warn_of_late_lines(&lines.value, around.end_s, reader);
    Some(schedule)
}

fn step(
    line: &Spanned<StepTable>,
    around: &Around<'_>,
    reader: &mut Reader,
) -> Option<ScheduleStep> {
    let table = &line.value;
    let rpm = table.rpm.optional()?;
    let velocity = table.block_velocity.optional()?;
    let wob = table.wob.optional()?;
    let flow = table.flow_rate.optional()?;
    let note = table.note.optional()?.map(|at| at.value.clone());
    if let (Some(velocity), Some(wob)) = (velocity, wob) {
        return Diagnostic::error("the hoist cannot keep a weight and a speed at the same time")
            .at(wob.place, "the autodriller holds this weight")
            .at(velocity.place, "the block moves at this speed")
            .help("give one of `wob` and `block_velocity`")
            .refuse(reader);
    }
    // A misspelt key has been reported.
    let empty = [rpm, velocity, wob, flow].iter().all(Option::is_none) && note.is_none();
    if empty && !reader.has_errors() {
        return Diagnostic::error("this line of the schedule changes nothing")
            .at(line.place, "expected rpm, block_velocity, wob, flow_rate or a note")
            .refuse(reader);
    }
    if let (Some(rpm), Some(kind)) = (rpm, around.kinds.first())
        && !kind.value.rotates()
        && rpm.value > 0.0
    {
        return Diagnostic::error(format!("`{}` does not turn the string", kind.value.name()))
            .at(rpm.place, "expected no rpm, or 0")
            .at(kind.place, "the operation")
            .help(
                "operations that rotate: \"rotate_off_bottom\", \"drill\", \"ream\" or \
                 \"back_ream\"; its schedule may begin with rpm = 0",
            )
            .refuse(reader);
    }
    if let (Some(wob), Some(kind)) = (wob, around.kinds.first())
        && (!kind.value.on_bottom() || around.wob_N == Some(0.0))
    {
        return Diagnostic::error(format!("`{}` has no weight on its bit", kind.value.name()))
            .at(wob.place, "the autodriller would have no weight to hold")
            .at(kind.place, "the operation")
            .help(
                "operations on bottom: \"drill\" or \"slide\", with a `wob` of its own; its \
                 schedule may begin with a block_velocity",
            )
            .refuse(reader);
    }
    Some(ScheduleStep {
        at_s: *table.at.get()?,
        ramp_s: *table.ramp.get()?,
        rotary_speed_rad_per_s: rpm.map(|at| at.value),
        hoist: velocity
            .map(|at| HoistSetPoint::BlockVelocity(at.value))
            .or(wob.map(|at| HoistSetPoint::WeightOnBit(at.value))),
        flow_rate_m3_per_s: flow.map(|at| at.value),
        note,
    })
}

fn fault_at(index: usize, fault: ScheduleFault, lines: &[Spanned<StepTable>]) -> Diagnostic {
    let line = &lines[index];
    let at = line.value.at.at().map_or(line.place, |at| at.place);
    let above = index.checked_sub(1).and_then(|above| lines[above].value.at.at());
    match (fault, above) {
        (ScheduleFault::Order, Some(above)) => {
            Diagnostic::error("the lines of the schedule must continue in time")
                .at(at, format!("expected {} s or later", number_text(above.value)))
                .at(above.place, "the line above begins here")
        }
        (ScheduleFault::Ramping(what), _) => {
            let before = lines[..index].iter().rev();
            let before = before.filter(|line| names(&line.value, what));
            let diagnostic = Diagnostic::error(format!("two lines set {what} at the same time"))
                .at(at, "begins before the line that set it last has ended");
            match before.filter_map(|line| line.value.at.at()).next() {
                Some(before) => diagnostic.at(before.place, "which began here"),
                None => diagnostic,
            }
        }
        _ => Diagnostic::error(fault.to_string()).at(at, "this line"),
    }
}

/// Whether a line sets the set point of a fault.
fn names(line: &StepTable, what: &str) -> bool {
    match what {
        "rpm" => line.rpm.given().is_some(),
        "flow_rate" => line.flow_rate.given().is_some(),
        _ => line.block_velocity.given().is_some() || line.wob.given().is_some(),
    }
}

fn warn_of_late_lines(lines: &[Spanned<StepTable>], end_s: Option<f64>, reader: &mut Reader) {
    let Some(end_s) = end_s else { return };
    let late = lines.iter().filter_map(|line| line.value.at.at()).find(|at| at.value >= end_s);
    if let Some(at) = late {
        let place: Span = at.place;
        Diagnostic::warning("the run ends before this line of the schedule begins")
            .at(place, format!("the run ends at {} s", number_text(end_s)))
            .help("it lasts for settle and duration of [dynamics]")
            .report(reader);
    }
}

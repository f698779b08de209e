//! `[operation]`.

pub(crate) mod kind;
pub(crate) mod schedule;

use std::f64::consts::PI;

use wholestring::{
    dynamics::{BitSettings, Schedule},
    mud::Mud,
    operation::{Operation, OperationKind},
    outcome::ModelKind,
};
use wholestring_config::prelude::*;

use crate::{
    bit::{BitTable, Given},
    operation::{
        kind::KindRule,
        schedule::{Around, StepTable},
    },
};

/// Default `rop` of a slide, m/s; the soft string requires its sign only.
const SLIDE_ROP_M_PER_S: f64 = 10.0 / 3600.0;

table! {
    /// The driller's operation.
    OperationTable in "[operation]" {
        /// One operation by its name, or a list that is solved one by one. Drillers' words are also
        /// accepted: "pick-up" and "POOH" for "trip_out", "slack-off" and "RIH" for "trip_in",
        /// "rotating off bottom", "sliding", "back-reaming".
        kind: Vec<Spanned<OperationKind>> = required(List::or_one(
            KindRule, "operations", OperationKind::ALL.len(),
        ));
        /// Measured depth of the bit, m unless a unit is given. Default: the last survey station.
        /// Below that, the hole continues in its last direction.
        bit_depth: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::positive_to(20_000.0).usual(10.0, 13_000.0),
            "4305 m",
        ));
        /// Rotary speed at surface; a bare number is in rev/min. Needed by the operations that
        /// rotate.
        rpm: f64 = optional(
            Quantity::si(
                Dimension::RotarySpeed,
                Range::from_to(0.0, 1000.0 * PI / 30.0).usual(10.0 * PI / 30.0, 400.0 * PI / 30.0),
                "70 rpm",
            )
            .bare("rev/min", PI / 30.0),
        );
        /// Weight on bit. Needed by "drill" and "slide".
        wob: f64 = optional(Quantity::si(
            Dimension::Force,
            Range::from_to(0.0, 5e6).usual(1e3, 7e5),
            "6 tf",
        ));
        /// Pull on the bit while it is off bottom: the force with which a stuck bit, a fish or a
        /// core holds the string back. Tension at the bit; the overpull at the surface is larger
        /// because of the friction that it adds on the way. Raising it raises the hook load.
        /// Default: none.
        bit_pull: f64 = default(
            Quantity::si(Dimension::Force, Range::from_to(0.0, 1e7).usual(1e3, 3e6), "200 kN"),
            0.0,
        );
        /// Rate of penetration at this weight on bit and rotary speed. Needed by "drill", and by
        /// "slide" in the dynamic model; all laws of the bit except the rate law compute their own.
        rop: f64 = optional(Quantity::si(
            Dimension::RateOfPenetration,
            Range::positive_to(0.3).usual(0.1 / 3600.0, 200.0 / 3600.0),
            "10 m/h",
        ));
        /// Axial speed of tripping and reaming.
        trip_speed: f64 = default(
            Quantity::si(Dimension::TripSpeed, Range::positive_to(10.0).usual(0.003, 3.0), "0.3 m/s"),
            Operation::TRIP_SPEED_M_PER_S,
        );
        /// Flow rate of the pumps, which are off while the string trips without rotation. It acts
        /// on a mud with a rheology: raising it raises the pressure losses and the lift of the
        /// flow, which lowers the hook load. It turns the motor of `[bit.motor]`: raising it turns
        /// the bit faster.
        flow_rate: f64 = default(
            Quantity::si(Dimension::FlowRate, Range::from_to(0.0, 0.5).usual(5e-4, 0.15), "2000 L/min"),
            0.0,
        );
        /// Pressure drop of the bit's nozzles at this flow rate. Raising it lifts the string with
        /// the thrust of the jets and lengthens it with the pressure inside.
        bit_pressure_drop: f64 = default(
            Quantity::si(Dimension::Pressure, Range::from_to(0.0, 1e8).usual(1e5, 4e7), "80 bar"),
            0.0,
        );
        /// Changes by the driller during a dynamic run, line by line in the order of time. Only a
        /// single operation can have a schedule.
        schedule: Vec<Spanned<StepTable>> = optional(List::tables::<StepTable>(
            "lines ([[operation.schedule]])", 5000,
        ));
    }
}

impl OperationTable {
    /// Place of the depth of the bit, if the case gives it.
    pub(crate) fn bit_depth_place(&self) -> Option<Span> {
        self.bit_depth.given().map(|at| at.place)
    }

    /// Returns the depth of the bit: given, or the last station's.
    pub(crate) fn bit_depth_m(&self, last_station_m: Option<f64>) -> Option<f64> {
        match self.bit_depth.optional()? {
            Some(at) => Some(at.value),
            None => last_station_m,
        }
    }

    /// Returns the schedule of a run that ends at `end_s`.
    pub(crate) fn schedule(
        &self,
        models: &[ModelKind],
        end_s: Option<f64>,
        reader: &mut Reader,
    ) -> Option<Schedule> {
        let Some(lines) = self.schedule.optional()? else {
            return Some(Schedule::default());
        };
        let around = Around {
            kinds: self.kind.get()?,
            models,
            wob_N: self.wob.optional()?.map(|at| at.value),
            end_s,
        };
        schedule::build(lines, &around, reader)
    }

    /// Warns of a flow without effect.
    pub(crate) fn check_flow(
        &self,
        mud: &Mud,
        turns_motor: bool,
        reader: &mut Reader,
    ) -> Option<()> {
        let flowing = *self.flow_rate.get()? > 0.0;
        let circulates = |kind: &Spanned<OperationKind>| kind.value.circulates();
        let (turns, acts) = (turns_motor, "acts on a mud with a rheology");
        let still = mud.rheology.is_none();
        let why = if still && !turns {
            acts
        } else if !self.kind.get()?.iter().any(circulates) {
            "the pumps rest while the string trips"
        } else {
            ""
        };
        let keys = [
            (&self.flow_rate, "flow_rate", why),
            (
                &self.bit_pressure_drop,
                "bit_pressure_drop",
                if why.is_empty() && !flowing {
                    "needs a flow_rate"
                } else if still {
                    acts
                } else {
                    why
                },
            ),
        ];
        for (field, name, why) in keys {
            if let (Some(entry), false) = (field.given(), why.is_empty()) {
                reader.report(Diagnostic::idle(name, entry.place, why));
            }
        }
        let lines = self.schedule.optional()?.map_or(&[][..], |at| &at.value);
        let scheduled = lines.iter().find_map(|line| line.value.flow_rate.given());
        if let (Some(entry), false) = (scheduled, why.is_empty()) {
            reader.report(Diagnostic::idle("flow_rate", entry.place, why));
        }
        Some(())
    }

    /// Warns of operations that rotate coiled tubing, which an injector head does not.
    pub(crate) fn check_injector(&self, reader: &mut Reader) {
        let kinds = self.kind.get().map_or(&[][..], |kinds| kinds);
        let Some(turning) = kinds.iter().find(|kind| kind.value.rotates()) else { return };
        Diagnostic::warning("an injector head does not rotate coiled tubing")
            .at(turning.place, format!("{} rotates the string", turning.value.words()))
            .help(
                "`snubbing_force` and a string without joints are those of coiled tubing: it \
                 drills with \"slide\"; pipe that has joints needs `joint_od`",
            )
            .report(reader);
    }

    /// Warns of a pull on a bit that is on bottom all the time.
    fn check_pull(&self, kinds: &[Spanned<OperationKind>], reader: &mut Reader) {
        if let Some(entry) = self.bit_pull.given()
            && kinds.iter().all(|kind| kind.value.on_bottom())
        {
            let why = "used off bottom: on bottom the bit has its `wob`";
            reader.report(Diagnostic::idle("bit_pull", entry.place, why));
        }
    }

    /// Builds the operations, with the set points that each needs.
    pub(crate) fn build(
        &self,
        bit: (&BitTable, Option<&BitSettings>),
        models: &[ModelKind],
        bit_depth_m: Option<f64>,
        reader: &mut Reader,
    ) -> Option<Vec<Operation>> {
        let kinds = self.kind.get()?;
        let (table, bit) = bit;
        let law = table.law_keys();
        let by_rate = law.is_some_and(|law| law.finds_rate().is_none());
        once_each(kinds, OperationKind::name, reader)?;
        self.check_pull(kinds, reader);
        let find = |matches: fn(OperationKind) -> bool| kinds.iter().find(|at| matches(at.value));
        let rotating = find(OperationKind::rotates);
        let on_bottom = find(OperationKind::on_bottom);
        let in_time = ModelKind::any_in_time(models);
        let advances =
            |kind: OperationKind| by_rate && kind.on_bottom() && (kind.rotates() || in_time);
        let advancing = kinds.iter().find(|at| advances(at.value));
        let rpm = set_point(&self.rpm, "rpm", "rpm = 70", rotating, reader);
        let wob = set_point(&self.wob, "wob", "wob = \"60 kN\"", on_bottom, reader);
        let rop = set_point(&self.rop, "rop", "rop = \"10 m/h\"", advancing, reader);
        if let (Some(kind), Some(at)) = (rotating, self.rpm.given())
            && at.value == 0.0
        {
            return Diagnostic::error(format!(
                "`{}` turns the string, but rpm is 0",
                kind.value.name()
            ))
            .at(at.place, "expected more than 0")
            .at(kind.place, "turns the string")
            .help("without rotation it is \"slide\", \"trip_in\" or \"trip_out\"")
            .refuse(reader);
        }
        let torque_N_m = law.map_or(Some(None), |law| law.torque_N_m())?;
        if let (Some(kind), None, true) = (on_bottom, torque_N_m, by_rate) {
            Diagnostic::warning("no bit torque is given: the bit is assumed to turn freely")
                .at(kind.place, "puts the bit on bottom")
                .help("give torque = \"3 kN.m\" under [bit]")
                .report(reader);
        }
        let trip_speed = *self.trip_speed.get()?;
        let bit_pull = *self.bit_pull.get()?;
        let flow_rate = *self.flow_rate.get()?;
        let bit_pressure_drop = *self.bit_pressure_drop.get()?;
        let (rpm, wob, rop) = (rpm?, wob?, rop?);
        let bit = bit?;
        if let (Some(kind), false) = (find(|kind| kind == OperationKind::Slide), table.has_motor())
            && bit.needs_motor_speed()
        {
            return Diagnostic::error("`slide` needs the speed at which the motor turns this bit")
                .at(kind.place, "`motor_speed` is missing in [bit]")
                .help("such as motor_speed = 120")
                .refuse(reader);
        }
        let set_points =
            Given { rpm: self.rpm.given(), wob: self.wob.given(), rop: self.rop.given() };
        law?.warn_of_set_points(&bit.law, &set_points, reader);
        let bit_depth_m = bit_depth_m?;
        let operation = |at: &Spanned<OperationKind>| {
            bit.drilling_steadily(Operation {
                kind: at.value,
                bit_depth_m,
                rotary_speed_rad_per_s: rpm.unwrap_or(0.0),
                weight_on_bit_N: wob.unwrap_or(0.0),
                bit_pull_N: bit_pull,
                bit_torque_N_m: torque_N_m.unwrap_or(0.0),
                rate_of_penetration_m_per_s: rop.unwrap_or(SLIDE_ROP_M_PER_S),
                trip_speed_m_per_s: trip_speed,
                flow_rate_m3_per_s: flow_rate,
                bit_pressure_drop_Pa: bit_pressure_drop,
                motor_pressure_drop_Pa: 0.0,
            })
        };
        let operations: Vec<Operation> = kinds.iter().map(operation).collect();
        for operation in operations.iter().filter(|o| o.kind.on_bottom()) {
            law?.check_operation(bit, operation, &set_points, reader)?;
            set_points.warn_of_motor(bit, operation, reader);
        }
        Some(operations)
    }
}

/// Returns a set point, reported if the case has an operation that needs it; `None` after a
/// mistake.
fn set_point(
    field: &Field<f64>,
    name: &str,
    example: &str,
    needed_by: Option<&Spanned<OperationKind>>,
    reader: &mut Reader,
) -> Option<Option<f64>> {
    let value = field.optional()?;
    if let (None, Some(kind)) = (value, needed_by) {
        return Diagnostic::error(format!("`{}` needs `{name}`", kind.value.name()))
            .at(kind.place, format!("`{name}` is missing in [operation]"))
            .help(format!("such as {example}"))
            .refuse(reader);
    }
    Some(value.map(|at| at.value))
}

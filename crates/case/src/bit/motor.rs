//! `[bit.motor]`.

use wholestring::dynamics::MudMotor;
use wholestring_config::prelude::*;

/// Defaults: part of the flow that leaks at the largest pressure drop, part of the ideal torque,
/// and the stall torque over that at the largest pressure drop.
const SLIP: f64 = 0.1;
const EFFICIENCY: f64 = 0.8;
const STALL: f64 = 1.5;

table! {
    /// A positive displacement motor between string and bit. Its speed is proportional to the flow
    /// and falls with the torque, until it stalls. It needs `displacement` and
    /// `max_differential_pressure`.
    MotorTable in "[bit.motor]" {
        /// Volume of mud that turns it once. Raising it slows it and strengthens it.
        displacement: f64 = optional(Quantity::si(
            Dimension::Volume,
            Range::positive_to(1.0).usual(2e-4, 0.2),
            "12 L",
        ));
        /// Largest rated pressure drop. Raising it keeps the speed up to a larger torque.
        max_differential_pressure: f64 = optional(Quantity::si(
            Dimension::Pressure,
            Range::positive_to(1e8).usual(2e5, 3e7),
            "80 bar",
        ));
        /// Part of the rated flow that leaks past the rotor at that pressure, which slows the
        /// motor. Raising it makes the speed fall faster with the torque.
        slip: f64 = default(
            Number { unit: "", range: Range::from_to(0.0, 0.9) },
            SLIP,
        );
        /// Part of the ideal torque, displacement times pressure over 2 pi, that reaches the bit.
        /// Raising it lowers the pressure for the same torque.
        efficiency: f64 = default(
            Number { unit: "", range: Range::from_to(0.05, 1.0) },
            EFFICIENCY,
        );
        /// Torque at which the motor stalls at the rated flow, its upper limit. Default: 1.5 times
        /// the torque at the largest pressure drop.
        stall_torque: f64 = optional(Quantity::si(
            Dimension::Torque,
            Range::positive_to(1e6).usual(50.0, 1e5),
            "12 kN.m",
        ));
        /// Flow at which slip and stall were measured. Default: the operation's flow_rate.
        rated_flow: f64 = optional(Quantity::si(
            Dimension::FlowRate,
            Range::positive_to(0.5).usual(5e-4, 0.15),
            "2000 L/min",
        ));
    }
}

impl MotorTable {
    /// Returns the motor with the flow of the pumps of the case.
    pub(super) fn build(
        &self,
        place: Span,
        flow_m3_per_s: Option<f64>,
        reader: &mut Reader,
    ) -> Option<MudMotor> {
        let displacement_m3 = needed(&self.displacement, "displacement", "\"12 L\"", place, reader);
        let max_pressure_Pa = needed(
            &self.max_differential_pressure,
            "max_differential_pressure",
            "\"80 bar\"",
            place,
            reader,
        );
        let flow = flow_m3_per_s?;
        if flow == 0.0 {
            return Diagnostic::error("nothing flows through the motor")
                .at(place, "`flow_rate` is missing in [operation]")
                .help("such as flow_rate = \"2000 L/min\"")
                .refuse(reader);
        }
        let mut motor = MudMotor {
            displacement_m3: displacement_m3?,
            rated_flow_m3_per_s: self.rated_flow.optional()?.map_or(flow, |at| at.value),
            max_pressure_Pa: max_pressure_Pa?,
            slip: *self.slip.get()?,
            efficiency: *self.efficiency.get()?,
            stall_torque_N_m: 0.0,
        };
        let most = motor.max_torque_N_m();
        let stall = self.stall_torque.optional()?;
        motor.stall_torque_N_m = stall.map_or(STALL * most, |at| at.value);
        if let Some(stall) = stall.filter(|stall| stall.value <= most) {
            let most = reader.at_least(Dimension::Torque, most);
            reader.report(stalls_early(stall, &most));
            return None;
        }
        Some(motor)
    }
}

fn stalls_early(stall: &Spanned<f64>, most: &str) -> Diagnostic {
    Diagnostic::error("the motor stalls below its largest pressure drop")
        .at(stall.place, format!("expected more than {most}"))
        .help("that is efficiency * displacement * max_differential_pressure / 2 pi")
}

/// Returns a key that the motor requires.
fn needed(
    field: &Field<f64>,
    name: &str,
    example: &str,
    place: Span,
    reader: &mut Reader,
) -> Option<f64> {
    let value = field.optional()?;
    if value.is_none() {
        reader.report(
            Diagnostic::error(format!("[bit.motor] lacks `{name}`"))
                .at(place, format!("`{name}` is missing"))
                .help(format!("such as {name} = {example}")),
        );
    }
    value.map(|at| at.value)
}

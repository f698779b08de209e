//! `[mud]`.

use wholestring::mud::Mud;
use wholestring_units::Dimension;

use crate::{
    quantity::Quantity,
    range::{Number, Range},
    table::{default, required, table},
};

table! {
    /// Drilling fluid, the same inside the string and in the annulus.
    MudTable in "[mud]" {
        /// Density, kg/m3 unless a unit is given; 0 is air. Raising it makes the string lighter and
        /// its lateral inertia larger.
        density: f64 = required(Quantity::si(
            Dimension::Density,
            Range::from_to(0.0, 3000.0),
            "1.2 sg",
        ));
        /// Linear lateral drag: force per length of pipe per lateral speed, Pa.s. Zero leaves it to
        /// the mass-proportional part of the Rayleigh damping. Raising it calms lateral vibration.
        /// Only the dynamic model uses it.
        linear_drag: f64 = default(
            Quantity::si(Dimension::Viscosity, Range::from_to(0.0, 1e4), "5 Pa.s"),
            0.0,
        );
        /// Quadratic lateral drag coefficient of the pipe as a cylinder on its outside diameter. A
        /// smooth cylinder across a stream has 1 at Reynolds numbers from 1e3 to 1e5. Only the
        /// dynamic model uses it.
        drag_coefficient: f64 = default(
            Number { unit: "", range: Range::from_to(0.0, 100.0) },
            1.0,
        );
    }
}

impl MudTable {
    pub(crate) fn build(&self) -> Option<Mud> {
        Some(Mud {
            rheology: None,
            density_kg_per_m3: *self.density.get()?,
            linear_drag_Pa_s: *self.linear_drag.get()?,
            drag_coefficient: *self.drag_coefficient.get()?,
        })
    }
}

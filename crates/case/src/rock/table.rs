//! The keys of `[rock]`.

use wholestring_config::prelude::*;

/// Default factor on the density.
const DENSITY_FACTOR: f64 = 400.0;

pub(super) const DEGREE: f64 = std::f64::consts::PI / 180.0;

fn pressure(range: Range, example: &'static str) -> Quantity {
    Quantity::si(Dimension::Pressure, range, example)
}

fn stress(range: Range, example: &'static str) -> Quantity {
    Quantity::si(Dimension::Stress, range, example)
}

fn angle(range: Range, example: &'static str) -> Quantity {
    Quantity::si(Dimension::Angle, range, example).bare("deg", DEGREE)
}

fn toughness(example: &'static str) -> Quantity {
    Quantity::si(Dimension::FractureEnergy, Range::positive_to(1e8), example)
}

fn length(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Diameter, Range::positive_to(5.0), example)
}

table! {
    /// The solid rock under the bit: of the law "rock" and of a bit test. Only its strength or its
    /// cohesion is required; the other defaults are typical of sandstone and limestone.
    RockTable in "[rock]" {
        /// Unconfined compressive strength. Raising it slows the bit down.
        strength: f64 = optional(stress(Range::from_to(1e5, 1e9).usual(1e6, 6e8), "60 MPa"));
        /// In place of the strength: cohesion of Mohr and Coulomb.
        cohesion: f64 = optional(stress(Range::from_to(1e4, 1e9).usual(1e5, 2e8), "15 MPa"));
        /// Friction angle of Mohr and Coulomb; a bare number is in deg. Raising it increases the
        /// gain of strength with confinement.
        friction_angle: f64 = default(
            angle(Range::from_to(DEGREE, 70.0 * DEGREE), "35 deg"),
            35.0 * DEGREE,
        );
        /// Dilation angle, at most the friction angle; a bare number is in deg. Raising it lets
        /// sheared rock swell and wedge itself. Default: 10 deg, or the friction angle where that
        /// is less.
        dilation_angle: f64 = optional(angle(Range::from_to(0.0, 70.0 * DEGREE), "10 deg"));
        /// Young's modulus. Raising it makes the rock stiffer and more brittle, shortens its steps,
        /// and raises the work per drilled volume: 1.3 times at twice the default, for which
        /// `crushing_energy` is calibrated. Default: 300 times the strength.
        youngs_modulus: f64 = optional(stress(Range::from_to(1e7, 1e12).usual(1e8, 2e11), "18 GPa"));
        /// Poisson's ratio.
        poisson_ratio: f64 = default(Number { unit: "", range: Range::from_to(0.0, 0.45) }, 0.25);
        /// Density. Raising it lengthens the rock's steps.
        density: f64 = default(
            Quantity::si(Dimension::Density, Range::from_to(500.0, 10_000.0).usual(1000.0, 5000.0), "2500 kg/m3"),
            2500.0,
        );
        /// Strength in uniaxial tension. Raising it leaves less to chip and more to crush. Default:
        /// a tenth of the strength.
        tensile_strength: f64 = optional(stress(Range::from_to(1e3, 1e9).usual(1e5, 1e8), "6 MPa"));
        /// Least energy of failure per volume, in tension and in compression. Raising it raises the
        /// bit's work per drilled volume about in proportion. Default: 0.085 of the strength, with
        /// which that work is about the strength.
        crushing_energy: f64 = optional(stress(Range::positive_to(1e9), "5 MJ/m3"));
        /// Energy of a tensile crack per area. Elements of more than some millimetres are crushed
        /// throughout, so that it has no effect on them. Default: 80 J/m2.
        tensile_fracture_energy: f64 = optional(toughness("80 J/m2"));
        /// Energy of a crushed band per area. The default, 2 mm times `crushing_energy`, has no
        /// effect on elements of more than 2 mm.
        compressive_fracture_energy: f64 = optional(toughness("8 kJ/m2"));
        /// Pressure of the mud at the bottom over that in the rock's pores. Raising it strengthens
        /// the rock.
        pressure: f64 = default(pressure(Range::from_to(0.0, 5e8).usual(1e4, 3e8), "10 MPa"), 0.0);
        /// Initial pressure in the rock across the hole, over that in its pores. Default: that of
        /// the mud.
        confinement: f64 = optional(pressure(Range::from_to(0.0, 5e8).usual(1e4, 3e8), "15 MPa"));
        /// Friction between bit and rock. Raising it drags more rock along.
        friction: f64 = default(Number { unit: "", range: Range::from_to(0.0, 2.0) }, 0.3);
        /// Edge of the elements. Halving it costs eight times the elements and twice the steps.
        /// Default: an eighteenth of the bit's diameter, or one and a half times the exposure of
        /// the cutters above its body where that is less.
        element_size: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::from_to(5e-4, 0.2).usual(5e-4, 0.1),
            "12 mm",
        ));
        /// Factor on the density of the elements, for longer steps: twenty times the step at 400.
        /// Raising it makes a run faster, until the rock's inertia affects the forces; a warning
        /// gives the limit.
        density_factor: f64 = default(
            Number { unit: "", range: Range::from_to(1.0, 1e6) },
            DENSITY_FACTOR,
        );
        /// Width of rock on each side of the bit. Default: an eighth of its diameter, two elements
        /// at least.
        beside: f64 = optional(length("27 mm"));
        /// Rock below the bit. Default: a quarter of its diameter, four elements at least.
        below: f64 = optional(length("54 mm"));
    }
}

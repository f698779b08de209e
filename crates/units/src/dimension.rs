//! The dimensions that a drill string's description needs.

use crate::{Unit, UnitSet, print, symbol, table};

/// What a quantity measures.
///
/// Dimensions that are the same to a physicist but not to an engineer are kept apart, because
/// people write and print them in different units: lengths and diameters, a rate of penetration
/// and a tripping speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Dimension {
    /// Depths and lengths along the hole or the string, m.
    Length,
    /// Diameters and other lengths across the hole, m.
    Diameter,
    /// Hook loads, tensions, weights on bit, N.
    Force,
    /// Torques and bending moments, N·m.
    Torque,
    /// Pressures, stresses, moduli, Pa.
    Pressure,
    /// Densities of mud and material, kg/m³.
    Density,
    /// Weights of pipe, as mass per length, kg/m.
    MassPerLength,
    /// Side forces and weights, as force per length, N/m.
    ForcePerLength,
    /// Rotary speeds, rad/s.
    RotarySpeed,
    /// Rates of penetration, m/s.
    RateOfPenetration,
    /// Speeds of tripping and of the travelling block, m/s.
    TripSpeed,
    /// Inclinations, azimuths, tool faces, rad.
    Angle,
    /// Curvatures of the hole, rad/m.
    DoglegSeverity,
    /// Stiffnesses of contacts and springs, N/m.
    Stiffness,
    /// Viscous damping against velocity, N·s/m.
    Damping,
    /// Viscosities, Pa·s.
    Viscosity,
    /// Consistency indices of power-law fluids, Pa·sⁿ.
    Consistency,
    /// Yield points and shear stresses of fluids, Pa.
    ShearStress,
    /// Flow rates of pumps, m³/s.
    FlowRate,
    /// Volumes, m³.
    Volume,
    /// Dissipation of an impact per velocity (Hunt and Crossley), s/m.
    DissipationTime,
    /// Velocity of the hoist per error of force, m/s/N.
    HoistGain,
    /// Durations, s.
    Time,
    /// Rates and cycles per time, 1/s.
    Frequency,
    /// Masses, kg.
    Mass,
    /// Moments of inertia about an axis, kg·m².
    MomentOfInertia,
    /// Torque per rotary speed, N·m·s.
    RotaryDamping,
    /// Energies that cracks take per area, J/m².
    FractureEnergy,
}

impl Dimension {
    /// Every dimension.
    pub const ALL: &[Dimension] = &[
        Dimension::Length,
        Dimension::Diameter,
        Dimension::Force,
        Dimension::Torque,
        Dimension::Pressure,
        Dimension::Density,
        Dimension::MassPerLength,
        Dimension::ForcePerLength,
        Dimension::RotarySpeed,
        Dimension::RateOfPenetration,
        Dimension::TripSpeed,
        Dimension::Angle,
        Dimension::DoglegSeverity,
        Dimension::Stiffness,
        Dimension::Damping,
        Dimension::Viscosity,
        Dimension::Consistency,
        Dimension::ShearStress,
        Dimension::FlowRate,
        Dimension::Volume,
        Dimension::DissipationTime,
        Dimension::HoistGain,
        Dimension::Time,
        Dimension::Frequency,
        Dimension::Mass,
        Dimension::MomentOfInertia,
        Dimension::RotaryDamping,
        Dimension::FractureEnergy,
    ];

    /// The SI unit at the end of a name in files for machines, such as `N_per_m`.
    ///
    /// ```
    /// use wholestring_units::Dimension;
    ///
    /// assert_eq!(Dimension::HoistGain.suffix(), "m_per_s_per_N");
    /// assert_eq!(Dimension::Consistency.suffix(), "Pa_s_n");
    /// assert_eq!(Dimension::Frequency.suffix(), "per_s");
    /// ```
    pub fn suffix(self) -> String {
        let symbol = self.si_symbol();
        let symbol = symbol.strip_prefix('1').unwrap_or(symbol);
        let words = symbol.replace('/', "_per_").replace(['.', '^'], "_");
        words.trim_start_matches('_').to_owned()
    }

    /// The name in a sentence, such as `"rotary speed"`.
    pub fn name(self) -> &'static str {
        match self {
            Dimension::Length => "length",
            Dimension::Diameter => "diameter",
            Dimension::Force => "force",
            Dimension::Torque => "torque",
            Dimension::Pressure => "pressure",
            Dimension::Density => "density",
            Dimension::MassPerLength => "mass per length",
            Dimension::ForcePerLength => "force per length",
            Dimension::RotarySpeed => "rotary speed",
            Dimension::RateOfPenetration => "rate of penetration",
            Dimension::TripSpeed => "speed",
            Dimension::Angle => "angle",
            Dimension::DoglegSeverity => "dogleg severity",
            Dimension::Stiffness => "stiffness",
            Dimension::Damping => "damping",
            Dimension::Viscosity => "viscosity",
            Dimension::Consistency => "consistency index",
            Dimension::ShearStress => "shear stress",
            Dimension::FlowRate => "flow rate",
            Dimension::Volume => "volume",
            Dimension::DissipationTime => "dissipation time",
            Dimension::HoistGain => "hoist gain",
            Dimension::Time => "time",
            Dimension::Frequency => "frequency",
            Dimension::Mass => "mass",
            Dimension::MomentOfInertia => "moment of inertia",
            Dimension::RotaryDamping => "torque per rotary speed",
            Dimension::FractureEnergy => "fracture energy",
        }
    }

    /// The units that are read, the commonest first. The SI unit is one of them.
    pub fn units(self) -> &'static [Unit] {
        match self {
            Dimension::Length => table::LENGTH,
            Dimension::Diameter => table::DIAMETER,
            Dimension::Force => table::FORCE,
            Dimension::Torque => table::TORQUE,
            Dimension::Pressure => table::PRESSURE,
            Dimension::Density => table::DENSITY,
            Dimension::MassPerLength => table::MASS_PER_LENGTH,
            Dimension::ForcePerLength => table::FORCE_PER_LENGTH,
            Dimension::RotarySpeed => table::ROTARY_SPEED,
            Dimension::RateOfPenetration => table::RATE_OF_PENETRATION,
            Dimension::TripSpeed => table::TRIP_SPEED,
            Dimension::Angle => table::ANGLE,
            Dimension::DoglegSeverity => table::DOGLEG_SEVERITY,
            Dimension::Stiffness => table::STIFFNESS,
            Dimension::Damping => table::DAMPING,
            Dimension::Viscosity => table::VISCOSITY,
            Dimension::Consistency => table::CONSISTENCY,
            Dimension::ShearStress => table::SHEAR_STRESS,
            Dimension::FlowRate => table::FLOW_RATE,
            Dimension::Volume => table::VOLUME,
            Dimension::DissipationTime => table::DISSIPATION_TIME,
            Dimension::HoistGain => table::HOIST_GAIN,
            Dimension::Time => table::TIME,
            Dimension::Frequency => table::FREQUENCY,
            Dimension::Mass => table::MASS,
            Dimension::MomentOfInertia => table::MOMENT_OF_INERTIA,
            Dimension::RotaryDamping => table::ROTARY_DAMPING,
            Dimension::FractureEnergy => table::FRACTURE_ENERGY,
        }
    }

    /// Symbol of the unit that [`parse`](Self::parse) returns and the printers take.
    pub fn si_symbol(self) -> &'static str {
        self.si_unit().symbol
    }

    /// The unit in which a unit set shows this dimension.
    pub fn unit_in(self, set: UnitSet) -> &'static Unit {
        let symbol = self.symbol_in(set);
        self.units().iter().find(|unit| unit.symbol == symbol).unwrap_or(self.si_unit())
    }

    /// Symbol of the unit in which a unit set shows this dimension.
    fn symbol_in(self, set: UnitSet) -> &'static str {
        let [si, metric, field] = match self {
            Dimension::Length => ["m", "m", "ft"],
            Dimension::Diameter => ["mm", "mm", "in"],
            Dimension::Force => ["kN", "t", "klbf"],
            Dimension::Torque => ["kN.m", "kN.m", "ft-lbf"],
            Dimension::Pressure => ["MPa", "bar", "psi"],
            Dimension::Density => ["kg/m3", "sg", "ppg"],
            Dimension::MassPerLength => ["kg/m", "kg/m", "lb/ft"],
            Dimension::ForcePerLength => ["kN/m", "kN/m", "lbf/ft"],
            Dimension::RotarySpeed => ["rpm", "rpm", "rpm"],
            Dimension::RateOfPenetration => ["m/h", "m/h", "ft/h"],
            Dimension::TripSpeed => ["m/s", "m/s", "ft/min"],
            Dimension::Angle => ["deg", "deg", "deg"],
            Dimension::DoglegSeverity => ["deg/30m", "deg/30m", "deg/100ft"],
            Dimension::Stiffness => ["kN/m", "kN/m", "lbf/in"],
            Dimension::Damping => ["kN.s/m", "kN.s/m", "lbf.s/ft"],
            Dimension::Viscosity => ["mPa.s", "mPa.s", "cP"],
            Dimension::Consistency => ["Pa.s^n", "Pa.s^n", "lbf.s^n/100ft2"],
            Dimension::ShearStress => ["Pa", "Pa", "lbf/100ft2"],
            Dimension::FlowRate => ["L/min", "L/min", "gpm"],
            Dimension::Volume => ["L", "L", "gal"],
            Dimension::DissipationTime => ["s/m", "s/m", "s/ft"],
            Dimension::HoistGain => ["m/s/kN", "m/s/t", "ft/s/klbf"],
            Dimension::Time => ["s", "s", "s"],
            Dimension::Frequency => ["1/s", "1/s", "1/s"],
            Dimension::Mass => ["kg", "t", "lb"],
            Dimension::MomentOfInertia => ["kg.m2", "kg.m2", "lb.ft2"],
            Dimension::RotaryDamping => ["kN.m.s", "kN.m.s", "ft-lbf.s"],
            Dimension::FractureEnergy => ["kJ/m2", "kJ/m2", "in-lbf/in2"],
        };
        match set {
            UnitSet::Si => si,
            UnitSet::Metric => metric,
            UnitSet::Field => field,
        }
    }

    /// The unit that is written so, or `None`.
    ///
    /// Capitals count first (`mPa.s` against `MPa`); where no unit has exactly these, a unit with
    /// other capitals is found if it is the only one (`KN`, `RPM`). Milli and mega are never
    /// taken for each other.
    ///
    /// A unit of length may tell, as depths do, from where and along what it is measured: `ftKB`,
    /// `m MD`, `mTVDRT`.
    pub fn find_unit(self, symbol: &str) -> Option<&'static Unit> {
        let depth = || match self {
            Dimension::Length => symbol::find_depth(self.units(), symbol),
            _ => None,
        };
        symbol::find(self.units(), symbol).or_else(depth)
    }

    /// The value for people: in the set's unit, with five significant digits and the unit.
    ///
    /// Whole numbers below ten million are never rounded to tens.
    pub fn format(self, si: f64, set: UnitSet) -> String {
        print::for_people(self.unit_in(set), si)
    }

    /// The shortest text that [`parse`](Self::parse) reads back as this value, to the last digit
    /// or two of a double.
    ///
    /// In the set's unit, except where a value near the ends of a double's range would lose digits
    /// there: then in SI. A value that is not finite gives a text that `parse` refuses.
    pub fn format_exact(self, si: f64, set: UnitSet) -> String {
        print::exact(self.unit_in(set), self.si_unit(), si)
    }

    /// The unit with factor 1.
    fn si_unit(self) -> &'static Unit {
        let units = self.units();
        units.iter().find(|unit| unit.factor == 1.0).unwrap_or(&units[0])
    }
}

#[cfg(test)]
mod tests {
    use super::{Dimension, UnitSet};

    #[test]
    fn the_unit_of_each_set_is_in_the_table() {
        for &dimension in Dimension::ALL {
            assert_eq!(dimension.si_unit().factor, 1.0, "{dimension:?}");
            for &set in UnitSet::ALL {
                let symbol = dimension.symbol_in(set);
                assert_eq!(dimension.unit_in(set).symbol, symbol, "{dimension:?} {set}");
            }
        }
    }
}

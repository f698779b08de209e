//! Dimensions in the description of a drill string.

use std::sync::LazyLock;

use crate::{Unit, UnitSet, print, symbol::Spellings, table};

/// Declares the dimensions: name in a sentence, accepted units, symbols of the unit in each unit
/// set.
macro_rules! dimensions {
    ($($(#[$meaning:meta])* $dimension:ident: $name:literal, $units:ident, $shown:expr;)+) => {
        /// Dimension of a quantity.
        ///
        /// Dimensions that are equal in physics but not in engineering practice are separate,
        /// because people use different units for them: lengths and diameters, a rate of
        /// penetration and a tripping speed.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Dimension {
            $($(#[$meaning])* $dimension,)+
        }

        impl Dimension {
            /// Every dimension.
            pub const ALL: &[Dimension] = &[$(Dimension::$dimension),+];

            /// The name in a sentence, such as `"rotary speed"`.
            pub fn name(self) -> &'static str {
                match self {
                    $(Dimension::$dimension => $name,)+
                }
            }

            /// The accepted units, the most common first. The SI unit is one of them.
            pub fn units(self) -> &'static [Unit] {
                match self {
                    $(Dimension::$dimension => table::$units,)+
                }
            }

            /// Spellings of the units.
            fn spellings(self) -> &'static Spellings {
                match self {
                    $(Dimension::$dimension => {
                        static SPELLINGS: LazyLock<Spellings> =
                            LazyLock::new(|| Spellings::of(table::$units));
                        &SPELLINGS
                    })+
                }
            }

            /// Symbol of the unit in which a unit set shows this dimension.
            fn symbol_in(self, set: UnitSet) -> &'static str {
                let [si, metric, field] = match self {
                    $(Dimension::$dimension => $shown,)+
                };
                match set {
                    UnitSet::Si => si,
                    UnitSet::Metric => metric,
                    UnitSet::Field => field,
                }
            }
        }
    };
}

dimensions! {
    /// Depths and lengths along the hole or the string, m.
    Length: "length", LENGTH, ["m", "m", "ft"];
    /// Diameters and other lengths across the hole, m.
    Diameter: "diameter", DIAMETER, ["mm", "mm", "in"];
    /// Hook loads, tensions, weights on bit, N.
    Force: "force", FORCE, ["kN", "t", "klbf"];
    /// Torques and bending moments, N·m.
    Torque: "torque", TORQUE, ["kN.m", "kN.m", "ft-lbf"];
    /// Pressures of fluids, Pa.
    Pressure: "pressure", PRESSURE, ["MPa", "bar", "psi"];
    /// Stresses, strengths and moduli of solids, and works per volume, Pa.
    Stress: "stress", PRESSURE, ["MPa", "MPa", "psi"];
    /// Densities of mud and material, kg/m³.
    Density: "density", DENSITY, ["kg/m3", "sg", "ppg"];
    /// Weights of pipe, as mass per length, kg/m.
    MassPerLength: "mass per length", MASS_PER_LENGTH, ["kg/m", "kg/m", "lb/ft"];
    /// Side forces and weights, as force per length, N/m.
    ForcePerLength: "force per length", FORCE_PER_LENGTH, ["kN/m", "kN/m", "lbf/ft"];
    /// Rotary speeds, rad/s.
    RotarySpeed: "rotary speed", ROTARY_SPEED, ["rpm", "rpm", "rpm"];
    /// Rates of penetration, m/s.
    RateOfPenetration: "rate of penetration", RATE_OF_PENETRATION, ["m/h", "m/h", "ft/h"];
    /// Speeds of tripping and of the travelling block, m/s.
    TripSpeed: "speed", TRIP_SPEED, ["m/s", "m/s", "ft/min"];
    /// Inclinations, azimuths, tool faces, rad.
    Angle: "angle", ANGLE, ["deg", "deg", "deg"];
    /// Curvatures of the hole, rad/m.
    DoglegSeverity: "dogleg severity", DOGLEG_SEVERITY, ["deg/30m", "deg/30m", "deg/100ft"];
    /// Stiffnesses of contacts and springs, N/m.
    Stiffness: "stiffness", STIFFNESS, ["kN/m", "kN/m", "lbf/in"];
    /// Viscous damping against velocity, N·s/m.
    Damping: "damping", DAMPING, ["kN.s/m", "kN.s/m", "lbf.s/ft"];
    /// Viscosities, Pa·s.
    Viscosity: "viscosity", VISCOSITY, ["mPa.s", "mPa.s", "cP"];
    /// Consistency indices of power-law fluids, Pa·sⁿ.
    Consistency: "consistency index", CONSISTENCY, ["Pa.s^n", "Pa.s^n", "lbf.s^n/100ft2"];
    /// Yield points and shear stresses of fluids, Pa.
    ShearStress: "shear stress", SHEAR_STRESS, ["Pa", "Pa", "lbf/100ft2"];
    /// Flow rates of pumps, m³/s.
    FlowRate: "flow rate", FLOW_RATE, ["L/min", "L/min", "gpm"];
    /// Volumes, m³.
    Volume: "volume", VOLUME, ["L", "L", "gal"];
    /// Dissipation of an impact per velocity (Hunt and Crossley), s/m.
    DissipationTime: "dissipation time", DISSIPATION_TIME, ["s/m", "s/m", "s/ft"];
    /// Velocity of the hoist per error of force, m/s/N.
    HoistGain: "hoist gain", HOIST_GAIN, ["m/s/kN", "m/s/t", "ft/s/klbf"];
    /// Durations, s.
    Time: "time", TIME, ["s", "s", "s"];
    /// Rates and cycles per time, 1/s.
    Frequency: "frequency", FREQUENCY, ["1/s", "1/s", "1/s"];
    /// Masses, kg.
    Mass: "mass", MASS, ["kg", "t", "lb"];
    /// Moments of inertia about an axis, kg·m².
    MomentOfInertia: "moment of inertia", MOMENT_OF_INERTIA, ["kg.m2", "kg.m2", "lb.ft2"];
    /// Torque per rotary speed, N·m·s.
    RotaryDamping: "torque per rotary speed", ROTARY_DAMPING, ["kN.m.s", "kN.m.s", "ft-lbf.s"];
    /// Energies per area of cracks, J/m².
    FractureEnergy: "fracture energy", FRACTURE_ENERGY, ["kJ/m2", "kJ/m2", "in-lbf/in2"];
}

impl Dimension {
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

    /// Symbol of the unit that [`parse`](Self::parse) returns and the print functions accept.
    pub fn si_symbol(self) -> &'static str {
        self.si_unit().symbol
    }

    /// The unit in which a unit set shows this dimension.
    pub fn unit_in(self, set: UnitSet) -> &'static Unit {
        let symbol = self.symbol_in(set);
        self.units().iter().find(|unit| unit.symbol == symbol).unwrap_or(self.si_unit())
    }

    /// Returns the unit with this spelling, or `None`.
    ///
    /// Exact capitals take precedence (`mPa.s` against `MPa`); if no unit has them, a unit with
    /// other capitals is accepted if it is the only one (`KN`, `RPM`). Milli and mega are never
    /// confused.
    ///
    /// A unit of length may include the depth reference and type, as for depths: `ftKB`, `m MD`,
    /// `mTVDRT`.
    pub fn find_unit(self, symbol: &str) -> Option<&'static Unit> {
        let spellings = self.spellings();
        let depth = || match self {
            Dimension::Length => spellings.find_depth(symbol),
            _ => None,
        };
        spellings.find(symbol).or_else(depth)
    }

    /// Formats the value for people: in the set's unit, with five significant digits and the unit.
    ///
    /// Whole numbers below ten million are never rounded to tens.
    pub fn format(self, si: f64, set: UnitSet) -> String {
        print::for_people(self.unit_in(set), si)
    }

    /// The shortest text that [`parse`](Self::parse) reads back as this value, to the last digit
    /// or two of a double.
    ///
    /// The text is in the set's unit, except that a value near the limits of a double's range is in
    /// SI if it would lose digits. A value that is not finite gives a text that `parse` refuses.
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

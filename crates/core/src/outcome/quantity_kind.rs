//! The kinds of quantities, declared once.

/// Declares the kinds of quantities: the description of each, its SI unit and the name of its
/// dimension.
macro_rules! kinds {
    ($($(#[$about:meta])* $kind:ident => $unit:literal, $dimension:literal;)*) => {
        /// Kind of a quantity (ISO 80000-1), as far as engineers read them in different units.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum QuantityKind {
            $($(#[$about])* $kind,)*
        }

        impl QuantityKind {
            /// Every kind.
            pub const ALL: &[Self] = &[$(Self::$kind,)*];

            /// Symbol of its SI unit; empty of a ratio.
            pub const fn unit(self) -> &'static str {
                match self {
                    $(Self::$kind => $unit,)*
                }
            }

            /// Name of its dimension, by which the units that people see are found.
            pub const fn dimension(self) -> &'static str {
                match self {
                    $(Self::$kind => $dimension,)*
                }
            }
        }
    };
}

kinds! {
    /// A ratio or a count.
    Ratio => "", "ratio";
    /// A length, an offset or a displacement, m.
    Length => "m", "length";
    /// A measured depth, m.
    Depth => "m", "length";
    /// A force, N.
    Force => "N", "force";
    /// A torque or a bending moment, N·m.
    Torque => "N·m", "torque";
    /// A force per length, N/m.
    ForcePerLength => "N/m", "force per length";
    /// A torque per length, N·m/m.
    TorquePerLength => "N·m/m", "torque per length";
    /// A work per length, J/m.
    WorkPerLength => "J/m", "work per length";
    /// A power per length, W/m.
    PowerPerLength => "W/m", "power per length";
    /// A pressure of a fluid, Pa.
    Pressure => "Pa", "pressure";
    /// A stress in a solid or a work per volume, Pa.
    Stress => "Pa", "stress";
    /// A density, kg/m³.
    Density => "kg/m³", "density";
    /// An angle, rad.
    Angle => "rad", "angle";
    /// A curvature, rad/m.
    Curvature => "rad/m", "dogleg severity";
    /// A rotary speed or another angular velocity, rad/s.
    RotarySpeed => "rad/s", "rotary speed";
    /// A speed, m/s.
    Speed => "m/s", "speed";
    /// A rate of penetration, m/s.
    RateOfPenetration => "m/s", "rate of penetration";
    /// A flow rate, m³/s.
    FlowRate => "m³/s", "flow rate";
    /// A time, s.
    Time => "s", "time";
    /// A frequency, Hz.
    Frequency => "Hz", "frequency";
    /// Rate of growth, 1/s.
    Growth => "1/s", "frequency";
}

impl QuantityKind {
    /// A name of this kind without the unit that it ends in: `hook_load` of `hook_load_N`. None of
    /// a name that ends in something else.
    pub(crate) const fn stem(self, name: &str) -> Option<&str> {
        let unit = self.unit().as_bytes();
        let letters = name.as_bytes();
        let mut end = letters.len();
        let mut left = unit.len();
        while left > 0 {
            left -= 1;
            if left == 0 && unit[0] == b'1' && end > 0 {
                // `growth_per_s`: the one of `1/s` is not written.
                return Some(name.split_at(end).0);
            }
            let written: &[u8] = match unit[left] {
                b'/' => b"_per_",
                // `·` and `³` are of two bytes, the first of which is the same.
                0xB7 => b"_",
                0xB3 => b"3",
                0xC2 => b"",
                _ => std::slice::from_ref(&unit[left]),
            };
            let mut k = written.len();
            while k > 0 {
                if end == 0 || letters[end - 1] != written[k - 1] {
                    return None;
                }
                (end, k) = (end - 1, k - 1);
            }
        }
        if unit.is_empty() {
            return Some(name);
        }
        if end == 0 || letters[end - 1] != b'_' {
            return None;
        }
        Some(name.split_at(end - 1).0)
    }
}

#[cfg(test)]
mod tests {
    use super::QuantityKind;

    #[test]
    fn a_name_without_its_unit() {
        for (name, kind, stem) in [
            ("hook_load_N", QuantityKind::Force, Some("hook_load")),
            ("friction_torque_N_m_per_m", QuantityKind::TorquePerLength, Some("friction_torque")),
            ("flow_rate_m3_per_s", QuantityKind::FlowRate, Some("flow_rate")),
            ("growth_per_s", QuantityKind::Growth, Some("growth")),
            ("growth_Hz", QuantityKind::Growth, None),
            ("contact_fraction", QuantityKind::Ratio, Some("contact_fraction")),
            ("hook_load_N", QuantityKind::Torque, None),
            ("hook_loadN", QuantityKind::Force, None),
            ("N", QuantityKind::Force, None),
        ] {
            assert_eq!(kind.stem(name), stem, "{name}");
        }
    }
}

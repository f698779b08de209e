//! The scalars that every method provides, declared once.

use serde::{Deserialize, Serialize};

use super::{
    quantity::{Quantity, is_same},
    quantity_kind::QuantityKind,
};

/// A scalar of [`Scalars`].
#[derive(Debug)]
pub struct Scalar {
    /// Declaration of the quantity.
    pub quantity: Quantity,
    /// Label for display.
    pub label: &'static str,
    /// Row in tables for people, counted from one.
    pub row: u8,
    /// Its value.
    pub of: fn(&Scalars) -> Option<f64>,
}

impl Scalar {
    /// The scalar of that name.
    ///
    /// # Panics
    /// Where there is none: in a constant this is a compile error.
    pub const fn declared(name: &str) -> &'static Self {
        let mut place = 0;
        while place < SCALARS.len() {
            if is_same(SCALARS[place].quantity.name, name) {
                return &SCALARS[place];
            }
            place += 1;
        }
        panic!("no scalar of that name is declared")
    }
}

/// The scalars in the order of [`Scalar::row`].
pub fn scalars_by_row() -> Vec<&'static Scalar> {
    let mut all: Vec<&Scalar> = SCALARS.iter().collect();
    all.sort_by_key(|scalar| scalar.row);
    all
}

/// Declares the structure and the list of its fields at once, in the order of `summary.json`: kind,
/// label, row in the tables, meaning, and the cases without a value.
macro_rules! scalars {
    (
        $(#[$about:meta])*
        pub struct $name:ident {
            $(
                $(#[$more:meta])*
                $scalar:ident: $type:ty => $kind:ident, $label:literal row $row:literal,
                $meaning:literal $(, null_where $null_where:literal)?;
            )*
        }
    ) => {
        $(#[$about])*
        pub struct $name {
            $(
                #[doc = $meaning]
                #[doc = ""]
                #[doc = concat!("Kind: `", stringify!($kind), "`.")]
                $(#[$more])*
                pub $scalar: $type,
            )*
        }

        /// Every scalar, in the order of `summary.json`.
        pub const SCALARS: &[Scalar] = &[$(
            Scalar {
                quantity: Quantity::number(stringify!($scalar), QuantityKind::$kind, $meaning)
                    .labelled($label)
                    $(.null_where($null_where))?,
                label: $label,
                row: $row,
                of: |scalars| scalars.$scalar.into(),
            },
        )*];
    };
}

scalars! {
    /// Torque and drag of one operation: the quantities that every method reports under the same
    /// names, so that their results can be compared. The dynamics report means over their window.
    #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
    pub struct Scalars {
        #[serde(with = "crate::finite::unsigned_zero")]
        weight_on_bit_N: f64 => Force, "Weight on bit" row 3, "Weight on bit as solved";
        #[serde(with = "crate::finite::unsigned_zero")]
        bit_torque_N_m: f64 => Torque, "Bit torque" row 7, "Bit torque as solved";
        #[serde(with = "crate::finite::unsigned_zero")]
        hook_load_N: f64 => Force, "Hook load without block" row 1,
            "Tension at the top of the string; block and top drive excluded";
        #[serde(with = "crate::finite::unsigned_zero")]
        surface_torque_N_m: f64 => Torque, "Surface torque" row 5,
            "Torque at the top of the string";
        #[serde(with = "crate::finite::unsigned_zero")]
        friction_torque_N_m: f64 => Torque, "Friction torque" row 6,
            "Part of the surface torque due to wall contact alone";
        #[serde(with = "crate::finite::unsigned_zero")]
        axial_friction_N: f64 => Force, "Axial friction" row 2,
            "Axial friction of the wall; positive adds to hook load";
        #[serde(with = "crate::finite::unsigned_zero")]
        side_force_total_N: f64 => Force, "Side force, total" row 4,
            "Integral of the magnitude of the side force";
        #[serde(with = "crate::finite::unsigned_zero")]
        twist_rad: f64 => Angle, "Twist" row 8,
            "Turn of the top against the bit; positive when the top leads";
        #[serde(with = "crate::finite::unsigned_zero")]
        stretch_m: f64 => Length, "Stretch" row 9, "Elongation against the unloaded string";
        neutral_point_m: Option<f64> => Depth, "Neutral point" row 10,
            "Measured depth of the shallowest zero of effective tension",
            null_where "there is none";
        cutoff_depth_m: Option<f64> => Depth, "Cut-off depth" row 11,
            "Deepest change from high-side to low-side contact between the kick-off and 30 m below \
             the build",
            null_where "there is none";
    }
}

impl Scalars {
    /// The scalars of an operation without a solution: none of them is a number.
    pub const UNKNOWN: Self = Self {
        weight_on_bit_N: f64::NAN,
        bit_torque_N_m: f64::NAN,
        hook_load_N: f64::NAN,
        surface_torque_N_m: f64::NAN,
        friction_torque_N_m: f64::NAN,
        axial_friction_N: f64::NAN,
        side_force_total_N: f64::NAN,
        twist_rad: f64::NAN,
        stretch_m: f64::NAN,
        neutral_point_m: None,
        cutoff_depth_m: None,
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scalar_has_a_row_of_its_own() {
        let rows: Vec<usize> =
            scalars_by_row().iter().map(|scalars_by_row| scalars_by_row.row.into()).collect();
        assert_eq!(rows, (1..=SCALARS.len()).collect::<Vec<_>>());
    }
}

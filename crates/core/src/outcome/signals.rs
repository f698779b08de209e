//! Declaration of the quantities against time that have spectra.

/// Declares signals: each is a column of numbers without gaps, and has its name without the unit.
macro_rules! signals {
    (
        $(#[$about:meta])*
        pub enum $name:ident of $rows:ident in $list:ident {
            $($(#[$signal_about:meta])* $signal:ident => $column:ident;)*
        }
    ) => {
        $(#[$about])*
        pub enum $name {
            $($(#[$signal_about])* $signal,)*
        }

        impl $name {
            /// Every signal.
            pub const ALL: [Self; [$(stringify!($signal)),*].len()] = [$(Self::$signal,)*];

            /// Every signal by its name.
            pub const BY_NAME: &[(&'static str, Self)] =
                &[$((Self::$signal.name(), Self::$signal),)*];

            /// Its column.
            pub const fn column(self) -> &'static $crate::outcome::Column<$rows> {
                match self {
                    $(Self::$signal => {
                        const DECLARED: &$crate::outcome::Column<$rows> =
                            $crate::outcome::Column::named($list, stringify!($column));
                        DECLARED
                    })*
                }
            }

            /// Declaration of the column.
            pub const fn quantity(self) -> &'static $crate::outcome::Quantity {
                &self.column().quantity
            }

            /// Name in case files and results.
            pub const fn name(self) -> &'static str {
                self.quantity().stem()
            }

            /// Symbol of its unit.
            pub const fn unit(self) -> &'static str {
                self.quantity().unit
            }

            /// Its samples.
            pub fn of(self, rows: &$rows) -> &[f64] {
                match self {
                    $(Self::$signal => &rows.$column,)*
                }
            }
        }
    };
}
pub(crate) use signals;

//! Enumerations whose variants have names.

/// Declares an enumeration with the name of each variant, so that none can be missing from the list
/// of all.
macro_rules! named {
    (
        $(#[$about:meta])*
        pub enum $of:ident {
            $($(#[$meaning:meta])* $one:ident = $name:literal,)+
        }
    ) => {
        $(#[$about])*
        pub enum $of {
            $($(#[$meaning])* $one,)+
        }

        impl $of {
            /// Every one, in the order in which they are listed.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$one),+];

            /// Name in case files and results.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$one => $name,)+
                }
            }
        }
    };
}

pub(crate) use named;

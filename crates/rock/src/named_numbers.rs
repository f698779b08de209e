//! Numbers with a name in messages.

/// Declares an enumeration of the numbers of something, with their names in messages.
macro_rules! named_numbers {
    ($(#[$doc:meta])* $name:ident { $($number:ident $words:literal),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name {
            $(#[doc = concat!("Number with the name \"", $words, "\".")] $number),+
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.write_str(match self {
                    $(Self::$number => $words),+
                })
            }
        }
    };
}

pub(crate) use named_numbers;

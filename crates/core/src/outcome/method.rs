//! The methods that solve an operation, and the results that each of them provides: one table.

use std::fmt;

use serde::{Deserialize, Serialize};

/// Duration of a method's computation for an operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cost {
    /// Milliseconds: it is solved again rather than read back.
    Milliseconds,
    /// Minutes to hours.
    Minutes,
}

/// Properties of a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Method {
    /// Name in case files and results.
    pub name: &'static str,
    /// Name in tables and sentences for people.
    pub long_name: &'static str,
    /// Name in the legends of curves.
    pub curve_name: &'static str,
    /// Whether its results are in time: series, statistics over a window, spectra, frames, and the
    /// effect of a schedule. The others compute one state of equilibrium.
    pub in_time: bool,
    /// Whether it cuts the string into elements, whose nodes touch the wall or not.
    pub has_elements: bool,
    /// Whether its forces hold the friction of a helix, which presses itself against the wall.
    pub has_helix_friction: bool,
    /// Duration of the computation.
    pub cost: Cost,
}

/// Declares the methods and their properties, from the simplest to the most detailed.
macro_rules! methods {
    ($($(#[$about:meta])* $model:ident => $method:expr;)*) => {
        /// A method that solves an operation. Its name and its results are described by its
        /// [`Method`].
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum ModelKind {
            $($(#[$about])* $model,)*
        }

        impl ModelKind {
            /// Every method, from the simplest to the most detailed.
            pub const ALL: &[Self] = &[$(Self::$model,)*];

            /// Properties of the method.
            pub const fn method(self) -> &'static Method {
                match self {
                    $(Self::$model => const { &$method },)*
                }
            }
        }
    };
}

methods! {
    /// Soft string: statics without bending stiffness.
    Soft => Method {
        name: "soft",
        long_name: "soft string",
        curve_name: "soft string",
        in_time: false,
        has_elements: false,
        has_helix_friction: false,
        cost: Cost::Milliseconds,
    };
    /// Stiff string: static equilibrium with bending stiffness and clearance.
    Stiff => Method {
        name: "stiff",
        long_name: "stiff string",
        curve_name: "stiff string",
        in_time: false,
        has_elements: true,
        has_helix_friction: true,
        cost: Cost::Milliseconds,
    };
    /// Dynamics of the whole string in time.
    Dynamic => Method {
        name: "dynamic",
        long_name: "dynamics",
        curve_name: "dynamics, mean",
        in_time: true,
        has_elements: true,
        has_helix_friction: true,
        cost: Cost::Minutes,
    };
}

/// Its [name](ModelKind::name).
impl fmt::Display for ModelKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl ModelKind {
    /// The name of each, in the same order.
    pub const NAMES: &[&'static str] = &{
        let mut names = [""; Self::ALL.len()];
        let mut place = 0;
        while place < names.len() {
            names[place] = Self::ALL[place].name();
            place += 1;
        }
        names
    };

    /// The names as listed in the meaning of a column.
    pub const LISTED: &str = match str::from_utf8(&LISTED) {
        Ok(listed) => listed,
        Err(_) => panic!("names are text"),
    };

    /// Name in case files and results.
    pub const fn name(self) -> &'static str {
        self.method().name
    }

    /// The method of that [`ModelKind::name`].
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|method| method.name() == name)
    }

    /// Whether its results are in time.
    pub const fn in_time(self) -> bool {
        self.method().in_time
    }

    /// Whether the results of one of them are in time.
    pub fn any_in_time(all: &[Self]) -> bool {
        all.iter().any(|method| method.in_time())
    }

    /// Number of methods that are more detailed.
    pub fn rank(self) -> usize {
        let more_detailed = Self::ALL.iter().rev();
        more_detailed.take_while(|more_detailed| **more_detailed != self).count()
    }
}

/// Declares a list of the methods that have a property.
macro_rules! methods_that {
    ($(#[$about:meta])* $list:ident, $is:ident) => {
        $(#[$about])*
        pub(crate) const $list: &[ModelKind] = &{
            let mut all = [ModelKind::ALL[0]; {
                let (mut found, mut place) = (0, 0);
                while place < ModelKind::ALL.len() {
                    found += ModelKind::ALL[place].method().$is as usize;
                    place += 1;
                }
                found
            }];
            let (mut found, mut place) = (0, 0);
            while place < ModelKind::ALL.len() {
                if ModelKind::ALL[place].method().$is {
                    all[found] = ModelKind::ALL[place];
                    found += 1;
                }
                place += 1;
            }
            all
        };
    };
}

methods_that! {
    /// The methods that answer in time.
    IN_TIME, in_time
}

methods_that! {
    /// The methods that cut the string into elements.
    IN_ELEMENTS, has_elements
}

const LISTED: [u8; list_names(&mut [])] = {
    let mut listed = [0; list_names(&mut [])];
    list_names(&mut listed);
    listed
};

/// Writes the names one after the other, as far as there is room; how long that is.
const fn list_names(to: &mut [u8]) -> usize {
    let names = ModelKind::NAMES;
    let (mut end, mut place) = (0, 0);
    while place < names.len() {
        let before = match place {
            0 => "`",
            last if last + 1 == names.len() => "` or `",
            _ => "`, `",
        };
        end = write(before, to, end);
        end = write(names[place], to, end);
        place += 1;
    }
    write("`", to, end)
}

/// Writes a text from a place on, as far as there is room; where it ends.
const fn write(text: &str, to: &mut [u8], from: usize) -> usize {
    let letters = text.as_bytes();
    let mut i = 0;
    while i < letters.len() {
        if from + i < to.len() {
            to[from + i] = letters[i];
        }
        i += 1;
    }
    from + letters.len()
}

#[cfg(test)]
mod tests {
    use super::ModelKind;

    #[test]
    fn names_are_listed_as_a_sentence_lists_them() {
        let names = ModelKind::NAMES.iter().map(|name| format!("`{name}`"));
        let names: Vec<String> = names.collect();
        let (last, others) = names.split_last().expect("methods");
        assert_eq!(ModelKind::LISTED, format!("{} or {last}", others.join(", ")));
    }

    #[test]
    fn a_method_is_found_by_its_name_and_has_a_rank_of_its_own() {
        for (index, kind) in ModelKind::ALL.iter().copied().enumerate() {
            assert_eq!(ModelKind::named(kind.name()), Some(kind));
            assert_eq!(kind.rank(), ModelKind::ALL.len() - 1 - index);
            assert_eq!(serde_json::to_value(kind).expect("a name"), kind.name());
        }
        assert_eq!(ModelKind::named("dynamics"), None);
    }
}

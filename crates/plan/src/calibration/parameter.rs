//! The parameters of a calibration.

use wholestring::well::{Friction, HoleError, HoleKind};

use super::Motion;
use crate::Setup;

/// Maximum number of sections of a hole with factors of their own.
pub const MOST_SECTIONS: usize = 5;

/// Friction factors of steel and of rock, along the hole and around it, or of sections of the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factors {
    /// In casing, along the hole.
    pub cased: f64,
    /// In open hole, along it.
    pub open: f64,
    /// In casing, around it.
    pub cased_around: f64,
    /// In open hole, around it.
    pub open_around: f64,
    /// Along and around the hole in sections that have their own, from the surface down.
    pub sections: [Option<[f64; 2]>; MOST_SECTIONS],
}

/// Smallest factor along the hole for which the one around the hole is taken as a ratio to it.
const LEAST: f64 = 1e-6;

impl Factors {
    /// Returns the same factor along the hole and around it, of steel and of rock.
    pub fn of_walls(cased: f64, open: f64) -> Self {
        let sections = [None; MOST_SECTIONS];
        Self { cased, open, cased_around: cased, open_around: open, sections }
    }

    /// Returns the factors along and around the hole in a section of a kind, counted from the
    /// surface.
    pub fn of_section(&self, section: usize, kind: HoleKind) -> [f64; 2] {
        let own = self.sections.get(section).copied().flatten();
        own.unwrap_or(match kind {
            HoleKind::Casing => [self.cased, self.cased_around],
            HoleKind::Open => [self.open, self.open_around],
        })
    }

    /// Returns a setup with these factors.
    ///
    /// # Errors
    /// A factor that is out of its range.
    pub fn applied_to(&self, setup: &Setup) -> Result<Setup, HoleError> {
        let sections = setup.well.hole.sections();
        setup.with_friction_of(|section| {
            let place = sections.iter().position(|other| other.from_md_m == section.from_md_m);
            let [along, around] = self.of_section(place.unwrap_or(usize::MAX), section.kind);
            let along = if around > 0.0 { along.max(LEAST) } else { along };
            let ratio = if along > 0.0 { around / along } else { 1.0 };
            Friction { around: ratio, ..Friction::uniform(along) }
        })
    }
}

/// A part of the hole that has a factor of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HolePart {
    /// All of its casings, or all of its rock.
    Kind(HoleKind),
    /// A section, counted from the surface.
    Section(usize),
}

impl From<HoleKind> for HolePart {
    fn from(kind: HoleKind) -> Self {
        Self::Kind(kind)
    }
}

/// Names and words of the factors of sections, along the hole and around it.
const SECTIONS: [[[&str; 2]; 2]; MOST_SECTIONS] = [
    [
        ["friction_section_1", "friction factor of section 1"],
        ["friction_section_1_around", "rotational friction factor of section 1"],
    ],
    [
        ["friction_section_2", "friction factor of section 2"],
        ["friction_section_2_around", "rotational friction factor of section 2"],
    ],
    [
        ["friction_section_3", "friction factor of section 3"],
        ["friction_section_3_around", "rotational friction factor of section 3"],
    ],
    [
        ["friction_section_4", "friction factor of section 4"],
        ["friction_section_4_around", "rotational friction factor of section 4"],
    ],
    [
        ["friction_section_5", "friction factor of section 5"],
        ["friction_section_5_around", "rotational friction factor of section 5"],
    ],
];

/// All parameters of the readings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Friction.
    pub factors: Factors,
    /// Weight of block and top drive, N, which the weight indicator includes.
    pub block_weight_N: f64,
    /// Torque of the bit on bottom, N·m.
    pub bit_torque_N_m: f64,
}

/// A parameter that can be fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Parameter {
    /// Friction factor of all walls, along the hole.
    Friction,
    /// Friction factor of casing, along the hole.
    Cased,
    /// Friction factor of open hole, along it.
    Open,
    /// Friction factor of all walls, around the hole.
    FrictionAround,
    /// Friction factor of casing, around the hole.
    CasedAround,
    /// Friction factor of open hole, around it.
    OpenAround,
    /// Friction factor of a section of the hole, counted from the surface, along the hole.
    Section(usize),
    /// Friction factor of a section, around the hole.
    SectionAround(usize),
    /// Weight of block and top drive, N.
    BlockWeight,
    /// Torque of the bit on bottom, N·m.
    BitTorque,
}

impl Parameter {
    /// Every parameter.
    pub const ALL: [Self; 8 + 2 * MOST_SECTIONS] = [
        Self::Friction,
        Self::Cased,
        Self::Open,
        Self::FrictionAround,
        Self::CasedAround,
        Self::OpenAround,
        Self::Section(0),
        Self::Section(1),
        Self::Section(2),
        Self::Section(3),
        Self::Section(4),
        Self::SectionAround(0),
        Self::SectionAround(1),
        Self::SectionAround(2),
        Self::SectionAround(3),
        Self::SectionAround(4),
        Self::BlockWeight,
        Self::BitTorque,
    ];

    /// Returns the name in results, with its unit.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Friction => "friction",
            Self::Cased => "friction_cased",
            Self::Open => "friction_open",
            Self::FrictionAround => "friction_around",
            Self::CasedAround => "friction_cased_around",
            Self::OpenAround => "friction_open_around",
            Self::Section(index) => SECTIONS[index][0][0],
            Self::SectionAround(index) => SECTIONS[index][1][0],
            Self::BlockWeight => "block_weight_N",
            Self::BitTorque => "bit_torque_N_m",
        }
    }

    /// Returns the parameter of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|parameter| parameter.name() == name)
    }

    /// Returns the words for it in a sentence.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Friction => "friction factor",
            Self::Cased => "friction factor of casing",
            Self::Open => "friction factor of open hole",
            Self::FrictionAround => "rotational friction factor",
            Self::CasedAround => "rotational friction factor of casing",
            Self::OpenAround => "rotational friction factor of open hole",
            Self::Section(index) => SECTIONS[index][0][1],
            Self::SectionAround(index) => SECTIONS[index][1][1],
            Self::BlockWeight => "block weight",
            Self::BitTorque => "bit torque",
        }
    }

    /// Whether it is a friction factor.
    pub const fn is_factor(self) -> bool {
        !matches!(self, Self::BlockWeight | Self::BitTorque)
    }

    /// Whether it is a factor around the hole only.
    pub const fn is_around(self) -> bool {
        matches!(
            self,
            Self::FrictionAround | Self::CasedAround | Self::OpenAround | Self::SectionAround(_)
        )
    }

    /// Returns the part of the hole that it belongs to; `None` for a factor of all of it, and for a
    /// parameter that is not a factor.
    pub const fn part(self) -> Option<HolePart> {
        match self {
            Self::Cased | Self::CasedAround => Some(HolePart::Kind(HoleKind::Casing)),
            Self::Open | Self::OpenAround => Some(HolePart::Kind(HoleKind::Open)),
            Self::Section(index) | Self::SectionAround(index) => Some(HolePart::Section(index)),
            _ => None,
        }
    }

    /// Whether two factors, both along the hole or both around it, may apply to one place.
    pub(super) fn meets(self, other: Self) -> bool {
        use HolePart::{Kind, Section};
        match (self.part(), other.part()) {
            (None, _) | (_, None) => true,
            (Some(Kind(_)), Some(Section(_))) | (Some(Section(_)), Some(Kind(_))) => true,
            (one, other) => one == other,
        }
    }

    /// Whether a string in this motion depends on it; on a factor along the hole during rotation,
    /// only where the factor around follows it.
    pub(super) const fn rubs(self, motion: Motion, around_follows: bool) -> bool {
        self.is_factor()
            && match (self.is_around(), motion.turns()) {
                (around, true) => around || around_follows,
                (around, false) => !around,
            }
    }

    /// Sets it; a factor along the hole also sets the one around it by its ratio, where it has one.
    pub(super) fn set(self, state: &mut State, value: f64, ratio: Option<&AroundRatio>) {
        let factors = &mut state.factors;
        let sections = ratio.map(|ratio| &ratio.sections);
        let ratio = ratio.map(|ratio| ratio.walls);
        if matches!(self, Self::Friction | Self::Cased) {
            factors.cased = value;
            factors.cased_around = ratio.map_or(factors.cased_around, |[ratio, _]| ratio * value);
        }
        if matches!(self, Self::Friction | Self::Open) {
            factors.open = value;
            factors.open_around = ratio.map_or(factors.open_around, |[_, ratio]| ratio * value);
        }
        match self {
            Self::FrictionAround => {
                (factors.cased_around, factors.open_around) = (value, value);
            }
            Self::CasedAround => factors.cased_around = value,
            Self::OpenAround => factors.open_around = value,
            Self::Section(index) => {
                let around = factors.sections[index].map_or(value, |[_, around]| around);
                let around = sections.map_or(around, |ratio| ratio[index] * value);
                factors.sections[index] = Some([value, around]);
            }
            Self::SectionAround(index) => {
                let along = factors.sections[index].map_or(value, |[along, _]| along);
                factors.sections[index] = Some([along, value]);
            }
            Self::BlockWeight => state.block_weight_N = value,
            Self::BitTorque => state.bit_torque_N_m = value,
            _ => {}
        }
    }
}

/// Friction around the hole over that along it, where the former follows the latter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AroundRatio {
    /// In casing and in open hole.
    pub walls: [f64; 2],
    /// In each section that has a factor of its own.
    pub sections: [f64; MOST_SECTIONS],
}

impl Default for AroundRatio {
    fn default() -> Self {
        Self { walls: [1.0; 2], sections: [1.0; MOST_SECTIONS] }
    }
}

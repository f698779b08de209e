//! A stiff string between walls that do not yield: the conditions of closed forms.

use wholestring::{
    sizing::ElementLength, statics::stiff::StiffSettings, wall::contact::ContactLaw,
};

/// A wall that a force of a tonne presses in by a micrometre: rigid compared with every clearance.
const RIGID: ContactLaw = ContactLaw::Linear { stiffness_N_per_m: 1e10, damping_ratio: 0.0 };

/// Elements of a length, a rigid wall, the bit on the hole's axis.
pub fn rigid(element_length_m: f64) -> StiffSettings {
    StiffSettings {
        element_length: ElementLength::Uniform(element_length_m),
        contact_law: RIGID,
        bit_lateral_stiffness_N_per_m: 1e10,
        ..StiffSettings::default()
    }
}

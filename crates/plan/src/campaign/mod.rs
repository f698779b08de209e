//! Effects of all operations of a plan together on string and casing.
//!
//! The section is drilled from a depth to the deepest of the bit; the string is pulled and run, and
//! turns off bottom at the end. Each solved operation has its [`Share`], and the shares of all add
//! up.

mod part;
mod schedule;
mod settings;
mod share;

pub use part::CampaignPart;
pub use schedule::Campaign;
pub use settings::CampaignSettings;
pub use share::Share;

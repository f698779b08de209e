//! Overviews of cases for the list: name, first mistake, silhouette of the well, and the verdict of
//! the soft string. They are computed in the background and stored by the fingerprint of the files.

mod compute;
mod store;

pub(crate) use compute::{CaseOverview, Silhouette};
pub(crate) use store::{Known, Overviews};

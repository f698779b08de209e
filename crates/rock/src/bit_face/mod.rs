//! The face of a bit as a rigid body, and its contact with the nodes of a rock's surface.
//!
//! The bit's own frame has its origin on the bit's axis at the level of the lowest point of its
//! profile, `z` down the hole, `x` towards the high side while the bit's angle is zero, `y` to the
//! right of that, looking down. The bit turns clockwise, from `x` to `y`.
//!
//! Parameters ([`PdcBit`], [`InsertBit`]) define a [`BitFace`], built once: its cutters, the body
//! that carries them, and a grid for lookup. [`Contact`] then computes the forces on nodes and bit,
//! and [`Tracks`] the cuts of the cutters at a given advance per revolution.

mod body;
mod bottom;
mod contact;
mod cutter;
mod error;
mod face;
mod grid;
mod insert;
mod pdc;
mod pose;
mod profile;
mod revolved;
mod tracks;

pub use self::{
    bottom::BottomHole,
    contact::{BitLoad, Contact, ContactLaw, RockNode},
    cutter::Cutter,
    error::{FaceError, FaceNumber},
    face::{BitFace, Part, Touch},
    insert::{InsertBit, InsertShape},
    pdc::PdcBit,
    pose::Pose,
    profile::{Profile, ProfilePoint},
    tracks::{Cut, Tracks},
};

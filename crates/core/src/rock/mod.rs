//! The rock under the bit, and the bit's face that breaks it.

pub mod bit_face;

//! Buckling of a pipe in its hole: critical loads by place, and push through a buckled string.
//!
//! With `F` the compression (minus the effective tension), `r` the radial clearance, `w` the buoyed
//! weight per length, `θ` the inclination, `θ'` the build rate and `φ'` the rate of the azimuth, a
//! pipe that is pressed against the wall by
//!
//! ```text
//! w_n = √((w sin θ + F θ')² + (F sin θ φ')²)
//! ```
//!
//! stays straight on it while
//!
//! ```text
//! F² < β EI w_n(F)/r
//! ```
//!
//! with `β = 4` up to the sinusoid and `β = 8` up to the helix. In a straight hole that is `2 √(EI
//! w sin θ/r)` (Dawson and Paslay, *Drillpipe buckling in inclined holes*, Journal of Petroleum
//! Technology 36, 1984) and `2√2 √(EI w sin θ/r)` (Chen, Lin and Cheatham, *Tubing and casing
//! buckling in horizontal wells*, Journal of Petroleum Technology 42, 1990). With the force of the
//! curvature in `w_n` it is the criterion of He and Kyllingstad, *Helical buckling and lock-up
//! conditions for coiled tubing in curved wells*, SPE Drilling & Completion 10 (1995): a build
//! holds a pushed pipe on its low side, a drop lifts it off. Wu and Juvkam-Wold (*Helical buckling
//! of pipes in extended reach and horizontal wells*, Journal of Energy Resources Technology 115,
//! 1993) put the finished helix higher, at `2(2√2 − 1) √(EI w sin θ/r)`; verdicts take the lower
//! load of Chen, Lin and Cheatham, from which a pipe may be helical.
//!
//! In a vertical hole nothing presses the pipe to the wall and `w_n` vanishes, but its weight still
//! holds it: a critical load is never less than `1.94 (EI w²)^⅓` for the first bow (Lubinski, *A
//! study of the buckling of rotary drilling strings*, API Drilling and Production Practice, 1950)
//! and `5.55 (EI w²)^⅓` for the helix (Wu and Juvkam-Wold). Both are loads at the lower end of a
//! long string; here they are compared with the compression of each place.
//!
//! The clearance is that of what touches the wall: of the tool joints where a pipe has them, as API
//! RP 7G counts it, of the body elsewhere.

mod criteria;
mod place;
mod push;

pub use criteria::Criterion;
pub use place::Place;
pub use push::{Pushed, Segment, push_through, weight_at_bit_N};

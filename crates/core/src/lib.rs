//! Mechanics of a whole drill string in a deviated well, from the top drive to the rock.
//!
//! # A first program
//!
//! A well, a string, one operation; torque and drag by the soft string, then the same operation in
//! time:
//!
//! ```
//! use wholestring::prelude::*;
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let path = Path::spline(&[
//!         Station::from_degrees(0.0, 0.0, 45.0), // measured depth in m, inclination, azimuth
//!         Station::from_degrees(300.0, 0.0, 45.0),
//!         Station::from_degrees(900.0, 60.0, 45.0),
//!         Station::from_degrees(1500.0, 60.0, 45.0),
//!     ])?;
//!     let hole = Hole::new(vec![
//!         HoleSection::casing(0.0..800.0, 0.2224, 0.25), // diameter in m, friction
//!         HoleSection::open(800.0..1500.0, 0.2159, 0.30),
//!     ])?;
//!     let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3))
//!         .catalogue("6-1/2 in x 2-13/16 in collar", Metres(60.0))?
//!         .catalogue("5 in 19.50 lb/ft S-135", ToSurface)?
//!         .assemble(1500.0)?;
//!     let model = Model::new(Well::new(path, hole), string, Mud::of_density(1200.0));
//!     let drill = Operation::drill(1500.0)
//!         .rotary_speed_rad_per_s(12.0)
//!         .weight_on_bit_N(50e3)
//!         .bit_torque_N_m(3e3)
//!         .rate_of_penetration_m_per_s(5e-3);
//!
//!     let soft = soft_string(&model, &drill)?.scalars;
//!     println!("soft string: {:.0} N, {:.0} N·m", soft.hook_load_N, soft.surface_torque_N_m);
//!
//!     let settings = DynamicsSettings { settle_s: 6.0, duration_s: 2.0, ..Default::default() };
//!     let dynamic = Simulation::new(&model, &drill, &settings)?.to_end()?.scalars;
//!     println!("in time: {:.0} N, {:.0} N·m", dynamic.hook_load_N, dynamic.surface_torque_N_m);
//! #   assert!((dynamic.hook_load_N / soft.hook_load_N - 1.0).abs() < 0.05, "{dynamic:?} {soft:?}");
//! #   let torques = dynamic.surface_torque_N_m / soft.surface_torque_N_m;
//! #   assert!((torques - 1.0).abs() < 0.2, "{dynamic:?} {soft:?}");
//!     Ok(())
//! }
//! ```
//!
//! # Contents, in the order of use
//!
//! 1. [`prelude`]: the imports of such a program.
//! 2. [`well`], [`string`] with its [catalogue](string::catalogue), [`mud`], [`rig`]: the four
//!    parts of a [`model::Model`]; [`ends`] contains the lateral constraints of the string's ends.
//! 3. [`operation`]: the driller's operation, with its set points.
//! 4. [`statics::soft`]: torque and drag along the string at once; [`statics::buckling`].
//! 5. [`dynamics`]: the string in time; its [`DynamicsSettings`](dynamics::DynamicsSettings) hold
//!    the bit, the top drive, the hoist and the numerics, with defaults.
//! 6. [`outcome`]: results of the solvers, each scalar and column with its unit and meaning. They
//!    are judged by the crate `wholestring-judge`.
//! 7. [`rock`] (the crate `wholestring-rock`), [`rod`], [`wall`]: the parts of the dynamics by
//!    themselves.
//!
//! Linear vibration about the state at rest, natural frequencies, critical speeds and whether
//! steady rotation grows into stick-slip, is in the crate `wholestring-vibration`.
//!
//! # Points of extension
//!
//! Each has an example in `crates/core/examples`, which the tests run.
//!
//! | of one's own | by | example |
//! |---|---|---|
//! | law of the bit | [`dynamics::BitRockLaw`] | `bit_law` |
//! | excitation of the bit | [`dynamics::BitExcitation`]; measured: [`dynamics::BitTable`] | `excitation` |
//! | friction law | [`dynamics::FrictionCoefficient`] | `friction_law` |
//! | friction profile | [`well::Hole::with_friction_profile`] | `friction` |
//! | controller of the top drive | [`dynamics::TopDriveController`] | `top_drive_controller` |
//! | observer of samples | [`dynamics::Observer`] | `observer` |
//! | threads under solid rock | [`rock::Executor`]; with the feature `rayon`, `rayon::ThreadPool` is one, and `Simulation::with_threads` starts some | |
//!
//! Laws of the bit, excitations and controllers act once a step at one node, a friction law at each
//! node on the wall, and their state between steps is written to checkpoints. The distribution of
//! friction between its two directions, the stopping of a node by friction, and the contact law are
//! compiled into the inner loop: their coefficients can be set, the laws themselves cannot be
//! replaced.
//!
//! # How it is put together
//!
//! The data flows one way: a [`model::Model`] (well, string, mud, rig) and an
//! [`operation::Operation`] are the inputs of a solver ([`statics::soft`], [`dynamics`]), and
//! profiles and scalars its results. Nothing here reads files, prints or starts threads (except
//! with the feature `rayon`, off by default, in programs that use it); everything is SI, angles in
//! radians.
//!
//! Axes are north, east and down; measured depth (MD) grows towards the bit; a positive rotation is
//! clockwise looking down the hole.
#![warn(missing_docs)]
#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[cfg(test)]
extern crate self as wholestring;

#[cfg(test)]
#[path = "../tests/common/mod.rs"]
mod common;
pub mod dynamics;
pub mod ends;
#[doc(hidden)]
pub mod internals;
pub mod model;
pub mod mud;
pub mod operation;
pub mod outcome;
pub mod prelude;
pub mod random;
pub mod rig;
pub mod rod;
pub mod sizing;
pub mod statics;
pub mod string;
pub mod wall;
pub mod well;

use wholestring_numbers::{damage, finite, simd};

pub use wholestring_numbers::damage::Damaged;
pub use wholestring_rock as rock;

/// Standard acceleration of gravity, m/s² (CGPM 1901, exact by definition).
pub const GRAVITY_M_PER_S2: f64 = 9.80665;

//! Speed of a machine: the measurements that [`Bench`] takes of the engine and of the command.

mod clock;
mod command;
mod kernel;
mod mechanisms;
mod rock;
mod session;
mod well;

pub use clock::{Spread, TIME};
pub use command::{MEASURES_MEMORY, Memory, SweepRow, Sweeps};
pub use kernel::{Kernel, KernelRow, RunRow};
pub use mechanisms::{MechanismRow, Mechanisms};
pub use rock::{RockRow, RockSpeed};
pub use session::{Bench, Watcher};
pub use well::MeasuredWell;

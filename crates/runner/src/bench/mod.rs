//! Speed of a machine: the measurements that [`Bench`] takes of the engine and of the command.

mod clock;
mod kernel;
mod mechanisms;
mod memory;
mod process;
mod rock;
mod session;
mod sweep;
mod well;
mod whole_run;

pub use clock::{Spread, TIME};
pub use kernel::{Kernel, KernelRow};
pub use mechanisms::{MechanismRow, Mechanisms};
pub use memory::{MEASURES_MEMORY, Memory};
pub use rock::{RockRow, RockSpeed};
pub use session::{Bench, Watcher};
pub use sweep::{SweepRow, Sweeps};
pub use well::MeasuredWell;
pub use whole_run::RunRow;

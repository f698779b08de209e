//! The limits of an event.

use wholestring::operation::Event;
use wholestring_judge::CheckKind;

/// Whether the peak of an event is compared with a limit: limits that do not depend on a peak are
/// left to the plan's states of equilibrium.
pub(super) const fn bears_on(event: Event, kind: CheckKind) -> bool {
    use CheckKind::{
        Hoist, MakeUp, Overpull, PumpPressure, Tension, TensionAndTorsion, TopDrivePeak, Torsion,
        VonMises,
    };
    match kind {
        Tension | VonMises | Hoist | Overpull => true,
        Torsion | TensionAndTorsion | MakeUp | TopDrivePeak => event.turns(),
        PumpPressure => event.circulates(),
        _ => false,
    }
}

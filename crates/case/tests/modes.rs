//! Linear vibration of every shipped case: each operation that has an equilibrium has as many modes
//! of each family as the case requests.

use std::{collections::BTreeSet, path::Path};

use wholestring::{operation::Operation, statics::stiff::StiffError};
use wholestring_case::load;
use wholestring_vibration::modal::{Family, ModalError, SmallMotions};

#[test]
fn every_shipped_case_has_its_modes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let mut without = BTreeSet::new();
    for ready in wholestring_cases::ALL {
        let case =
            load(&folder.join(ready.file_name), &[]).unwrap_or_else(|report| panic!("{report}"));
        let planned = case.plan.operations.iter().chain(&case.operations);
        let mut operations: Vec<Operation> = Vec::new();
        for operation in planned {
            if operations.iter().all(|other| other.kind != operation.kind) {
                operations.push(*operation);
            }
        }
        for operation in operations {
            let name = format!("{} {}", ready.name, operation.kind.name());
            let settings = case.dynamics.stiff_string();
            let motions =
                match SmallMotions::new(&case.model, &operation, &settings, &case.dynamics) {
                    Ok(motions) => motions,
                    Err(ModalError::Stiff(
                        StiffError::LocksUp { .. } | StiffError::RunsAway { .. },
                    )) => {
                        without.insert(name);
                        continue;
                    }
                    Err(error) => panic!("{name}: {error}"),
                };
            let count = case.modes.count;
            for family in [Family::Axial, Family::Torsional] {
                let found = motions.family(family, count);
                let found = found.unwrap_or_else(|error| panic!("{name}: {error}"));
                assert_eq!(found.len(), count, "{name}");
                assert!(found.is_sorted_by(|a, b| a.frequency_Hz < b.frequency_Hz), "{name}");
            }
            let assembly = motions.assembly(case.modes.assembly_m);
            let lateral = assembly.lateral(0.0, count, motions.rotary_rad_per_s());
            let lateral = lateral.unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_eq!(lateral.len(), count, "{name}");
        }
    }
    // Without an equilibrium there is no linear vibration about it.
    let locks_up = BTreeSet::from(["lateral-that-cannot-be-drilled slide".to_owned()]);
    assert_eq!(without, locks_up);
}

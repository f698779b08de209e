//! Solid rock in the record of a run.

use serde_json::{Value as Json, json};
use wholestring::rock::DrillingSpec;

use crate::bit::face_settings;

/// The rock in bricks and the bit's face, for the record of a run.
pub(crate) fn settings(spec: &DrillingSpec) -> [Json; 2] {
    let (rock, block) = (&spec.block.rock, &spec.block);
    let json = json!({
        "strength_Pa": rock.ucs_Pa(),
        "cohesion_Pa": rock.cohesion_Pa,
        "friction_angle_rad": rock.friction_angle_rad,
        "dilation_angle_rad": rock.dilation_angle_rad,
        "youngs_modulus_Pa": rock.youngs_modulus_Pa,
        "poisson_ratio": rock.poisson_ratio,
        "density_kg_per_m3": rock.density_kg_per_m3,
        "tensile_strength_Pa": rock.tensile_strength_Pa,
        "tensile_fracture_energy_J_per_m2": rock.tensile_fracture_energy_J_per_m2,
        "crushing_energy_J_per_m3": rock.crushing_energy_J_per_m3,
        "compressive_fracture_energy_J_per_m2": rock.compressive_fracture_energy_J_per_m2,
        "pressure_Pa": block.pressure_Pa,
        "confinement_Pa": block.confinement_Pa,
        "friction": spec.contact.friction,
        "element_size_m": block.size_m[0],
        "density_factor": block.numerics.density_factor,
        "cells": block.cells,
    });
    [json, face_settings(&spec.bit)]
}

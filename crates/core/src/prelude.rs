//! Names that a program of torque, drag and dynamics needs, under one import.

pub use crate::{
    dynamics::{
        Accuracy, DynamicOutcome, DynamicsSettings, ElementLength, MeshSettings, Simulation,
    },
    model::Model,
    mud::Mud,
    operation::{Operation, OperationKind},
    rig::Rig,
    statics::soft::{SoftProfile, soft_string},
    string::{
        ComponentLength::{self, Metres, ToSurface},
        ComponentSpec, Material, StringSpec,
    },
    well::{Friction, Hole, HoleSection, Path, Station, Well},
};

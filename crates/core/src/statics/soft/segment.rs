//! A stretch of hole with the string in it, and its loads in an operation.

use super::{
    bearing::Carrier,
    hole::{Node, Stretch},
    load::{Load, Point, Totals},
};
use nalgebra::Vector3;

use crate::{
    model::Model,
    mud::{ColumnLayers, Conduit, MudColumn},
    operation::Operation,
    statics::{
        buckling::{Criterion, Pipe, Place},
        circulation::{Circulating, Passage},
        sliding::Sliding,
    },
    string::{Component, FreeStrain},
};

/// An operation on a [`Stretch`] of hole.
pub(super) struct Segment<'a> {
    /// Upper and lower end, m.
    pub(super) from_md_m: f64,
    pub(super) to_md_m: f64,
    weight_N_per_m: f64,
    contact_radius_m: f64,
    /// Coefficients of friction along and around.
    friction: (f64, f64),
    /// Parts of the sliding direction along and around.
    sliding: (f64, f64),
    axial_stiffness_N: f64,
    torsional_stiffness_N_m2: f64,
    free_strain: FreeStrain,
    layers: ColumnLayers,
    outer_diameter_m: f64,
    hole_diameter_m: f64,
    pub(super) circulating: Circulating,
    pub(super) carrier: Carrier<'a>,
    pipe: Pipe,
    pub(super) buckling: Criterion,
}

/// Whether the wall is pressed by a helix too.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Course {
    Straight,
    Helix,
}

impl Course {
    pub(super) fn other(self) -> Self {
        match self {
            Self::Straight => Self::Helix,
            Self::Helix => Self::Straight,
        }
    }
}

impl<'a> Segment<'a> {
    pub(super) fn new(
        model: &'a Model,
        mud: &MudColumn,
        operation: &Operation,
        sliding: Sliding,
        &Stretch { from_md_m, to_md_m, .. }: &Stretch,
    ) -> Self {
        let middle_m = 0.5 * (from_md_m + to_md_m);
        let (_, component): (_, &Component) =
            model.string.component_at(operation.bit_depth_m - middle_m);
        let friction = model.well.hole.at(middle_m).friction;
        let layers = mud.layers_at(middle_m);
        let densities = layers.densities();
        let contact_radius_m = component.contact_radius_m();
        let hole = model.well.hole.at(middle_m);
        Self {
            from_md_m,
            to_md_m,
            weight_N_per_m: component.weight_in_N_per_m(densities),
            contact_radius_m,
            friction: (friction.kinetic, friction.kinetic * friction.around),
            sliding: sliding.direction(contact_radius_m),
            axial_stiffness_N: component.axial_stiffness_N(),
            torsional_stiffness_N_m2: component.torsional_stiffness_N_m2(),
            free_strain: FreeStrain::of(component),
            layers,
            outer_diameter_m: component.od_m,
            hole_diameter_m: hole.diameter_m,
            circulating: Circulating::default(),
            carrier: Carrier::new(
                model,
                operation,
                component,
                hole.diameter_m,
                densities.inside_kg_per_m3,
            ),
            pipe: Pipe::new(component, hole.diameter_m, densities),
            buckling: model.buckling,
        }
    }

    pub(super) fn passage(&self) -> Passage {
        let bore_m2 = self.free_strain.bore_m2;
        Passage {
            length_m: self.to_md_m - self.from_md_m,
            conduit: Conduit::uniform(self.outer_diameter_m, bore_m2, self.hole_diameter_m),
            free_strain: self.free_strain,
            inside: self.layers.inside.fluid,
            annulus: self.layers.annulus.fluid,
        }
    }

    /// Whether the drag of its helix alone makes a compression infinite within a step, m:
    /// `dF/dx = μ r F²/(4 EI)` does so within `F` over that.
    pub(super) fn locks_up(&self, tension_N: f64, step_m: f64) -> bool {
        let drag_N_per_m =
            self.friction.0 * self.sliding.0 * self.pipe.helix_load_N_per_m(tension_N);
        drag_N_per_m * step_m >= -tension_N
    }

    pub(super) fn place(&self, point: &Point) -> Place {
        self.pipe.at(&point.tangent, &point.curvature_per_m)
    }

    pub(super) fn course(&self, helix_counts: bool, point: &Point, tension_N: f64) -> Course {
        match helix_counts && self.place(point).is_helix(self.buckling, -tension_N) {
            true => Course::Helix,
            false => Course::Straight,
        }
    }

    pub(super) fn load(&self, point: &Point, tension_N: f64, course: Course) -> Load {
        let down = Vector3::z();
        let across = down - point.tangent * point.tangent.z;
        // q = F κ n + w (k − (k·t) t).
        let q_N_per_m = point.curvature_per_m * tension_N + across * self.weight_N_per_m;
        let side_force_N_per_m = q_N_per_m.norm()
            + match course {
                Course::Straight => 0.0,
                Course::Helix => self.pipe.helix_load_N_per_m(tension_N),
            };
        let (mu_along, mu_around) = self.friction;
        let (along, around) = self.sliding;
        Load {
            q_N_per_m,
            side_force_N_per_m,
            // Friction is positive where it adds to hook load: against the motion along the hole.
            axial_friction_N_per_m: -mu_along * side_force_N_per_m * along,
            friction_torque_N_m_per_m: mu_around
                * side_force_N_per_m
                * around
                * self.contact_radius_m,
        }
    }

    /// Change per metre upwards.
    pub(super) fn rate(&self, point: &Point, at: &Totals, course: Course) -> Totals {
        self.rate_under(point, at, &self.load(point, at.tension_N, course))
    }

    /// The same where the load is known.
    pub(super) fn rate_under(&self, point: &Point, at: &Totals, load: &Load) -> Totals {
        // One fluid on each side of the stretch: its temperature alone depends on measured depth.
        let around = self.layers.surroundings(point.md_m, point.tvd_m);
        // Upwards, so with the opposite signs of dF/ds and dM/ds.
        Totals {
            tension_N: self.weight_N_per_m * point.tangent.z
                + load.axial_friction_N_per_m
                + self.circulating.pull_N_per_m,
            torque_N_m: load.friction_torque_N_m_per_m + self.circulating.torque_N_m_per_m,
            axial_friction_N: load.axial_friction_N_per_m,
            side_force_N: load.side_force_N_per_m,
            stretch_m: at.tension_N / self.axial_stiffness_N
                + self.free_strain.strain(&around)
                + self.circulating.strain,
            twist_rad: at.torque_N_m / self.torsional_stiffness_N_m2,
        }
    }

    /// Pressures outside and inside at a node of the stretch, Pa.
    pub(super) fn pressures_Pa(&self, node: &Node) -> [f64; 2] {
        let [outside_Pa, inside_Pa] = [&self.layers.annulus, &self.layers.inside]
            .map(|layer| layer.pressure_Pa(node.point.tvd_m));
        // The losses of the flow change linearly along the stretch.
        let up_m = self.to_md_m - node.md_m;
        let Circulating { outer_Pa, outer_fall_Pa_per_m, inner_Pa, inner_rise_Pa_per_m, .. } =
            self.circulating;
        [
            outside_Pa + outer_Pa - outer_fall_Pa_per_m * up_m,
            inside_Pa + inner_Pa + inner_rise_Pa_per_m * up_m,
        ]
    }
}

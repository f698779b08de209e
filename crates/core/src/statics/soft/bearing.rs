//! What a stretch of the string bears at a depth: its metal, its joints, its surface.

use nalgebra::Vector3;

use super::load::{Load, Point, Totals};
use crate::{
    model::Model,
    operation::Operation,
    statics::span::JointSpan,
    string::{BodySection, Component},
};

/// A share of the load below this is rounding, not a direction.
const NO_SIDE: f64 = 1e-9;

/// What a stretch of one component in one hole section carries its loads with.
pub(super) struct Carrier<'a> {
    component: &'a Component,
    section: BodySection,
    span: Option<JointSpan>,
    /// Distance of the component's axis from the hole's where it lies on the wall, m.
    clearance_m: f64,
    /// `ρ Q²`, N·m².
    stream_N_m2: f64,
    axial_m_per_s: f64,
    rotation_rad_per_s: f64,
}

/// What it bears at a depth.
pub(super) struct Bearing {
    pub(super) climb_rad: Option<f64>,
    pub(super) lateral_offset_m: f64,
    pub(super) side_force_per_joint_N: Option<f64>,
    pub(super) outside_pressure_Pa: f64,
    pub(super) inside_pressure_Pa: f64,
    pub(super) true_tension_N: f64,
    pub(super) bending_moment_N_m: f64,
    pub(super) bending_stress_Pa: f64,
    pub(super) von_mises_stress_Pa: f64,
    pub(super) yield_use: Option<f64>,
    pub(super) wear_power_W_per_m: f64,
}

impl<'a> Carrier<'a> {
    pub(super) fn new(
        model: &Model,
        operation: &Operation,
        component: &'a Component,
        hole_diameter_m: f64,
    ) -> Self {
        let flow_m3_per_s = match model.mud.rheology {
            Some(_) => operation.flow_now_m3_per_s(),
            None => 0.0,
        };
        Self {
            component,
            section: BodySection::of(component),
            span: JointSpan::of(component),
            clearance_m: (0.5 * hole_diameter_m - component.contact_radius_m()).max(0.0),
            stream_N_m2: model.mud.density_kg_per_m3 * flow_m3_per_s * flow_m3_per_s,
            axial_m_per_s: operation.axial_velocity_m_per_s(),
            rotation_rad_per_s: operation.rotation_rad_per_s(),
        }
    }

    /// What it bears at a point of the path, with the pressures outside and inside, Pa.
    pub(super) fn bears(
        &self,
        point: &Point,
        high_side: &Vector3<f64>,
        load: &Load,
        totals: &Totals,
        [outside_Pa, inside_Pa]: [f64; 2],
    ) -> Bearing {
        let component = self.component;
        let bending_N_m =
            component.bending_stiffness_N_m2() * self.curvature_per_m(point, load, totals);
        let burst_Pa = inside_Pa - outside_Pa;
        let stress_Pa = self.section.von_mises_Pa(
            totals.tension_N,
            bending_N_m,
            totals.torque_N_m,
            burst_Pa * burst_Pa,
        );
        let side = load.q_N_per_m.dot(high_side);
        let signed_N_per_m = load.side_force_N_per_m.copysign(side);
        Bearing {
            climb_rad: climb_rad(point, high_side, load),
            lateral_offset_m: self.clearance_m,
            side_force_per_joint_N: component
                .joints
                .map(|joints| signed_N_per_m * joints.spacing_m),
            outside_pressure_Pa: outside_Pa,
            inside_pressure_Pa: inside_Pa,
            true_tension_N: component.true_tension_N(
                totals.tension_N,
                outside_Pa,
                inside_Pa,
                self.stream_N_m2,
            ),
            bending_moment_N_m: bending_N_m,
            bending_stress_Pa: bending_N_m * self.section.per_modulus_m3,
            von_mises_stress_Pa: stress_Pa,
            yield_use: component.yield_strength_Pa.map(|yields_Pa| stress_Pa / yields_Pa),
            wear_power_W_per_m: self.rotation_rad_per_s * load.friction_torque_N_m_per_m
                - self.axial_m_per_s * load.axial_friction_N_per_m,
        }
    }

    /// The largest curvature that the body has near a point: the hole's, where tool joints hold it
    /// off the wall that at the joints or half-way between them, whichever is more.
    fn curvature_per_m(&self, point: &Point, load: &Load, totals: &Totals) -> f64 {
        let hole_per_m = point.curvature_per_m;
        let Some(span) = &self.span else {
            return hole_per_m.norm();
        };
        let Some(towards) = load.q_N_per_m.try_normalize(0.0) else {
            return hole_per_m.norm();
        };
        let bent = span.bending(totals.tension_N, load.side_force_N_per_m);
        [bent.at_joint_per_m, bent.at_middle_per_m]
            .map(|beyond_per_m| (hole_per_m + towards * beyond_per_m).norm())
            .into_iter()
            .fold(0.0, f64::max)
    }
}

/// Angle of the load from the low side, rad, positive to the right looking down the hole; none
/// without a load.
fn climb_rad(point: &Point, high_side: &Vector3<f64>, load: &Load) -> Option<f64> {
    let up = load.q_N_per_m.dot(high_side);
    let right = load.q_N_per_m.dot(&point.tangent.cross(high_side));
    let right = if right.abs() > NO_SIDE * load.side_force_N_per_m { right } else { 0.0 };
    (load.side_force_N_per_m > 0.0).then(|| right.atan2(-up))
}

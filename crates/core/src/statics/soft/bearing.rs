//! Loads of a stretch of the string at a depth: its metal, its joints, its surface.

use nalgebra::Vector3;

use super::load::{Load, Point, Totals};
use crate::{
    model::Model,
    operation::Operation,
    statics::span::{BodyContact, JointSpan},
    string::{BodySection, Component},
};

/// A share of the load below this is rounding, not a direction.
const NO_SIDE: f64 = 1e-9;

/// Load-carrying properties of a stretch of one component in one hole section.
pub(super) struct Carrier<'a> {
    component: &'a Component,
    section: BodySection,
    span: Option<JointSpan>,
    /// Distance of the component's axis from the hole's where it is on the wall, m.
    clearance_m: f64,
    /// `ρ Q²`, N·m².
    stream_N_m2: f64,
    axial_m_per_s: f64,
    rotation_rad_per_s: f64,
}

/// Its loads at a depth.
pub(super) struct Bearing {
    pub(super) climb_rad: Option<f64>,
    pub(super) lateral_offset_m: f64,
    pub(super) side_force_per_joint_N: Option<f64>,
    pub(super) outside_pressure_Pa: f64,
    pub(super) inside_pressure_Pa: f64,
    pub(super) true_tension_N: f64,
    pub(super) bending_moment_N_m: f64,
    pub(super) bending_moment_between_N_m: f64,
    pub(super) sag_m: f64,
    pub(super) body_contact_fraction: f64,
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
        inside_kg_per_m3: f64,
    ) -> Self {
        let flow_m3_per_s = match model.has_rheology() {
            true => operation.flow_now_m3_per_s(),
            false => 0.0,
        };
        Self {
            component,
            section: BodySection::of(component),
            span: JointSpan::of(component),
            clearance_m: (0.5 * hole_diameter_m - component.contact_radius_m()).max(0.0),
            stream_N_m2: inside_kg_per_m3 * flow_m3_per_s * flow_m3_per_s,
            axial_m_per_s: operation.axial_velocity_m_per_s(),
            rotation_rad_per_s: operation.rotation_rad_per_s(),
        }
    }

    /// Computes its loads at a point of the path, with the pressures outside and inside, Pa.
    pub(super) fn bears(
        &self,
        point: &Point,
        high_side: &Vector3<f64>,
        load: &Load,
        totals: &Totals,
        [outside_Pa, inside_Pa]: [f64; 2],
    ) -> Bearing {
        let component = self.component;
        let bent = self.bent(point, load, totals);
        let [at_joint_N_m, between_N_m] = self.moments_of_N_m(&bent);
        let bending_N_m = at_joint_N_m.max(between_N_m);
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
            bending_moment_N_m: at_joint_N_m,
            bending_moment_between_N_m: between_N_m,
            sag_m: bent.sag_m,
            body_contact_fraction: f64::from(u8::from(bent.touches)),
            bending_stress_Pa: bending_N_m * self.section.per_modulus_m3,
            von_mises_stress_Pa: stress_Pa,
            yield_use: component.yield_strength_Pa.map(|yields_Pa| stress_Pa / yields_Pa),
            wear_power_W_per_m: self.rotation_rad_per_s * load.friction_torque_N_m_per_m
                - self.axial_m_per_s * load.axial_friction_N_per_m,
        }
    }

    /// Bending moments of the body at the joints and half-way between them, N·m.
    pub(super) fn moments_N_m(&self, point: &Point, load: &Load, totals: &Totals) -> [f64; 2] {
        self.moments_of_N_m(&self.bent(point, load, totals))
    }

    fn moments_of_N_m(&self, bent: &Bent) -> [f64; 2] {
        let stiffness_N_m2 = self.component.bending_stiffness_N_m2();
        bent.curvatures_per_m.map(|per_m| stiffness_N_m2 * per_m)
    }

    /// Bending of the body near a point: that of the hole, plus its own where tool joints hold it
    /// off the wall.
    fn bent(&self, point: &Point, load: &Load, totals: &Totals) -> Bent {
        let hole_per_m = point.curvature_per_m;
        let Some(span) = &self.span else {
            return Bent {
                curvatures_per_m: [hole_per_m.norm(); 2],
                sag_m: 0.0,
                touches: load.side_force_N_per_m > 0.0,
            };
        };
        let towards = load.q_N_per_m.try_normalize(0.0).unwrap_or_default();
        let bent = span.bending(totals.tension_N, load.q_N_per_m.norm());
        Bent {
            curvatures_per_m: [bent.at_joint_per_m, bent.at_middle_per_m]
                .map(|beyond_per_m| (hole_per_m + towards * beyond_per_m).norm()),
            sag_m: bent.sag_m,
            touches: bent.contact != BodyContact::None,
        }
    }
}

/// Bending of a component's body near a point.
struct Bent {
    /// Curvature at the joints and half-way between them, 1/m.
    curvatures_per_m: [f64; 2],
    sag_m: f64,
    touches: bool,
}

/// Angle of the load from the low side, rad, positive to the right looking down the hole; none
/// without a load.
fn climb_rad(point: &Point, high_side: &Vector3<f64>, load: &Load) -> Option<f64> {
    let up = load.q_N_per_m.dot(high_side);
    let right = load.q_N_per_m.dot(&point.tangent.cross(high_side));
    let right = if right.abs() > NO_SIDE * load.side_force_N_per_m { right } else { 0.0 };
    (load.side_force_N_per_m > 0.0).then(|| libm::atan2(right, -up))
}

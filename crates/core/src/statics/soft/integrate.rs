//! Integration from the bit to the surface.

use nalgebra::Vector3;

use super::{
    SoftError, SoftSettings,
    bearing::{Bearing, Carrier},
    load::{Load, Point, Totals},
};
use crate::{
    model::{Model, MudColumn},
    mud::Hydraulics,
    operation::Operation,
    outcome::{hole_steps, spread},
    statics::{
        buckling::{Criterion, Pipe, Place},
        circulation::{self, Circulating, Passage},
        sliding::Sliding,
    },
    string::Component,
    well::Path,
};

/// A stretch of hole on which everything but the path's direction is constant.
struct Segment<'a> {
    /// Upper and lower end, m.
    from_md_m: f64,
    to_md_m: f64,
    weight_N_per_m: f64,
    contact_radius_m: f64,
    /// Coefficients of friction along and around.
    friction: (f64, f64),
    /// Parts of the sliding direction along and around.
    sliding: (f64, f64),
    axial_stiffness_N: f64,
    torsional_stiffness_N_m2: f64,
    /// `(1 - 2ν)/E`, 1/Pa.
    pressure_strain_per_Pa: f64,
    mud: MudColumn,
    outer_diameter_m: f64,
    bore_m2: f64,
    hole_diameter_m: f64,
    circulating: Circulating,
    carrier: Carrier<'a>,
    pipe: Pipe,
    buckling: Criterion,
}

/// State and load at one depth.
pub(super) struct Row {
    pub(super) md_m: f64,
    pub(super) totals: Totals,
    pub(super) load: Load,
    pub(super) high_side: Vector3<f64>,
    pub(super) bearing: Bearing,
    /// Of the sinusoid and the helix; none where there is no clearance.
    pub(super) buckling_loads_N: Option<[f64; 2]>,
}

/// Whether the wall is pressed by a helix too.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Course {
    Straight,
    Helix,
}

impl Course {
    fn other(self) -> Self {
        match self {
            Self::Straight => Self::Helix,
            Self::Helix => Self::Straight,
        }
    }
}

impl Segment<'_> {
    /// Whether the drag of its helix alone makes a compression infinite within a step, m:
    /// `dF/dx = μ r F²/(4 EI)` does so within `F` over that.
    fn locks_up(&self, tension_N: f64, step_m: f64) -> bool {
        let drag_N_per_m =
            self.friction.0 * self.sliding.0 * self.pipe.helix_load_N_per_m(tension_N);
        drag_N_per_m * step_m >= -tension_N
    }

    fn place(&self, point: &Point) -> Place {
        self.pipe.at(&point.tangent, &point.curvature_per_m)
    }

    fn course(&self, helix_counts: bool, point: &Point, tension_N: f64) -> Course {
        match helix_counts && self.place(point).is_helix(self.buckling, -tension_N) {
            true => Course::Helix,
            false => Course::Straight,
        }
    }

    fn load(&self, point: &Point, tension_N: f64, course: Course) -> Load {
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
    fn rate(&self, point: &Point, at: &Totals, course: Course) -> Totals {
        let load = self.load(point, at.tension_N, course);
        // Upwards, so with the opposite signs of dF/ds and dM/ds.
        let pressure_Pa = self.mud.pressure_Pa(point.tvd_m);
        Totals {
            tension_N: self.weight_N_per_m * point.tangent.z
                + load.axial_friction_N_per_m
                + self.circulating.pull_N_per_m,
            torque_N_m: load.friction_torque_N_m_per_m + self.circulating.torque_N_m_per_m,
            axial_friction_N: load.axial_friction_N_per_m,
            side_force_N: load.side_force_N_per_m,
            stretch_m: at.tension_N / self.axial_stiffness_N
                - self.pressure_strain_per_Pa * pressure_Pa
                + self.circulating.strain,
            twist_rad: at.torque_N_m / self.torsional_stiffness_N_m2,
        }
    }

    fn row(
        &self,
        path: &Path,
        md_m: f64,
        point: &Point,
        totals: &Totals,
        helix_counts: bool,
    ) -> Row {
        let high_side = path.high_side_of(md_m, &point.tangent);
        let course = self.course(helix_counts, point, totals.tension_N);
        let load = self.load(point, totals.tension_N, course);
        let at_rest_Pa = self.mud.pressure_Pa(point.tvd_m);
        // The losses of the flow change linearly along the stretch.
        let up_m = self.to_md_m - md_m;
        let Circulating { outer_Pa, outer_fall_Pa_per_m, inner_Pa, inner_rise_Pa_per_m, .. } =
            self.circulating;
        let pressures_Pa = [
            at_rest_Pa + outer_Pa - outer_fall_Pa_per_m * up_m,
            at_rest_Pa + inner_Pa + inner_rise_Pa_per_m * up_m,
        ];
        let bearing = self.carrier.bears(point, &high_side, &load, totals, pressures_Pa);
        let buckling_loads_N = self.place(point).loads_N(self.buckling, -totals.tension_N);
        Row { md_m, totals: *totals, load, high_side, bearing, buckling_loads_N }
    }
}

/// Ends of the stretches, from the bit up: where the path's curvature, the component or the hole
/// section may change.
fn ends(model: &Model, bit_depth_m: f64) -> Vec<f64> {
    let stations = model.well.path.stations().iter().map(|station| station.md_m);
    let sections = model.well.hole.sections().iter().map(|section| section.to_md_m);
    let components = model.string.spans().map(|span| bit_depth_m - span.to_bit_m);
    let mut ends: Vec<f64> = stations
        .chain(sections)
        .chain(components)
        .filter(|&md_m| md_m > SHORTEST_SEGMENT_M && md_m < bit_depth_m - SHORTEST_SEGMENT_M)
        .chain([0.0, bit_depth_m])
        .collect();
    ends.sort_by(|a, b| b.total_cmp(a));
    ends.dedup_by(|above, below| *below - *above < SHORTEST_SEGMENT_M);
    ends
}

/// Boundaries that lie closer together than this are one, m.
const SHORTEST_SEGMENT_M: f64 = 1e-6;

fn segment<'a>(
    model: &'a Model,
    operation: &Operation,
    sliding: Sliding,
    to_md_m: f64,
    from_md_m: f64,
) -> Segment<'a> {
    let middle_m = 0.5 * (from_md_m + to_md_m);
    let (_, component): (_, &Component) =
        model.string.component_at(operation.bit_depth_m - middle_m);
    let friction = model.well.hole.at(middle_m).friction;
    let mud_density = model.mud.density_kg_per_m3;
    let contact_radius_m = component.contact_radius_m();
    let material = &component.material;
    let hole = model.well.hole.at(middle_m);
    Segment {
        from_md_m,
        to_md_m,
        weight_N_per_m: component.buoyed_weight_per_length_N_per_m(mud_density),
        contact_radius_m,
        friction: (friction.kinetic, friction.kinetic * friction.around),
        sliding: sliding.direction(contact_radius_m),
        axial_stiffness_N: component.axial_stiffness_N(),
        torsional_stiffness_N_m2: component.torsional_stiffness_N_m2(),
        pressure_strain_per_Pa: (1.0 - 2.0 * material.poisson_ratio()) / material.youngs_modulus_Pa,
        mud: model.mud_column(),
        outer_diameter_m: component.od_m,
        bore_m2: component.inner_area_m2(),
        hole_diameter_m: hole.diameter_m,
        circulating: Circulating::default(),
        carrier: Carrier::new(model, operation, component, hole.diameter_m),
        pipe: Pipe::new(component, hole.diameter_m, mud_density),
        buckling: model.buckling,
    }
}

impl Segment<'_> {
    fn passage(&self) -> Passage {
        Passage {
            length_m: self.to_md_m - self.from_md_m,
            od_m: self.outer_diameter_m,
            bore_m2: self.bore_m2,
            hole_diameter_m: self.hole_diameter_m,
            pressure_strain_per_Pa: self.pressure_strain_per_Pa,
        }
    }
}

/// One step of the classical Runge-Kutta method, up by `step_m`, through three points of the path.
fn step(
    segment: &Segment<'_>,
    points: [&Point; 3],
    step_m: f64,
    at: Totals,
    course: Course,
) -> Totals {
    let [lower, middle, upper] = points;
    let k1 = segment.rate(lower, &at, course);
    let k2 = segment.rate(middle, &(at + k1 * (0.5 * step_m)), course);
    let k3 = segment.rate(middle, &(at + k2 * (0.5 * step_m)), course);
    let k4 = segment.rate(upper, &(at + k3 * step_m), course);
    at + (k1 + (k2 + k3) * 2.0 + k4) * (step_m / 6.0)
}

/// The step from a lower to an upper depth in which a helix begins or ends: to there, and on from
/// there.
fn divided(
    segment: &Segment<'_>,
    path: &Path,
    [lower_md_m, upper_md_m]: [f64; 2],
    [lower, _, upper]: [&Point; 3],
    at: Totals,
    course: Course,
) -> Totals {
    let length_m = lower_md_m - upper_md_m;
    // The depth below surface, which only the pressures see, changes linearly.
    let point = |part: f64| {
        let tvd_m = lower.tvd_m + part * (upper.tvd_m - lower.tvd_m);
        Point::new(path.heading_at(lower_md_m - part * length_m), tvd_m)
    };
    let first = |part: f64| {
        let (middle, end) = (point(0.5 * part), point(part));
        let totals = step(segment, [lower, &middle, &end], part * length_m, at, course);
        (totals, end)
    };
    let (mut same, mut other) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let part = 0.5 * (same + other);
        let (totals, end) = first(part);
        if segment.course(true, &end, totals.tension_N) == course {
            same = part;
        } else {
            other = part;
        }
    }
    let (totals, there) = first(other);
    let middle = point(0.5 * (1.0 + other));
    let rest_m = (1.0 - other) * length_m;
    step(segment, [&there, &middle, upper], rest_m, totals, course.other())
}

/// Halvings of a step until nothing is left of it in double precision.
const HALVINGS: usize = 50;

/// What the integration found.
pub(super) struct Integral {
    /// Rows from the bit up, at least two.
    pub(super) rows: Vec<Row>,
    /// What has accumulated at the surface.
    pub(super) totals: Totals,
    /// What of it the uppermost metre adds.
    pub(super) per_metre_at_surface: Totals,
    /// Power of friction on each stretch of the hole, W.
    pub(super) hole_W: Vec<f64>,
    /// What the mud does, if it flows.
    pub(super) hydraulics: Option<Hydraulics>,
}

/// Integrates from the bit to the surface.
pub(super) fn from_bit(
    model: &Model,
    operation: &Operation,
    sliding: Sliding,
    settings: &SoftSettings,
) -> Result<Integral, SoftError> {
    let bit_depth_m = operation.bit_depth_m;
    let path = &model.well.path;
    let mut segments: Vec<Segment<'_>> = ends(model, bit_depth_m)
        .windows(2)
        .map(|pair| segment(model, operation, sliding, pair[0], pair[1]))
        .collect();
    let passages: Vec<Passage> = segments.iter().map(Segment::passage).collect();
    let (circulating, hydraulics) = circulation::along(model, operation, &passages);
    for (segment, circulating) in segments.iter_mut().zip(circulating) {
        segment.circulating = circulating;
    }
    // At the bit: F = P − WOB less the thrust of the jets, M = M_bit.
    let mut totals = Totals {
        tension_N: operation.tension_at_bit_N() - hydraulics.map_or(0.0, |mud| mud.jet_thrust_N),
        torque_N_m: operation.bit_torque_now_N_m(),
        axial_friction_N: 0.0,
        side_force_N: 0.0,
        stretch_m: 0.0,
        twist_rad: 0.0,
    };
    let axial_m_per_s = operation.axial_velocity_m_per_s();
    let rotation_rad_per_s = operation.rotation_rad_per_s();
    let helix_counts = settings.helix_side_force;
    let mut hole_W = vec![0.0; hole_steps(bit_depth_m)];
    let mut rows = Vec::new();
    let mut per_metre_at_surface = totals;
    for segment in &segments {
        let length_m = segment.to_md_m - segment.from_md_m;
        let count = (length_m / settings.step_m).ceil().max(1.0);
        let step_m = length_m / count;
        // The curvature may jump at the stretch's lower end: this is its value just above.
        let mut lower_md_m = segment.to_md_m;
        let mut lower =
            Point::new(path.heading_at(lower_md_m.next_down()), path.at(lower_md_m).position_m.z);
        for index in 1..=count as usize {
            let upper_md_m = if index == count as usize {
                segment.from_md_m
            } else {
                segment.to_md_m - index as f64 * step_m
            };
            rows.push(segment.row(path, lower_md_m, &lower, &totals, helix_counts));
            let middle = path.heading_at(0.5 * (lower_md_m + upper_md_m));
            let upper = path.heading_at(upper_md_m);
            // Simpson's rule from the stretch's lower end up: `κ⁴ step⁵/2880` a step, for
            // pressures.
            let [low_z, middle_z, up_z] = [lower.tangent.z, middle.tangent.z, upper.tangent.z];
            let middle_tvd_m = lower.tvd_m - step_m / 24.0 * (5.0 * low_z + 8.0 * middle_z - up_z);
            let upper_tvd_m = lower.tvd_m - step_m / 6.0 * (low_z + 4.0 * middle_z + up_z);
            let middle = Point::new(middle, middle_tvd_m);
            let upper = Point::new(upper, upper_tvd_m);
            let before = totals;
            let course = segment.course(helix_counts, &lower, totals.tension_N);
            let points = [&lower, &middle, &upper];
            totals = step(segment, points, step_m, totals, course);
            if helix_counts {
                if course == Course::Helix && segment.locks_up(before.tension_N, step_m) {
                    return Err(SoftError::LocksUp { md_m: lower_md_m });
                }
                if segment.course(helix_counts, &upper, totals.tension_N) != course {
                    let mds_m = [lower_md_m, upper_md_m];
                    totals = divided(segment, path, mds_m, points, before, course);
                }
            }
            if !(totals.tension_N.is_finite()
                && totals.torque_N_m.is_finite()
                && totals.stretch_m.is_finite()
                && totals.twist_rad.is_finite())
            {
                return Err(SoftError::NotFinite { md_m: upper_md_m });
            }
            let mud_N_m = segment.circulating.torque_N_m_per_m * step_m;
            let rubbed_N_m = totals.torque_N_m - before.torque_N_m - mud_N_m;
            // Force times sliding speed, about and along; what the mud takes does not rub the wall.
            let rubbed_W = rotation_rad_per_s * rubbed_N_m
                - axial_m_per_s * (totals.axial_friction_N - before.axial_friction_N);
            spread(&mut hole_W, upper_md_m, lower_md_m, rubbed_W);
            (lower_md_m, lower) = (upper_md_m, upper);
        }
        // The uppermost stretch ends at the surface, with a row of its own.
        if segment.from_md_m == 0.0 {
            rows.push(segment.row(path, 0.0, &lower, &totals, helix_counts));
            let course = segment.course(helix_counts, &lower, totals.tension_N);
            per_metre_at_surface = segment.rate(&lower, &totals, course);
        }
    }
    Ok(Integral { rows, totals, per_metre_at_surface, hole_W, hydraulics })
}

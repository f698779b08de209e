//! The string as a list of parts, before it is known how deep the bit is.

use super::{
    Blades, BodyBend, Component, ConnectionStrength, DrillString, Eccentricity, LateralForce,
    Material, ToolJoints, body, catalogue::PipeClass, component::ring_area_m2,
};

/// Length of a component of a [`StringSpec`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ComponentLength {
    /// A length, m.
    Metres(f64),
    /// Whatever is left between the components below it and the surface.
    ToSurface,
}

/// A component whose length may depend on the depth of the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct ComponentSpec {
    /// Name given by the user.
    pub name: String,
    /// Length.
    pub length: ComponentLength,
    /// Outside diameter of the body, m.
    pub od_m: f64,
    /// Inside diameter of the body, m; zero for a solid bar.
    pub id_m: f64,
    /// Mass per length in air, kg/m, tool joints included.
    pub mass_per_length_kg_per_m: f64,
    /// Tool joints, if it has any.
    pub joints: Option<ToolJoints>,
    /// Blades, if it has any: instead of joints.
    pub blades: Option<Blades>,
    /// Material.
    pub material: Material,
    /// Minimum yield strength, Pa, where known.
    pub yield_strength_Pa: Option<f64>,
    /// Wear class of its body: [`Self::od_m`] is the remaining diameter.
    pub class: PipeClass,
    /// Strength of its connections.
    pub connection: ConnectionStrength,
    /// A bend of its body.
    pub bend: Option<BodyBend>,
    /// Steel off the axis.
    pub eccentricity: Option<Eccentricity>,
    /// Distance of its survey sensor from the lower end, m, if it holds one.
    pub survey_sensor_m: Option<f64>,
    /// A force across it.
    pub lateral_force: Option<LateralForce>,
}

impl ComponentSpec {
    /// Plain pipe: no joints, its mass that of the ring between `id_m` and `od_m`.
    pub fn uniform(
        name: impl Into<String>,
        od_m: f64,
        id_m: f64,
        length: ComponentLength,
        material: Material,
    ) -> Self {
        Self {
            name: name.into(),
            length,
            od_m,
            id_m,
            mass_per_length_kg_per_m: material.density_kg_per_m3 * ring_area_m2(od_m, id_m),
            joints: None,
            blades: None,
            material,
            yield_strength_Pa: None,
            class: PipeClass::New,
            connection: ConnectionStrength::default(),
            bend: None,
            eccentricity: None,
            survey_sensor_m: None,
            lateral_force: None,
        }
    }

    fn with_length(&self, length_m: f64) -> Component {
        Component {
            name: self.name.clone(),
            length_m,
            od_m: self.od_m,
            id_m: self.id_m,
            mass_per_length_kg_per_m: self.mass_per_length_kg_per_m,
            joints: self.joints,
            blades: self.blades,
            material: self.material,
            yield_strength_Pa: self.yield_strength_Pa,
            class: self.class,
            connection: self.connection,
            bend: self.bend,
            eccentricity: self.eccentricity,
            survey_sensor_m: self.survey_sensor_m,
            lateral_force: self.lateral_force,
        }
    }

    /// The first field with a value that no component can have.
    fn bad_field(&self) -> Option<(&'static str, f64, &'static str)> {
        let positive = |field, value: f64| {
            (field, value, value.is_finite() && value > 0.0, "a positive number")
        };
        let id = self.id_m.is_finite() && self.id_m >= 0.0 && self.id_m < self.od_m;
        let around = |od_m: f64| od_m.is_finite() && od_m >= self.od_m;
        let an_angle = |field, value: f64| (field, value, value.is_finite(), "an angle");
        let mut fields = vec![
            positive("od", self.od_m),
            ("id", self.id_m, id, "zero or more, and less than od"),
            positive("mass_per_length", self.mass_per_length_kg_per_m),
            positive("density", self.material.density_kg_per_m3),
            positive("youngs_modulus", self.material.youngs_modulus_Pa),
            positive("shear_modulus", self.material.shear_modulus_Pa),
        ];
        let length_m = match self.length {
            ComponentLength::Metres(length_m) => length_m,
            ComponentLength::ToSurface => f64::MAX,
        };
        fields.push(positive("length", length_m));
        if let Some(joints) = self.joints {
            fields.push(("joint_od", joints.od_m, around(joints.od_m), "at least od"));
            fields.push(positive("joint_spacing", joints.spacing_m));
        }
        if let Some(blades) = self.blades {
            let od = around(blades.od_m) && self.joints.is_none();
            fields.push(("blade_od", blades.od_m, od, "at least od, without joints"));
            let length = blades.length_m > 0.0 && blades.length_m <= length_m;
            let expected = "more than zero, and no more than length";
            fields.push(("blade_length", blades.length_m, length, expected));
        }
        fields.extend(
            self.yield_strength_Pa
                .map(|yield_strength_Pa| positive("yield_strength", yield_strength_Pa)),
        );
        let make_up = self.connection.make_up_torque_N_m;
        fields.extend(make_up.map(|make_up| positive("make_up_torque", make_up)));
        if let Some(bend) = self.bend {
            let (angle, at) = (bend.angle_rad, bend.from_lower_end_m);
            fields.push(("bend", angle, angle.abs() <= MAX_BEND_RAD, "10 deg at most"));
            let inside = (0.0..=length_m).contains(&at);
            fields.push(("bend_at", at, inside, "a place on the component"));
            fields.push(an_angle("bend_toolface", bend.toolface_rad));
        }
        if let Some(lateral) = self.lateral_force {
            let (force, at) = (lateral.force_N, lateral.from_lower_end_m);
            fields.push(("lateral_force", force, force.is_finite(), "a force"));
            let inside = (0.0..=length_m).contains(&at);
            fields.push(("lateral_force_at", at, inside, "a place on the component"));
            fields.push(an_angle("lateral_force_toolface", lateral.toolface_rad));
        }
        if let Some(eccentricity) = self.eccentricity {
            let (offset, most) = (eccentricity.offset_m, body::MAX_ECCENTRIC * self.od_m);
            let small = (0.0..=most).contains(&offset);
            fields.push(("eccentricity", offset, small, "a tenth of od at most"));
            fields.push(an_angle("eccentricity_phase", eccentricity.phase_rad));
        }
        if let Some(at) = self.survey_sensor_m {
            let inside = (0.0..=length_m).contains(&at);
            fields.push(("survey_sensor", at, inside, "a place on the component"));
        }
        let wrong = fields.into_iter().find(|&(_, _, valid, _)| !valid);
        wrong.map(|(field, value, _, expected)| (field, value, expected))
    }
}

/// The string from the bit up, from which a [`DrillString`] is assembled for any depth of the bit.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StringSpec {
    /// Components from the bit up. At most one is [`ComponentLength::ToSurface`], and it is the
    /// last.
    pub components: Vec<ComponentSpec>,
}

/// Why a [`StringSpec`] makes no string. Components are counted from the bit, from zero.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum AssemblyError {
    /// No component at all.
    #[error("a string needs at least one component")]
    Empty,
    /// The depth of the bit is not a length.
    #[error("the bit depth must be a positive number of metres, more than a millimetre, got {0}")]
    BitDepth(f64),
    /// A value that no component can have, SI.
    #[error("component {index} (`{name}`): `{field}` must be {expected}, got {value}")]
    Dimension {
        /// Place of the component, counted from the bit.
        index: usize,
        /// Name of the component.
        name: String,
        /// Field, as case files spell it.
        field: &'static str,
        /// Value, SI.
        value: f64,
        /// Expected value.
        expected: &'static str,
    },
    /// More than one component runs to the surface.
    #[error("components {first} and {second} both run to the surface: only the topmost one can")]
    SecondToSurface {
        /// Place of the lower one.
        first: usize,
        /// Place of the upper one.
        second: usize,
    },
    /// A component that runs to the surface has another one above it.
    #[error(
        "component {index} (`{name}`) runs to the surface, but has {above} above it: it must \
         be the last"
    )]
    ToSurfaceNotLast {
        /// Place of the component.
        index: usize,
        /// Name of the component.
        name: String,
        /// Number of components above it.
        above: usize,
    },
    /// The components below the one that fills up to the surface are longer than the hole.
    #[error(
        "the components below `{name}` are {assembly_m:.3} m long, but the bit is only \
         {bit_depth_m:.3} m deep"
    )]
    AssemblyTooLong {
        /// Name of the component that runs to the surface.
        name: String,
        /// Length of everything below it, m.
        assembly_m: f64,
        /// Depth of the bit, m.
        bit_depth_m: f64,
    },
    /// Without a component that fills up, the lengths must add up to the bit depth.
    #[error(
        "the string is {string_m:.3} m long, {} than the bit depth of {bit_depth_m:.3} m: \
         adjust a length or let the topmost component run \"to surface\"",
        if string_m > bit_depth_m { "longer" } else { "shorter" }
    )]
    LengthMismatch {
        /// Sum of the lengths, m.
        string_m: f64,
        /// Depth of the bit, m.
        bit_depth_m: f64,
    },
}

/// Lengths that add up to the bit depth within this are taken as equal, m: tallies are written to
/// the millimetre at best.
const LENGTH_TOLERANCE_M: f64 = 1e-3;

/// Largest bend of a body, rad: adjustable housings have 3° at most, bent subs as much.
const MAX_BEND_RAD: f64 = 0.175;

/// Returns an error for a bend or a lateral force at the bit or at the surface, where there is no
/// node between the ends of the string.
fn all_inside(string: DrillString) -> Result<DrillString, AssemblyError> {
    let length_m = string.length_m();
    for (index, span) in string.spans().enumerate() {
        let component = span.component;
        let bend = component.bend.map(|bend| ("bend_at", bend.from_lower_end_m));
        let force = component
            .lateral_force
            .map(|lateral_force| ("lateral_force_at", lateral_force.from_lower_end_m));
        for (field, from_lower_end_m) in bend.into_iter().chain(force) {
            let at = span.from_bit_m + from_lower_end_m;
            if at < body::NEAREST_BEND_M || at > length_m - body::NEAREST_BEND_M {
                return Err(AssemblyError::Dimension {
                    index,
                    name: component.name.clone(),
                    field,
                    value: from_lower_end_m,
                    expected: "0.3 m from both ends of the string",
                });
            }
        }
    }
    Ok(string)
}

impl StringSpec {
    /// Checks every component and assembles the string for a depth of the bit, m.
    ///
    /// The component that runs to the surface fills the remaining length; where none remains it is
    /// not part of the string. Without one, the lengths must add up to the bit depth within a
    /// millimetre, and the topmost component absorbs the difference.
    pub fn assemble(&self, bit_depth_m: f64) -> Result<DrillString, AssemblyError> {
        if !(bit_depth_m.is_finite() && bit_depth_m > 0.0) {
            return Err(AssemblyError::BitDepth(bit_depth_m));
        }
        self.check()?;
        let mut components = Vec::with_capacity(self.components.len());
        let mut fixed_m = 0.0;
        for spec in &self.components {
            match spec.length {
                ComponentLength::Metres(length_m) => {
                    fixed_m += length_m;
                    components.push(spec.with_length(length_m));
                }
                ComponentLength::ToSurface => {
                    let left_m = bit_depth_m - fixed_m;
                    if left_m > LENGTH_TOLERANCE_M {
                        components.push(spec.with_length(left_m));
                        return all_inside(DrillString::new(components));
                    }
                    if components.is_empty() {
                        return Err(AssemblyError::BitDepth(bit_depth_m));
                    }
                    if left_m < -LENGTH_TOLERANCE_M {
                        return Err(AssemblyError::AssemblyTooLong {
                            name: spec.name.clone(),
                            assembly_m: fixed_m,
                            bit_depth_m,
                        });
                    }
                }
            }
        }
        let difference_m = bit_depth_m - fixed_m;
        let top_m = components.last().map_or(0.0, |top| top.length_m);
        if difference_m.abs() > LENGTH_TOLERANCE_M || top_m + difference_m <= 0.0 {
            return Err(AssemblyError::LengthMismatch { string_m: fixed_m, bit_depth_m });
        }
        if let Some(top) = components.last_mut() {
            top.length_m += difference_m;
        }
        all_inside(DrillString::new(components))
    }

    /// Checks that do not need the depth of the bit.
    fn check(&self) -> Result<(), AssemblyError> {
        if self.components.is_empty() {
            return Err(AssemblyError::Empty);
        }
        let mut to_surface = None;
        for (index, spec) in self.components.iter().enumerate() {
            if let Some((field, value, expected)) = spec.bad_field() {
                return Err(AssemblyError::Dimension {
                    index,
                    name: spec.name.clone(),
                    field,
                    value,
                    expected,
                });
            }
            if spec.length == ComponentLength::ToSurface {
                if let Some(first) = to_surface {
                    return Err(AssemblyError::SecondToSurface { first, second: index });
                }
                to_surface = Some(index);
            }
        }
        match to_surface {
            Some(index) if index + 1 < self.components.len() => {
                Err(AssemblyError::ToSurfaceNotLast {
                    index,
                    name: self.components[index].name.clone(),
                    above: self.components.len() - index - 1,
                })
            }
            _ => Ok(()),
        }
    }
}

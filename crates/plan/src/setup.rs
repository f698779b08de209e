//! Parts of a model, for any depth of the bit and any friction.

use wholestring::{
    ends::Ends,
    model::Model,
    mud::{Fluids, Mud},
    rig::Rig,
    statics::buckling::Criterion,
    string::{AssemblyError, ComponentLength, ComponentSpec, StringSpec},
    well::{Friction, Hole, HoleError, HoleKind, HoleSection, Well},
};

use crate::wear::CasingError;

/// Least length of pipe above the assembly, m, because a string of its assembly alone is not a
/// string.
const LEAST_PIPE_M: f64 = 1.0;

/// Length of pipe above the hole's depth for evaluations of the string as a whole, m.
const LONG_PIPE_M: f64 = 100.0;

/// A well, a string that is cut at the surface at any depth of the bit, a mud and a rig.
#[derive(Debug, Clone)]
pub struct Setup {
    /// Path of the hole and its sections, down to the deepest bit.
    pub well: Well,
    /// Components from the bit up.
    pub string: StringSpec,
    /// Drilling fluid.
    pub mud: Mud,
    /// Fluids that replace it in parts of the well.
    pub fluids: Fluids,
    /// Hoist and top drive.
    pub rig: Rig,
    /// Lateral supports of the ends of the string.
    pub ends: Ends,
    /// Criterion of the buckling loads that compression is compared with.
    pub buckling: Criterion,
}

/// Friction factors of a well: of its casings and of its open hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallFriction {
    /// Friction of every casing and liner.
    pub cased: Friction,
    /// Friction of the rock.
    pub open: Friction,
}

impl WallFriction {
    /// Returns the same friction everywhere.
    pub const fn uniform(coefficient: f64) -> Self {
        let friction = Friction::uniform(coefficient);
        Self { cased: friction, open: friction }
    }

    /// Returns the friction of one kind of hole.
    pub const fn of(&self, kind: HoleKind) -> Friction {
        match kind {
            HoleKind::Casing => self.cased,
            HoleKind::Open => self.open,
        }
    }
}

impl Setup {
    /// Returns the model with the bit at a measured depth, m: components are run from the bit up,
    /// so that the string is cut at the surface at any depth. Where no component runs to the
    /// surface, the topmost one does.
    ///
    /// # Errors
    /// A depth that is not positive, or a component that no string can have.
    pub fn at(&self, bit_depth_m: f64) -> Result<Model, AssemblyError> {
        let string = self.running().lower_end(bit_depth_m).assemble(bit_depth_m)?;
        Ok(Model {
            well: self.well.clone(),
            string,
            mud: self.mud,
            fluids: self.fluids.clone(),
            rig: self.rig,
            ends: self.ends,
            buckling: self.buckling,
        })
    }

    /// Returns the same with other friction factors.
    ///
    /// # Errors
    /// A factor that is out of its range.
    pub fn with_friction(&self, friction: &WallFriction) -> Result<Self, HoleError> {
        self.with_friction_of(|section| friction.of(section.kind))
    }

    /// Returns the same with the friction that is given for each section.
    ///
    /// # Errors
    /// A factor that is out of its range.
    pub fn with_friction_of(
        &self,
        friction: impl Fn(&HoleSection) -> Friction,
    ) -> Result<Self, HoleError> {
        let mut sections = self.well.hole.sections().to_vec();
        for section in &mut sections {
            section.friction = friction(section);
        }
        let hole = Hole::new(sections)?.with_roughness(self.well.hole.roughness().copied())?;
        Ok(Self { well: Well { path: self.well.path.clone(), hole }, ..self.clone() })
    }

    /// Returns the length of the components below the one that runs to the surface, m.
    pub fn below_topmost_m(&self) -> f64 {
        self.running().components.iter().map(length_m).sum()
    }

    /// Returns the distances from the bit of the ends of the components below the topmost, m.
    pub fn component_ends_m(&self) -> Vec<f64> {
        let mut to_m = 0.0;
        let components = self.running().components;
        let ends = components.iter().take(components.len().saturating_sub(1)).map(|component| {
            to_m += length_m(component);
            to_m
        });
        ends.collect()
    }

    /// Returns the length of the bottom-hole assembly, m: from the bit to the lower end of drill
    /// pipe. For a string without distinguishable drill pipe, the length below its topmost
    /// component.
    pub fn assembly_m(&self) -> f64 {
        let below_m = self.below_topmost_m();
        // At its largest length, because a component that is hardly in the hole is not recognised
        // as pipe.
        let hole_m = self.well.hole.sections().last().map_or(0.0, |section| section.to_md_m);
        let whole = self.running().assemble(below_m.max(hole_m) + LONG_PIPE_M);
        let assembly_m = whole.ok().and_then(|string| string.assembly_length_m());
        assembly_m.map_or(below_m, |length_m| length_m.min(below_m))
    }

    /// Returns the default shallowest depth of the bit of a plan, m: the assembly is in the hole,
    /// with a little pipe.
    pub fn shallowest_m(&self) -> f64 {
        self.assembly_m() + LEAST_PIPE_M
    }

    /// Returns the lower limit of all depths of the bit, m: its lowest component, the bit, is
    /// whole.
    pub fn least_depth_m(&self) -> f64 {
        match &self.running().components[..] {
            [bit, _, ..] => length_m(bit),
            _ => 0.0,
        }
    }

    /// Returns the string whose topmost component runs to the surface.
    fn running(&self) -> StringSpec {
        let mut string = self.string.clone();
        if let Some(top) = string.components.last_mut() {
            top.length = ComponentLength::ToSurface;
        }
        string
    }
}

/// Returns the length of a component, m; none of one that runs to the surface.
fn length_m(component: &ComponentSpec) -> f64 {
    match component.length {
        ComponentLength::Metres(length_m) => length_m,
        ComponentLength::ToSurface => 0.0,
    }
}

// Errors of a plan.

/// The reason why there is no plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// The friction factors are not valid for the hole.
    #[error(transparent)]
    Hole(#[from] HoleError),
    /// A casing cannot be worn.
    #[error(transparent)]
    Casing(#[from] CasingError),
}

#[cfg(test)]
mod tests {
    use wholestring::{
        prelude::*,
        statics::soft::soft_string,
        string::{ComponentLength::Metres, ComponentSpec},
    };

    use super::*;

    fn setup() -> Setup {
        let path = Path::minimum_curvature(&[
            Station::from_degrees(0.0, 0.0, 0.0),
            Station::from_degrees(500.0, 0.0, 0.0),
            Station::from_degrees(1400.0, 60.0, 0.0),
            Station::from_degrees(2000.0, 60.0, 0.0),
        ])
        .expect("a path");
        let hole = Hole::new(vec![
            HoleSection::casing(0.0..1000.0, 0.2224, 0.2),
            HoleSection::open(1000.0..2000.0, 0.2159, 0.3),
        ])
        .expect("a hole");
        let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3))
            .catalogue("6-1/2 in x 2-13/16 in collar", Metres(99.7))
            .and_then(|string| string.catalogue("5 in 19.50 lb/ft S-135", Metres(1900.0)))
            .expect("a string");
        Setup {
            well: Well { path, hole },
            string,
            mud: Mud::of_density(1200.0),
            fluids: Fluids::default(),
            rig: Rig::default(),
            ends: Ends::default(),
            buckling: Criterion::default(),
        }
    }

    #[test]
    fn pipe_is_laid_down_at_the_surface() {
        let setup = setup();
        assert!((setup.assembly_m() - 100.0).abs() < 1e-9);
        for depth_m in [100.5, 700.0, 2000.0] {
            let string = setup.at(depth_m).expect("a model").string;
            assert!((string.length_m() - depth_m).abs() < 1e-9);
            assert!((string.components()[1].length_m - 99.7).abs() < 1e-9);
        }
        assert!(matches!(setup.at(0.0), Err(AssemblyError::BitDepth(_))));
    }

    /// A tapered string begins with the bit just below the assembly, before its upper pipe is in
    /// the hole; one whose bit is shallower than the assembly has a part of that.
    #[test]
    fn a_string_is_cut_at_the_surface() {
        let mut setup = setup();
        setup.string.components[2].length = Metres(700.0);
        let upper =
            ComponentSpec { name: "upper pipe".into(), ..setup.string.components[2].clone() };
        setup.string.components.push(upper);
        assert!((setup.below_topmost_m() - 800.0).abs() < 1e-9);
        assert!((setup.assembly_m() - 100.0).abs() < 1e-9);
        for (depth_m, count, top_m) in
            [(50.0, 2, 49.7), (100.0, 2, 99.7), (500.0, 3, 400.0), (1000.0, 4, 200.0)]
        {
            let string = setup.at(depth_m).expect("a model").string;
            assert!((string.length_m() - depth_m).abs() < 1e-9);
            let components = string.components();
            assert_eq!(components.len(), count, "{depth_m}");
            assert!((components[count - 1].length_m - top_m).abs() < 1e-9, "{depth_m}");
        }
        // Off bottom the hook load of a vertical string is the weight in the hole.
        let depth_m = 400.0;
        let model = setup.at(depth_m).expect("a model");
        let turns = Operation::rotate_off_bottom(depth_m).rotary_speed_rad_per_s(7.0);
        let found = soft_string(&model, &turns).expect("an answer").scalars.hook_load_N;
        let weight_N = |index: usize, length_m: f64| {
            let component = &model.string.components()[index];
            let steel = component.mass_per_length_kg_per_m;
            let buoyed = 1.0 - 1200.0 / component.material.density_kg_per_m3;
            9.80665 * steel * length_m * buoyed
        };
        let expected_N = weight_N(0, 0.3) + weight_N(1, 99.7) + weight_N(2, 300.0);
        assert!((found / expected_N - 1.0).abs() < 1e-3, "{found} for {expected_N}");
    }

    #[test]
    fn each_kind_of_hole_has_its_friction() {
        let friction = WallFriction { cased: Friction::uniform(0.1), open: Friction::uniform(0.5) };
        let changed = setup().with_friction(&friction).expect("a setup");
        let [cased, open] = changed.well.hole.sections() else { panic!("two sections") };
        assert_eq!([cased.friction, open.friction], [friction.cased, friction.open]);
        assert!(setup().with_friction(&WallFriction::uniform(-0.1)).is_err());
        // Nothing else changes: without friction both hang the same.
        let hang = |setup: &Setup| {
            let model = setup.at(1500.0).expect("a model");
            soft_string(&model, &Operation::trip_out(1500.0)).expect("an answer").scalars
        };
        let smooth = WallFriction::uniform(0.0);
        let [first, second] =
            [setup(), changed].map(|setup| hang(&setup.with_friction(&smooth).expect("a setup")));
        assert_eq!(first.hook_load_N, second.hook_load_N);
    }
}

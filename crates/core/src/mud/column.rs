//! Fluids in the well by measured depth: inside the string and in the annulus.
//!
//! Theory: `docs/src/theory/mud.md`.

use serde::{Deserialize, Serialize};

use super::{Densities, Mud, Rheology};
use crate::{GRAVITY_M_PER_S2, string::Surroundings, well::Path};

/// A fluid other than the mud between two measured depths.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FluidInterval {
    /// Measured depth of its upper end, m.
    pub from_md_m: f64,
    /// Measured depth of its lower end, m.
    pub to_md_m: f64,
    /// Density, kg/m³; zero means air.
    pub density_kg_per_m3: f64,
    /// Rheology; without it the fluid flows without friction.
    pub rheology: Option<Rheology>,
    /// Temperatures at its upper and lower end, K, linear in measured depth between them; without
    /// them the string there has the temperature at which its length was measured.
    pub temperatures_K: Option<[f64; 2]>,
}

/// Fluids that replace the [mud](Mud) in parts of the well, from the surface down on each side;
/// everything else is full of mud.
///
/// ```
/// use wholestring::mud::{FluidInterval, Fluids};
///
/// // A casing that is filled to 400 m below the rig.
/// let fluids = Fluids { inside: vec![FluidInterval::air(400.0)], ..Fluids::default() };
/// assert!(fluids.check().is_ok());
/// ```
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Fluids {
    /// Fluids inside the string.
    pub inside: Vec<FluidInterval>,
    /// Fluids in the annulus.
    pub annulus: Vec<FluidInterval>,
}

/// The reason why intervals are no column.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum FluidsError {
    /// An interval without length, or one that begins above the surface or above the end of the
    /// interval before it.
    #[error(
        "fluid from MD {from_md_m} m to {to_md_m} m: intervals must be longer than zero, begin at \
         {least_md_m} m or deeper and be finite"
    )]
    Interval {
        /// Upper end, m.
        from_md_m: f64,
        /// Lower end, m.
        to_md_m: f64,
        /// Shallowest measured depth at which it can begin, m.
        least_md_m: f64,
    },
    /// A density that no fluid has.
    #[error("fluid from MD {from_md_m} m: the density must be zero or more, got {kg_per_m3} kg/m³")]
    Density {
        /// Upper end, m.
        from_md_m: f64,
        /// Density, kg/m³.
        kg_per_m3: f64,
    },
    /// A temperature that is not above absolute zero.
    #[error("fluid from MD {from_md_m} m: the temperature must be above 0 K, got {kelvin} K")]
    Temperature {
        /// Upper end, m.
        from_md_m: f64,
        /// Temperature, K.
        kelvin: f64,
    },
}

impl FluidInterval {
    /// A fluid of a density, kg/m³, between two measured depths, m, without rheology and
    /// temperature.
    pub const fn of_density(from_md_m: f64, to_md_m: f64, density_kg_per_m3: f64) -> Self {
        Self { from_md_m, to_md_m, density_kg_per_m3, rheology: None, temperatures_K: None }
    }

    /// Air from the surface to the free surface of the fluid below, m.
    pub const fn air(level_md_m: f64) -> Self {
        Self::of_density(0.0, level_md_m, 0.0)
    }

    fn check(&self, least_md_m: f64) -> Result<(), FluidsError> {
        let Self { from_md_m, to_md_m, density_kg_per_m3: kg_per_m3, .. } = *self;
        if !(from_md_m >= least_md_m && to_md_m > from_md_m && to_md_m.is_finite()) {
            return Err(FluidsError::Interval { from_md_m, to_md_m, least_md_m });
        }
        if !(kg_per_m3 >= 0.0 && kg_per_m3.is_finite()) {
            return Err(FluidsError::Density { from_md_m, kg_per_m3 });
        }
        let mut temperatures_K = self.temperatures_K.into_iter().flatten();
        match temperatures_K.find(|kelvin| !(*kelvin > 0.0 && kelvin.is_finite())) {
            Some(kelvin) => Err(FluidsError::Temperature { from_md_m, kelvin }),
            None => Ok(()),
        }
    }
}

/// The fluid of one side at a measured depth, m: at a boundary that of the interval above.
fn fluid_at(intervals: &[FluidInterval], mud: &Mud, md_m: f64) -> Mud {
    let interval = intervals.get(intervals.partition_point(|interval| interval.to_md_m < md_m));
    match interval.filter(|interval| interval.from_md_m < md_m || interval.from_md_m <= 0.0) {
        Some(&FluidInterval { density_kg_per_m3, rheology, .. }) => {
            Mud { density_kg_per_m3, rheology, ..*mud }
        }
        None => *mud,
    }
}

impl Fluids {
    /// Whether the mud fills the whole well.
    pub fn is_empty(&self) -> bool {
        self.inside.is_empty() && self.annulus.is_empty()
    }

    /// Whether the intervals of each side are in order and do not overlap, and their densities and
    /// temperatures are possible.
    ///
    /// # Errors
    /// The first interval that is not.
    pub fn check(&self) -> Result<(), FluidsError> {
        [&self.inside, &self.annulus].into_iter().try_for_each(|intervals| {
            intervals.iter().try_fold(0.0, |least_md_m, interval| {
                interval.check(least_md_m).map(|()| interval.to_md_m)
            })?;
            Ok(())
        })
    }

    /// The fluid inside the string at a measured depth, m; the drag coefficients are the mud's.
    pub fn inside_at(&self, mud: &Mud, md_m: f64) -> Mud {
        fluid_at(&self.inside, mud, md_m)
    }

    /// The fluid in the annulus at a measured depth, m.
    pub fn annulus_at(&self, mud: &Mud, md_m: f64) -> Mud {
        fluid_at(&self.annulus, mud, md_m)
    }

    /// Measured depths at which a fluid of either side begins or ends, m.
    pub fn boundaries_m(&self) -> impl Iterator<Item = f64> + '_ {
        let intervals = self.inside.iter().chain(&self.annulus);
        intervals.flat_map(|interval| [interval.from_md_m, interval.to_md_m])
    }

    /// Whether any fluid in the well has a rheology.
    pub fn has_rheology(&self, mud: &Mud) -> bool {
        let mut intervals = self.inside.iter().chain(&self.annulus);
        mud.rheology.is_some() || intervals.any(|interval| interval.rheology.is_some())
    }
}

/// A stretch of one fluid in a column at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FluidLayer {
    /// Measured depth of its upper end, m.
    pub from_md_m: f64,
    /// Measured depth of its lower end, m; infinite of the lowest layer.
    pub to_md_m: f64,
    /// The fluid.
    pub fluid: Mud,
    weight_N_per_m3: f64,
    top_tvd_m: f64,
    top_Pa: f64,
    temperatures_K: Option<[f64; 2]>,
}

impl FluidLayer {
    /// Hydrostatic pressure in the layer at a true vertical depth, Pa; never below zero, which the
    /// free surface and everything above it has.
    pub fn pressure_Pa(&self, tvd_m: f64) -> f64 {
        (self.top_Pa + self.weight_N_per_m3 * (tvd_m - self.top_tvd_m)).max(0.0)
    }

    /// Temperature at a measured depth, K, where it is known.
    pub fn temperature_K(&self, md_m: f64) -> Option<f64> {
        let [upper_K, lower_K] = self.temperatures_K?;
        let part = (md_m - self.from_md_m) / (self.to_md_m - self.from_md_m);
        Some(upper_K + (lower_K - upper_K) * part)
    }
}

/// Fluid at rest on one side of the string, from the surface to any depth.
#[derive(Debug, Clone, PartialEq)]
pub struct FluidColumn {
    lowest: FluidLayer,
    /// Layers above it, from the surface down; none of a column of one fluid.
    above: Vec<FluidLayer>,
}

impl FluidColumn {
    fn new(intervals: &[FluidInterval], mud: &Mud, path: &Path) -> Self {
        let tvd_m = |md_m: f64| path.at(md_m).position_m.z;
        let layer =
            |fluid: Mud, temperatures_K, [from_md_m, to_md_m]: [f64; 2], top_Pa| FluidLayer {
                from_md_m,
                to_md_m,
                fluid,
                weight_N_per_m3: fluid.density_kg_per_m3 * GRAVITY_M_PER_S2,
                top_tvd_m: tvd_m(from_md_m),
                top_Pa,
                temperatures_K,
            };
        let mut above: Vec<FluidLayer> = Vec::new();
        let (mut md_m, mut top_Pa) = (0.0, 0.0);
        for interval in intervals {
            let &FluidInterval { from_md_m, to_md_m, density_kg_per_m3, rheology, .. } = interval;
            if from_md_m > md_m {
                let mud_layer = layer(*mud, None, [md_m, from_md_m], top_Pa);
                top_Pa = mud_layer.pressure_Pa(tvd_m(from_md_m));
                above.push(mud_layer);
            }
            let fluid = Mud { density_kg_per_m3, rheology, ..*mud };
            let own = layer(fluid, interval.temperatures_K, [from_md_m, to_md_m], top_Pa);
            top_Pa = own.pressure_Pa(tvd_m(to_md_m));
            above.push(own);
            md_m = to_md_m;
        }
        Self { lowest: layer(*mud, None, [md_m, f64::INFINITY], top_Pa), above }
    }

    /// The layer at a measured depth, m: at a boundary the one above.
    pub fn at(&self, md_m: f64) -> &FluidLayer {
        let index = self.above.partition_point(|layer| layer.to_md_m < md_m);
        self.above.get(index).unwrap_or(&self.lowest)
    }

    /// Density at a measured depth, kg/m³.
    pub fn density_at(&self, md_m: f64) -> f64 {
        self.at(md_m).fluid.density_kg_per_m3
    }

    /// Rheology at a measured depth.
    pub fn rheology_at(&self, md_m: f64) -> Option<Rheology> {
        self.at(md_m).fluid.rheology
    }

    /// Temperature at a measured depth, K, where it is known.
    pub fn temperature_at(&self, md_m: f64) -> Option<f64> {
        self.at(md_m).temperature_K(md_m)
    }

    /// Hydrostatic pressure at a measured depth and the true vertical depth there, m, Pa: the
    /// weight of all fluid above, over its vertical depth. Zero at the surface and above.
    pub fn hydrostatic_pressure_Pa(&self, md_m: f64, tvd_m: f64) -> f64 {
        self.at(md_m).pressure_Pa(tvd_m)
    }

    /// Mean density between two measured depths, kg/m³.
    pub fn mean_density(&self, [from_md_m, to_md_m]: [f64; 2]) -> f64 {
        let upper = self.at(from_md_m);
        if upper.to_md_m >= to_md_m {
            return upper.fluid.density_kg_per_m3;
        }
        let layers = self.above.iter().chain([&self.lowest]);
        let masses = layers.map(|layer| {
            let length_m = layer.to_md_m.min(to_md_m) - layer.from_md_m.max(from_md_m);
            length_m.max(0.0) * layer.fluid.density_kg_per_m3
        });
        masses.sum::<f64>() / (to_md_m - from_md_m)
    }

    /// Largest density of its fluids, kg/m³.
    pub fn densest(&self) -> f64 {
        let densities = self.above.iter().map(|layer| layer.fluid.density_kg_per_m3);
        densities.fold(self.lowest.fluid.density_kg_per_m3, f64::max)
    }

    /// Density of one fluid that weighs as much down to a measured depth and the true vertical depth
    /// there, m, kg/m³.
    pub fn equivalent_density(&self, md_m: f64, tvd_m: f64) -> f64 {
        if self.above.is_empty() {
            return self.lowest.fluid.density_kg_per_m3;
        }
        let surface_m = self.at(0.0).top_tvd_m;
        self.hydrostatic_pressure_Pa(md_m, tvd_m) / (GRAVITY_M_PER_S2 * (tvd_m - surface_m))
    }
}

/// Fluids at rest in the well, with their free surface where measured depth begins unless
/// [air](FluidInterval::air) is above them.
#[derive(Debug, Clone, PartialEq)]
pub struct MudColumn {
    /// Inside the string.
    pub inside: FluidColumn,
    /// In the annulus.
    pub annulus: FluidColumn,
}

impl MudColumn {
    /// The mud with the fluids that replace it, in a hole of that path.
    pub fn new(mud: &Mud, fluids: &Fluids, path: &Path) -> Self {
        Self {
            inside: FluidColumn::new(&fluids.inside, mud, path),
            annulus: FluidColumn::new(&fluids.annulus, mud, path),
        }
    }

    /// Whether one fluid fills the whole well.
    pub fn is_uniform(&self) -> bool {
        self.inside.above.is_empty() && self.annulus.above.is_empty()
    }

    /// Densities of both sides at a measured depth.
    pub fn densities_at(&self, md_m: f64) -> Densities {
        Densities {
            inside_kg_per_m3: self.inside.density_at(md_m),
            annulus_kg_per_m3: self.annulus.density_at(md_m),
        }
    }

    /// Mean densities of both sides between two measured depths, m.
    pub fn mean_densities(&self, mds_m: [f64; 2]) -> Densities {
        Densities {
            inside_kg_per_m3: self.inside.mean_density(mds_m),
            annulus_kg_per_m3: self.annulus.mean_density(mds_m),
        }
    }

    /// The layers of both sides at a measured depth, m.
    pub fn layers_at(&self, md_m: f64) -> ColumnLayers {
        ColumnLayers { inside: *self.inside.at(md_m), annulus: *self.annulus.at(md_m) }
    }

    /// Pressures and temperature of the string at rest at a measured depth and the true vertical
    /// depth there, m.
    pub fn surroundings_at(&self, md_m: f64, tvd_m: f64) -> Surroundings {
        self.layers_at(md_m).surroundings(md_m, tvd_m)
    }

    /// Measured depths between two others at which a fluid of either side ends, m, from the surface
    /// down.
    pub fn boundaries_between(&self, [from_md_m, to_md_m]: [f64; 2]) -> Vec<f64> {
        let layers = self.inside.above.iter().chain(&self.annulus.above);
        let ends = layers.map(|layer| layer.to_md_m);
        let mut inside: Vec<f64> =
            ends.filter(|md_m| *md_m > from_md_m && *md_m < to_md_m).collect();
        inside.sort_by(f64::total_cmp);
        inside.dedup();
        inside
    }
}

/// Layers on both sides of a stretch of the string that has one fluid inside and one outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ColumnLayers {
    /// Inside the string.
    pub inside: FluidLayer,
    /// In the annulus.
    pub annulus: FluidLayer,
}

impl ColumnLayers {
    /// Densities of both sides.
    pub fn densities(&self) -> Densities {
        Densities {
            inside_kg_per_m3: self.inside.fluid.density_kg_per_m3,
            annulus_kg_per_m3: self.annulus.fluid.density_kg_per_m3,
        }
    }

    /// Pressures and temperature of the string at rest at a measured and a true vertical depth, m.
    /// The metal has the mean of the temperatures of both sides, or the only known one.
    pub fn surroundings(&self, md_m: f64, tvd_m: f64) -> Surroundings {
        let temperatures_K = [&self.inside, &self.annulus].map(|layer| layer.temperature_K(md_m));
        let temperature_K = match temperatures_K {
            [Some(inside_K), Some(annulus_K)] => Some(0.5 * (inside_K + annulus_K)),
            [one_K, other_K] => one_K.or(other_K),
        };
        Surroundings {
            outside_Pa: self.annulus.pressure_Pa(tvd_m),
            inside_Pa: self.inside.pressure_Pa(tvd_m),
            temperature_K,
        }
    }
}

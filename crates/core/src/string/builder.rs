//! A string from the bit up, component by component.

use super::{
    ComponentLength, ComponentSpec, Material, StringSpec,
    catalogue::{CatalogueError, find},
};

impl ComponentSpec {
    /// A bit of steel without a bore, diameter and length in m: its mass is that of a full
    /// cylinder.
    pub fn bit(diameter_m: f64, length_m: f64) -> Self {
        let length = ComponentLength::Metres(length_m);
        Self::uniform("bit", diameter_m, 0.0, length, Material::STEEL)
    }
}

/// From the bit up:
///
/// ```
/// use wholestring::prelude::*;
///
/// let string = StringSpec::from_bit(ComponentSpec::bit(0.2159, 0.3))
///     .catalogue("6-1/2 in x 2-13/16 in collar", Metres(80.0))?
///     .component(ComponentSpec::uniform("jar", 0.165, 0.07, Metres(10.0), Material::STEEL))
///     .catalogue("5 in 19.50 lb/ft S-135", ToSurface)?
///     .assemble(2500.0)?;
/// assert_eq!(string.length_m(), 2500.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
impl StringSpec {
    /// A string that begins with its lowest component.
    pub fn from_bit(bit: ComponentSpec) -> Self {
        Self { components: vec![bit] }
    }

    /// With one more component above the others.
    #[must_use]
    pub fn component(mut self, component: ComponentSpec) -> Self {
        self.components.push(component);
        self
    }

    /// With a tubular of the catalogue above the others, of steel and named by its designation.
    ///
    /// # Errors
    /// A designation that is not in the catalogue: the error names the nearest that are.
    pub fn catalogue(
        self,
        designation: &str,
        length: ComponentLength,
    ) -> Result<Self, CatalogueError> {
        let entry = find(designation)?;
        let name = entry.designation.clone();
        Ok(self.component(entry.component(name, length, Material::STEEL)))
    }
}

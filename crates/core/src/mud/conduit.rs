//! Mud along a stretch of the string that may span several components: each keeps its own bore and
//! its own annulus.
//!
//! Friction is proportional to the inverse fifth power of a diameter. The loss of a mean bore is
//! therefore no mean of the losses: a solid bit next to a collar would leave a bore as narrow as
//! rounding makes it.

use serde::{Deserialize, Serialize};

use super::{Annulus, AnnulusDrag, Motion, Mud, bore};
use crate::{string::DrillString, well::Hole};

/// Bore and annulus of a component over a part of a stretch.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ConduitPart {
    /// Part of the length of the stretch.
    pub part: f64,
    /// Area of the bore, m²; zero of a solid body.
    pub bore_m2: f64,
    /// Gap to the hole.
    pub annulus: Annulus,
}

/// Tolerance of the sum of all parts for rounding.
const WHOLE: f64 = 1e-6;

/// Bores and annuli of a stretch.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Conduit {
    parts: Vec<ConduitPart>,
}

impl Conduit {
    /// A stretch of one component.
    pub fn uniform(od_m: f64, bore_m2: f64, hole_diameter_m: f64) -> Self {
        let annulus = Annulus::new(od_m, hole_diameter_m);
        Self { parts: vec![ConduitPart { part: 1.0, bore_m2, annulus }] }
    }

    /// The stretch of a string between two distances from the bit, m, whose lower and upper ends are
    /// at measured depths, m. Each component has the hole at the middle of its part.
    pub fn between(
        string: &DrillString,
        hole: &Hole,
        [from_bit_m, to_bit_m]: [f64; 2],
        [lower_md_m, upper_md_m]: [f64; 2],
    ) -> Self {
        let mut below = 0.0;
        let parts = string.parts_between(from_bit_m, to_bit_m).map(|(component, part)| {
            let middle = below + 0.5 * part;
            below += part;
            let md_m = lower_md_m + middle * (upper_md_m - lower_md_m);
            ConduitPart {
                part,
                bore_m2: component.inner_area_m2(),
                annulus: Annulus::new(component.od_m, hole.at(md_m).diameter_m),
            }
        });
        Self { parts: parts.collect() }
    }

    /// Whether its parts add up to the stretch: not so of a stored one that is damaged.
    pub fn is_whole(&self) -> bool {
        let sum: f64 = self.parts.iter().map(|part| part.part).sum();
        (sum - 1.0).abs() < WHOLE
    }

    /// Mean drag of the annuli.
    pub fn drag(&self, mud: &Mud, motion: &Motion) -> AnnulusDrag {
        let drags = self.parts.iter().map(|part| part.annulus.drag(mud, motion) * part.part);
        drags.fold(AnnulusDrag::default(), |sum, drag| sum + drag)
    }

    /// Mean pressure gradient by friction in the bores, Pa/m, at a flow rate relative to the pipe.
    pub fn bore_gradient_Pa_per_m(&self, mud: &Mud, flow_m3_per_s: f64) -> f64 {
        let gradient =
            |part: &ConduitPart| bore::gradient_Pa_per_m(mud, part.bore_m2, flow_m3_per_s);
        self.parts.iter().map(|part| part.part * gradient(part)).sum()
    }

    /// Mean speed of the mud up the annuli, m/s.
    pub fn rising_m_per_s(&self, flow_m3_per_s: f64) -> f64 {
        self.parts.iter().map(|part| part.part * part.annulus.mean_m_per_s(flow_m3_per_s)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        common,
        mud::Rheology,
        random::Random,
        string::{ComponentLength, ComponentSpec, StringSpec},
    };

    /// Strings of random lengths in elements of random lengths, whose ends fall on those of the
    /// components but for rounding, or anywhere: the loss in the elements equals the loss in the
    /// components, each by the closed forms of its own bore. Before, the sliver of a collar's bore
    /// in the element of a solid bit cost 1e38 Pa.
    #[test]
    fn losses_do_not_depend_on_where_elements_end() {
        let mud = common::viscous_mud(
            1200.0,
            Rheology::Bingham { plastic_viscosity_Pa_s: 0.02, yield_point_Pa: 6.0 },
        );
        let motion = Motion { axial_m_per_s: 0.1, spin_rad_per_s: 12.0, flow_m3_per_s: 0.03 };
        let mut random = Random::new(11);
        for _ in 0..300 {
            let lengths_m = [0.05 + 1.5 * random.unit(), 3.0 + 60.0 * random.unit()];
            let depth_m = 200.0;
            let part = |od_m: f64, id_m: f64, length: ComponentLength| {
                ComponentSpec::uniform("part", od_m, id_m, length, common::steel())
            };
            let components = vec![
                part(0.2159, 0.0, ComponentLength::Metres(lengths_m[0])),
                part(0.1651, 0.0714, ComponentLength::Metres(lengths_m[1])),
                part(0.127, 0.1086, ComponentLength::ToSurface),
            ];
            let string = StringSpec { components }.assemble(depth_m).expect("a string");
            let hole = common::open_hole(0.2159, 0.2, depth_m);
            // Ends of components, shifted by a last digit or not at all, and others.
            let mut ends: Vec<f64> = string.spans().map(|span| span.to_bit_m).collect();
            for end in &mut ends {
                *end *= 1.0 + 1e-15 * (3.0 * random.signed()).round();
            }
            ends.extend((0..20).map(|_| depth_m * random.unit()));
            ends.extend([0.0, depth_m]);
            ends.retain(|end| *end <= depth_m);
            ends.sort_by(f64::total_cmp);
            ends.dedup_by(|next, before| *next - *before < 1e-9);
            let (mut bore_Pa, mut annulus_Pa) = (0.0, 0.0);
            for pair in ends.windows(2) {
                let (low_m, high_m) = (pair[0], pair[1]);
                let mds_m = [depth_m - low_m, depth_m - high_m];
                let conduit = Conduit::between(&string, &hole, [low_m, high_m], mds_m);
                let flow = motion.flow_m3_per_s;
                bore_Pa += (high_m - low_m) * conduit.bore_gradient_Pa_per_m(&mud, flow);
                annulus_Pa += (high_m - low_m) * conduit.drag(&mud, &motion).gradient_Pa_per_m;
            }
            let (mut expected_bore_Pa, mut expected_annulus_Pa) = (0.0, 0.0);
            for component in string.components() {
                let bore_m2 = component.inner_area_m2();
                expected_bore_Pa += component.length_m
                    * bore::gradient_Pa_per_m(&mud, bore_m2, motion.flow_m3_per_s);
                let annulus = Annulus::new(component.od_m, 0.2159);
                expected_annulus_Pa +=
                    component.length_m * annulus.drag(&mud, &motion).gradient_Pa_per_m;
            }
            for (found, expected) in
                [(bore_Pa, expected_bore_Pa), (annulus_Pa, expected_annulus_Pa)]
            {
                let error = found / expected - 1.0;
                assert!(error.abs() < 1e-9, "{lengths_m:?}: {found} for {expected}");
            }
        }
    }
}

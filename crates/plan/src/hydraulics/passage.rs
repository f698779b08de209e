//! The path of the mud: down the bore, up the annulus.

use wholestring::{
    model::Model,
    mud::{Annulus, Motion, Mud, bore},
};

/// Boundaries that are closer than this are one, m.
const SHORTEST_M: f64 = 1e-6;

/// A stretch with constant bore, pipe, hole and fluids.
struct Passage {
    from_md_m: f64,
    to_md_m: f64,
    annulus: Annulus,
    bore_m2: f64,
    /// Fluids in the bore and in the annulus.
    inside: Mud,
    around: Mud,
}

impl Passage {
    /// Returns its length above a measured depth, m.
    fn above_m(&self, md_m: f64) -> f64 {
        (md_m.min(self.to_md_m) - self.from_md_m).max(0.0)
    }
}

/// All stretches of a string in its hole.
pub(super) struct Passages {
    stretches: Vec<Passage>,
}

impl Passages {
    pub(super) fn of(model: &Model, bit_depth_m: f64) -> Self {
        let sections = model.well.hole.sections().iter().map(|section| section.to_md_m);
        let components = model.string.spans().map(|span| bit_depth_m - span.to_bit_m);
        let fluids = model.fluids.boundaries_m();
        let inside = SHORTEST_M..bit_depth_m - SHORTEST_M;
        let mut ends: Vec<f64> =
            sections.chain(components).chain(fluids).filter(|md_m| inside.contains(md_m)).collect();
        ends.extend([0.0, bit_depth_m]);
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|below, above| *below - *above < SHORTEST_M);
        let stretches = ends.windows(2).map(|pair| {
            let middle_m = 0.5 * (pair[0] + pair[1]);
            let (_, component) = model.string.component_at(bit_depth_m - middle_m);
            Passage {
                from_md_m: pair[0],
                to_md_m: pair[1],
                annulus: Annulus::new(component.od_m, model.well.hole.at(middle_m).diameter_m),
                bore_m2: component.inner_area_m2(),
                inside: model.fluids.inside_at(&model.mud, middle_m),
                around: model.fluids.annulus_at(&model.mud, middle_m),
            }
        });
        Self { stretches: stretches.collect() }
    }

    /// Returns the length of each stretch, m, its annulus and its bore, m².
    pub(super) fn lengths(&self) -> impl Iterator<Item = (f64, &Annulus, f64)> {
        self.stretches
            .iter()
            .map(|stretch| (stretch.to_md_m - stretch.from_md_m, &stretch.annulus, stretch.bore_m2))
    }

    /// Returns the pressure that friction adds in the annulus at measured depths, Pa. Below the bit
    /// nothing is added.
    pub(super) fn annulus_loss_Pa<const N: usize>(
        &self,
        motion: &Motion,
        mds_m: [f64; N],
    ) -> [f64; N] {
        let mut losses_Pa = [0.0; N];
        for stretch in &self.stretches {
            let gradient = stretch.annulus.drag(&stretch.around, motion).gradient_Pa_per_m;
            for (loss_Pa, md_m) in losses_Pa.iter_mut().zip(mds_m) {
                *loss_Pa += gradient * stretch.above_m(md_m);
            }
        }
        losses_Pa
    }

    /// Returns the friction loss in the bore of a flow down it, relative to the pipe, Pa.
    pub(super) fn bore_loss_Pa(&self, flow_m3_per_s: f64) -> f64 {
        let loss = |stretch: &Passage| {
            (stretch.to_md_m - stretch.from_md_m)
                * bore::gradient_Pa_per_m(&stretch.inside, stretch.bore_m2, flow_m3_per_s)
        };
        self.stretches.iter().map(loss).sum()
    }
}

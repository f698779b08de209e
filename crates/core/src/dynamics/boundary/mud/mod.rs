//! The mud around and inside the string, in time.

pub mod viscous;

use serde::{Deserialize, Serialize};

use crate::{
    dynamics::boundary::anchor::Anchor,
    model::Model,
    mud::MudColumn,
    rod::{
        in_fluid::{HolePlace, free_elongation_m},
        mesh::{Mesh, MeshElement},
    },
};

// The pressures that the flow of the mud adds to those of the mud at rest, along the string.

/// Pressures added by the flow at each node, from the top down.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FlowPressures {
    /// Pressure in the annulus, Pa.
    pub outside_Pa: Vec<f64>,
    /// Pressure in the bore, Pa.
    pub inside_Pa: Vec<f64>,
    /// `ρ Q²`, N·m², of the densest fluid in the string: over the area of a bore it is the momentum
    /// that the stream carries through it in a second.
    pub stream_N_m2: f64,
}

impl FlowPressures {
    /// A mud at rest around so many nodes.
    pub fn none(nodes: usize) -> Self {
        Self { outside_Pa: vec![0.0; nodes], inside_Pa: vec![0.0; nodes], stream_N_m2: 0.0 }
    }

    /// Back to a mud at rest.
    pub fn clear(&mut self) {
        self.outside_Pa.fill(0.0);
        self.inside_Pa.fill(0.0);
        self.stream_N_m2 = 0.0;
    }

    /// Finds the pressures from the losses of each element's annulus and bore, Pa, and of bit and
    /// motor, Pa: the mud leaves the annulus at the surface without any, so that they rise down the
    /// annulus, by the loss below to the bore and on up it.
    pub fn find(
        &mut self,
        below_Pa: f64,
        stream_N_m2: f64,
        losses_Pa: impl DoubleEndedIterator<Item = (f64, f64)> + Clone,
    ) {
        let mut pressure_Pa = 0.0;
        self.outside_Pa[0] = pressure_Pa;
        for (below, (annulus_Pa, _)) in self.outside_Pa[1..].iter_mut().zip(losses_Pa.clone()) {
            pressure_Pa += annulus_Pa;
            *below = pressure_Pa;
        }
        pressure_Pa += below_Pa;
        let last = self.inside_Pa.len() - 1;
        self.inside_Pa[last] = pressure_Pa;
        for (above, (_, bore_Pa)) in self.inside_Pa[..last].iter_mut().rev().zip(losses_Pa.rev()) {
            pressure_Pa += bore_Pa;
            *above = pressure_Pa;
        }
        self.stream_N_m2 = stream_N_m2;
    }

    /// Adds another.
    pub fn add(&mut self, other: &Self) {
        let sums =
            [(&mut self.outside_Pa, &other.outside_Pa), (&mut self.inside_Pa, &other.inside_Pa)];
        for (sum, more) in sums {
            for (sum, more) in sum.iter_mut().zip(more) {
                *sum += more;
            }
        }
        self.stream_N_m2 += other.stream_N_m2;
    }

    /// Everything times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        let times = |values: &[f64]| values.iter().map(|x| factor * x).collect();
        Self {
            outside_Pa: times(&self.outside_Pa),
            inside_Pa: times(&self.inside_Pa),
            stream_N_m2: factor * self.stream_N_m2,
        }
    }

    /// Pressure that the pump delivers at, Pa: that in the bore at the surface.
    pub fn pump_Pa(&self) -> f64 {
        self.inside_Pa[0]
    }

    /// Pressure inside less that outside added by the flow at a node, Pa.
    pub fn difference_Pa(&self, node: usize) -> f64 {
        self.inside_Pa[node] - self.outside_Pa[node]
    }
}

// Shortening of the string by the pressures and the temperature of the fluids at rest.

/// Shortening of each element at rest without effective tension against its length at the surface.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(in crate::dynamics) struct Squeezed {
    /// From the top down, m.
    pub(in crate::dynamics) each_m: Vec<f64>,
    /// Their sum, m.
    pub(in crate::dynamics) total_m: f64,
}

impl Squeezed {
    /// Of a string with these anchors.
    pub(in crate::dynamics) fn of(
        model: &Model,
        mesh: &Mesh,
        mud: &MudColumn,
        anchors: &[Anchor],
    ) -> Self {
        let squeeze = |(i, e): (usize, &MeshElement)| {
            let ends = [&anchors[i], &anchors[i + 1]]
                .map(|anchor| HolePlace { md_m: anchor.md_m, tvd_m: anchor.position_m.z });
            let element = (e, [&mesh.nodes[i], &mesh.nodes[i + 1]]);
            -free_elongation_m(&model.string, mud, element, ends, e.length_m)
        };
        let each_m: Vec<f64> = mesh.elements.iter().enumerate().map(squeeze).collect();
        Self { total_m: each_m.iter().sum(), each_m }
    }
}

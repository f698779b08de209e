//! Record of a run in progress: sums per node, samples of the scalars.

mod contact_map;
mod deflection;
mod depths;
mod end_stiffness;
mod lane;
mod node_sample;
mod reservoir;
mod shape_block;
mod shapes;
mod strength;
mod string_end;
mod sums;
#[cfg(test)]
mod tests;

use crate::{
    damage::{Damaged, ensure},
    dynamics::{
        body::Body,
        boundary::anchor::Anchor,
        kernel::{
            chain::{Chain, Rows},
            layout::Layout,
        },
    },
    model::Model,
    outcome::{ContactMap, TimeSeries},
    rod::{
        buckled_element::{BuckledElement, own_load_N},
        mesh::{Mesh, MeshElement},
    },
    simd::number::Real,
    well::Path,
};
use serde::{Deserialize, Serialize};

use super::outcome::DeepestContact;
use contact_map::MapKeeper;
use depths::Sides;
use lane::Lane;
use reservoir::Reservoir;
use sums::{Pass, SumBlock, TotalBlock};

pub use deflection::{BentNode, Ends};
pub use depths::neutral_point_m;
pub use node_sample::{NodeSample, Source};
pub use reservoir::Quantity;
pub use shapes::Shapes;
pub use strength::Strength;
pub use sums::Totals;

/// Mean and standard deviation of one node.
#[derive(Debug, Clone, Copy)]
pub struct Spread {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub std: f64,
}

/// Circulation of a node round the hole's axis, over the window.
#[derive(Debug, Clone, Copy)]
pub struct Circling {
    /// Mean angular velocity of the offset, weighted with its square, rad/s; clockwise looking down
    /// the hole is positive.
    pub rate_rad_per_s: f64,
    /// Fraction of the lateral motion that is circulation: one for a circle about the hole's axis,
    /// zero for a string that swings to and fro.
    pub coherence: f64,
}

/// The streaming record.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Record {
    layout: Layout,
    strength: Strength,
    shapes: Shapes,
    sums: Vec<SumBlock>,
    /// Sums of each element's shortening by the pressure of the mud at rest, m.
    squeezed_m: Vec<f64>,
    reservoir: Reservoir,
    sides: Sides,
    contact: MapKeeper,
    samples: u64,
    /// Scalars against time, from time zero but for the rows that were handed over.
    pub series: TimeSeries,
    /// Rows before those of the series: somebody else keeps them.
    pub handed_over: usize,
    /// Row at which the window begins, those that were handed over included.
    pub window_row: usize,
    /// Time of the last sample before the window, s.
    pub window_from_s: f64,
    /// Deepest penetration of any sample, m.
    pub max_penetration_m: f64,
    /// The deepest of the nodes that touch the wall.
    pub deepest_contact: Option<DeepestContact>,
}

impl Record {
    /// Checks that a stored record has this number of nodes, so that its sums and samples have the
    /// length that its layout requires.
    pub(in crate::dynamics) fn check(&self, nodes: usize) -> Result<(), Damaged> {
        let rows = self.series.check(nodes, self.handed_over)?;
        let all_rows = rows.saturating_add(self.handed_over);
        let fits = self.sums.len() == self.layout.blocks()
            && self.sides.is_of(nodes)
            && self.squeezed_m.len() + 1 == nodes
            && self.window_row <= all_rows
            && (rows > 0 || self.samples == 0);
        ensure(fits, "the record")?;
        self.strength.check(nodes, self.layout)?;
        self.shapes.check(self.layout)?;
        self.reservoir.check(self.layout.blocks())?;
        self.contact.check(nodes)
    }

    /// An empty record of a string, for a chain of that layout, with the expected number of
    /// `samples` in its window.
    pub fn new(model: &Model, mesh: &Mesh, layout: Layout, samples: u64) -> Self {
        Self {
            layout,
            strength: Strength::new(model, mesh, layout),
            shapes: Shapes::new(model, mesh, layout),
            sums: vec![SumBlock::EMPTY; layout.blocks()],
            squeezed_m: vec![0.0; mesh.elements.len()],
            reservoir: Reservoir::new(layout.blocks(), samples),
            sides: Sides::new(mesh.nodes.len()),
            contact: MapKeeper::new(mesh),
            samples: 0,
            series: TimeSeries::default(),
            handed_over: 0,
            window_row: 0,
            window_from_s: 0.0,
            max_penetration_m: 0.0,
            deepest_contact: None,
        }
    }

    /// Begins the window after the sample of `before_s`: the sums before it, kept in case it never
    /// began, are discarded.
    pub fn open_window(&mut self, before_s: f64) {
        self.sums.fill(SumBlock::EMPTY);
        self.squeezed_m.fill(0.0);
        self.shapes.restart();
        self.reservoir.clear();
        self.sides.restart();
        self.contact.restart();
        self.samples = 0;
        self.window_row = self.handed_over + self.series.time_s.len();
        self.window_from_s = before_s;
    }

    /// Forgets the samples of before a window that has just been opened.
    pub fn forget_samples(&mut self) {
        let mut probes = std::mem::take(&mut self.series.probes);
        probes.iter_mut().for_each(|probe| probe.samples.clear());
        self.series = TimeSeries { probes, ..TimeSeries::default() };
        self.handed_over = 0;
        self.window_row = 0;
        self.contact.forget();
    }

    /// Drops the samples of before a time, s, except the last one. The sums of the window stay.
    pub fn drop_samples(&mut self, before_s: f64) {
        let times_s = &self.series.time_s;
        let rows = times_s.partition_point(|time_s| *time_s < before_s);
        let rows = rows.min(times_s.len().saturating_sub(1));
        if rows > 0 {
            self.series.drop_first(rows);
            let dropped = std::mem::take(&mut self.handed_over) + rows;
            self.series.drop_first_probed(dropped);
            self.window_row = self.window_row.saturating_sub(dropped);
        }
        self.contact.drop_rows(before_s);
    }

    /// Drops the first rows of the series, which somebody else keeps from now on.
    pub fn hand_over(&mut self, rows: usize) {
        let rows = rows.min(self.series.time_s.len().saturating_sub(1));
        self.series.drop_first(rows);
        self.handed_over += rows;
    }

    /// Row of the series in memory at which the window begins, at the earliest its first.
    pub fn window_row_in_memory(&self) -> usize {
        self.window_row.saturating_sub(self.handed_over)
    }

    /// Takes a sample of every node: contact quantities as averages over the `steps` since the last
    /// one, which the chain has summed. `high` holds each node's high side, block by block; `body`
    /// has the bends.
    pub fn sample(
        &mut self,
        chain: &Chain<impl Real>,
        high: &[Rows<f64>],
        body: &Body,
        steps: u64,
    ) -> Totals {
        let ends = Ends { chain, bent: &BentNode::all(body, chain) };
        if self.shapes.are_due() {
            self.shapes.look(&ends);
        }
        let mut totals = TotalBlock::EMPTY;
        Pass {
            sums: &mut self.sums,
            source: Source {
                ends,
                high,
                strength: &self.strength,
                shapes: &self.shapes,
                per_step: 1.0 / steps as f64,
            },
            first: self.samples == 0,
            reservoir: self.reservoir.next(),
            totals: &mut totals,
        }
        .add();
        let totals = totals.sum();
        self.samples += 1;
        self.note_penetration(totals.penetration_m);
        totals
    }

    /// Looks at how the elements bend between their ends before the first sample does.
    pub fn look_at_shapes(&mut self, chain: &Chain<impl Real>, body: &Body) {
        self.shapes.look(&Ends { chain, bent: &BentNode::all(body, chain) });
        self.shapes.restart();
    }

    /// Records the penetration of a node into the wall, m; negative where it is off it.
    pub fn note_penetration(&mut self, depth_m: f64) {
        self.max_penetration_m = self.max_penetration_m.max(depth_m);
    }

    /// Notes the node that is deepest in the wall at a sample, where it is deeper than any before.
    pub fn note_contact(&mut self, chain: &Chain<impl Real>, anchors: &[Anchor], depth_m: f64) {
        if depth_m <= self.deepest_contact.map_or(0.0, |deepest| deepest.penetration_m) {
            return;
        }
        let depths = (0..chain.nodes()).map(|index| {
            let (row, lane) = chain.place(index);
            let nodes = &chain.node_blocks[row];
            let [stiffness, clearance, slope] =
                [&nodes.stiffness, &nodes.clearance, &nodes.clearance_slope]
                    .map(|numbers| numbers.0[lane].to_f64());
            let (tangent, u) = (chain.tangent(index), chain.displacement(index));
            let z = u.dot(tangent);
            let across = u.minus(tangent, z).minus(chain.curvature(index), 0.5 * z * z);
            let depth_m = across.dot(across).sqrt() - (clearance + slope * z);
            (if stiffness > 0.0 { depth_m } else { f64::NEG_INFINITY }, anchors[index].md_m + z)
        });
        let deepest = depths.max_by(|a, b| a.0.total_cmp(&b.0));
        self.deepest_contact =
            deepest.map(|(_, md_m)| DeepestContact { penetration_m: depth_m, md_m });
    }

    /// Adds the shortening of each element by the pressure of the mud at rest at the sample, m.
    pub fn squeeze(&mut self, each_m: &[f64]) {
        for (sum, squeezed) in self.squeezed_m.iter_mut().zip(each_m) {
            *sum += squeezed;
        }
    }

    /// Sets, from the next sample on, the pressure inside less that outside at each node, Pa.
    pub fn press(&mut self, difference_Pa: impl Fn(usize) -> f64) {
        self.strength.press(difference_Pa);
    }

    /// The bodies that carry the string's stresses.
    pub fn strength(&self) -> &Strength {
        &self.strength
    }

    /// Bending of the elements between their ends.
    pub fn shapes(&self) -> &Shapes {
        &self.shapes
    }

    /// Layout of the data of each node.
    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// Counts a sample of a run that takes `run_samples`, and closes a row of the map where one is
    /// full.
    pub fn map_contact(&mut self, anchors: &[Anchor], time_s: f64, run_samples: u64) {
        if self.contact.count(run_samples) {
            self.close_contact_row(anchors, time_s);
        }
    }

    /// Closes a row of the map with the samples since the last one, if there are any.
    pub fn close_contact_row(&mut self, anchors: &[Anchor], time_s: f64) {
        let (layout, blocks) = (self.layout, &self.sums);
        self.contact.close_row(anchors, time_s, |index| {
            let (block, lane) = layout.place(index);
            [blocks[block].signed[lane], blocks[block].normal[0][lane]]
        });
    }

    /// The map so far.
    pub fn contact_map(&self) -> &ContactMap {
        self.contact.map()
    }

    /// Once a second, after as many samples of `sample_interval_s`: where the side force changed
    /// from the high to the low side over that second, m.
    pub fn cutoff_depth_m(
        &mut self,
        mesh: &Mesh,
        path: &Path,
        anchors: &[Anchor],
        sample_interval_s: f64,
    ) -> Option<f64> {
        if !self.sides.is_due(sample_interval_s) {
            return None;
        }
        let (layout, blocks) = (self.layout, &self.sums);
        self.sides.cutoff_depth_m(mesh, path, anchors, |index| {
            let (block, lane) = layout.place(index);
            blocks[block].signed[lane]
        })
    }

    fn sum_of(&self, index: usize, pick: impl Fn(&SumBlock) -> &Lane) -> f64 {
        let (block, lane) = self.layout.place(index);
        pick(&self.sums[block])[lane]
    }

    fn mean_of(&self, index: usize, pick: impl Fn(&SumBlock) -> &Lane) -> f64 {
        self.sum_of(index, pick) / self.samples.max(1) as f64
    }

    fn spread_of(
        &self,
        index: usize,
        about: f64,
        pick: impl Fn(&SumBlock) -> &[Lane; 2],
    ) -> Spread {
        let (block, lane) = self.layout.place(index);
        let [first, second] = pick(&self.sums[block]);
        let n = self.samples.max(1) as f64;
        let (m1, m2) = (first[lane] / n, second[lane] / n);
        Spread { mean: about + m1, std: (m2 - m1 * m1).max(0.0).sqrt() }
    }

    /// Tension of an element, N.
    pub fn tension(&self, index: usize) -> Spread {
        let about = self.sum_of(index, |s| &s.about[0]);
        self.spread_of(index, about, |s| &s.tension)
    }
    /// The element whose compression exceeds its own buckling load most: that of a second or two at
    /// any time since the start of the run, or the mean over the window.
    pub fn buckled_element(
        &self,
        mesh: &Mesh,
        md_m: impl Fn(usize) -> f64,
    ) -> Option<BuckledElement> {
        BuckledElement::most(mesh, md_m, |index| {
            let MeshElement { section, length_m, .. } = &mesh.elements[index];
            let own_load_N = own_load_N(section.bending_stiffness_N_m2, *length_m);
            let passing_N = self.shapes.most_compressed(index) * own_load_N;
            passing_N.max(-self.tension(index).mean)
        })
    }
    /// Torque of an element, N·m, in the sign of the chain.
    pub fn torque(&self, index: usize) -> Spread {
        let about = self.sum_of(index, |s| &s.about[1]);
        self.spread_of(index, about, |s| &s.torque)
    }
    /// Mean twist of an element, rad, in the sign of the chain.
    pub fn twist(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.twist)
    }
    /// Mean elongation of an element by its tension less its shortening by the mud at rest, m.
    pub fn longer_m(&self, index: usize) -> f64 {
        let pulled_m = self.tension(index).mean * self.strength.compliance_m_per_N(index);
        pulled_m - self.squeezed_m[index] / self.samples.max(1) as f64
    }
    /// Contact force of a node, N.
    pub fn normal(&self, index: usize) -> Spread {
        self.spread_of(index, 0.0, |s| &s.normal)
    }
    /// Largest contact force of a node, N.
    pub fn normal_max(&self, index: usize) -> f64 {
        self.sum_of(index, |s| &s.normal_max)
    }
    /// Part of the samples in which a node touched.
    pub fn touched(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.touched)
    }
    /// Mean contact force of a node, N, positive on the high side.
    pub fn signed(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.signed)
    }
    /// Angle of a node's mean contact force from the low side, rad, positive to the right of it
    /// looking down the hole; none if it never touched.
    pub fn climb_rad(&self, index: usize) -> Option<f64> {
        let (up, right) = (self.mean_of(index, |s| &s.up), self.mean_of(index, |s| &s.right));
        (up != 0.0 || right != 0.0).then(|| libm::atan2(right, -up))
    }
    /// Mean axial friction of a node on the wall, N, along the hole.
    pub fn axial(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.axial)
    }
    /// Mean friction torque of a node, N·m.
    pub fn friction_torque(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.friction_torque)
    }
    /// Mean distance of a node from the hole's axis, m.
    pub fn offset(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.offset)
    }
    /// Mean bending moment at a node, N·m.
    pub fn bending(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.bending)
    }
    /// Largest bending moment at a node, N·m.
    pub fn bending_max(&self, index: usize) -> f64 {
        self.sum_of(index, |s| &s.bending_max)
    }
    /// Mean bending moment half-way to the node below, N·m.
    pub fn between(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.between)
    }
    /// Largest bending moment half-way to the node below, N·m.
    pub fn between_max(&self, index: usize) -> f64 {
        self.sum_of(index, |s| &s.between_max)
    }
    /// Mean von Mises stress at a node, Pa.
    pub fn stress(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.stress)
    }
    /// Largest von Mises stress at a node, Pa.
    pub fn stress_max(&self, index: usize) -> f64 {
        self.sum_of(index, |s| &s.stress_max)
    }
    /// Root mean square of a node's lateral speed, m/s.
    pub fn lateral_speed(&self, index: usize) -> f64 {
        self.mean_of(index, |s| &s.speed_square).sqrt()
    }
    /// Circulation of a node round the hole's axis; zero where it never left it.
    pub fn circling(&self, index: usize) -> Circling {
        let moment = self.mean_of(index, |s| &s.circling);
        let offset_square = self.mean_of(index, |s| &s.offset_square);
        let speed_square = self.mean_of(index, |s| &s.speed_square);
        let over = |x: f64, y: f64| if y > 0.0 { x / y } else { 0.0 };
        Circling {
            rate_rad_per_s: over(moment, offset_square),
            coherence: over(moment * moment, offset_square * speed_square),
        }
    }
    /// 5th, 50th and 95th percentile of a quantity at each node, or of its element below, from the
    /// top down.
    pub fn percentiles(&self, quantity: Quantity) -> Vec<[f64; 3]> {
        let places = self.reservoir.percentiles(quantity);
        let nodes = self.squeezed_m.len() + 1;
        self.layout.places().take(nodes).map(|(block, lane)| places[block][lane]).collect()
    }
}

//! The string in its hole: the quantities that the iterations do not change.

mod element;
mod load;
mod node;

use super::error::StiffSettings;
use crate::{
    ends,
    model::Model,
    mud::Hydraulics,
    operation::Operation,
    rod::{
        in_fluid::{self, ElementInFluid},
        mesh::Mesh,
    },
    statics::{circulation::Circulating, sliding::Sliding, soft::SoftProfile},
    wall::Bore,
};

pub(super) use element::Element;
pub(super) use node::Node;

/// Minimum excess of the radius of a joint or a blade over that of the body, m.
pub(super) const STANDS_OUT_M: f64 = 1e-4;

/// The string in its hole.
#[derive(Debug, Clone)]
pub(super) struct StringInHole {
    /// From the top down.
    pub(super) nodes: Vec<Node>,
    /// From the top down.
    pub(super) elements: Vec<Element>,
    /// Weight of each element in the fluids around it.
    pub(super) in_fluid: Vec<ElementInFluid>,
    /// Supports of its ends.
    pub(super) ends: ends::Ends,
    /// Torque of the bit, N·m.
    pub(super) bit_torque_N_m: f64,
    /// Effect of the mud; none without a rheology.
    pub(super) hydraulics: Option<Hydraulics>,
    /// Effect of the flow on each element.
    pub(super) circulating: Vec<Circulating>,
}

impl StringInHole {
    pub(super) fn new(
        model: &Model,
        operation: &Operation,
        settings: &StiffSettings,
        mesh: &Mesh,
        soft: &SoftProfile,
    ) -> Self {
        let bore = Bore::new(&model.well.hole);
        let depths = node::Depths::new(model, &bore, operation.bit_depth_m, mesh, soft);
        let (circulating, hydraulics) = element::circulation(model, operation, mesh, &depths.md_m);
        let around = (Sliding::of(operation), soft);
        let mut nodes = node::along(model, &bore, settings, mesh, &depths.md_m, around);
        let on_wall = (soft, depths.inside_m.as_slice());
        let mut elements = element::between(mesh, &bore, &nodes, &circulating, on_wall);
        let high_rad = high_side_rad(model, &nodes);
        element::bend(&mut elements, model, mesh, high_rad);
        let in_fluid = in_fluid::along(model, mesh);
        load::add_weight(&mut nodes, mesh, &circulating, &in_fluid);
        if !settings.lumped_weight {
            load::add_couples(&mut elements, &nodes, mesh, &in_fluid);
        }
        let jet_N = hydraulics.map_or(0.0, |mud| mud.jet_thrust_N);
        load::add_pull(&mut nodes, operation.tension_at_bit_N() - jet_N);
        load::add_lateral(&mut nodes, model, mesh, high_rad);
        let mut string = Self {
            nodes,
            elements,
            in_fluid,
            ends: model.ends,
            bit_torque_N_m: operation.bit_torque_now_N_m(),
            hydraulics,
            circulating,
        };
        string.hang(|_| true);
        string
    }

    /// Marks the elements that hang between their nodes: all but those whose body touches the wall
    /// at both ends. `touches` is the contact of a node. Returns whether any element changed.
    pub(super) fn hang(&mut self, touches: impl Fn(usize) -> bool) -> bool {
        let mut changed = false;
        for index in 0..self.elements.len() {
            let body = self.elements[index].body_clearance_m;
            let lies = [index, index + 1].into_iter().all(|node| {
                let end = &self.nodes[node];
                touches(node) && end.has_wall() && end.clearance_m > body - STANDS_OUT_M
            });
            changed |= self.elements[index].hangs == lies;
            self.elements[index].hangs = !lies;
        }
        changed
    }

    /// Mean weight of a node over its mean clearance, N/m: the elastic foundation on which a pipe
    /// rests on the low side of its hole, `w/r` of Dawson and Paslay.
    pub(super) fn foundation_N_per_m(&self) -> f64 {
        self.weight_N() / self.nodes.len() as f64 / self.mean_clearance_m()
    }

    /// Mean clearance of the nodes that have a wall, m; a metre where none has.
    pub(super) fn mean_clearance_m(&self) -> f64 {
        let walled = self.nodes.iter().filter(|node| node.has_wall());
        let (sum_m, count) =
            walled.fold((0.0, 0.0), |(sum, count), node| (sum + node.clearance_m, count + 1.0));
        if count > 0.0 { sum_m / count } else { 1.0 }
    }

    /// Buoyed weight of the string, N.
    pub(super) fn weight_N(&self) -> f64 {
        self.nodes.iter().map(|node| node.load_N.z.abs()).sum()
    }
}

/// The angle of the high side at the bit between the axes across the hole, rad, from the first to
/// the second. They are carried along the hole: the high side at the bit has the same parts
/// everywhere.
pub(super) fn high_side_rad(model: &Model, nodes: &[Node]) -> f64 {
    nodes.last().map_or(0.0, |bit| {
        let high = model.well.path.high_side_of(bit.md_m, &bit.axes[2]);
        libm::atan2(high.dot(&bit.axes[1]), high.dot(&bit.axes[0]))
    })
}

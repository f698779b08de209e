//! A chain of elements in space, with a bend at every node if need be, brought to equilibrium by
//! Newton's method.
//!
//! The reactions are those of the engine; the tangent is their finite difference and only steers
//! the iteration. Twist is not summed up here: it is the angle between marks on the body.

use nalgebra::{DMatrix, DVector, Rotation3, Vector3};
use wholestring::rod::{
    bent::{director_below, moment_above, moment_below, pose_below, twist},
    element::{Pose, Stiffness, react},
    section::Section,
    vector::Vector,
};

use crate::plane::at_rest;

type V = Vector3<f64>;

/// Degrees of freedom of a node: three displacements, three rotations.
const FREE: usize = 6;

#[derive(Clone, Copy)]
struct Node {
    at: V,
    director: V,
    /// Across the director and across its bend's plane.
    mark: V,
    /// Bend of the element below: towards `mark × director`, rad.
    bend_rad: f64,
}

impl Node {
    fn moved(&self, by: &[f64]) -> Self {
        let turn = Rotation3::new(V::new(by[3], by[4], by[5]));
        Self {
            at: self.at + V::new(by[0], by[1], by[2]),
            director: turn * self.director,
            mark: turn * self.mark,
            ..*self
        }
    }

    fn below(&self) -> V {
        let toward = self.mark.cross(&self.director);
        director_below(self.director.into(), toward.into(), self.bend_rad).into()
    }
}

/// A rod in one plane before it is loaded, clamped at its first node.
pub struct Space {
    elements: Vec<Stiffness<f64>>,
    nodes: Vec<Node>,
    /// Dead force on the last node, N.
    pub force: V,
}

impl Space {
    /// A rod through `corners`, all in the plane across `normal`.
    pub fn new(section: &Section, corners: &[V], normal: V) -> Self {
        let chords: Vec<V> = corners.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let along = |i: usize| chords[i.min(chords.len() - 1)].normalize();
        let nodes = corners
            .iter()
            .enumerate()
            .map(|(i, at)| {
                // The director is that of the element above.
                let director = along(i.saturating_sub(1));
                let next = along(i);
                let toward = normal.cross(&director);
                Node {
                    at: *at,
                    director,
                    mark: normal,
                    bend_rad: next.dot(&toward).atan2(next.dot(&director)),
                }
            })
            .collect();
        Self {
            elements: chords.iter().map(|chord| Stiffness::new(section, chord.norm())).collect(),
            nodes,
            force: V::zeros(),
        }
    }

    /// Position of the last node.
    pub fn tip(&self) -> V {
        self.nodes[self.nodes.len() - 1].at
    }

    /// Forces and moments of element `e` on its two nodes.
    fn reaction(k: &Stiffness<f64>, one: &Node, two: &Node) -> [f64; 2 * FREE] {
        let chord = two.at - one.at;
        let length = chord.norm();
        let d2 = Vector::from(two.director);
        let below = Vector::from(one.below());
        let pose = Pose {
            anchor_excess: (length - k.length) * (length + k.length),
            twist: twist(one.mark.into(), below, two.mark.into(), d2),
            ..at_rest(chord, k.length, [one.director, two.director])
        };
        let r = react(k, &pose_below(&pose, 0.0, below), 0.0, 0.0);
        let (m1, m2) = (moment_above(&r, below), moment_below(&r, d2));
        let f = r.force;
        [-f.0, -f.1, -f.2, m1.0, m1.1, m1.2, f.0, f.1, f.2, m2.0, m2.1, m2.2]
    }

    fn imbalance(&self) -> DVector<f64> {
        let mut sum = DVector::zeros(FREE * self.nodes.len());
        for (e, k) in self.elements.iter().enumerate() {
            let r = Self::reaction(k, &self.nodes[e], &self.nodes[e + 1]);
            for (i, f) in r.iter().enumerate() {
                sum[FREE * e + i] += f;
            }
        }
        let last = FREE * (self.nodes.len() - 1);
        for axis in 0..3 {
            sum[last + axis] += self.force[axis];
        }
        // Clamped nodes carry any load.
        sum.rows(FREE, sum.len() - FREE).into()
    }

    fn tangent(&self) -> DMatrix<f64> {
        let size = FREE * self.nodes.len();
        let mut matrix = DMatrix::zeros(size, size);
        for (e, k) in self.elements.iter().enumerate() {
            for j in 0..2 * FREE {
                let h = 1e-6 * if j % FREE < 3 { k.length } else { 1.0 };
                let at = |h: f64| {
                    let mut by = [0.0; 2 * FREE];
                    by[j] = h;
                    let one = self.nodes[e].moved(&by[..FREE]);
                    let two = self.nodes[e + 1].moved(&by[FREE..]);
                    Self::reaction(k, &one, &two)
                };
                let (plus, minus) = (at(h), at(-h));
                for i in 0..2 * FREE {
                    matrix[(FREE * e + i, FREE * e + j)] -= (plus[i] - minus[i]) / (2.0 * h);
                }
            }
        }
        matrix.view((FREE, FREE), (size - FREE, size - FREE)).into()
    }

    /// Brings the load on in `steps`, each to equilibrium.
    pub fn balance(&mut self, steps: usize) {
        let load = self.force;
        for step in 1..=steps {
            self.force = load * (step as f64 / steps as f64);
            let mut last = f64::INFINITY;
            for _ in 0..60 {
                let mut change =
                    self.tangent().lu().solve(&self.imbalance()).expect("a stiffness matrix");
                // No node turns by more than this at once.
                let most = (0..change.len())
                    .filter(|i| i % FREE >= 3)
                    .map(|i| change[i].abs())
                    .fold(0.0, f64::max);
                change *= (0.3 / most).min(1.0);
                for (i, node) in self.nodes.iter_mut().skip(1).enumerate() {
                    *node = node.moved(&change.as_slice()[FREE * i..FREE * (i + 1)]);
                }
                let size = change.amax();
                if size < 1e-8 && size >= 0.5 * last {
                    break;
                }
                last = size;
            }
            assert!(last < 1e-6, "no equilibrium: {last:e}");
        }
    }
}

//! The directors that an element sees at its ends, and the direction of a node.

use nalgebra::{Matrix2, Matrix3x2, UnitVector3, Vector3};

/// A director that an element sees, and its derivative with respect to the node's rotation.
#[derive(Debug)]
pub(super) struct Director {
    pub(super) along: Vector3<f64>,
    pub(super) by: Matrix3x2<f64>,
    /// Whether it is the node's own.
    own: bool,
}

impl Director {
    pub(super) fn of(heading: &Heading, bend: Option<&Vector3<f64>>) -> Self {
        let [b1, b2] = heading.across;
        let Some(parts) = bend else {
            return Self {
                along: heading.along,
                by: Matrix3x2::from_columns(&[b1, b2]),
                own: true,
            };
        };
        let director = b1 * parts.x + b2 * parts.y + heading.along * parts.z;
        // The node's rotation d × b turns the other director, too.
        let column = |b: Vector3<f64>, part: f64| b * parts.z - heading.along * part;
        let by = Matrix3x2::from_columns(&[column(b1, parts.x), column(b2, parts.y)]);
        Self { along: director, by, own: false }
    }

    /// Second-order term of a director's rotation in the tangent, for a gradient on it, N·m.
    pub(super) fn second(
        &self,
        heading: &Heading,
        gradient: Vector3<f64>,
        pull_N_m: f64,
    ) -> Matrix2<f64> {
        if self.own {
            return Matrix2::identity() * -pull_N_m;
        }
        // The gradient is known except for its component along the director.
        let d = self.along;
        let whole = gradient + d * (pull_N_m - gradient.dot(&d));
        let turns = heading.across.map(|b| heading.along.cross(&b));
        Matrix2::from_fn(|row, column| {
            let twice = |a: usize, b: usize| turns[a].cross(&turns[b].cross(&d));
            0.5 * whole.dot(&(twice(row, column) + twice(column, row)))
        })
    }
}

// Direction of a node.

/// A node's director and two directions across it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Heading {
    /// The director.
    pub(super) along: Vector3<f64>,
    /// Two directions across it, a right-handed frame with it.
    pub(super) across: [Vector3<f64>; 2],
}

impl Heading {
    /// A heading along a direction; the first direction across is as near as possible to `near`.
    pub(super) fn new(along: Vector3<f64>, near: Vector3<f64>) -> Self {
        let first = (near - along * along.dot(&near)).normalize();
        Self { along, across: [first, along.cross(&first)] }
    }

    /// Rotated so that the director moves by two components across it, rad.
    pub(super) fn turned(&self, by: [f64; 2]) -> Self {
        let toward = self.across[0] * by[0] + self.across[1] * by[1];
        let Some((toward, angle)) = UnitVector3::try_new_and_get(toward, 0.0) else {
            return *self;
        };
        let (sine, cosine) = libm::sincos(angle);
        let along = (self.along * cosine + toward.into_inner() * sine).normalize();
        // Transported by the smallest rotation, so that a bend keeps its tool face.
        let first = self.across[0];
        let share = first.dot(&along) / (1.0 + self.along.dot(&along));
        Self::new(along, first - (self.along + along) * share)
    }
}

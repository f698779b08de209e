//! Position and motion of a bit.

use nalgebra::{Matrix3, Rotation3, Vector3};
use serde::{Deserialize, Serialize};

/// Place, direction and motion of a bit in the frame of the rock, a right-handed one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// The bit's reference point, m.
    pub position_m: Vector3<f64>,
    /// Turns the bit's frame into the rock's: its columns are the bit's `x`, `y` and `z` (down the
    /// hole).
    pub rotation: Matrix3<f64>,
    /// Velocity of the reference point, m/s.
    pub velocity_m_per_s: Vector3<f64>,
    /// Angular velocity, rad/s; along `z` while the bit turns clockwise, looking down the hole.
    pub angular_velocity_rad_per_s: Vector3<f64>,
}

impl Pose {
    /// A bit at rest. `axis` points down the hole, `high_side` is the direction of the bit's `x` at
    /// an angle of zero (its part along the axis is ignored); `angle_rad` is positive clockwise,
    /// looking down the hole.
    ///
    /// A `high_side` along the axis, as in a vertical hole, leaves the choice to the bit: any
    /// direction across.
    pub fn new(
        position_m: Vector3<f64>,
        axis: Vector3<f64>,
        high_side: Vector3<f64>,
        angle_rad: f64,
    ) -> Self {
        let z = axis.normalize();
        let across = |vector: Vector3<f64>| vector - z * vector.dot(&z);
        let mut high = across(high_side);
        if high.norm() <= 1e-9 * high_side.norm() {
            high = across(Vector3::ith(z.iamin(), 1.0));
        }
        let high = high.normalize();
        let x = high * libm::cos(angle_rad) + z.cross(&high) * libm::sin(angle_rad);
        Self {
            position_m,
            rotation: Matrix3::from_columns(&[x, z.cross(&x), z]),
            velocity_m_per_s: Vector3::zeros(),
            angular_velocity_rad_per_s: Vector3::zeros(),
        }
    }

    /// The same place in motion.
    pub fn moving(
        self,
        velocity_m_per_s: Vector3<f64>,
        angular_velocity_rad_per_s: Vector3<f64>,
    ) -> Self {
        Self { velocity_m_per_s, angular_velocity_rad_per_s, ..self }
    }

    /// The pose after its motion over a time.
    pub fn after(self, dt_s: f64) -> Self {
        let turn = Rotation3::new(self.angular_velocity_rad_per_s * dt_s);
        let rotation = turn.matrix() * self.rotation;
        // Rounding must not shear the frame in a million steps.
        let z = rotation.column(2).normalize();
        let y = z.cross(&rotation.column(0)).normalize();
        Self {
            position_m: self.position_m + self.velocity_m_per_s * dt_s,
            rotation: Matrix3::from_columns(&[y.cross(&z), y, z]),
            ..self
        }
    }

    /// The bit's axis, down the hole.
    pub fn axis(&self) -> Vector3<f64> {
        self.rotation.column(2).into_owned()
    }

    /// A point of the rock's frame in the bit's.
    #[inline]
    pub fn to_bit(&self, position_m: Vector3<f64>) -> Vector3<f64> {
        self.rotation.tr_mul(&(position_m - self.position_m))
    }

    /// A point of the bit's frame in the rock's.
    pub fn to_rock(&self, position_m: Vector3<f64>) -> Vector3<f64> {
        self.position_m + self.rotation * position_m
    }
}

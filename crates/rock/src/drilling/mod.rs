//! A bit on a block of rock.

mod bit;
mod bottom;
mod driver;
mod motion;
mod progress;
mod seat;
mod spec;

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

pub use self::{
    bit::{Bit, BitShape},
    driver::Driver,
    motion::{Advance, BitMotion, Inertia},
    progress::Progress,
    spec::{DrillingError, DrillingSpec},
};
use wholestring_numbers::damage::{Damaged, ensure};

use super::{
    bit_face::{ContactLaw, Pose},
    block::Block,
    executor::Executor,
    kernel::Stepper,
};

/// Balance of the bit's energy, J: the four sum to zero.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct DrillingEnergies {
    /// Work of the rock on the bit.
    pub on_bit_J: f64,
    /// Work of the bit on the rock.
    pub on_rock_J: f64,
    /// Lost in friction between them.
    pub friction_J: f64,
    /// Taken by the contact.
    pub contact_J: f64,
}

impl DrillingEnergies {
    /// Residual of the energy balance.
    pub fn residual_J(&self) -> f64 {
        self.on_bit_J + self.on_rock_J + self.friction_J + self.contact_J
    }
}

/// A rigid bit on a block of rock, each of which moves the other.
///
/// It is plain data; of the bit, its numbers are stored. The frame is that of the hole: z points
/// down along it, the origin is the corner of the block as it was at first, and stays there while
/// the block follows the bit.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Drilling {
    block: Block,
    bit: Bit,
    contact: ContactLaw,
    wall_m: f64,
    pose: Pose,
    energies: DrillingEnergies,
    /// Elements of the first hole and of the wall that were dropped, not broken.
    dropped: usize,
}

impl Drilling {
    /// A bit at rest on the middle of a block, upright: in the hole that it would have drilled, as
    /// deep as the wall that is kept, or on the flat top. The elements of that hole count as
    /// dropped, not as broken.
    ///
    /// # Errors
    /// Those of [`DrillingSpec::check`].
    pub fn new(spec: &DrillingSpec) -> Result<Self, DrillingError> {
        let bit = spec.valid_bit()?;
        let block = Block::new(&spec.block)?;
        let ([nx, ny, _], [x, y, _]) = (spec.block.cells, spec.block.size_m);
        let middle = Vector3::new(0.5 * nx as f64 * x, 0.5 * ny as f64 * y, 0.0);
        let mut drilling = Self {
            block,
            bit,
            contact: spec.contact,
            wall_m: spec.wall_m,
            pose: Pose {
                position_m: middle,
                rotation: Matrix3::identity(),
                velocity_m_per_s: Vector3::zeros(),
                angular_velocity_rad_per_s: Vector3::zeros(),
            },
            energies: DrillingEnergies::default(),
            dropped: 0,
        };
        if spec.seated {
            drilling.seat();
        }
        Ok(drilling)
    }

    /// Whether stored rock and bit are of this kind.
    ///
    /// # Errors
    /// The part that does not match: a length, a place, or a number of the rock.
    pub fn check(&self, spec: &DrillingSpec) -> Result<(), Damaged> {
        let fits = *self.bit.shape() == spec.bit
            && self.contact == spec.contact
            && self.wall_m == spec.wall_m;
        ensure(fits, "the bit")?;
        self.block.check(&spec.block)?;
        ensure(self.dropped <= self.block.removed().0, "the number of elements that have gone")
    }

    /// Moves bit and rock through a time, in equal steps that are stable for the rock.
    ///
    /// The bit is pushed by the rock after each step of the rock, like the nodes that it touches:
    /// the momentum that the one gains the others lose, and works are forces times the means of the
    /// velocities before and after. The contact uses the bit's velocity from before the push, so
    /// that the bit must be heavier than the nodes that it touches.
    pub fn advance(
        &mut self,
        time_s: f64,
        motion: &BitMotion,
        stepper: &Stepper,
        executor: &impl Executor,
    ) -> Advance {
        let steps = self.block.share(time_s);
        let dt = self.block.dt_s();
        let inertia = &motion.inertia;
        self.pose = self.pose.moving(motion.velocity_m_per_s, motion.angular_velocity_rad_per_s);
        let from_m = self.pose.position_m;
        let eroded = self.block.removed().0 - self.dropped;
        let mut advance = Advance { time_s, ..Advance::default() };
        for _ in 0..steps {
            self.block.step(stepper, executor);
            advance.turned_rad += self.go(dt) * dt;
            let axis = self.pose.axis();
            let [velocity_before, spun] =
                [self.pose.velocity_m_per_s, self.pose.angular_velocity_rad_per_s];
            self.pose.velocity_m_per_s += inertia.velocity_change_m_per_s(motion.force_N * dt);
            self.pose.angular_velocity_rad_per_s += inertia.turned(motion.moment_N_m * dt, &axis);
            let met = self.block.press(self.bit.face(), &self.pose, &self.contact);
            let load = met.load;
            self.pose.velocity_m_per_s += inertia.velocity_change_m_per_s(load.force_N * dt);
            self.pose.angular_velocity_rad_per_s += inertia.turned(load.moment_N_m * dt, &axis);
            let work_J = 0.5
                * dt
                * (load.force_N.dot(&(velocity_before + self.pose.velocity_m_per_s))
                    + load.moment_N_m.dot(&(spun + self.pose.angular_velocity_rad_per_s)));
            self.energies.on_bit_J += work_J;
            self.energies.on_rock_J += met.pushed_J;
            self.energies.friction_J += load.friction_loss_J;
            // The contact saw the bit at another velocity than the mean.
            self.energies.contact_J += load.contact_loss_J + load.work_on_bit_J - work_J;
            advance.force_N += load.force_N;
            advance.moment_N_m += load.moment_N_m;
            advance.work_J += work_J;
        }
        advance.force_N /= steps as f64;
        advance.moment_N_m /= steps as f64;
        advance.velocity_m_per_s = self.pose.velocity_m_per_s;
        advance.angular_velocity_rad_per_s = self.pose.angular_velocity_rad_per_s;
        advance.displacement_m = self.pose.position_m - from_m;
        advance.broken = self.block.removed().0 - self.dropped - eroded;
        self.follow();
        advance
    }

    /// Moves and turns the bit; returns its spin, rad/s. The spin follows the axis when the bit
    /// tilts, because the precession of a spinning bit belongs to its string.
    fn go(&mut self, dt: f64) -> f64 {
        let omega = self.pose.angular_velocity_rad_per_s;
        let axis = self.pose.axis();
        let spin = axis.dot(&omega);
        self.pose = self.pose.after(dt);
        let (tilting, axis) = (omega - axis * spin, self.pose.axis());
        self.pose.angular_velocity_rad_per_s = axis * (spin - axis.dot(&tilting)) + tilting;
        spin
    }

    /// Drops the layers that the bit has left above it.
    fn follow(&mut self) {
        let grid = *self.block.grid();
        let above_m = self.pose.position_m.z - self.wall_m - self.block.top_m();
        // The lowest layer of all stays, for the next to move with.
        let passed = ((above_m / grid.size_m[2]).max(0.0) as usize).min(grid.cells[2] - 1);
        if passed == 0 {
            return;
        }
        for element in grid.each_element().filter(|element| element[2] < passed) {
            if self.block.intact(element).is_some() {
                self.block.remove(element);
                self.dropped += 1;
            }
        }
        self.block.follow();
    }

    /// The block.
    pub fn block(&self) -> &Block {
        &self.block
    }

    /// The bit.
    pub fn bit(&self) -> &Bit {
        &self.bit
    }

    /// Position and motion of the bit.
    pub fn pose(&self) -> &Pose {
        &self.pose
    }

    /// Puts the bit elsewhere.
    pub fn place(&mut self, pose: Pose) {
        self.pose = pose;
    }

    /// Balance of the bit's energy.
    pub fn energies(&self) -> DrillingEnergies {
        self.energies
    }

    /// Elements that were dropped, not broken: those of the hole that the bit began in, and of its
    /// wall as the block followed the bit. They count among those that have gone from the block.
    pub fn dropped(&self) -> usize {
        self.dropped
    }
}

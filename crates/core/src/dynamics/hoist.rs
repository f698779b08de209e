//! The top of the string: block, line and autodriller.

use serde::{Deserialize, Serialize};

use super::{
    chain::{Chain, node},
    settings::{HoistControl, HoistLine},
};

/// The hoist that carries the top of the string.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Hoist {
    line: HoistLine,
    control: HoistControl,
    /// Weight on bit that an autodriller holds, N.
    target_N: f64,
    /// Block velocity at that weight, m/s, positive downwards.
    nominal_m_per_s: f64,
    /// Measured depth of the block's end of the line, m.
    block_m: f64,
    velocity_m_per_s: f64,
    filtered_N: f64,
}

/// What the hoist did in a step.
#[derive(Debug, Clone, Copy, Default)]
pub struct HoistStep {
    /// Force on the top of the string, N, upwards: the hook load.
    pub hook_load_N: f64,
    /// Work done on the string, J.
    pub work_J: f64,
}

impl Hoist {
    /// A hoist that carries `hook_load_N` with the top of the string at `top_md_m`.
    pub fn new(
        line: HoistLine,
        control: HoistControl,
        target_N: f64,
        nominal_m_per_s: f64,
        top_md_m: f64,
        hook_load_N: f64,
    ) -> Self {
        let velocity_m_per_s = match control {
            HoistControl::BlockVelocity(velocity) => velocity,
            HoistControl::Autodriller { .. } | HoistControl::HookLoad(_) => nominal_m_per_s,
        };
        Self {
            line,
            control,
            target_N,
            nominal_m_per_s,
            block_m: top_md_m - hook_load_N / line.stiffness_N_per_m,
            velocity_m_per_s,
            filtered_N: target_N,
        }
    }

    /// Changes what the hoist does from now on.
    pub fn set_control(&mut self, control: HoistControl) {
        self.control = control;
        if let HoistControl::BlockVelocity(velocity) = control {
            self.velocity_m_per_s = velocity;
        }
    }

    /// Block velocity, m/s, positive downwards.
    pub fn velocity_m_per_s(&self) -> f64 {
        self.velocity_m_per_s
    }

    /// Corrects the top node, which the step has moved without the hoist, and moves the block. The
    /// line is evaluated at the step's end: implicit, stable for any stiffness. `top_md_m` is the
    /// depth of the top node's anchor, `before_m_per_s` its axial velocity before the step.
    pub fn act(
        &mut self,
        chain: &mut Chain,
        top_md_m: f64,
        before_m_per_s: f64,
        weight_on_bit_N: f64,
        dt: f64,
    ) -> HoistStep {
        if let HoistControl::Autodriller {
            gain_m_per_s_per_N,
            filter_s,
        } = self.control
        {
            let part = dt / (filter_s + dt);
            self.filtered_N += part * (weight_on_bit_N - self.filtered_N);
            let missing = self.target_N - self.filtered_N;
            self.velocity_m_per_s = gain_m_per_s_per_N
                .mul_add(missing, self.nominal_m_per_s)
                .max(0.0);
        }
        let tangent = chain.tangent(0);
        let free = chain.velocity(0).dot(tangent);
        let end = top_md_m + chain.displacement(0).dot(tangent);
        let mobility = dt * node!(chain, 0, inv_mass_axial);
        let force = match self.control {
            HoistControl::HookLoad(force) => force,
            _ => {
                self.block_m += dt * self.velocity_m_per_s;
                let HoistLine {
                    stiffness_N_per_m: k,
                    damping_N_s_per_m: c,
                } = self.line;
                let stretch = k * (end - self.block_m) + c * (free - self.velocity_m_per_s);
                // A line does not push.
                (stretch / (1.0 + mobility * (k * dt + c))).max(0.0)
            }
        };
        let change = mobility * force;
        chain.set_velocity(0, chain.velocity(0).minus(tangent, change));
        chain.set_displacement(0, chain.displacement(0).minus(tangent, dt * change));
        if matches!(self.control, HoistControl::HookLoad(_)) {
            self.velocity_m_per_s = free - change;
            self.block_m = end - dt * change - force / self.line.stiffness_N_per_m;
        }
        let mean = 0.5 * (before_m_per_s + free - change);
        HoistStep {
            hook_load_N: force,
            work_J: -force * mean * dt,
        }
    }
}

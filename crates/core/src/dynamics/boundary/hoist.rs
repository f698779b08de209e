//! The top of the string: block, line and autodriller.

use serde::{Deserialize, Serialize};

use crate::{
    GRAVITY_M_PER_S2,
    dynamics::{
        kernel::chain::{Chain, node},
        settings::{Autodriller, HoistControl, HoistLine},
    },
    simd::number::Real,
};

/// The hoist that carries the top of the string.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Hoist {
    line: HoistLine,
    control: HoistControl,
    autodriller: Autodriller,
    target: Target,
    /// Measured depth of the block's end of the line, m: where the line would carry the block
    /// alone.
    block_m: f64,
    velocity_m_per_s: f64,
    filtered_N: f64,
    /// Integral part of the autodriller's speed, m/s.
    integral_m_per_s: f64,
    /// Maximum force of pushing in addition to the block's weight, N.
    push_N: f64,
}

/// Target of an autodriller.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Target {
    /// Weight on bit, N.
    pub weight_N: f64,
    /// Block velocity at that weight, m/s, positive downwards.
    pub velocity_m_per_s: f64,
}

/// Results of a step for the hoist.
#[derive(Debug, Clone, Copy, Default)]
pub struct HoistStep {
    /// Force on the top of the string, N, upwards: the hook load; negative where it pushes.
    pub hook_load_N: f64,
    /// Work done on the string, J.
    pub work_J: f64,
}

impl Hoist {
    /// A hoist that carries `hook_load_N` with the top of the string at `top_md_m`.
    pub fn new(
        line: HoistLine,
        control: HoistControl,
        autodriller: Autodriller,
        target: Target,
        top_md_m: f64,
        hook_load_N: f64,
    ) -> Self {
        let velocity_m_per_s = match control {
            HoistControl::BlockVelocity(velocity) => velocity,
            HoistControl::Autodriller | HoistControl::HookLoad(_) => target.velocity_m_per_s,
        };
        Self {
            line,
            control,
            autodriller,
            target,
            // The load stretches the line.
            block_m: top_md_m - hook_load_N / line.stiffness_N_per_m,
            velocity_m_per_s,
            filtered_N: target.weight_N,
            integral_m_per_s: 0.0,
            push_N: 0.0,
        }
    }

    /// The same of a rig that pushes the string into the hole with at most this force, N.
    pub fn pushing(self, push_N: f64) -> Self {
        Self { push_N, ..self }
    }

    /// Changes the control of the hoist from now on. An autodriller that takes control continues
    /// from the present speed of the block, as far as it has an integral part to keep it.
    pub fn set_control(&mut self, control: HoistControl) {
        if control == HoistControl::Autodriller
            && self.control != control
            && self.autodriller.integral_time_s.is_finite()
        {
            self.integral_m_per_s = self.velocity_m_per_s
                - self.target.velocity_m_per_s
                - self.autodriller.gain_m_per_s_per_N * (self.target.weight_N - self.filtered_N);
        }
        self.control = control;
        if let HoistControl::BlockVelocity(velocity) = control {
            self.velocity_m_per_s = velocity;
        }
    }

    /// Changes the autodriller's target.
    pub fn set_target(&mut self, target: Target) {
        self.target = target;
    }

    /// Present control of the hoist.
    pub fn control(&self) -> HoistControl {
        self.control
    }

    /// Weight on bit that the autodriller is to hold, N.
    pub fn target_N(&self) -> f64 {
        self.target.weight_N
    }

    /// Weight on bit as the autodriller sees it, N.
    pub fn filtered_N(&self) -> f64 {
        self.filtered_N
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
        chain: &mut Chain<impl Real>,
        top_md_m: f64,
        before_m_per_s: f64,
        weight_on_bit_N: f64,
        dt: f64,
    ) -> HoistStep {
        // Filter of first order, implicit.
        let part = dt / (self.autodriller.filter_s + dt);
        self.filtered_N += part * (weight_on_bit_N - self.filtered_N);
        if self.control == HoistControl::Autodriller {
            self.drill(dt);
        }
        let tangent = chain.tangent(0);
        let moved = chain.velocity(0).dot(tangent);
        let end = top_md_m + chain.displacement(0).dot(tangent);
        let block_kg = self.line.block_mass_kg;
        let (free, end, mobility) = if block_kg > 0.0 {
            // The step has moved the top as if it were alone: the block shares in its impulse.
            let string_kg = node!(chain, 0, mass_axial);
            let both_kg = string_kg + block_kg;
            let shared = before_m_per_s + (moved - before_m_per_s) * (string_kg / both_kg);
            (shared, end + dt * (shared - moved), dt / both_kg)
        } else {
            (moved, end, dt * node!(chain, 0, inv_mass_axial))
        };
        // Pull of the line beyond the weight of the block.
        let force = match self.control {
            HoistControl::HookLoad(force) => force,
            _ => {
                self.block_m += dt * self.velocity_m_per_s;
                let HoistLine { stiffness_N_per_m: k, damping_N_s_per_m: c, .. } = self.line;
                // F = k x + c v with the x and v that F itself leaves at the step's end.
                let stretch = k * (end - self.block_m) + c * (free - self.velocity_m_per_s);
                // A line does not push; a snubbing unit does, up to its force.
                let least = -block_kg * GRAVITY_M_PER_S2 - self.push_N;
                (stretch / (1.0 + mobility * (k * dt + c))).max(least)
            }
        };
        let taken = mobility * force;
        let after = free - taken;
        let change = (moved - free) + taken;
        chain.set_velocity(0, chain.velocity(0).minus(tangent, change));
        chain.set_displacement(0, chain.displacement(0).minus(tangent, dt * change));
        if matches!(self.control, HoistControl::HookLoad(_)) {
            self.velocity_m_per_s = after;
            // There is no line: the block goes where a line under this load would have it.
            self.block_m = end - dt * taken - force / self.line.stiffness_N_per_m;
        }
        // F_hook = F_line − M g + M v': `force` is the line's beyond the block's weight already.
        let hook_load_N =
            if block_kg > 0.0 { force + block_kg * (after - before_m_per_s) / dt } else { force };
        let mean = 0.5 * (before_m_per_s + after);
        HoistStep { hook_load_N, work_J: -hook_load_N * mean * dt }
    }

    /// Sets the speed by the weight that is missing.
    fn drill(&mut self, dt: f64) {
        let Autodriller {
            gain_m_per_s_per_N: gain,
            integral_time_s,
            min_speed_m_per_s: least,
            max_speed_m_per_s: most,
            ..
        } = self.autodriller;
        // v = v₀ + K (e + ∫ e dt/T_i).
        let missing = self.target.weight_N - self.filtered_N;
        let demand = libm::fma(gain, missing, self.target.velocity_m_per_s) + self.integral_m_per_s;
        self.velocity_m_per_s = demand.max(least).min(most);
        // The integral does not run on against a limit.
        let held = (demand < least && missing < 0.0) || (demand > most && missing > 0.0);
        if !held {
            self.integral_m_per_s += gain * missing * dt / integral_time_s;
        }
    }
}

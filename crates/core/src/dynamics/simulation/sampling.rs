//! Records of a run at each sample.

use super::{
    run::Run,
    settling::{Settled, Settling},
};
use crate::{
    dynamics::{
        kernel::chain::node,
        output::{energy::Ledger, record},
        settings::HoistControl,
    },
    simd::number::Real,
};

impl<R: Real> Run<R> {
    /// Ends a sample: adds the sums since the last one to the record.
    pub(super) fn sample(&mut self) {
        let time = self.time_s();
        let interval_s = self.sample_interval_s();
        let run_samples = (self.end_time_s() / interval_s).round() as u64;
        let opens = !self.state.window_open && self.settles(time, interval_s);
        if opens {
            self.open_window();
        }
        self.chain.close();
        let (chain, state) = (&self.chain, &mut self.state);
        let (anchors, record) = (&state.anchors, &mut state.record);
        let sums = std::mem::take(&mut state.since_sample);
        let n = sums.steps as f64;
        let motor_pressure_Pa = state.bit.motor_pressure_Pa(sums.bit_torque / n);
        if let Some(mud) = &mut state.viscous {
            mud.sample(chain, &self.model, motor_pressure_Pa.unwrap_or(0.0));
            let pressures = mud.pressures();
            record.press(|node| pressures.difference_Pa(node));
        }
        let rubbed_J = state.wear.sample(chain, |i| anchors[i].md_m);
        if !opens {
            state.ledger.book_friction(rubbed_J);
        }
        let cut = state.bit.side_cut_m();
        record.note_penetration(self.borehole.held_penetration_m(chain, anchors, cut));
        let totals = record.sample(chain, &state.high, &state.body, sums.steps);
        record.note_contact(chain, anchors, totals.penetration_m);
        record.squeeze(&state.squeezed.each_m);
        record.map_contact(anchors, time, run_samples);
        let last = chain.nodes() - 1;
        let neutral_point_m = record::neutral_point_m(chain, anchors, totals.tension_N);
        let path = &self.model.well.path;
        let cutoff_depth_m = record.cutoff_depth_m(&self.mesh, path, anchors, interval_s);
        let (block, weight) = match state.hoist.control() {
            HoistControl::BlockVelocity(velocity) => (Some(velocity), None),
            HoistControl::Autodriller => (None, Some(state.hoist.target_N())),
            HoistControl::HookLoad(_) => (None, None),
        };
        let bit_depth_m = anchors[last].md_m + chain.displacement(last).dot(chain.tangent(last));
        let rotation = state.set_points.rotary_speed_rad_per_s(time);
        let pump_pressure_Pa = state.viscous.as_ref().map(|mud| mud.pressures().pump_Pa());
        let series = &mut record.series;
        series.time_s.push(time);
        series.bit_depth_m.push(bit_depth_m);
        series.hook_load_N.push(sums.hook_load / n);
        series.surface_torque_N_m.push(sums.surface_torque / n);
        series.friction_torque_N_m.push(totals.torque_N_m);
        series.axial_friction_N.push(-totals.axial_N);
        series.side_force_total_N.push(totals.normal_N);
        series.weight_on_bit_N.push(sums.weight_on_bit / n);
        series.bit_torque_N_m.push(sums.bit_torque / n);
        series.bit_force_high_N.push(sums.bit_high / n);
        series.bit_force_right_N.push(sums.bit_right / n);
        series.bit_moment_N_m.push(sums.bit_moment / n);
        series.depth_of_cut_m.push(sums.depth_of_cut / n);
        series.rate_of_penetration_m_per_s.push(sums.rate_of_penetration / n);
        let motor = state.bit.has_motor().then_some(sums.motor_speed / n);
        series.motor_speed_rad_per_s.push(motor);
        series.motor_pressure_Pa.push(motor_pressure_Pa);
        series.twist_rad.push(-totals.twist_rad);
        series.stretch_m.push(
            totals.longer_m - state.squeezed.total_m
                + state.viscous.as_ref().map_or(0.0, |mud| mud.stretch_m(&self.mesh)),
        );
        let block_now = state.hoist.velocity_m_per_s();
        series.block_velocity_m_per_s.push(block_now);
        let bit_spin = node!(chain, last, spin);
        series.bit_rotary_speed_rad_per_s.push(bit_spin);
        series.rotary_speed_rad_per_s.push(node!(chain, 0, spin));
        series.rotary_speed_set_rad_per_s.push(rotation);
        series.block_velocity_set_m_per_s.push(block);
        series.weight_on_bit_set_N.push(weight);
        series.flow_rate_m3_per_s.push(state.flow_m3_per_s);
        series.pump_pressure_Pa.push(pump_pressure_Pa);
        series.schedule_line.push(state.set_points.line());
        series.neutral_point_m.push(neutral_point_m);
        series.cutoff_depth_m.push(cutoff_depth_m);
        self.probe();
    }

    /// Notes the signals of single nodes.
    fn probe(&mut self) {
        let scene = self.scene();
        let probes = self.state.record.series.probes.iter();
        let values: Vec<f64> = probes.map(|p| scene.signal(p.node, p.signal)).collect();
        for (probe, value) in self.state.record.series.probes.iter_mut().zip(values) {
            probe.samples.push(value);
        }
    }

    /// Whether the sample that ends at `time` is the first of the window.
    fn settles(&mut self, time: f64, interval_s: f64) -> bool {
        if let Settling::Fixed(settle_s) = self.settling {
            return time >= settle_s;
        }
        let length_m = self.mesh.nodes[0].from_bit_m;
        let (series, duration_s) = (&self.state.record.series, self.settings.duration_s);
        self.state.settled = self.settling.ends(series, interval_s, duration_s, length_m);
        self.state.settled.is_some()
    }

    /// Begins the window anew, whether it had begun or not, and discards the earlier samples: the
    /// next sample is its first. The schedule and the motion continue.
    pub fn restart_window(&mut self) {
        let time_s = self.time_s();
        self.open_window_after(time_s);
        let steady = self.state.settled.is_some_and(|settled| settled.steady);
        let settle_s = time_s + self.sample_interval_s();
        self.state.settled = Some(Settled { settle_s, steady });
        self.state.record.forget_samples();
    }

    /// Drops the samples of before a time, s, so that a run of hours takes no more memory than one
    /// of minutes, with the lines of the schedule that were added by hand and were replaced before
    /// it. The last sample stays, and so do those that the test of steadiness uses while the string
    /// settles. The schedule and the motion continue.
    pub fn forget(&mut self, before_s: f64) {
        let needed_s = match self.settling {
            _ if self.state.window_open => 0.0,
            Settling::Fixed(_) => 0.0,
            Settling::UntilSteady { stretch_s, .. } => stretch_s + self.sample_interval_s(),
        };
        let before_s = before_s.min(self.time_s() - needed_s);
        let state = &mut self.state;
        state.record.drop_samples(before_s);
        let lines = &mut state.record.series.schedule_line;
        // The line that the first sample follows is named by it.
        let replaced = lines.first().map_or(0, |line| line.saturating_sub(1));
        let dropped = state.set_points.drop_added(replaced, &self.settings.schedule);
        lines.iter_mut().for_each(|line| *line -= dropped);
    }

    /// From now on statistics and the ledger of energy count.
    fn open_window(&mut self) {
        self.open_window_after(self.time_s() - self.sample_interval_s());
    }

    /// The same where the last sample before the window is that of `before_s`.
    fn open_window_after(&mut self, before_s: f64) {
        let (energies, flow_work_J) = (self.energies(), self.flow_work_J());
        let state = &mut self.state;
        state.window_open = true;
        state.record.close_contact_row(&state.anchors, before_s);
        state.record.open_window(before_s);
        state.bit.open_window();
        state.wear.restart(state.anchors[state.anchors.len() - 1].md_m);
        state.ledger = Ledger::open(energies, flow_work_J);
        if let Some(mud) = &mut state.viscous {
            mud.open_window();
        }
    }
}

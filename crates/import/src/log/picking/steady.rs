//! Windows of steady motion in the rows of a stand.

use super::{
    beginning::Beginning,
    estimate::{Estimate, median, noise, quantile},
    motion::{Motion, Moving, half_span},
    row::Row,
    thresholds::Thresholds,
    window::{Kind, Refusal, Refused, Window},
};

/// Parameters by which windows are accepted.
#[derive(Debug, Clone, Copy)]
pub(super) struct Judge<'a> {
    pub(super) limits: &'a Thresholds,
    pub(super) log: &'a Beginning,
    /// Weight on the sensor in addition to the string, N.
    pub(super) on_sensor_N: f64,
    /// Correction added to a logged weight, N.
    pub(super) added_N: f64,
}

/// An accepted window, or the reason for a refusal.
pub(super) type Found = Result<Window, Refused>;

impl Judge<'_> {
    /// The windows of a stand.
    pub(super) fn windows(&self, moving: &Moving<'_>, stand: usize) -> Vec<Found> {
        let mut found = Vec::new();
        for (motion, first, end) in moving.runs() {
            let Some(kind) = Kind::of(motion) else { continue };
            if kind == Kind::Rotating && !self.log.tells_bottom {
                continue;
            }
            let rows = &moving.rows[first..end];
            if duration_s(rows) < self.shortest_s(kind) {
                continue;
            }
            let refused = |(from, to): (usize, usize), why| Refused {
                kind,
                from_s: moving.rows[from].time_s,
                to_s: moving.rows[to - 1].time_s,
                why,
            };
            let Some(cut) = self.cut(moving, motion, (first, end)) else {
                found.push(Err(refused((first, end), Refusal::Short)));
                continue;
            };
            for piece in self.pieces(moving.rows, cut) {
                let pick = self.pick(moving, kind, piece, stand);
                found.push(pick.map_err(|why| refused(piece, why)));
            }
        }
        found
    }

    fn shortest_s(&self, kind: Kind) -> f64 {
        match kind {
            Kind::PickUp | Kind::SlackOff => self.limits.moving_s,
            Kind::Rotating => self.limits.turning_s,
            Kind::Drilling => self.limits.drilling_s,
        }
    }

    /// Whether the rows last long enough and are numerous enough.
    fn is_enough(&self, rows: &[Row], kind: Kind) -> bool {
        // n rows cover n time steps.
        let lasts_s = duration_s(rows) + self.log.step_s;
        rows.len() >= self.limits.rows && lasts_s >= self.shortest_s(kind)
    }

    /// Cuts the transients off a stretch of motion; `None` if too little remains.
    fn cut(
        &self,
        moving: &Moving<'_>,
        motion: Motion,
        (first, end): (usize, usize),
    ) -> Option<(usize, usize)> {
        let limits = self.limits;
        let rows = moving.rows;
        let kind = Kind::of(motion)?;
        let begin_s = rows[first].time_s;
        let blurred_s = half_span(self.log.step_s) as f64 * self.log.step_s;
        let (mut from_s, mut to_s) = match kind {
            Kind::PickUp | Kind::SlackOff => {
                let (steady, steady_end) = self.steady(&moving.speed, (first, end));
                let way = |at: &usize| (moving.height[*at] - moving.height[first]).abs();
                let moved = (first..end).find(|at| way(at) >= limits.settle_m)?;
                let after = [begin_s + limits.settle_s, rows[moved].time_s, rows[steady].time_s];
                (after.into_iter().fold(begin_s + blurred_s, f64::max), rows[steady_end - 1].time_s)
            }
            Kind::Rotating => (begin_s + limits.settle_turning_s, rows[end - 1].time_s),
            Kind::Drilling => (begin_s + limits.settle_drilling_s, rows[end - 1].time_s),
        };
        to_s -= limits.end_s.max(blurred_s);
        let (stand, stand_end) = (rows[0].time_s, rows[rows.len() - 1].time_s);
        from_s = from_s.max(stand + limits.beside_slips_s);
        to_s = to_s.min(stand_end - limits.beside_slips_s);
        let from = first + rows[first..end].partition_point(|row| row.time_s < from_s);
        let to = first + rows[first..end].partition_point(|row| row.time_s <= to_s);
        (from < to && self.is_enough(&rows[from..to], kind)).then_some((from, to))
    }

    /// The longest part of a stretch in which the speed stays near its median; a single outlier is
    /// tolerated.
    fn steady(&self, speed: &[f64], (first, end): (usize, usize)) -> (usize, usize) {
        let usual = median(&mut speed[first..end].to_vec()).unwrap_or(0.0);
        let most = self.limits.steady_m_per_s.max(self.limits.steady_part * usual.abs());
        let is_steady = |at: usize| (speed[at] - usual).abs() <= most;
        let (mut best, mut begins) = ((first, first + 1), None);
        for at in first..end {
            if is_steady(at) {
                let from = *begins.get_or_insert(at);
                if at + 1 - from > best.1 - best.0 {
                    best = (from, at + 1);
                }
            } else if at + 1 >= end || !is_steady(at + 1) {
                begins = None;
            }
        }
        best
    }

    /// Divides a long stretch into pieces of one depth each.
    fn pieces(&self, rows: &[Row], (from, to): (usize, usize)) -> Vec<(usize, usize)> {
        let lasts_s = duration_s(&rows[from..to]);
        let count = (lasts_s / self.limits.longest_s).ceil().max(1.0) as usize;
        let size = (to - from).div_ceil(count);
        (from..to).step_by(size).map(|at| (at, (at + size).min(to))).collect()
    }

    /// Picks the values of a window, or returns the reason for refusing it.
    fn pick(
        &self,
        moving: &Moving<'_>,
        kind: Kind,
        (mut from, to): (usize, usize),
        stand: usize,
    ) -> Result<Window, Refusal> {
        let weight_N = match kind {
            Kind::Drilling => None,
            _ => {
                let (settled, weight_N) = self.weight(moving.rows, kind, (from, to))?;
                from = settled;
                Some(weight_N)
            }
        };
        let rows = &moving.rows[from..to];
        let torque = match kind {
            Kind::Rotating if self.log.has.torque => Some(self.torque(rows)),
            Kind::PickUp | Kind::SlackOff | Kind::Rotating => None,
            Kind::Drilling if rows[rows.len() - 1].hole_depth_m > rows[0].hole_depth_m => {
                Some(Ok(self.torque(rows)?))
            }
            Kind::Drilling => return Err(Refusal::NotDeeper),
        };
        let middle = |values: &mut Vec<f64>| median(values).unwrap_or(f64::NAN);
        let median_of = |value: fn(&Row) -> f64| middle(&mut rows.iter().map(value).collect());
        Ok(Window {
            kind,
            stand,
            from_s: rows[0].time_s,
            to_s: rows[rows.len() - 1].time_s,
            bit_depth_m: median_of(|row| row.bit_depth_m),
            speed_m_per_s: middle(&mut moving.speed[from..to].to_vec()),
            rotary_rad_per_s: median_of(|row| row.rotary_rad_per_s),
            weight_N,
            torque_N_m: torque.and_then(Result::ok),
            torque_refusal: torque.and_then(Result::err),
        })
    }

    /// Weight of a window from the row where it has settled.
    fn weight(
        &self,
        rows: &[Row],
        kind: Kind,
        (mut from, to): (usize, usize),
    ) -> Result<(usize, Estimate), Refusal> {
        loop {
            let own = &rows[from..to];
            let loads = there(own, |row| row.hook_load_N);
            if 2 * loads.len() < own.len() || loads.is_empty() {
                return Err(Refusal::Silent);
            }
            let mut found = Estimate::by_median(&loads).ok_or(Refusal::Silent)?;
            let string_N = found.value - self.on_sensor_N;
            if self.changes(own, &loads, string_N) {
                let later = from + (own.len() / 4).max(1);
                if later < to && self.is_enough(&rows[later..to], kind) {
                    from = later;
                    continue;
                }
                return Err(Refusal::Settling);
            }
            if found.spread > self.limits.spread * string_N {
                return Err(Refusal::Unsteady);
            }
            let on_bit = median(&mut there(own, |row| row.weight_on_bit_N)).unwrap_or(0.0);
            if kind == Kind::Rotating && on_bit > self.limits.weight_on_bit * string_N {
                return Err(Refusal::OnBit);
            }
            found.value += self.added_N;
            return Ok((from, found));
        }
    }

    /// Whether the weight at the end of a window differs from that at its beginning.
    fn changes(&self, rows: &[Row], loads: &[f64], string_N: f64) -> bool {
        let third = loads.len() / 3;
        let part = |part: &[f64]| median(&mut part.to_vec());
        let (Some(before), Some(after)) =
            (part(&loads[..third]), part(&loads[loads.len() - third..]))
        else {
            return false;
        };
        let depth = |row: &Row| row.bit_depth_m;
        let (top, low) = (depth(&rows[0]), depth(&rows[rows.len() - 1]));
        let longer = (low - top).abs() / top.max(low);
        let longer = if longer.is_finite() { longer } else { 0.0 };
        let error = 1.2533 * noise(loads) * (2.0 / third as f64).sqrt();
        (after - before).abs() > (self.limits.change + longer) * string_N + 3.0 * error
    }

    /// The torque of a window.
    fn torque(&self, rows: &[Row]) -> Result<Estimate, Refusal> {
        let torques = there(rows, |row| row.torque_N_m);
        if 2 * torques.len() < rows.len() {
            return Err(Refusal::Silent);
        }
        let found = Estimate::by_mean(&torques).ok_or(Refusal::Silent)?;
        let end = |part: f64| quantile(&mut torques.clone(), part).unwrap_or(f64::NAN);
        let swing = 0.5 * (end(0.95) - end(0.05));
        if swing < self.limits.swing * found.value { Ok(found) } else { Err(Refusal::Swinging) }
    }
}

fn there(rows: &[Row], value: impl Fn(&Row) -> f64) -> Vec<f64> {
    rows.iter().map(value).filter(|value| value.is_finite()).collect()
}

fn duration_s(rows: &[Row]) -> f64 {
    match rows {
        [first, .., last] => last.time_s - first.time_s,
        _ => 0.0,
    }
}

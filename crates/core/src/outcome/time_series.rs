//! Scalars against time, declared once.

use serde::{Deserialize, Serialize};

use super::{
    column::{Column, DriftScale, columns},
    method::IN_TIME,
    quantity::is_same,
};
use crate::{
    damage::{Damaged, ensure},
    dynamics::Probed,
};

columns! {
    /// Scalars against time, from time zero; rows are samples, contact quantities averages over
    /// them.
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
    pub struct TimeSeries, "Columns of the series against time, in the order of `time.parquet`."
    TIME_SERIES {
        time_s: Vec<f64> => Time, "Simulated time from the start, settling included",
            known_by IN_TIME;
        bit_depth_m: Vec<f64> => Depth, "Measured depth of the bit", known_by IN_TIME;
        weight_on_bit_N: Vec<f64> => Force, "Weight on bit", known_by IN_TIME,
            statistics 6 on DriftScale::Force;
        bit_torque_N_m: Vec<f64> => Torque, "Torque at the bit", known_by IN_TIME,
            statistics 7 on DriftScale::Torque;
        bit_force_high_N: Vec<f64> => Force,
            "Force of rock and hole on the bit across the hole, towards its high side",
            known_by IN_TIME;
        bit_force_right_N: Vec<f64> => Force, "The same to the right, looking down the hole",
            known_by IN_TIME;
        bit_moment_N_m: Vec<f64> => Torque,
            "Magnitude of the bending moment of solid rock on the bit; 0 for other laws",
            known_by IN_TIME;
        depth_of_cut_m: Vec<f64> => Length,
            "Depth of rock removed per revolution of the bit; 0 where a motor turns it at a speed \
             that is not given", known_by IN_TIME;
        rate_of_penetration_m_per_s: Vec<f64> => RateOfPenetration,
            "Depth of rock that the bit removes per time", known_by IN_TIME,
            statistics 8 on DriftScale::Own(1.0 / 3600.0);
        motor_speed_rad_per_s: Vec<Option<f64>> => RotarySpeed,
            "Speed of the mud motor relative to the string; `null` without a motor",
            known_by IN_TIME,
            null_where "there is no motor";
        motor_pressure_Pa: Vec<Option<f64>> => Pressure,
            "Pressure drop across the mud motor; `null` without a motor or where its \
             speed alone is given", known_by IN_TIME,
            null_where "there is no motor, or its speed alone is given";
        hook_load_N: Vec<f64> => Force,
            "Tension at the top of the string; block and top drive excluded", known_by IN_TIME,
            statistics 1 on DriftScale::Force;
        surface_torque_N_m: Vec<f64> => Torque, "Torque at the top of the string", known_by IN_TIME,
            statistics 2 on DriftScale::Torque;
        friction_torque_N_m: Vec<f64> => Torque, "Torque of wall friction, summed along the string",
            known_by IN_TIME,
            statistics 3 on DriftScale::Torque;
        axial_friction_N: Vec<f64> => Force,
            "Axial friction of the wall, summed; positive adds to hook load", known_by IN_TIME,
            statistics 4 on DriftScale::Force;
        side_force_total_N: Vec<f64> => Force,
            "Magnitude of the side force, summed along the string", known_by IN_TIME,
            statistics 5 on DriftScale::Own(1e4);
        twist_rad: Vec<f64> => Angle,
            "Turn of the top against the bit; positive where the top leads", known_by IN_TIME,
            statistics 9 on DriftScale::Own(1.0);
        stretch_m: Vec<f64> => Length, "Elongation against the unloaded string", known_by IN_TIME,
            statistics 10 on DriftScale::Own(0.1);
        neutral_point_m: Vec<Option<f64>> => Depth,
            "Measured depth of the shallowest zero of effective tension; `null` if none",
            known_by IN_TIME,
            null_where "there is none";
        cutoff_depth_m: Vec<Option<f64>> => Depth,
            "Deepest change of the side force, averaged over the preceding second, from high to \
             low side: one value per second, `null` in between and if there is none",
            known_by IN_TIME,
            null_where "there is none, and between whole seconds";
        block_velocity_m_per_s: Vec<f64> => Speed,
            "Speed of the travelling block; positive downwards", known_by IN_TIME;
        bit_rotary_speed_rad_per_s: Vec<f64> => RotarySpeed,
            "Rotary speed of the string at the bit, without that of a mud motor", known_by IN_TIME,
            statistics 11 on DriftScale::Own(1.0);
        rotary_speed_rad_per_s: Vec<f64> => RotarySpeed, "Rotary speed at surface",
            known_by IN_TIME;
        rotary_speed_set_rad_per_s: Vec<f64> => RotarySpeed,
            "Set point of the rotary speed at surface", known_by IN_TIME;
        block_velocity_set_m_per_s: Vec<Option<f64>> => Speed,
            "Set point of the speed of the block; positive downwards, `null` where another \
             quantity is set", known_by IN_TIME,
            null_where "something else is set";
        weight_on_bit_set_N: Vec<Option<f64>> => Force,
            "Set point of the autodriller for the weight on bit; `null` where it is not in control",
            known_by IN_TIME,
            null_where "the autodriller is not in control";
        flow_rate_m3_per_s: Vec<f64> => FlowRate, "Flow rate of the pumps", known_by IN_TIME;
        pump_pressure_Pa: Vec<Option<f64>> => Pressure,
            "Delivery pressure of the pumps; `null` without a rheology", known_by IN_TIME,
            null_where "the mud has no rheology";
    }
    beside {
        /// Line of the schedule that began last, counted from one; zero before the first.
        schedule_line: Vec<usize>;
        /// Records of single nodes, as required by the settings.
        probes: Vec<Probed>;
    }
}

/// Number of columns with statistics.
const COUNT: usize = {
    let (mut count, mut place) = (0, 0);
    while place < TIME_SERIES.len() {
        if TIME_SERIES[place].statistics.is_some() {
            count += 1;
        }
        place += 1;
    }
    count
};

/// The columns that have statistics over a window, in the order of their places there.
pub(crate) const VARYING: [&Column<TimeSeries>; COUNT] = {
    let mut all = [None; COUNT];
    let mut place = 0;
    while place < TIME_SERIES.len() {
        let column = &TIME_SERIES[place];
        if let Some(statistic) = column.statistics {
            assert!(all[statistic.place - 1].is_none(), "two columns have the same place");
            all[statistic.place - 1] = Some(column);
        }
        place += 1;
    }
    let mut found = [&TIME_SERIES[0]; COUNT];
    let mut place = 0;
    while place < COUNT {
        found[place] = all[place].expect("places are counted from one");
        place += 1;
    }
    found
};

/// The place of a column among [`VARYING`].
///
/// # Panics
/// Where the column has no statistics: in a constant this is a compile error.
pub(crate) const fn varying_place(name: &str) -> usize {
    let mut place = 0;
    while place < COUNT {
        if is_same(VARYING[place].quantity.name, name) {
            return place;
        }
        place += 1;
    }
    panic!("no statistics are taken of a column of that name")
}

impl TimeSeries {
    /// Checks that a stored series has this number of nodes, that all its columns have one length,
    /// and that the records of nodes are longer by the rows that were handed over; returns its
    /// number of rows.
    pub(crate) fn check(&self, nodes: usize, handed_over: usize) -> Result<usize, Damaged> {
        let rows = self.time_s.len();
        let probed = rows.checked_add(handed_over);
        let fits = TIME_SERIES.iter().all(|column| (column.of)(self).len() == rows)
            && self.schedule_line.len() == rows
            && self.probes.iter().all(|p| p.node < nodes && Some(p.samples.len()) == probed);
        ensure(fits, "the series against time")?;
        Ok(rows)
    }

    /// Drops the first rows of all columns, but not the records of single nodes.
    pub(crate) fn drop_first(&mut self, rows: usize) {
        let rows = rows.min(self.time_s.len());
        for column in TIME_SERIES {
            (column.drop_first)(self, rows);
        }
        self.schedule_line.drain(..rows);
    }

    /// Drops the first samples that were recorded of single nodes.
    pub(crate) fn drop_first_probed(&mut self, samples: usize) {
        for probe in &mut self.probes {
            probe.samples.drain(..samples.min(probe.samples.len()));
        }
    }
}

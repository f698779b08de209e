//! Output of the measurements on the screen.

use wholestring_runner::bench::{
    Kernel, MeasuredWell, Mechanisms, Memory, RockSpeed, RunRow, Spread, Sweeps, TIME,
};

use crate::screen_table::Table;

pub(super) fn sentence(well: &MeasuredWell, count: usize) -> String {
    let MeasuredWell { case, bit_depth_m, elements, time_step_s, assembly_steps } = well;
    let step_ms = 1e3 * time_step_s;
    let assembly =
        assembly_steps.map_or_else(String::new, |steps| format!(", {steps} in it of the assembly"));
    format!(
        "{case}: bit at {bit_depth_m:.0} m, {elements} elements, steps of {step_ms:.3} \
         ms{assembly}; contact, friction and statistics on\n\
         {TIME}, median of {count}\n"
    )
}

pub(super) fn kernel(kernel: &Kernel) -> String {
    let mut table = Table::new(
        "The inner loop",
        2,
        &[
            "precision",
            "instructions",
            "ns per element-step",
            "least to most",
            "Gflop/s",
            "peak",
            "of it",
        ],
    );
    for row in &kernel.rows {
        let [median, spread] = cells(row.ns_per_element_step, 1);
        let share = row.gflop_per_s / row.peak_gflop_per_s;
        table.row(vec![
            row.precision.to_owned(),
            row.instructions.to_owned(),
            median,
            spread,
            format!("{:.1}", row.gflop_per_s),
            format!("{:.1}", row.peak_gflop_per_s),
            format!("{:.0} %", 100.0 * share),
        ]);
    }
    let each = |count: u64| count as f64 / kernel.element_steps;
    let flops = kernel.flops;
    format!(
        "{}An element-step is {:.0} flop: {:.0} multiplications with addition (two each), \
         {:.0} multiplications, \
         {:.0} additions,\n{:.1} divisions and {:.1} roots (one each). The peak is the \
         best rate of multiplications and additions with the same registers.\n",
        table.text(),
        each(flops.total()),
        each(flops.multiply_additions),
        each(flops.multiplications),
        each(flops.additions),
        each(flops.divisions),
        each(flops.roots),
    )
}

pub(super) fn runs(rows: &[RunRow]) -> String {
    let mut table = Table::new(
        "A whole run",
        2,
        &["precision", "instructions", "ns per element-step", "least to most", "× real time"],
    );
    for row in rows {
        let [median, spread] = cells(row.ns_per_element_step, 1);
        table.row(vec![
            row.precision.to_owned(),
            row.instructions.to_owned(),
            median,
            spread,
            format!("{:.1}", row.real_time_factor),
        ]);
    }
    table.text()
}

pub(super) fn memory(memory: &Memory) -> String {
    format!(
        "`wholestring run` of {:.0} s, results written: {:.1} s of wall-clock time, {:.1} MB of \
         memory at most\n",
        memory.simulated_s, memory.wall_time_s, memory.peak_MB
    )
}

pub(super) fn mechanisms(mechanisms: &Mechanisms) -> String {
    let mut table = Table::new(
        "Cost of each mechanism in a whole run",
        1,
        &["switched on", "ns per element-step", "costs", "least to most"],
    );
    table.row(vec![
        "nothing".to_owned(),
        format!("{:.1}", mechanisms.ns_per_element_step),
        String::new(),
        String::new(),
    ]);
    for row in &mechanisms.rows {
        let percent = |ratio: f64| format!("{:+.0} %", 100.0 * (ratio - 1.0));
        let Spread { median, least, most } = row.time_ratio;
        table.row(vec![
            row.mechanism.to_owned(),
            format!("{:.1}", row.ns_per_element_step),
            percent(median),
            format!("{} to {}", percent(least), percent(most)),
        ]);
    }
    table.text()
}

pub(super) fn rock(speed: &RockSpeed) -> String {
    let [x, y, z] = speed.cells;
    let title = format!(
        "Solid rock, {x} × {y} × {z} hexahedra of {:.0} mm under a bit of {:.0} mm",
        1e3 * speed.edge_m,
        1e3 * speed.bit_m
    );
    let mut table = Table::new(
        &title,
        2,
        &[
            "rock",
            "instructions",
            "ns per hexahedron-step",
            "least to most",
            "contact of it",
            "yielding",
            "nodes touching",
        ],
    );
    for row in &speed.rows {
        let [median, spread] = cells(row.ns_per_hexahedron_step, 1);
        table.row(vec![
            row.rock.to_owned(),
            row.instructions.to_owned(),
            median,
            spread,
            format!("{:.1}", row.contact_ns_per_hexahedron_step),
            format!("{:.0} %", 100.0 * row.yielding),
            row.touching_nodes.to_string(),
        ]);
    }
    table.text()
}

pub(super) fn sweeps(sweeps: &Sweeps) -> String {
    let title =
        format!("A sweep of {} cases on {} cores, results written", sweeps.cases, sweeps.cores);
    let mut table = Table::new(
        &title,
        2,
        &["precision", "friction", "simulated, s", "wall-clock, s", "× real time"],
    );
    for row in &sweeps.rows {
        table.row(vec![
            row.precision.to_owned(),
            row.friction_law.to_owned(),
            format!("{:.0}", row.simulated_s),
            format!("{:.1}", row.wall_time_s),
            format!("{:.1}", row.simulated_s / row.wall_time_s),
        ]);
    }
    table.text()
}

/// Median, and the range from least to greatest.
fn cells(spread: Spread, decimals: usize) -> [String; 2] {
    let Spread { median, least, most } = spread;
    [format!("{median:.decimals$}"), format!("{least:.decimals$} to {most:.decimals$}")]
}

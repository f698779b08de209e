//! Waves: their speeds, and the reflections at open faces.

use wholestring_rock::{Block, BlockSpec, Edge, Stepper};
use wholestring_verification::verify;

use crate::setup::{elastic, step, tell_layer};

/// A pulse sent down from the upper face, and its values at two depths.
struct Pulse {
    speed_m_per_s: f64,
    /// Largest velocity of the reflection, over that of the incident pulse.
    returned: f64,
}

/// Sends a pulse of `length` elements down a block, 60 deep, in which waves of a speed go; seen in
/// the middle of its width.
fn send(edges: [Edge; 6], wide: usize, direction: usize, wave_m_per_s: f64) -> Pulse {
    let (deep, size_m, length) = (60, 1e-3, 24.0);
    let spec = BlockSpec { edges, ..BlockSpec::new(elastic(), [wide, 1, deep], size_m) };
    let mut block = Block::new(&spec).expect("a sound block");
    let (grid, stepper, dt) = (*block.grid(), Stepper::default(), block.dt_s());
    let lasts = length * size_m / wave_m_per_s;
    let depths = [15, 40];
    let gauges = depths.map(|k| grid.node([wide / 2, 0, k]));
    let (mut when, mut weight) = ([0.0; 2], [0.0; 2]);
    let (mut down, mut up): (f64, f64) = (0.0, 0.0);
    // The pulse's end is at the lower face, and its reflection, once it has left again, above the
    // lower gauge.
    let steps = ((deep as f64 * 1.9 * size_m) / wave_m_per_s / dt) as usize;
    for n in 0..steps {
        let t = n as f64 * dt;
        let mut velocity = [0.0; 3];
        if t < lasts {
            velocity[direction] = (std::f64::consts::PI * t / lasts).sin().powi(2);
        }
        tell_layer(&mut block, 0, velocity);
        step(&mut block, &stepper);
        let passed = (depths[1] as f64 * size_m) / wave_m_per_s + 1.15 * lasts;
        for (gauge, index) in gauges.into_iter().enumerate() {
            let v = block.velocity_m_per_s(index)[direction];
            if t < passed {
                when[gauge] += t * v * v;
                weight[gauge] += v * v;
                down = down.max(v);
            } else {
                up = up.max(v.abs());
            }
        }
    }
    let [first, second] = [0, 1].map(|gauge| when[gauge] / weight[gauge]);
    Pulse {
        speed_m_per_s: (depths[1] - depths[0]) as f64 * size_m / (second - first),
        returned: up / down,
    }
}

fn check(name: &str, pulse: &Pulse, expected: f64) {
    verify("rock", format!("speed of {name} waves, m/s"))
        .relative(0.01, "required, of waves 24 elements long")
        .report(expected, pulse.speed_m_per_s);
    verify("rock", format!("energy of a {name} pulse that an open face sends back as a part"))
        .absolute(0.05, "required")
        .report(0.0, pulse.returned * pulse.returned);
}

#[test]
fn pressure_waves_have_their_speed_and_leave() {
    use Edge::{Guided, Held, Open};
    let speed = elastic().pressure_wave_m_per_s();
    let pulse = send([Guided, Guided, Guided, Guided, Held, Open], 2, 2, speed);
    check("pressure", &pulse, speed);
}

#[test]
fn shear_waves_have_their_speed_and_leave() {
    use Edge::{Free, Guided, Held, Open};
    let speed = elastic().shear_wave_m_per_s();
    // So wide that nothing comes from the sides before the end: pressure waves are sqrt(3) times as
    // fast.
    let pulse = send([Free, Free, Guided, Guided, Held, Open], 420, 0, speed);
    check("shear", &pulse, speed);
}

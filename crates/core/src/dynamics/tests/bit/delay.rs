//! The bit-rock system of Richard, Germay and Detournay by an integrator of its own: the
//! independent answer to how it sticks and slips.
//!
//! Dimensionless as in *Journal of Sound and Vibration* 305 (2007): time in `√(I/C)`, depth in
//! `2C/(ε a²)`. Runge-Kutta of fourth order between events; the surface that the bit leaves is kept
//! against the angle for good, and looked up a blade's sector back.

/// A mass and a wheel on a torsion spring with a drag bit, and their drive.
#[derive(Clone, Copy)]
pub(super) struct System {
    pub(super) blades: f64,
    /// `ψ = ζ ε a I/(M C)`.
    pub(super) psi: f64,
    /// Weight on the wear flats, `nλ`.
    pub(super) bearing: f64,
    /// `β = μ γ ζ`.
    pub(super) beta: f64,
    /// Weight on bit that is applied.
    pub(super) weight: f64,
    /// Speed of the top, `ω₀`.
    pub(super) speed: f64,
}

#[derive(Clone, Copy, PartialEq)]
enum Axial {
    Down,
    Stands,
    Up,
}

#[derive(Clone, Copy)]
struct State {
    depth: f64,
    velocity: f64,
    angle: f64,
    spin: f64,
}

#[derive(Clone, Copy, PartialEq)]
struct Mode {
    axial: Axial,
    touches: bool,
    turns: bool,
}

/// Results of one run.
pub(super) struct Seen {
    /// When the bit stopped turning.
    pub(super) sticks: Vec<f64>,
    /// Largest spin.
    pub(super) fastest: f64,
    /// Share of the time off the rock.
    pub(super) off: f64,
}

struct Run {
    system: System,
    time: f64,
    state: State,
    mode: Mode,
    /// Surface against angle, both growing.
    angles: Vec<f64>,
    surface: Vec<f64>,
}

/// Step between events.
const STEP: f64 = 1e-3;

impl System {
    /// Runs from steady drilling, the spin changed by a part of itself.
    pub(super) fn run(self, until: f64, disturbed: f64) -> Seen {
        let sector = std::f64::consts::TAU / self.blades;
        let cut = (self.weight - self.bearing) / self.blades;
        let angles: Vec<f64> = (0..=40).map(|i| sector * (f64::from(i) / 20.0 - 2.0)).collect();
        let run = Run {
            system: self,
            time: 0.0,
            state: State {
                depth: 0.0,
                velocity: cut / sector * self.speed,
                angle: 0.0,
                spin: self.speed * (1.0 + disturbed),
            },
            mode: Mode { axial: Axial::Down, touches: true, turns: true },
            surface: angles.iter().map(|a| a * cut / sector).collect(),
            angles,
        };
        // The top is ahead by the torque.
        let torque = self.blades * cut + self.beta * self.bearing;
        run.go(until, torque)
    }
}

impl Run {
    /// Surface at an angle that the bit has passed.
    fn surface_at(&self, angle: f64) -> f64 {
        let next = self.angles.partition_point(|a| *a <= angle);
        let next = next.clamp(1, self.angles.len() - 1);
        let (a, b) = (self.angles[next - 1], self.angles[next]);
        let part = if b > a { (angle - a) / (b - a) } else { 1.0 };
        self.surface[next - 1] + part * (self.surface[next] - self.surface[next - 1])
    }

    fn cut(&self, s: &State) -> f64 {
        s.depth - self.surface_at(s.angle - std::f64::consts::TAU / self.system.blades)
    }

    /// Weight of cutting, weight on the wear flats.
    fn weights(&self, s: &State, mode: Mode) -> (f64, f64) {
        if !mode.touches {
            return (0.0, 0.0);
        }
        let cutting = self.system.blades * self.cut(s);
        let bearing = match mode.axial {
            Axial::Down => self.system.bearing,
            Axial::Up => 0.0,
            Axial::Stands => self.system.weight - cutting,
        };
        (cutting, bearing)
    }

    fn torque(&self, s: &State, mode: Mode) -> f64 {
        let (cutting, bearing) = self.weights(s, mode);
        cutting + self.system.beta * bearing
    }

    fn rates(&self, s: &State, time: f64, mode: Mode, lead: f64) -> State {
        let (cutting, bearing) = self.weights(s, mode);
        State {
            depth: s.velocity,
            velocity: self.system.psi * (self.system.weight - cutting - bearing),
            angle: s.spin,
            spin: if mode.turns { self.spring(s, time, lead) - self.torque(s, mode) } else { 0.0 },
        }
    }

    fn spring(&self, s: &State, time: f64, lead: f64) -> f64 {
        self.system.speed * time + lead - s.angle
    }

    fn step(&self, h: f64, lead: f64) -> State {
        let s = self.state;
        let at = |k: &State, h: f64| State {
            depth: s.depth + h * k.depth,
            velocity: s.velocity + h * k.velocity,
            angle: s.angle + h * k.angle,
            spin: s.spin + h * k.spin,
        };
        let rates = |s: &State, h: f64| self.rates(s, self.time + h, self.mode, lead);
        let k1 = rates(&s, 0.0);
        let k2 = rates(&at(&k1, 0.5 * h), 0.5 * h);
        let k3 = rates(&at(&k2, 0.5 * h), 0.5 * h);
        let k4 = rates(&at(&k3, h), h);
        let mean = |f: fn(&State) -> f64| (f(&k1) + 2.0 * f(&k2) + 2.0 * f(&k3) + f(&k4)) / 6.0;
        let mean = State {
            depth: mean(|k| k.depth),
            velocity: mean(|k| k.velocity),
            angle: mean(|k| k.angle),
            spin: mean(|k| k.spin),
        };
        at(&mean, h)
    }

    /// Whether the mode does not hold at a state.
    fn ends(&self, s: &State, time: f64, lead: f64) -> bool {
        let mode = self.mode;
        let axial = match mode.axial {
            Axial::Down => s.velocity < 0.0,
            Axial::Up => s.velocity > 0.0,
            Axial::Stands => {
                let needed = self.system.weight - self.system.blades * self.cut(s);
                !(0.0..=self.system.bearing).contains(&needed)
            }
        };
        let turning = if mode.turns {
            s.spin < 0.0
        } else {
            self.spring(s, time, lead) > self.torque(s, mode)
        };
        axial || turning || (self.cut(s) > 0.0) != mode.touches
    }

    fn go(mut self, until: f64, lead: f64) -> Seen {
        let mut seen = Seen { sticks: Vec::new(), fastest: 0.0, off: 0.0 };
        while self.time < until {
            let mut h = STEP;
            let mut end = self.step(h, lead);
            let event = self.ends(&end, self.time + h, lead);
            if event {
                let (mut low, mut high) = (0.0, h);
                for _ in 0..40 {
                    let middle = 0.5 * (low + high);
                    let state = self.step(middle, lead);
                    if self.ends(&state, self.time + middle, lead) {
                        high = middle;
                    } else {
                        low = middle;
                    }
                }
                h = high;
                end = self.step(h, lead);
            }
            if !self.mode.touches {
                seen.off += h;
            }
            self.time += h;
            self.state = end;
            if event {
                self.switch(lead, &mut seen);
            }
            let s = self.state;
            if self.mode.turns {
                let sector = std::f64::consts::TAU / self.system.blades;
                self.surface.push(s.depth.max(self.surface_at(s.angle - sector)));
                self.angles.push(s.angle);
            }
            seen.fastest = seen.fastest.max(s.spin);
        }
        seen.off /= until;
        seen
    }

    /// The mode that continues from here.
    fn switch(&mut self, lead: f64, seen: &mut Seen) {
        let mut s = self.state;
        self.mode.touches = self.cut(&s) > 0.0;
        let needed = self.system.weight - self.system.blades * self.cut(&s);
        let stops = match self.mode.axial {
            Axial::Down => s.velocity <= 0.0,
            Axial::Up => s.velocity >= 0.0,
            Axial::Stands => true,
        };
        if stops {
            s.velocity = 0.0;
            self.mode.axial = if !self.mode.touches || needed > self.system.bearing {
                Axial::Down
            } else if needed < 0.0 {
                Axial::Up
            } else {
                Axial::Stands
            };
        }
        let spring = self.spring(&s, self.time, lead);
        let holds = self.torque(&s, self.mode);
        if self.mode.turns && s.spin <= 0.0 {
            assert!(spring >= 0.0, "the bit would be turned back");
            s.spin = 0.0;
            if spring <= holds {
                self.mode.turns = false;
                seen.sticks.push(self.time);
            }
        } else if !self.mode.turns && spring > holds {
            self.mode.turns = true;
        }
        self.state = s;
    }
}

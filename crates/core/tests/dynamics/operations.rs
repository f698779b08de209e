//! Every operation in the dynamics, against the soft string.
use wholestring::{dynamics::*, operation::OperationKind};
use crate::wells::*;
#[test]
fn x() {
    let laws=[FrictionLaw::Vector,FrictionLaw::Independent];
    let contacts=[DynamicsSettings::default().contact_law, ContactLaw::Linear{stiffness_N_per_m:2e8,damping_ratio:0.05}];
    let mut v=vec![]; for k in OperationKind::ALL { for l in laws { for c in contacts { v.push((k,l,c)); }}}
    let r=each(&v,|(k,l,c)|{ let mut case=moderate(*k,0.25); case.settings.friction_law=*l; case.settings.contact_law=*c; let t=std::time::Instant::now(); (case.run(), case.soft().scalars, t.elapsed().as_secs_f64()) });
    for ((k,l,c),(o,s,t)) in v.iter().zip(r) { let d=o.scalars; let f=(1.0f64+0.0625).sqrt();
      eprintln!("op {:18} {:?} {} hook {:.1} {:.1} {:+.2e} axial {:.1} {:.1} {:+.2e} torque {:.2} {:.2} {:+.2e} side {:.1} {:.1} wob {:.1} hstd {:.1} resid {:.1e} pen {:.1e} {t:.2}", k.name(), l, matches!(c,ContactLaw::Hertz{..}), d.hook_load_N, s.hook_load_N, d.hook_load_N/s.hook_load_N-1.0, d.axial_friction_N,s.axial_friction_N, d.axial_friction_N/s.axial_friction_N-1.0, d.friction_torque_N_m,s.friction_torque_N_m, d.friction_torque_N_m/s.friction_torque_N_m*f-1.0, d.side_force_total_N, s.side_force_total_N, d.weight_on_bit_N, o.statistics[0].1.std, o.numerics.energy_residual, o.numerics.max_penetration_m);
    }
}

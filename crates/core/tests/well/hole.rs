//! Hole sections.

use wholestring::well::{Friction, Hole, HoleError, HoleKind, HoleSection};

fn section(from_md_m: f64, to_md_m: f64) -> HoleSection {
    HoleSection {
        kind: HoleKind::Casing,
        from_md_m,
        to_md_m,
        diameter_m: 0.22,
        friction: Friction { kinetic: 0.2, at_rest: 0.3, around: 1.0 },
        youngs_modulus_Pa: 210e9,
        poisson_ratio: 0.3,
        roughness: 1.0,
        casing: None,
    }
}

#[test]
fn section_by_depth() {
    let hole = Hole::new(vec![section(0.0, 1000.0), section(1000.0, 1500.0)]).unwrap();
    assert_eq!(hole.sections().len(), 2);
    for (md_m, index) in
        [(-5.0, 0), (0.0, 0), (999.0, 0), (1000.0, 0), (1000.1, 1), (1500.0, 1), (9999.0, 1)]
    {
        assert_eq!(hole.at(md_m), &hole.sections()[index], "MD {md_m}");
    }
}

#[test]
fn friction_everywhere() {
    let hole = Hole::new(vec![section(0.0, 1000.0), section(1000.0, 1500.0)]).unwrap();
    let other = hole.with_friction(0.4).unwrap();
    for section in other.sections() {
        assert_eq!(section.friction.kinetic, 0.4);
        assert!((section.friction.at_rest - 0.6).abs() < 1e-15);
    }
    let bare = hole.with_friction(0.0).unwrap().with_friction(0.1).unwrap();
    assert_eq!(bare.at(0.0).friction.at_rest, 0.1);
    assert!(hole.with_friction(-0.1).is_err());
    assert!(hole.with_friction(f64::NAN).is_err());
}

#[test]
fn refuses_what_makes_no_hole() {
    let message = |sections: Vec<HoleSection>| Hole::new(sections).unwrap_err().to_string();
    assert_eq!(Hole::new(Vec::new()), Err(HoleError::Empty));
    assert_eq!(
        message(vec![section(0.0, 1000.0), section(1200.0, 1500.0)]),
        "hole section 1 begins at MD 1200 m, but the section above ends at 1000 m"
    );
    assert_eq!(
        message(vec![section(0.0, 1000.0), section(900.0, 1500.0)]),
        "hole section 1 begins at MD 900 m, but the section above ends at 1000 m"
    );
    assert_eq!(
        message(vec![section(500.0, 500.0)]),
        "hole section 0 ends at MD 500 m, not below its beginning at 500 m"
    );
    let bad = |change: fn(&mut HoleSection)| {
        let mut sections = vec![section(0.0, 1000.0)];
        change(&mut sections[0]);
        message(sections)
    };
    assert_eq!(
        bad(|section| section.diameter_m = -0.2),
        "hole section 0: diameter is -0.2, expected more than zero"
    );
    assert_eq!(
        bad(|section| section.friction.at_rest = 0.1),
        "hole section 0: friction at rest is 0.1, expected at least the kinetic one"
    );
    assert_eq!(
        bad(|section| section.poisson_ratio = 0.5),
        "hole section 0: Poisson's ratio is 0.5, expected from 0 to below 0.5"
    );
    for change in [
        (|section| section.from_md_m = f64::NAN) as fn(&mut HoleSection),
        |section| section.to_md_m = f64::INFINITY,
        |section| section.friction.kinetic = -0.1,
        |section| section.youngs_modulus_Pa = 0.0,
        |section| section.diameter_m = f64::NAN,
    ] {
        assert!(bad(change).starts_with("hole section 0: "));
    }
}

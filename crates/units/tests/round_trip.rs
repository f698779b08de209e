//! Printed quantities are read back; no text causes a panic.

use proptest::prelude::*;
use wholestring_units::{Dimension, UnitSet};

/// Doubles between two finite numbers of the same sign.
fn steps_between(a: f64, b: f64) -> u64 {
    assert_eq!(a.is_sign_negative(), b.is_sign_negative(), "{a} {b}");
    a.to_bits().abs_diff(b.to_bits())
}

fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
        -1e6..1e6f64,
        (-10_000_000i64..10_000_000).prop_map(|n| n as f64 / 1000.0),
    ]
}

/// Texts near to quantities: pieces of them in any order.
fn nearly_a_quantity() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        Just("5".to_owned()),
        Just("-".to_owned()),
        Just("1/2".to_owned()),
        Just("/".to_owned()),
        Just(".".to_owned()),
        Just("e".to_owned()),
        Just("½".to_owned()),
        Just(" ".to_owned()),
        Just("−".to_owned()),
        Just("°".to_owned()),
        Just("deg/30m".to_owned()),
        Just("ft".to_owned()),
        Just("\u{a0}".to_owned()),
        "\\PC",
    ];
    proptest::collection::vec(piece, 0..8).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn exact_text_reads_back(si in finite()) {
        for &dimension in Dimension::ALL {
            for &set in UnitSet::ALL {
                let text = dimension.format_exact(si, set);
                let back = dimension.parse(&text).unwrap();
                prop_assert!(steps_between(si, back) <= 4, "{si:e} as '{text}' is {back:e}");
            }
        }
    }

    #[test]
    fn every_unit_reads_back_what_it_is_given(value in -1e9..1e9f64) {
        for &dimension in Dimension::ALL {
            for unit in dimension.units() {
                let si = dimension.parse(&format!("{value} {}", unit.symbol)).unwrap();
                let back = unit.from_si(si);
                prop_assert!(steps_between(value, back) <= 4, "{value} {}: {back}", unit.symbol);
            }
        }
    }

    #[test]
    fn people_see_five_true_digits(si in -1e9..1e9f64) {
        for &dimension in Dimension::ALL {
            for &set in UnitSet::ALL {
                let read_back = dimension.parse(&dimension.format(si, set)).unwrap();
                prop_assert!((read_back - si).abs() <= 5.0001e-5 * si.abs(), "{si} {read_back}");
            }
        }
    }

    #[test]
    fn no_text_panics(text in prop_oneof![".*", "\\PC{0,40}", nearly_a_quantity()]) {
        for &dimension in Dimension::ALL {
            match dimension.parse(&text) {
                Ok(si) => prop_assert!(si.is_finite()),
                Err(error) => {
                    prop_assert!(text.get(error.span.clone()).is_some(), "{error:?}");
                    prop_assert!(!error.to_string().is_empty());
                }
            }
        }
    }
}

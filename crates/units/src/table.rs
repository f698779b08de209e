//! The units of each dimension.
//!
//! Every factor is computed from definitions: the international yard and pound agreement of 1959
//! (foot, pound), the standard acceleration of gravity (CGPM 1901), the US gallon of 231 cubic
//! inches, the standard atmosphere of 101 325 Pa. The aliases include the spellings of the
//! Energistics Unit of Measure Standard where they differ from usual oilfield ones, the symbols of
//! WITS level 0 (`F`, `KDN`, `KFLB`, `KGM3`, `L/M`, `PHSF`) and of LAS files, and those in Cyrillic
//! letters.

use std::f64::consts::PI;

use crate::Unit;

const INCH: f64 = 0.0254;
const FOOT: f64 = 0.3048;
const YARD: f64 = 0.9144;
const US_SURVEY_FOOT: f64 = 1200.0 / 3937.0;
const POUND: f64 = 0.453_592_37;
const GRAVITY: f64 = 9.806_65;
const POUND_FORCE: f64 = POUND * GRAVITY;
const TONNE_FORCE: f64 = 1000.0 * GRAVITY;
const SHORT_TON_FORCE: f64 = 2000.0 * POUND_FORCE;
const PSI: f64 = POUND_FORCE / (INCH * INCH);
const US_GALLON: f64 = 231.0 * INCH * INCH * INCH;
const DEGREE: f64 = PI / 180.0;
const TURN: f64 = 2.0 * PI;
const MINUTE: f64 = 60.0;
const HOUR: f64 = 3600.0;
const DAY: f64 = 86_400.0;

const fn unit(symbol: &'static str, factor: f64, aliases: &'static [&'static str]) -> Unit {
    Unit { symbol, aliases, factor }
}

const METRE: Unit = unit(
    "m",
    1.0,
    &["metre", "metres", "meter", "meters", "mtr", "mtrs", "mt", "mts", "м", "М", "метр", "метров"],
);
const FEET: Unit = unit("ft", FOOT, &["'", "feet", "foot"]);
/// Feet of a depth: `F` is their symbol in LAS and WITS, which have no diameters in feet.
const FEET_ALONG: Unit = unit("ft", FOOT, &["'", "feet", "foot", "F"]);
const INCHES: Unit = unit("in", INCH, &["\"", "''", "inch", "inches"]);
const CENTIMETRE: Unit = unit("cm", 0.01, &["см"]);
const MILLIMETRE: Unit = unit("mm", 0.001, &["мм"]);
const KILOMETRE: Unit = unit("km", 1000.0, &["км"]);
const YARDS: Unit = unit("yd", YARD, &["yard", "yards"]);
const SURVEY_FEET: Unit = unit("usft", US_SURVEY_FOOT, &["ftUS", "ft[US]", "US ft", "ft US"]);

pub(crate) const LENGTH: &[Unit] =
    &[METRE, FEET_ALONG, MILLIMETRE, INCHES, CENTIMETRE, KILOMETRE, YARDS, SURVEY_FEET];

pub(crate) const DIAMETER: &[Unit] =
    &[MILLIMETRE, INCHES, METRE, CENTIMETRE, FEET, KILOMETRE, YARDS, SURVEY_FEET];

pub(crate) const FORCE: &[Unit] = &[
    unit("kN", 1e3, &["кН"]),
    unit(
        "t",
        TONNE_FORCE,
        &[
            "tf",
            "tonnef",
            "tonne-force",
            "tonne",
            "tonnes",
            "Mgf",
            "metric ton",
            "metric tons",
            "kkgf",
            "1000 kgf",
            "MT",
            "т",
            "тс",
        ],
    ),
    unit(
        "klbf",
        1e3 * POUND_FORCE,
        &["klb", "klbs", "kip", "kips", "kipf", "1000 lbf", "1000 lb", "1000 lbs"],
    ),
    unit("N", 1.0, &["newton", "Н"]),
    unit("MN", 1e6, &["МН"]),
    unit("daN", 10.0, &["даН"]),
    unit("kdaN", 1e4, &["KDN"]),
    unit("lbf", POUND_FORCE, &["lb", "lbs"]),
    unit("kgf", GRAVITY, &["kp", "кгс"]),
    unit("tonfUS", SHORT_TON_FORCE, &["tonf[US]", "US tonf", "short tonf", "short ton-force"]),
];

pub(crate) const TORQUE: &[Unit] = &[
    unit("kN.m", 1e3, &["кН.м"]),
    unit(
        "ft-lbf",
        FOOT * POUND_FORCE,
        &["lbf.ft", "ft.lb", "lb.ft", "ft.lbs", "lbs.ft", "foot pounds"],
    ),
    unit(
        "kft-lbf",
        1e3 * FOOT * POUND_FORCE,
        &[
            "klbf.ft",
            "ft.klbf",
            "kft.lb",
            "kft.lbs",
            "klb.ft",
            "klbs.ft",
            "ft.klb",
            "ft.klbs",
            "ft.kip",
            "ft.kips",
            "kip.ft",
            "kips.ft",
            "1000 ft-lbf",
            "1000 lbf.ft",
            "1000 ft-lb",
            "1000 ft-lbs",
            "KFLB",
        ],
    ),
    unit("N.m", 1.0, &["Н.м"]),
    unit("MN.m", 1e6, &[]),
    unit("daN.m", 10.0, &[]),
    unit("kgf.m", GRAVITY, &["m.kgf", "kg.m", "кгс.м"]),
    unit("in-lbf", INCH * POUND_FORCE, &["lbf.in", "in.lb", "lb.in", "in.lbs", "lbs.in"]),
];

pub(crate) const PRESSURE: &[Unit] = &[
    unit("MPa", 1e6, &["N/mm2", "MJ/m3", "МПа"]),
    unit("bar", 1e5, &["bars", "barg", "бар"]),
    unit("psi", PSI, &["lbf/in2", "psig", "psia"]),
    unit("Pa", 1.0, &["N/m2", "J/m3"]),
    unit("kPa", 1e3, &["kN/m2", "кПа"]),
    unit("GPa", 1e9, &["kN/mm2"]),
    unit("ksi", 1e3 * PSI, &["kpsi", "klbf/in2"]),
    unit("Mpsi", 1e6 * PSI, &["Msi"]),
    unit("atm", 101_325.0, &["атм"]),
];

pub(crate) const DENSITY: &[Unit] = &[
    unit("kg/m3", 1.0, &["g/l", "g/L", "g/dm3", "KGM3", "K/M3", "кг/м3"]),
    unit("sg", 1e3, &["SG", "specific gravity"]),
    unit(
        "ppg",
        POUND / US_GALLON,
        &["lb/gal", "lbs/gal", "lbm/gal", "lbm/galUS", "lbm/gal[US]", "lb/USgal", "lbs/USgal"],
    ),
    unit(
        "g/cm3",
        1e3,
        &["g/cc", "kg/l", "kg/L", "kg/dm3", "t/m3", "Mg/m3", "g/ml", "g/mL", "G/C3", "г/см3"],
    ),
    unit("lb/ft3", POUND / (FOOT * FOOT * FOOT), &["lbm/ft3", "lbs/ft3", "pcf", "lb/cu ft"]),
    unit("psi/ft", PSI / FOOT / GRAVITY, &[]),
    unit("kPa/m", 1e3 / GRAVITY, &[]),
];

pub(crate) const MASS_PER_LENGTH: &[Unit] = &[
    unit("kg/m", 1.0, &["кг/м"]),
    unit("lb/ft", POUND / FOOT, &["lbm/ft", "lbs/ft", "ppf", "#/ft", "#", "LB/F"]),
    unit("t/m", 1e3, &[]),
];

pub(crate) const FORCE_PER_LENGTH: &[Unit] = &[
    unit("kN/m", 1e3, &["N/mm"]),
    unit("N/m", 1.0, &[]),
    unit("lbf/ft", POUND_FORCE / FOOT, &["lb/ft", "lbs/ft"]),
    unit("lbf/30ft", POUND_FORCE / (30.0 * FOOT), &["lbf/jt"]),
    unit("kN/10m", 100.0, &[]),
    unit("kN/30m", 1e3 / 30.0, &[]),
    unit("daN/m", 10.0, &[]),
    unit("kgf/m", GRAVITY, &[]),
];

pub(crate) const ROTARY_SPEED: &[Unit] = &[
    unit("rpm", TURN / MINUTE, &["rev/min", "revs/min", "r/min", "1/min", "c/min", "об/мин"]),
    unit("rad/s", 1.0, &[]),
    unit("rev/s", TURN, &["Hz", "rps", "r/s", "c/s"]),
    unit("deg/s", DEGREE, &["dega/s"]),
];

pub(crate) const RATE_OF_PENETRATION: &[Unit] = &[
    unit("m/h", 1.0 / HOUR, &["m/hr", "m/hour", "metres/hour", "meters/hour", "м/ч"]),
    unit(
        "ft/h",
        FOOT / HOUR,
        &["ft/hr", "fph", "ft/hour", "feet/h", "feet/hr", "feet/hour", "F/H", "F/HR"],
    ),
    unit("m/s", 1.0, &["m/sec", "м/с"]),
    unit("m/min", 1.0 / MINUTE, &["м/мин"]),
    unit("ft/min", FOOT / MINUTE, &["fpm", "feet/min", "F/MIN"]),
    unit("ft/s", FOOT, &["ft/sec"]),
    unit("mm/s", 1e-3, &[]),
];

pub(crate) const TRIP_SPEED: &[Unit] = RATE_OF_PENETRATION;

pub(crate) const ANGLE: &[Unit] = &[
    unit("deg", DEGREE, &["°", "dega", "degree", "degrees", "degs", "град"]),
    unit("rad", 1.0, &["radian", "radians"]),
    unit("turn", TURN, &["turns", "rev", "revs"]),
];

pub(crate) const DOGLEG_SEVERITY: &[Unit] = &[
    unit("deg/30m", DEGREE / 30.0, &["dega/30m"]),
    unit("deg/100ft", DEGREE / (100.0 * FOOT), &["dega/100ft", "deg/100'", "deg/100feet", "DGHF"]),
    unit("deg/10m", DEGREE / 10.0, &["dega/10m"]),
    unit("deg/m", DEGREE, &["dega/m"]),
    unit("deg/ft", DEGREE / FOOT, &["dega/ft"]),
    unit("rad/m", 1.0, &["1/m"]),
];

pub(crate) const STIFFNESS: &[Unit] = &[
    unit("N/m", 1.0, &[]),
    unit("kN/m", 1e3, &["N/mm"]),
    unit("MN/m", 1e6, &["kN/mm"]),
    unit("lbf/in", POUND_FORCE / INCH, &["lb/in", "lbs/in"]),
    unit("lbf/ft", POUND_FORCE / FOOT, &["lb/ft", "lbs/ft"]),
    unit("klbf/in", 1e3 * POUND_FORCE / INCH, &["kip/in", "kips/in", "klb/in"]),
];

pub(crate) const DAMPING: &[Unit] = &[
    unit("N.s/m", 1.0, &["kg/s"]),
    unit("kN.s/m", 1e3, &["N.s/mm"]),
    unit("lbf.s/ft", POUND_FORCE / FOOT, &["lb.s/ft"]),
    unit("lbf.s/in", POUND_FORCE / INCH, &["lb.s/in"]),
];

pub(crate) const VISCOSITY: &[Unit] = &[
    unit("mPa.s", 1e-3, &[]),
    unit("cP", 1e-3, &["cp", "cps", "centipoise"]),
    unit("Pa.s", 1.0, &["N.s/m2"]),
];

const PER_HUNDRED_SQUARE_FEET: f64 = POUND_FORCE / (100.0 * FOOT * FOOT);

pub(crate) const CONSISTENCY: &[Unit] = &[
    unit("Pa.s^n", 1.0, &["Pa.sn", "Pa.sⁿ", "N.s^n/m2"]),
    unit("mPa.s^n", 1e-3, &["mPa.sn", "mPa.sⁿ"]),
    unit(
        "lbf.s^n/100ft2",
        PER_HUNDRED_SQUARE_FEET,
        &["lb.s^n/100ft2", "lbf.sn/100ft2", "lb.sn/100ft2"],
    ),
    unit("eq cP", 1e-3, &["eqcP", "cP eq"]),
];

pub(crate) const SHEAR_STRESS: &[Unit] = &[
    unit("Pa", 1.0, &["N/m2"]),
    unit(
        "lbf/100ft2",
        PER_HUNDRED_SQUARE_FEET,
        &[
            "lb/100ft2",
            "lbs/100ft2",
            "#/100ft2",
            "lbf/100sqft",
            "lb/100sqft",
            "lbs/100sqft",
            "0.01 lbf/ft2",
            "PHSF",
        ],
    ),
    unit("dyn/cm2", 0.1, &["dyne/cm2"]),
];

pub(crate) const FLOW_RATE: &[Unit] = &[
    unit("L/min", 1e-3 / MINUTE, &["l/min", "lpm", "LPM", "litres/min", "L/M", "л/мин"]),
    unit(
        "gpm",
        US_GALLON / MINUTE,
        &["gal/min", "galUS/min", "gal[US]/min", "USgpm", "US gal/min", "USgal/min"],
    ),
    unit("m3/s", 1.0, &["м3/с"]),
    unit("m3/min", 1.0 / MINUTE, &["M3/M", "м3/мин"]),
    unit("m3/h", 1.0 / HOUR, &["m3/hr", "м3/ч"]),
    unit("L/s", 1e-3, &["l/s", "l/sec", "dm3/s", "л/с"]),
    unit("bbl/min", 42.0 * US_GALLON / MINUTE, &["bpm"]),
];

pub(crate) const VOLUME: &[Unit] = &[
    unit("L", 1e-3, &["l", "litre", "litres", "liter", "liters"]),
    unit("gal", US_GALLON, &["galUS", "gal[US]", "USgal", "US gal"]),
    unit("m3", 1.0, &[]),
    unit("in3", INCH * INCH * INCH, &["cu in"]),
];

pub(crate) const DISSIPATION_TIME: &[Unit] = &[
    unit("s/m", 1.0, &[]),
    unit("s/mm", 1e3, &[]),
    unit("s/ft", 1.0 / FOOT, &[]),
    unit("s/in", 1.0 / INCH, &[]),
];

pub(crate) const HOIST_GAIN: &[Unit] = &[
    unit("m/s/N", 1.0, &["m/(s.N)", "m/(N.s)", "m/N/s", "s/kg"]),
    unit("m/s/kN", 1e-3, &["m/(s.kN)", "m/(kN.s)", "m/kN/s", "mm/s/N", "s/t"]),
    unit("m/s/t", 1.0 / TONNE_FORCE, &["m/s/tf", "m/(s.tf)", "m/(tf.s)"]),
    unit("ft/s/klbf", FOOT / (1e3 * POUND_FORCE), &["ft/(s.klbf)", "ft/(klbf.s)", "ft/klbf/s"]),
];

pub(crate) const TIME: &[Unit] = &[
    unit("s", 1.0, &["sec", "secs", "second", "seconds", "с", "сек"]),
    unit("ms", 1e-3, &["msec", "msecs", "millisecond", "milliseconds"]),
    unit("min", MINUTE, &["mins", "minute", "minutes", "мин"]),
    unit("h", HOUR, &["hr", "hrs", "hour", "hours", "ч"]),
    unit("d", DAY, &["day", "days"]),
];

pub(crate) const FREQUENCY: &[Unit] = &[
    unit("1/s", 1.0, &["Hz", "c/s", "s-1"]),
    unit("1/min", 1.0 / MINUTE, &["c/min"]),
    unit("kHz", 1e3, &[]),
];

pub(crate) const MASS: &[Unit] = &[
    unit("kg", 1.0, &[]),
    unit("t", 1e3, &["tonne", "tonnes", "Mg", "MT", "т"]),
    unit("lb", POUND, &["lbm", "lbs"]),
    unit("klb", 1e3 * POUND, &["klbm", "klbs"]),
    unit("g", 1e-3, &[]),
    unit("tonUS", 2000.0 * POUND, &["ton[US]", "US ton", "short ton"]),
];

pub(crate) const MOMENT_OF_INERTIA: &[Unit] = &[
    unit("kg.m2", 1.0, &["kg m2", "kgm2"]),
    unit("t.m2", 1e3, &["t m2"]),
    unit("lb.ft2", POUND * FOOT * FOOT, &["lbm.ft2", "lb ft2"]),
];

pub(crate) const ROTARY_DAMPING: &[Unit] = &[
    unit("kN.m.s", 1e3, &["kN.m.s/rad"]),
    unit("N.m.s", 1.0, &["N.m.s/rad"]),
    unit("ft-lbf.s", FOOT * POUND_FORCE, &["lbf.ft.s", "ft.lbf.s", "ft.lb.s"]),
    unit("kN.m/rpm", 1e3 * MINUTE / TURN, &[]),
];

pub(crate) const FRACTURE_ENERGY: &[Unit] = &[
    unit("kJ/m2", 1e3, &["N/mm"]),
    unit("J/m2", 1.0, &["N/m"]),
    unit("in-lbf/in2", POUND_FORCE / INCH, &["lbf/in", "in.lbf/in2"]),
];

//! Pages of a run, a sweep, an assembly, a study, a plan, a reach, a calibration and a bit test:
//! checks that their committed bundle equals that of its sources, and that they work in a browser.

use std::{path::Path, process::Command};

use crate::{
    command::{Failure, program, run},
    finding::Finding,
    folders::{root, target},
    web::{Web, installed_browser, unable},
};

/// Sources of the pages.
const WEB: Web = Web("crates/report/web");

/// A name that would break out of its element without escaping, and a text that looks like code.
const NASTY: &str = r#"name="Slant </script><script>window.harmed = 1</script> & <b>co</b>""#;

/// A plan with contents in every part of its page: a mud with flow, a rig near its limits,
/// uncertain numbers, peaks, and from [`READ`] measured values and those of another program.
const PLANNED: [&str; 28] = [
    "--set",
    "plan.depths=8",
    "--set",
    "plan.models=[\"soft\", \"stiff\"]",
    "--set",
    "mud.rheology=bingham",
    "--set",
    "mud.plastic_viscosity=0.02 Pa.s",
    "--set",
    "mud.yield_point=7 Pa",
    "--set",
    "operation.flow_rate=30 l/s",
    "--set",
    "rig.block_weight=150 kN",
    "--set",
    "rig.hoist_capacity=600 kN",
    "--set",
    "rig.top_drive_torque=6 kN.m",
    "--set",
    "rig.top_drive_peak_torque=7 kN.m",
    "--set",
    "plan.dynamic.events=[\"pick_up_from_slips\", \"break_circulation\"]",
    "--set",
    "plan.dynamic.watch=4 s",
    "--set",
    UNCERTAIN,
    "--set",
    "plan.uncertain.samples=20",
];

/// Uncertain numbers.
const UNCERTAIN: &str = "plan.uncertain.input=[{ key = \"friction\", from = 0.15, to = 0.35 }, \
    { key = \"mud.density\", from = \"1.1 sg\", to = \"1.3 sg\" }]";

/// Invented weights and torques of the slant well.
const READ: &str = "crates/cli/tests/data/slant-read.csv";

/// The bundle in `crates/report/assets` equals that of `crates/report/web`.
pub(crate) fn bundle() -> Result<Finding, Failure> {
    WEB.bundle()
}

/// Every plot of a page is drawn, its switches work, and nothing is fetched.
pub(crate) fn browser() -> Result<Finding, Failure> {
    if let Err(reason) = WEB.install() {
        return unable(reason);
    }
    let browser = match installed_browser() {
        Ok(browser) => browser,
        Err(reason) => return unable(reason),
    };
    const SLANT: &str = "crates/cli/tests/data/slant.toml";
    let frames = [
        "--set",
        NASTY,
        "--set",
        "records.frames=20Hz",
        "--set",
        r#"operation.kind=["trip_out", "rotate_off_bottom", "drill"]"#,
        // Nodes closer than the joints.
        "--set",
        "mesh.element_length=3.2m",
    ];
    page(["run", SLANT], &frames, &browser, "page.mjs")?;
    works(&target().join("run-page"), &browser, "checks.mjs")?;
    works(&target().join("run-page"), &browser, "missing.mjs")?;
    let varied = ["--set", NASTY, "--vary", "friction=0.2,0.3", "--vary", "bit_depth=300m,600m"];
    page(["sweep", SLANT], &varied, &browser, "sweep.mjs")?;
    page(["bha", "cases/bent-motor.toml"], &["--set", NASTY], &browser, "bha.mjs")?;
    let study = "studies/friction-on-a-slant.toml";
    page(["study", study], &["--png"], &browser, "study.mjs")?;
    let read = root().join(READ).display().to_string();
    let measured = format!("plan.measured={read}");
    let beside = ["--set", &measured, "--overlay", &read];
    let planned = [&["--set", NASTY], &PLANNED[..], &beside].concat();
    page(["plan", "cases/slant.toml"], &planned, &browser, "plan.mjs")?;
    page(["reach", "cases/np13-x1042.toml"], &["--to", "11km"], &browser, "reach.mjs")?;
    let uncertain = ["--set", UNCERTAIN, "--set", "plan.uncertain.samples=20", "--to", "6km"];
    page(["reach", "cases/slant.toml"], &uncertain, &browser, "uncertain.mjs")?;
    let readings = ["--data", "cases/forge-16a-measured.csv"];
    page(["calibrate", "cases/forge-16a.toml"], &readings, &browser, "calibrate.mjs")?;
    let made_up = target().join("bit-test-page");
    run(program("--example", "bit_test_page")?.arg(&made_up), "the browser needs a page")?;
    works(&made_up, &browser, "bit_test.mjs")?;
    Ok(Finding::Done)
}

/// Makes the page of a command, and runs its test in a browser.
fn page(
    [command, file]: [&str; 2],
    more: &[&str],
    browser: &Path,
    test: &str,
) -> Result<(), Failure> {
    let results = target().join(format!("{command}-page"));
    run(
        program("--bin", "wholestring")?
            .args([command, file, "--quiet", "--overwrite"])
            .args(more)
            .arg("-o")
            .arg(&results),
        "the browser needs a page",
    )?;
    works(&results, browser, test)
}

/// Runs the test of the page in a folder in a browser.
fn works(folder: &Path, browser: &Path, test: &str) -> Result<(), Failure> {
    run(
        Command::new("node")
            .current_dir(WEB.folder())
            .arg(Path::new("test").join(test))
            .arg(browser)
            .arg(folder.join("report.html")),
        "the page must work in a browser",
    )
}

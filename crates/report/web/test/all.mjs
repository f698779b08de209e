// The pages of every command in a real browser: `node test/all.mjs WHOLESTRING BIT_TEST_PAGE CHROMIUM FOLDER`, with the
// program, the example that makes up the page of a bit test, and a folder for the results.
import { execFileSync } from "node:child_process";
import { join, resolve } from "node:path";

const [wholestring, bitTestPage, chromium, folder] = process.argv.slice(2);
const root = resolve(import.meta.dirname, "../../../..");
const run = (program, words) => execFileSync(program, words, { cwd: root, stdio: "inherit" });
const works = (test, results) =>
  run(process.execPath, [join(import.meta.dirname, test), chromium, join(results, "report.html")]);

/** Makes the page of a command, and runs its tests. */
const page = (command, file, settings, options, ...tests) => {
  const results = join(folder, `${command}-page`);
  const words = settings.flatMap((setting) => ["--set", setting]);
  run(wholestring, [command, file, "--quiet", "--overwrite", ...words, ...options, "-o", results]);
  tests.forEach((test) => works(test, results));
};

const slant = "crates/cli/tests/data/slant.toml";
// Invented weights and torques of the slant well.
const read = join(root, "crates/cli/tests/data/slant-read.csv");
// A name that would break out of its element without escaping, and a text that looks like code.
const nasty = 'name="Slant </script><script>window.harmed = 1</script> & <b>co</b>"';
const uncertain = [
  'plan.uncertain.input=[{ key = "friction", from = 0.15, to = 0.35 }, { key = "mud.density", from = "1.1 sg", to = "1.3 sg" }]',
  "plan.uncertain.samples=20",
];

const frames = [
  "records.frames=20Hz",
  'operation.kind=["trip_out", "rotate_off_bottom", "drill"]',
  // Nodes closer than the joints.
  "mesh.element_length=3.2m",
];
page("run", slant, [nasty, ...frames], [], "page.mjs", "checks.mjs", "missing.mjs");
page("sweep", slant, [nasty], ["--vary", "friction=0.2,0.3", "--vary", "bit_depth=300m,600m"], "sweep.mjs");
page("bha", "cases/bent-motor.toml", [nasty], [], "bha.mjs");
page("study", "studies/friction-on-a-slant.toml", [], ["--png"], "study.mjs");
// Contents in every part of the page: a mud with flow, a rig near its limits, uncertain numbers, peaks, measured values
// and those of another program.
const planned = [
  "plan.depths=8",
  'plan.models=["soft", "stiff"]',
  "mud.rheology=bingham",
  "mud.plastic_viscosity=0.02 Pa.s",
  "mud.yield_point=7 Pa",
  "operation.flow_rate=30 l/s",
  "rig.block_weight=150 kN",
  "rig.hoist_capacity=600 kN",
  "rig.top_drive_torque=6 kN.m",
  "rig.top_drive_peak_torque=7 kN.m",
  'plan.dynamic.events=["pick_up_from_slips", "break_circulation"]',
  "plan.dynamic.watch=4 s",
  ...uncertain,
  `plan.measured=${read}`,
];
page("plan", "cases/slant.toml", [nasty, ...planned], ["--overlay", read], "plan.mjs");
page("reach", "cases/np13-x1042.toml", [], ["--to", "11km"], "reach.mjs");
page("reach", "cases/slant.toml", uncertain, ["--to", "6km"], "uncertain.mjs");
page("calibrate", "cases/forge-16a.toml", [], ["--data", "cases/forge-16a-measured.csv"], "calibrate.mjs");
run(bitTestPage, [join(folder, "bit-test-page")]);
works("bit_test.mjs", join(folder, "bit-test-page"));

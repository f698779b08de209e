// Requests and answers of the server, from its declarations in Rust. Not written by hand:
// WHOLESTRING_UPDATE_DOCS=1 cargo test -p wholestring-app --test app typescript

/** Results of a case. */
export interface Answer {
  /** Loads of its operations against the capacities of pipe and rig, by the soft string, if that model was requested. */
  limits: OperationLimits[];
  /** Each operation by each model, with its checks, as in `summary.json`. */
  operations: Solved[];
  /** Values that can be replaced without editing the text, and the units of the case. */
  set_points: SetPoints;
  /** Wall-clock time of the solving, s. */
  took_s: number;
  /** Values along the string, one track for each operation and model. */
  tracks: Track[];
  /** The verdict on each operation by each model. */
  verdicts: OperationVerdict[];
  /** Path, hole and string. */
  well: WellView;
}

/** Error response: `{"error": {...}}`. */
export interface ApiError {
  error: ErrorDetails;
}

/** A text with other values written into it. */
export interface Applied {
  /** The changed keys. */
  changes: ChangedKey[];
  /** The comments that may refer to the changes, with their treatments. */
  comments: Comment[];
  /** The text. */
  text: string;
  /** Warnings that the text did not have before. */
  warnings: string[];
}

/** Trial values to be written into the text. */
export interface Applying {
  /** Treatments of comments, by their first lines; for others, the proposals of [`Applied`]. */
  comments?: Record<number, Fate>;
  /** Values by key, as in `--set KEY=VALUE`; `friction_multiplier` scales every section's own friction and that of the plan, `friction` applies to all sections alike. */
  set: { [key: string]: string };
  /** The text. */
  text: string;
}

/** A renamed or copied case file. */
export interface Arranged {
  /** Identifier in requests. */
  id: string;
}

/** An option that answers a question: `--unit`, `--value` or `--pick`. */
export type Ask = "unit" | "value" | "pick";

/** A text, with some values of it replaced. */
export interface Asked {
  /** Values by key, as in `--set KEY=VALUE`; `friction_multiplier` scales every section's own friction and that of the plan, `friction` applies to all sections alike. */
  set?: { [key: string]: string };
  /** The text. */
  text: string;
}

/** The same, with models. */
export interface AskedOfModels {
  /** The models: `soft`, `stiff`. Both by default. */
  models?: string[];
  /** Values by key, as in `--set KEY=VALUE`. */
  set?: { [key: string]: string };
  /** The text. */
  text: string;
  /** Units of the sentences: `si`, `metric`, `field`. By default those of the case. */
  units?: string | null;
}

/** The same, with an operation. */
export interface AskedOfOperation {
  /** The operation: `drill`, ...; by default the first that drills, or else the first. */
  operation?: string | null;
  /** Values by key, as in `--set KEY=VALUE`. */
  set?: { [key: string]: string };
  /** The text. */
  text: string;
}

/** A static BHA analysis. Each pair has the component towards the high side and the one to the right of it, looking down the hole; distances are from the bit. */
export interface AssemblyView {
  /** The axis of the string. */
  axis: Axis;
  /** Measured depth of the bit, m. */
  bit_depth_m: number;
  /** Contacts with the wall, from the bit up. */
  contacts: Touch[];
  /** Inclination of the hole at the bit, rad. */
  inclination_rad: number;
  /** Upper end of the assembly, m, where ordinary pipe begins. */
  length_m: number;
  /** The operation: `drill`, `slide`, ... */
  operation: string;
  /** Components, from the bit up. */
  parts: Part[];
  /** Positions of the survey sensors, m. */
  sensors_m: number[];
  /** Side force of the bit on the rock, N; towards the high side it builds. */
  side_force_N: [number, number];
  /** Tilt of the bit relative to the hole's axis, rad. */
  tilt_rad: [number, number];
  /** Wall-clock time of the solving, s. */
  took_s: number;
  /** Tool face of the lowest bend, rad; null without one. */
  toolface_rad: number | null;
  /** Weight on bit, N. */
  weight_on_bit_N: number;
}

/** A moment of a string. */
export interface At {
  /** Number of a checkpoint; the present state if there is none. */
  checkpoint?: number | null;
}

/** The string's axis at its nodes, from the bit up. */
export interface Axis {
  /** Bending moment, N·m. */
  bending_moment_N_m: number[];
  /** Positions, m. */
  from_bit_m: number[];
  /** Radius of the hole, m. */
  hole_radius_m: number[];
  /** Offset from the hole's axis towards the high side, m. */
  offset_high_m: number[];
  /** The same to the right, m. */
  offset_right_m: number[];
}

/** A checkpoint to rewind to. */
export interface Back {
  /** Its number. */
  checkpoint: number;
  /** Whether the later set points are applied again, each at its time. Otherwise they are discarded. */
  replay?: boolean;
}

/** An operation in progress. */
export interface Bar {
  /** Simulated time of the end, s; the latest possible one while it settles. */
  end_s: number;
  /** Remaining wall-clock time at the current pace, s. */
  left_s: number | null;
  /** The preparation before its time begins; none afterwards. */
  preparing: string | null;
  /** Simulated time reached, s. */
  reached_s: number;
  /** Whether it waits for a steady state. */
  settling: boolean;
  /** Title: `trip out`, `slide, lift 2 of at most 9`. */
  title: string;
}

/** Progress of many cases, points or samples. */
export interface Batch {
  /** Number of finished ones. */
  ended: number;
  /** Remaining wall-clock time at the current pace, s. */
  left_s: number | null;
  /** Total number. */
  of: number;
  /** Fraction of the work that is done, from 0 to 1. */
  part: number;
}

/** Options of `bha`. */
export interface BhaOptions {
  /** Build rate of those holes: `2 deg/30m`. */
  build?: string | null;
  /** Whether the tables are written as CSV too. */
  csv?: boolean;
  /** Inclinations of a straight hole. */
  inclination?: string | null;
  /** The operation; the first that drills by default. */
  operation?: string | null;
  /** Tool faces of the bend: `0 deg..360 deg/15 deg`. */
  toolface?: string | null;
  /** Weights on bit: `20 kN..120 kN/20 kN`. */
  weight?: string | null;
  /** Whether the whole string is solved. */
  whole?: boolean;
}

/** A broomstick. */
export interface Broomstick {
  /** A curve for each operation at each friction. */
  curves: BroomstickCurve[];
  /** Levels of friction, from the least to the most. */
  frictions: FrictionOfLevel[];
  /** Capacity of the hoist minus the block weight, N; null if unknown. */
  hoist_N: number | null;
  /** Wall-clock time of the solving, s. */
  took_s: number;
  /** Continuous torque of the top drive, N·m; null if unknown. */
  top_drive_N_m: number | null;
}

/** An operation at a friction level, against bit depth. Points without a result are null. */
export interface BroomstickCurve {
  /** Bit depths, m. */
  bit_depth_m: Column;
  /** Level of friction, as in the plan of the case. */
  friction: FrictionLevel;
  /** Hook load without the block, N. */
  hook_load_N: Column;
  /** The operation: `trip_out`, `trip_in`, ... */
  operation: string;
  /** Torque at the top, N·m. */
  surface_torque_N_m: Column;
}

/** Options of `calibrate`. */
export interface CalibrateOptions {
  /** Confidence of the bands, %; 90 by default. */
  band?: string | null;
  /** Fits the bit torque on bottom. */
  bit_torque?: boolean;
  /** Fits the block weight although the case gives it. */
  block_weight?: boolean;
  /** A factor for each hole section instead of casing and open hole. */
  by_section?: boolean;
  /** Bit depths of that comparison, such as `2100 m`; the shallowest, the middle and the deepest by default. */
  check_depths?: string[];
  /** Whether the dynamic model is compared with the readings. */
  check_dynamics?: boolean;
  /** The file of readings. */
  data: string;
  /** Rotational friction separate from axial friction. */
  friction_around?: boolean;
  /** Fixed parameters: `friction_cased=0.2`. */
  hold?: string[];
  /** The model of the predictions: `soft`, the default, or `stiff`. */
  model?: string | null;
  /** One friction factor for casing and open hole. */
  one_factor?: boolean;
  /** Case files of the other strings that were in the hole. */
  other_cases?: string[];
  /** Number of standard errors beyond which a residual is an outlier; 3 by default. */
  outlier?: string | null;
  /** Whether PNG images are written too. */
  png?: boolean;
  /** Standard error of rotating weights; estimated by default. */
  rotating_error?: string | null;
  /** Standard error of torques, such as `500 N.m`; estimated by default. */
  torque_error?: string | null;
  /** Standard error of pick-up and slack-off weights, such as `12 kN`; estimated by default. */
  weight_error?: string | null;
  /** Excludes the outliers from the fit. */
  without_outliers?: boolean;
}

/** A case of the folder. */
export interface CaseEntry {
  /** Whether it has an unsaved draft. */
  has_draft: boolean;
  /** Identifier in requests. */
  id: string;
  /** Whether `problem`, `silhouette` or `overview` is still computed: a later list has them. */
  is_pending: boolean;
  /** Time of its last change, milliseconds since 1970. */
  modified_ms: number;
  /** Its name in results. */
  name: string;
  overview: CaseOverview | null;
  /** Path within the folder, for display. */
  path: string;
  /** Its first mistake; null if there is none, or if it is not yet checked. */
  problem: string | null;
  silhouette: Silhouette | null;
  verdict: CaseVerdict | null;
}

/** The judge's verdict on a case by the soft string, and key numbers of the operation that it is about. */
export interface CaseOverview {
  /** Bit depth of that operation, m. */
  bit_depth_m: number;
  check: WorstCheck | null;
  /** Hook load of that operation without the block, N. */
  hook_load_N: number | null;
  /** Reason why an operation has no answer. */
  message: string | null;
  /** The operation of the check: `drill`, ...; without a check, the first. */
  operation: string;
  /** Surface torque of that operation, N m. */
  surface_torque_N_m: number | null;
}

/** A value of a case file. */
export type CaseValue = string | number | boolean | null | CaseValue[] | { [key: string]: CaseValue };

/** The judge's verdict on a case, from its newest results. */
export interface CaseVerdict {
  /** Whether the case is unchanged since it was computed. */
  is_current: boolean;
  /** The command of the results: `run`, `plan`, ... */
  kind: string;
  /** Id of the results in requests. */
  results: string;
  /** Its severity. */
  severity: Severity;
  /** The verdict in words. */
  words: string;
}

/** Options of work on many cases: of `sweep` and `study`. */
export interface CasesOptions {
  /** Whether the tables that are kept are written as CSV too. */
  csv?: boolean;
  /** Results to keep of each case: `summary`, `tables` or `all`. */
  keep?: string | null;
  /** Share of the cases to solve, such as `1/4`. */
  shard?: string | null;
}

/** A casing. */
export interface CasingEntry {
  drift_m: number;
  id_m: number;
  mass_per_length_kg_per_m: number;
  /** Its name in a case. */
  name: string;
  od_m: number;
  /** Present if a grade was given. */
  yield_strength_Pa: number | null;
}

/** Entries of the catalogue. */
export interface Catalogue {
  /** Those of a hole: `casing = "NAME"` under `[[well.hole]]`. */
  casings: CasingEntry[];
  /** Typical hoists. */
  hoists: Hoist[];
  /** Sources of the entries. */
  sources: string[];
  /** Tubulars of a string: `catalogue = "NAME"` under `[[string]]`. */
  string: Tubular[];
  /** Typical top drives. */
  top_drives: TopDrive[];
}

/** A change. Keys are dotted, with the indices of items from 0: `well.hole.0.friction`. */
export type Change = Set | Remove | Insert | Move;

/** A changed text. */
export interface Changed {
  /** The text. */
  text: string;
}

/** A changed key. */
export interface ChangedKey {
  /** The dotted key. */
  key: string;
  /** Its label for display: `Friction, casing to 5110 ft`. */
  label: string;
  /** Its new written value. */
  new: string;
  /** Its written value; null if the key is new. */
  old: string | null;
}

/** A text and its changes. */
export interface Changes {
  /** The changes, applied in order. */
  changes: Change[];
  /** The text. */
  text: string;
}

/** A column of samples or of frames. */
export interface Channel {
  /** Its dimension, whose display units are in `units` of the layout. */
  dimension: string;
  /** Its name for display. */
  label: string;
  /** Its meaning. */
  meaning: string;
  /** Its name, with the SI unit in it. */
  name: string;
}

/** One comparison of a result with its limit, in SI units, and its verdict. */
export interface Check {
  /** The component; none for the rig and for the whole string. */
  component: string | null;
  /** Capacity over load; none for a kind that is not a limit. */
  factor: number | null;
  /** Quantity that is compared, or state that is reported: `lock_up`, `top_drive`, `von_mises`. */
  kind: CheckKind;
  /** Number that the value is compared with, for a limit the capacity; none where there is no such number. */
  limit: number | null;
  /** Measured depth of the place, or of the upper end of its interval, m; none without a place. */
  md_m: number | null;
  /** The sentence with its quantities, from which it is rendered in other units; empty in files of earlier versions and where no quantity is in it. */
  parts: unknown[];
  /** The required factor; none for a kind that is not a limit. */
  required: number | null;
  /** The check as a sentence in the user's units. */
  sentence: string;
  /** Its severity: `ok`, `note`, `warning` or `error`. */
  severity: Severity;
  /** Measured depth of the lower end of its interval, m; none for a point and without a place. */
  to_md_m: number | null;
  /** SI unit of value and limit; empty for a ratio. */
  unit: string;
  /** The value, for a limit the load, in `unit`; none where it is not a number. */
  value: number | null;
  /** The verdict in words: `OK`, `marginal`, `below required factor`, `exceeded`; the severity where there is no limit. */
  verdict: string;
}

/** Kind of a check, an identifier for programs. */
export type CheckKind = "tension" | "torsion" | "tension_and_torsion" | "von_mises" | "burst" | "collapse" | "make_up" | "side_force" | "hoist" | "top_drive" | "top_drive_peak" | "breakaway" | "pump_pressure" | "sinusoidal_buckling" | "helical_buckling" | "lock_up" | "overpull" | "goes_down" | "weight_not_available" | "no_equilibrium" | "weight_on_bit_not_reached" | "weight_on_bit_exceeded" | "weight_on_bit_unsteady" | "bit_bounce" | "top_drive_at_limit" | "top_drive_stalled" | "stick_slip" | "backward_whirl" | "forward_whirl" | "wall_penetration" | "energy_residual" | "bit_table_left" | "node_unsettled" | "element_buckles" | "bending_waves_left_out" | "lateral_force_left_out" | "helix_not_resolved" | "unstable_equilibrium" | "implausible_hydraulics" | "window_drifts" | "never_steady" | "hook_load_swings" | "reach" | "zero" | "negative" | "swapped" | "order_of_loads" | "no_readings" | "unit" | "below_block" | "block_not_in_readings" | "no_block" | "no_friction" | "outlier" | "outliers" | "not_told_apart" | "fragment" | "dynamics" | "interrupted" | "too_many_outliers" | "estimated_error" | "scatter" | "band" | "open_interval" | "block_weight" | "rounded_depth" | "point_failed" | "bit_does_not_drill" | "rock_kinetic_energy" | "calibration" | "bit_elsewhere";

/** Diagnostics and values of a text. */
export interface Checked {
  /** Errors, warnings and notes. */
  diagnostics: Diagnostic[];
  /** Its drawing. */
  layout: Layout;
  /** SI values of its texts, by dimension and text: `{"length": {"10 ft": 3.048}}`. */
  quantities: { [key: string]: { [key: string]: number } };
  /** The text as JSON, with unchanged numbers and texts; null if it is not TOML. */
  values: { [key: string]: CaseValue } | null;
}

/** A moment to rewind to. */
export interface CheckpointEntry {
  /** Identifier in requests. */
  number: number;
  /** Its time, s. */
  time_s: number;
}

/** Numbers for drawing, in single precision, which suffices for a picture and halves the page's transfer time. NaN is null. */
export type Column = (number | null)[];

/** A comment after or above a changed value. */
export interface Comment {
  /** Its treatment. */
  fate: Fate;
  /** Its first line in the text, from 1. */
  line: number;
  /** Its text when it is marked. */
  marked: string;
  /** Its lines, without `#`. */
  text: string;
}

/** Results side by side. */
export interface Compared {
  /** Curves against depth of those that have some. */
  curves: Curve[];
  /** The inputs that differ between them. */
  inputs: Differing[];
  /** The compared results, in the order of the request. */
  results: ResultsEntry[];
  /** Numbers that at least one of them has. */
  scalars: ComparedScalar[];
}

/** A number of the results. */
export interface ComparedScalar {
  /** Its label: `Hook load`. */
  label: string;
  /** Its operation and model: `trip out (soft)`. */
  of: string;
  /** The symbol of its unit. */
  unit: string;
  /** Its value in each of the results; null if it has none. */
  values: (number | null)[];
}

/** A component of the string. */
export interface Component {
  /** Diameter over joints or blades, which contact the wall first, m. */
  contact_od_m: number;
  /** Its upper end, m. */
  from_m: number;
  /** Inside diameter, m. */
  id_m: number;
  /** Its name in the case. */
  name: string;
  /** Outside diameter of the body, m. */
  od_m: number;
  /** Its lower end, m. */
  to_m: number;
}

/** A created case. */
export interface Created {
  /** Identifier in requests. */
  id: string;
}

/** A curve against depth. */
export interface Curve {
  /** The kind of depth: `Measured depth`, `Depth of the bit`. */
  against: string;
  depth: Column;
  /** The symbol of the unit of the depths. */
  depth_unit: string;
  /** Its operation and model: `trip out (soft)`. */
  of: string;
  /** Its quantity: `Effective tension`. */
  quantity: string;
  /** Index of its result, from 0. */
  result: number;
  /** The symbol of its unit. */
  unit: string;
  value: Column;
}

/** A sentence about a place of a text. */
export interface Diagnostic {
  /** Its column, from 1, in UTF-16 units. */
  column: number | null;
  /** One past its end. */
  end: number | null;
  /** The file of the place; null for the case. */
  file: string | null;
  /** The expected form, the nearest valid name, advice for the correction. */
  help: string[];
  /** The dotted key at the place, such as `well.hole.0.friction`. */
  key: string | null;
  /** Text next to the place. */
  label: string;
  /** `error`: the case cannot be used; `warning`: probably a mistake; `note`: how it was interpreted. */
  level: Level;
  /** Its line, from 1. */
  line: number | null;
  /** The mistake, in one sentence without a full stop. */
  message: string;
  /** Its start, in UTF-16 units of the text. */
  start: number | null;
}

/** An input that differs between the results. */
export interface Differing {
  /** Its key in the record of the settings, with the SI unit in its name. */
  key: string;
  /** Its value in each of the results; null if it has none. */
  values: (string | null)[];
}

/** A dimension's units. */
export interface DimensionUnits {
  /** SI value of one unit, for every notation of a unit. Empty for dimensions that no case file has. */
  factors: { [key: string]: number };
  /** The unit in each set, by the set's name. */
  shown: Record<"si" | "metric" | "field", ShownUnit>;
}

/** Details of an error. */
export interface ErrorDetails {
  /** The diagnostics of the case, if it is invalid. */
  diagnostics?: Diagnostic[];
  /** Identifier for programs. */
  kind: string;
  /** Message for people. */
  message: string;
}

/** An example case with its text. */
export interface Example {
  /** Files that it names. */
  beside: ExampleFile[];
  /** Its identifier. */
  name: string;
  /** Its text. */
  text: string;
  /** Description, in a sentence. */
  title: string;
}

/** An example case in a list. */
export interface ExampleEntry {
  /** Its identifier, and a name for its file without the extension. */
  name: string;
  /** Description, in a sentence. */
  title: string;
}

/** A file that an example names. */
export interface ExampleFile {
  /** Its name. */
  file_name: string;
  /** Its contents. */
  text: string;
}

/** Treatment of existing results in a folder. */
export type Existing = "protect" | "resume" | "overwrite";

/** As fast as possible. */
export type Fastest = "max";

/** Treatment of a comment. */
export type Fate = "keep" | "mark" | "remove";

/** A file of the folder. */
export interface FileEntry {
  /** Identifier in requests. */
  id: string;
  /** Path within the folder, for display. */
  path: string;
}

/** A file of results. */
export interface FileView {
  /** Size, bytes. */
  bytes: number;
  /** Identifier in requests. */
  id: string;
  /** Whether it is a page, which is shown inside the app. */
  is_page: boolean;
  /** Path within the results folder, for display. */
  path: string;
}

/** A check that needs attention, once for all bit depths at which it does. */
export interface Found {
  /** Kind of check, an identifier for programs: `helical_buckling`. */
  kind: string;
  /** The operation and the model: `trip in (soft)`. */
  name: string;
  /** A sentence, for the first place. */
  sentence: string;
  /** Its severity: `error`, `warning` or `note`. */
  severity: Severity;
  /** Number of places. */
  times: number;
}

/** A level of friction. */
export type FrictionLevel = "low" | "expected" | "high";

/** Friction of the hole at a level. */
export interface FrictionOfLevel {
  /** Kinetic coefficients of the hole sections, from the surface down. */
  coefficients: number[];
  /** The level. */
  name: FrictionLevel;
}

/** A file to create. */
export interface GivenFile {
  /** Its name, without a path. */
  file_name: string;
  /** Its contents. */
  text: string;
}

/** A file and its contents. */
export interface Held {
  /** Its contents, one line each, or the reason why it cannot be read. */
  lines: string[];
  /** Its name. */
  name: string;
  /** Its format: `a survey`, `WITSML 1.4.1.1`; null if it is none of the known ones. */
  what: string | null;
}

/** Hoists of a class. */
export interface Hoist {
  block_weight_N: Span | null;
  capacity_N: Span;
  name: string;
  snubbing_force_N: Span | null;
}

/** A kind of hole. */
export type HoleKind = "casing" | "open";

/** An import, as a multipart form. */
export interface ImportForm {
  choices?: Said | null;
  /** The files. */
  file: string[];
  /** The name of the case file. */
  name: string;
  /** `true` to write the case; nothing is written by default. */
  write?: boolean | null;
}

/** The case that files make. */
export interface ImportedCase {
  /** Names of the files that accompany it: `well-measured.csv`. */
  beside: string[];
  /** Missing inputs without which it cannot be solved, in sentences. */
  missing: string[];
  notes: SaidNote[];
  /** Its text, with a comment on the source of every value. */
  text: string;
}

/** Inserts an item into a list; a missing list is created. */
export interface Insert {
  /** The index of the item afterwards, from 0. */
  at: number;
  /** The key of the list. */
  insert: string;
  /** The item. */
  value: CaseValue;
}

/** A job. */
export interface Job {
  /** The command: `run`, `plan`, ... */
  command: string;
  /** Time of the request, milliseconds since 1970. */
  created_ms: number;
  /** Time of the end. */
  ended_ms: number | null;
  /** Path of its results in the folder. */
  folder: string | null;
  /** Identifier in requests. */
  id: string;
  /** Message about its end. */
  message: string | null;
  /** Path of its file in the folder. */
  path: string;
  refusal: Refusal | null;
  /** The request. */
  request: JobRequest;
  /** Time of the start, or of the latest resumption. */
  started_ms: number | null;
  /** Its state. */
  state: State;
  /** Name of the case or the study. */
  title: string;
}

/** A request to run a command of the program on a saved case. The files that the command reads are identified as in the lists of the folder. */
export interface JobRequest {
  /** The id of the case; none for a study, which names its own. */
  case?: string | null;
  /** Treatment of existing files in the results folder. */
  if_there?: Existing;
  /** Values by key, as in `--set KEY=VALUE`. */
  set?: { [key: string]: string };
  /** The command. */
  work: Work;
}

/** A job with its progress. */
export type JobView = Job & {
  progress: Progress;
  /** The id of its results, if there are any. */
  results: string | null;
  /** Whether it can continue from its partial results; other jobs can start again. */
  resumable: boolean;
};

/** A saved string in a list. */
export interface KeptEntry {
  /** The id of its case. */
  case: string;
  /** Time when it was saved, milliseconds since 1970. */
  modified_ms: number;
  /** Identifier in requests. */
  name: string;
  /** Name of the operation. */
  operation: string;
  /** Its time, s. */
  time_s: number;
  /** The name of the case. */
  title: string;
}

/** A saved string. */
export interface KeptName {
  /** Identifier in requests. */
  name: string;
}

/** A knob. */
export interface Knob {
  begins: number;
  high: number;
  low: number;
}

/** Knobs in SI units: bounds and initial value; null if the value cannot be set. */
export interface Knobs {
  block_velocity_m_per_s: Knob | null;
  /** The available controllers of the top drive; empty for a drive that follows its set point at any torque. */
  controllers: string[];
  flow_rate_m3_per_s: Knob | null;
  friction: Knob | null;
  rotary_speed_rad_per_s: Knob | null;
  weight_on_bit_N: Knob | null;
}

/** A lamp of the driller's seat. */
export interface Lamp {
  /** Its name. */
  name: string;
  /** Its meaning as a sentence in the viewer's units. */
  sentence: string;
  severity: Severity | null;
  /** Its value in a word or a percentage. */
  value: string;
}

/** Survey, path, hole and string. */
export interface Layout {
  /** Sections of the hole, from the surface down. */
  hole: Section[];
  path: PathView | null;
  /** The stations, from the case or from its file. */
  stations: Stations;
  /** Components of the string, from the surface down; empty if one of them is invalid. */
  string: Component[];
  tie_in: Start | null;
}

/** Severity of a diagnostic. */
export type Level = "error" | "warning" | "note";

/** A load against its capacity. */
export interface Limit {
  /** The capacity, SI. */
  capacity: number;
  /** The component; null for the rig. */
  component: string | null;
  /** Dimension of load and capacity: `force`, `torque`, `pressure`, `stress`. */
  dimension: string;
  /** Kind of limit, as in `plan_limits.parquet`: `hoist`, `von_mises`, ... */
  kind: string;
  /** Label for display. */
  label: string;
  /** The load, SI. */
  load: number;
  /** Measured depth of the place, m; null for the rig. */
  md_m: number | null;
  /** Required capacity over load. */
  required: number;
  /** Capacity over load, divided by the required factor: the factor by which the load may grow. Less than 1 is insufficient. */
  reserve: number;
  /** The result as a sentence, in the units of the case. */
  sentence: string;
  /** Its severity. */
  severity: Severity;
  /** The verdict: `OK`, `marginal`, `below required factor` or `exceeded`. */
  verdict: string;
}

/** A live string in a list. */
export interface LiveEntry {
  /** The id of its case. */
  case: string;
  /** Identifier in requests. */
  id: string;
  /** The name of the case. */
  name: string;
  /** Name of the operation. */
  operation: string;
  /** Reason of the state, if there is one. */
  sentence: string | null;
  /** Its state. */
  state: LiveState;
  /** Simulated time, s. */
  time_s: number;
  /** Number of pages that view it. */
  viewers: number;
}

/** A live string. */
export interface LiveId {
  /** Identifier in requests. */
  id: string;
}

/** Layout of a live string, which a viewer needs before the first frame. */
export interface LiveLayout {
  /** Depth of the bit at the start of the operation, m. */
  bit_depth_m: number;
  /** Its case. */
  case: string;
  /** Units of the case. */
  case_units: UnitSet;
  /** Contact radius of each node from the surface down, m. */
  contact_radius_m: number[];
  /** Number of elements of the string. */
  elements: number;
  /** Columns of a frame, in their order. */
  frame: Channel[];
  /** Sections of the hole, from the surface down. */
  hole: Section[];
  /** Identifier in requests. */
  id: string;
  /** The knobs. */
  knobs: Knobs;
  /** Limits of the strip charts. */
  limits: LiveLimit[];
  /** The name of the case. */
  name: string;
  /** Name of the operation. */
  operation: string;
  /** The path. */
  path: LivePath;
  /** Time between two samples, s: sample `n` is at `(n + 1)` intervals. */
  sample_interval_s: number;
  /** Columns of a sample, in their order. */
  samples: Channel[];
  /** Number of samples kept for viewers that join later. */
  samples_kept: number;
  /** Travel time of a torsional wave from the surface to the bit, s. */
  torsional_travel_s: number;
  /** Display units of each dimension: in SI, metric and field units. */
  units: { [key: string]: UnitsOfSets };
}

/** A limit of a column of the samples. */
export interface LiveLimit {
  /** Name of the column. */
  column: string;
  /** Its label. */
  label: string;
  /** The allowable value, SI. */
  value: number;
}

/** The path of the well in columns. */
export interface LivePath {
  east_m: number[];
  /** Components of the direction towards the high side: north, east and down. */
  high: [number[], number[], number[]];
  md_m: number[];
  north_m: number[];
  tvd_m: number[];
}

/** Set points of the driller; omitted ones stay unchanged. */
export interface LiveSetPoints {
  /** Speed of the block, positive downwards; replaces the autodriller. */
  block_velocity_m_per_s?: number;
  /** The top drive's controller: `pi`, `soft-torque` or `z-torque`. */
  controller?: string;
  /** Flow rate of the pumps. */
  flow_rate_m3_per_s?: number;
  /** Kinetic friction coefficient of the whole hole. */
  friction?: number;
  /** Time in which they are reached, s. */
  ramp_s?: number;
  /** Rotary speed at surface. */
  rotary_speed_rad_per_s?: number;
  /** Weight held by the autodriller; replaces a moving block. */
  weight_on_bit_N?: number;
}

/** State of a live string. */
export type LiveState = "paused" | "running" | "failed" | "ended";

/** A display unit. */
export interface LiveUnit {
  /** Its SI value. */
  factor: number;
  symbol: string;
}

/** Moves an item of a list. */
export interface Move {
  /** Its index, from 0. */
  from: number;
  /** The key of the list. */
  move: string;
  /** Its index afterwards. */
  to: number;
}

/** The new name of a case file within its folder. */
export interface Named {
  /** The name, which ends in `.toml`. */
  file_name: string;
}

/** A case to create. */
export interface NewCase {
  /** Files that it names. An existing one must have the same contents. */
  beside?: GivenFile[];
  /** The name of its file, which ends in `.toml`. */
  file_name: string;
  /** Its text. */
  text: string;
}

/** A live string to start. */
export interface NewString {
  /** The id of its case. */
  case: string;
  /** Name of the operation; may be omitted if there is only one. */
  operation?: string | null;
  /** The text in the editor; that of the file if there is none. */
  text?: string | null;
}

/** A case with its text. */
export interface OpenCase {
  /** The existing files that it names. */
  beside: string[];
  draft: OpenDraft | null;
  /** Identifier in requests. */
  id: string;
  /** Path within the folder, for display. */
  path: string;
  /** Fingerprint of the current contents. */
  revision: string;
  /** Contents of the file. */
  text: string;
}

/** An unsaved draft. */
export interface OpenDraft {
  /** The revision of the file when it was opened. */
  base_revision: string;
  /** Time when it was saved, milliseconds since 1970. */
  modified_ms: number;
  /** The text. */
  text: string;
}

/** The limits of an operation. */
export interface OperationLimits {
  /** The limit with the smallest reserve for each kind, in the order of the plan's tables. */
  limits: Limit[];
  /** The operation: `drill`, `trip_out`, ... */
  operation: string;
  /** Limits that could not be checked. */
  unchecked: Unchecked[];
}

/** The verdict on an operation by a model. */
export interface OperationVerdict {
  /** The model. */
  model: StaticModel;
  /** The operation: `drill`, ... */
  operation: string;
  /** Its severity. */
  severity: Severity;
  /** The verdict in words. */
  words: string;
}

/** Simulated seconds per wall-clock second. */
export type Pace = number | Fastest;

/** A component. */
export interface Part {
  /** Position of its bend, m. */
  bend_m: number | null;
  /** Diameter over its blades, m, and their length, m. */
  blades_m: [number, number] | null;
  /** Its lower end, m. */
  from_bit_m: number;
  /** Diameter of its tool joints, m. */
  joint_od_m: number | null;
  /** Its name. */
  name: string;
  /** Outside diameter of the body, m. */
  od_m: number;
  /** Its upper end, m. */
  to_bit_m: number;
}

/** Rows with a heading, separated by tabs, commas, semicolons or blanks. */
export interface Pasted {
  /** Unit of the lengths, if the heading does not give it. */
  length_unit?: string | null;
  /** The rows. */
  text: string;
}

/** A path, at its stations and between them. */
export interface PathView {
  /** Azimuth, rad. */
  azimuth_rad: number[];
  /** Dogleg severity, rad/m. */
  dogleg_severity_rad_per_m: Column;
  /** East, m. */
  east_m: number[];
  /** Inclination, rad. */
  inclination_rad: number[];
  /** Measured depths of the stations and of evenly spaced points between them, m. */
  md_m: number[];
  /** North, m. */
  north_m: number[];
  /** True vertical depth, m. */
  tvd_m: number[];
  /** Distance along the direction of the closure, m. */
  vertical_section_m: number[];
}

/** Progress of a job. */
export interface Progress {
  /** Operations, or cases of a sweep, in progress. */
  bars: Bar[];
  batch: Batch | null;
  /** Checks of the finished operations, the most severe first. */
  checks: Found[];
  /** Notes. */
  notes: string[];
  /** Problems that did not end the work, and likely mistakes of the input. */
  warnings: string[];
}

/** A choice that is missing or invalid. */
export interface Question {
  /** The option that answers it. */
  ask: Ask;
  /** The question as a sentence, with the file and the place in it. */
  message: string;
  /** The name under which it is answered: `md`, `block-weight`, `tubular`. */
  name: string;
  /** Possible answers; for a value, examples of its notation. */
  options: string[];
}

/** Options of `reach`. */
export interface ReachOptions {
  /** Friction factors, each applied to all hole sections. */
  frictions?: number[];
  /** First bit depth: `4000 m`. */
  from?: string | null;
  /** Whether the friction from the wall force of a helix is ignored. */
  no_helix_friction?: boolean;
  /** The operations: `drill`, `slide`. */
  operations?: string[];
  /** Whether a PNG image is written too. */
  png?: boolean;
  /** Whether the string stops at the onset of its helix, although it could advance buckled. */
  stop_at_helix?: boolean;
  /** Deepest bit depth. */
  to?: string | null;
}

/** Result of reading files. */
export interface Reading {
  case: ImportedCase | null;
  files: Held[];
  /** Reason why they make no case, if no answer helps. */
  problem: string | null;
  question: Question | null;
  /** The id of the case that was written. */
  written: string | null;
}

/** Set points at a time. */
export interface RecordedEvent {
  /** Simulated time, s, at a sample. */
  at_s: number;
  /** The set points before; a ramp in progress is cut off there. */
  before: LiveSetPoints;
  /** The new set points. */
  set: LiveSetPoints;
}

/** Reason why the results folder of some work was refused. */
export type Refusal = "unfinished" | "occupied" | "busy" | "not_resumable";

/** Removes a key, or an item of a list. */
export interface Remove {
  /** The key. */
  remove: string;
}

/** A results folder. */
export interface ResultsEntry {
  /** The version of the program that wrote it, if known. */
  engine_version: string | null;
  /** Number of errors in the results. */
  errors: number;
  /** Whether it has a page. */
  has_page: boolean;
  /** Identifier in requests. */
  id: string;
  /** The command that wrote it: `run`, `plan`, `study`, ... */
  kind: string;
  /** Time when it was written, milliseconds since 1970. */
  modified_ms: number;
  /** Name of the case or the study. */
  name: string;
  /** Number of notes. */
  notes: number;
  /** Path within the folder, for display. */
  path: string;
  /** Whether it has stopped work that can be continued. */
  unfinished: boolean;
  /** Number of warnings. */
  warnings: number;
}

/** Results with their files. */
export type ResultsView = ResultsEntry & {
  /** Checks, the most severe first. */
  checks: Found[];
  /** The files, by path. */
  files: FileView[];
};

/** A text, with the revision of the file when it was opened. */
export interface Revised {
  /** The revision of the file when it was opened. */
  revision: string;
  /** The text. */
  text: string;
}

/** Information that is missing in the files. */
export interface Said {
  /** Choices by name: the `tubular` called `BHA 7`. */
  picks?: { [key: string]: string };
  /** Units by name: `md` is in `ft`. */
  units?: { [key: string]: string };
  /** Values by name: `block-weight` is `25 tf`. */
  values?: { [key: string]: string };
}

/** A note about an import. */
export interface SaidNote {
  /** The file of the note; null for all files. */
  file: string | null;
  /** `assumed`, `left out`, `checked` or `read`. */
  kind: string;
  /** A sentence. */
  text: string;
}

/** A saved case. */
export interface Saved {
  /** The new revision of the file. */
  revision: string;
}

/** A text with the schedule. */
export interface Scheduled {
  /** Actions that no schedule can express, in sentences. */
  left_out: string[];
  /** Number of added lines. */
  lines: number;
  /** The text. */
  text: string;
}

/** A section of the hole. */
export interface Section {
  /** Diameter, m. */
  diameter_m: number;
  /** Kinetic coefficient of axial friction. */
  friction: number;
  /** Its top, m. */
  from_m: number;
  /** Kind of the hole. */
  kind: HoleKind;
  /** Its end, m. */
  to_m: number;
}

/** The friction of a hole section. */
export interface SectionFriction {
  /** Kinetic axial friction coefficient. */
  friction: number;
  /** The section: `casing to 1500 m`. */
  label: string;
}

/** The program and its folder. */
export interface Session {
  /** The name of the folder, without its path, which is not disclosed. */
  folder_name: string;
  /** The version of the program. */
  version: string;
}

/** Sets the value of a key; missing tables on the way to it are created. */
export interface Set {
  /** The key. */
  set: string;
  /** Its value. */
  to: CaseValue;
}

/** A replaceable value. */
export interface SetPoint {
  /** Its dimension; `ratio` for a bare number. */
  dimension: string;
  /** The key of `--set`: `friction`, `wob`, ... */
  key: string;
  /** Label for display. */
  label: string;
  /** Its value in the case. */
  now: number;
  /** The smallest and the largest sensible value. */
  range: [number, number];
}

/** Values of a case that can be replaced, SI. */
export interface SetPoints {
  /** Reason why no single friction can be set for all sections; null if it can. */
  no_uniform_friction: string | null;
  /** Hole sections, each with its friction. */
  sections: SectionFriction[];
  /** Units of the case. */
  units: UnitSet;
  /** The replaceable values. */
  values: SetPoint[];
}

/** Severity of a check. Worse ones are greater. */
export type Severity = "ok" | "note" | "warning" | "error";

/** A display unit. */
export interface ShownUnit {
  /** Its SI value. */
  factor: number;
  /** Its printed symbol. */
  label: string;
  /** Its notation after a number in a case file. None for dimensions that no case file has. */
  symbol: string | null;
}

/** The well of a case as a line, for a small drawing. */
export interface Silhouette {
  /** Measured depth of the bit in the first operation, m. */
  bit_md_m: number;
  /** Measured depths, m. */
  md_m: number[];
  /** Measured depth of the deepest casing shoe, m; null without casing. */
  shoe_md_m: number | null;
  /** True vertical depths, m. */
  tvd_m: number[];
  /** Distances along the direction of the closure, m. */
  vertical_section_m: number[];
}

/** An operation by a model, as in the `summary.json` of a run, which has more. */
export type Solved = SolvedScalars & {
  /** The checks, the most severe first. */
  checks: Check[];
  /** Reason why there is no answer. */
  message?: string;
  /** The model. */
  model: StaticModel;
  /** The operation: `drill`, ... */
  operation: string;
  /** Progress of the solution. */
  status: SolvedStatus;
};

/** Torque and drag; null where there is no number. */
export interface SolvedScalars {
  /** Axial friction of the wall; positive adds to hook load */
  axial_friction_N: number | null;
  /** Bit torque as solved */
  bit_torque_N_m: number | null;
  /** Deepest change from high-side to low-side contact between the kick-off and 30 m below the build */
  cutoff_depth_m: number | null;
  /** Part of the surface torque due to wall contact alone */
  friction_torque_N_m: number | null;
  /** Tension at the top of the string; block and top drive excluded */
  hook_load_N: number | null;
  /** Measured depth of the shallowest zero of effective tension */
  neutral_point_m: number | null;
  /** Integral of the magnitude of the side force */
  side_force_total_N: number | null;
  /** Elongation against the unloaded string */
  stretch_m: number | null;
  /** Torque at the top of the string */
  surface_torque_N_m: number | null;
  /** Turn of the top against the bit; positive when the top leads */
  twist_rad: number | null;
  /** Weight on bit as solved */
  weight_on_bit_N: number | null;
}

/** Progress of the solution of an operation. */
export type SolvedStatus = "complete" | "interrupted" | "failed";

/** Range of common values. */
export interface Span {
  least: number;
  most: number;
}

/** Position of the first station. */
export interface Start {
  east_m: number;
  north_m: number;
  tvd_m: number;
}

/** A queued job. */
export interface Started {
  /** Identifier in requests. */
  id: string;
}

/** State of a job. */
export type State = "waiting" | "running" | "finished" | "stopped" | "interrupted" | "failed" | "refused";

/** A method that answers without steps of time. */
export type StaticModel = "soft" | "stiff";

/** Stations, column by column. */
export interface Stations {
  azimuth_rad: number[];
  /** From the preceding station, along a circular arc; 0 for the first. */
  dogleg_severity_rad_per_m: number[];
  inclination_rad: number[];
  md_m: number[];
}

/** Status of a live string, sent at changes and a few times a second. */
export interface Status {
  /** The judge's checks of the present motion that need attention, the most severe first: limits of pipe and rig, and states of the motion. */
  alarms: Check[];
  /** Moments to rewind to. */
  checkpoints: CheckpointEntry[];
  /** The top drive's controller; null if it follows its set point at any torque. */
  controller: string | null;
  /** Number of recorded events. */
  events: number;
  /** Kinetic friction coefficient of each hole section. */
  friction: number[];
  /** Depth of the hole, m. */
  hole_depth_m: number;
  /** Lamps of stick-slip, whirl and top drive. */
  lamps: Lamp[];
  /** The requested pace. */
  pace: Pace;
  /** Simulated seconds per wall-clock second, over the last second. */
  reached: number;
  /** Number of events still to be replayed. */
  replaying: number;
  /** Reason of the state, or of a refused set point, if there is one. */
  sentence: string | null;
  /** Reason why it runs slower than its pace, if it does. */
  slow: string | null;
  /** Its state. */
  state: LiveState;
  /** Simulated time, s. */
  time_s: number;
  /** Number of pages that view it. */
  viewers: number;
}

/** Options of `study`. */
export type StudyOptions = CasesOptions & {
  /** Whether PNG images are written too. */
  png?: boolean;
  /** The study file. */
  study: string;
};

/** A survey. */
export interface Survey {
  /** Recognised and assumed properties, in sentences. */
  notes: string[];
  /** The stations. */
  stations: Stations;
  tie_in: Start | null;
}

/** Options of `sweep`. */
export type SweepOptions = CasesOptions & {
  /** Whether the keys are varied together: the n-th case has the n-th value of every key. */
  together?: boolean;
  /** The varied keys with their values. */
  vary: Varied[];
};

/** A text that may be the contents of a case file. */
export interface Text {
  /** The text. */
  text: string;
}

/** A text into whose schedule the recorded actions are written. */
export interface TextOfCase {
  /** The text. */
  text: string;
}

/** Text messages to a page; samples and frames are binary. */
export type Told = LiveLayout & {
  type: "layout";
} | Status & {
  type: "status";
} | {
  /** Reason. */
  message: string;
  type: "refused";
};

/** Top drives of a class. */
export interface TopDrive {
  capacity_N: number;
  highest_speed_rad_per_s: Span;
  name: string;
  peak_torque_N_m: Span;
  torque_N_m: Span;
}

/** A contact with the wall. */
export interface Touch {
  /** Force on the wall, N. */
  force_N: [number, number];
  /** Lower and upper end, m. */
  from_bit_m: [number, number];
  /** The component. */
  name: string;
  /** The contacting part: `bit`, `blades`, `joint`, `body`. */
  touching: string;
}

/** Values along the string of an operation by a model, from the surface down. */
export type Track = TrackColumns & {
  /** Measured depths, m. */
  md_m: Column;
  /** The model. */
  model: StaticModel;
  /** The operation: `drill`, `trip_out`, ... */
  operation: string;
};

/** Columns that a model computes. */
export interface TrackColumns {
  bending_moment_N_m?: Column;
  contact_fraction?: Column;
  side_force_N_per_m?: Column;
  tension_N?: Column;
  torque_N_m?: Column;
  von_mises_stress_Pa?: Column;
}

/** A tubular of a string. */
export interface Tubular {
  /** The connections at its ends. */
  connection: string | null;
  id_m: number;
  /** Outside diameter of its tool joints. */
  joint_od_m: number | null;
  /** `drill_pipe`, `heavy_weight`, `collar` or `coiled_tubing`. */
  kind: string;
  /** In air, including tool joints. */
  mass_per_length_kg_per_m: number;
  /** Its name in a case. */
  name: string;
  od_m: number;
  yield_strength_Pa: number;
}

/** A missing input, with the components that lack it; no components for the rig. */
export interface Unchecked {
  /** The components. */
  components: string[];
  /** Description: `no yield strength`. */
  missing: string;
}

/** A set of units. */
export type UnitSet = "si" | "metric" | "field";

/** Description of the units of a dimension in each set. */
export type UnitsOfSets = [LiveUnit, LiveUnit, LiveUnit];

/** A varied key with its values. */
export type Varied = string | {
  /** Dotted or short key. */
  key: string;
  /** Values as by `--set`. */
  values: string[];
};

/** Path, hole and string. */
export type WellView = PathView & {
  /** Sections of the hole, from the surface down. */
  hole: Section[];
  /** Components of the string, from the surface down, at the bit depth of the case's first operation. */
  string: Component[];
};

/** A command with its options. */
export type Work = {
  /** Whether the tables are written as CSV too. */
  csv?: boolean;
  kind: "run";
  /** Models that replace the case's: `soft`, `stiff`, `dynamic`. */
  models?: string[];
} | {
  kind: "plan";
  /** File of readings: another program's curves, overlaid on the plan. */
  overlay?: string | null;
  /** Whether PNG images are written too. */
  png?: boolean;
} | ReachOptions & {
  kind: "reach";
} | BhaOptions & {
  kind: "bha";
} | {
  kind: "modes";
  /** The operation; the first of the case by default. */
  operation?: string | null;
  /** Whether PNG images are written too. */
  png?: boolean;
} | CalibrateOptions & {
  kind: "calibrate";
} | SweepOptions & {
  kind: "sweep";
} | StudyOptions & {
  kind: "study";
} | {
  /** Whether the tables are written as CSV too. */
  csv?: boolean;
  kind: "bit_test";
  /** Share of the points to drill, such as `1/4`. */
  shard?: string | null;
};

/** The most severe check of a case. */
export interface WorstCheck {
  /** Its sentence, and the number of other errors and warnings. For a case without an error or a warning, it is the limit with the least reserve. */
  sentence: string;
  /** Its severity. */
  severity: Severity;
  /** The verdict in words: `OK`, `marginal`, `below required factor`, `exceeded`. */
  verdict: string;
}

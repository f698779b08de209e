// Tracks of an operation, and their curves.

import { extent } from "../../../components/curve.ts";
import { fromAfar } from "../../../components/from_afar.ts";
import { domain, type Interval } from "../../../components/ticks.ts";
import type { CurveLook, TrackCurve } from "../../../components/track.ts";
import { si } from "../../../components/units.ts";
import type { Along, Answer, ColumnName, Numbers } from "../api/answers";

/** A curve and its look. */
export interface ShownCurve {
  name: string;
  curve: TrackCurve;
  /** The curve at small scale, if it oscillates from joint to joint. */
  far?: TrackCurve | undefined;
  look: CurveLook;
}

/** A track with its curves. */
export interface ShownTrack {
  title: string;
  dimension: string;
  curves: ShownCurve[];
  leastSpan: number;
}

/** Titles, dimensions and the smallest span of an axis, SI, so that nearly constant curves look flat. */
const TRACKS: readonly [ColumnName, string, string, number][] = [
  ["tension_N", "Tension", "force", 10e3],
  ["torque_N_m", "Torque", "torque", 500],
  ["side_force_N_per_m", "Side force", "force per length", 100],
  ["bending_moment_N_m", "Bending moment", "torque", 500],
  ["von_mises_stress_Pa", "Von Mises stress", "stress", 10e6],
];

/** Columns that oscillate from joint to joint. */
const SWINGS: readonly ColumnName[] = ["bending_moment_N_m", "von_mises_stress_Pa"];

/** Length in view, m, above which curves are drawn at small scale; the other rules are those of the report. */
const FAR_M = 400;
const SWING_RULE = { joint_reach_m: 6, min_difference: 0.01 };

/** One degree in thirty metres. */
const DOGLEG_SPAN = Math.PI / 180 / 30;

/** Look of the curves of each model. */
export const MODELS = {
  soft: { name: "soft string", colour: "var(--line-0)", dash: null },
  stiff: { name: "stiff string", colour: "var(--line-1)", dash: [6, 3] },
} as const;

const numbers = (column: Numbers): Float64Array => Float64Array.from(column, (value) => value ?? NaN);

/** Columns are converted once per answer, however often they are drawn. */
const taken = new WeakMap<Numbers, Float64Array>();
function column(values: Numbers): Float64Array {
  const known = taken.get(values);
  if (known) return known;
  const made = numbers(values);
  taken.set(values, made);
  return made;
}

const afar = new WeakMap<Numbers, TrackCurve>();
function farOf(values: Numbers, curve: TrackCurve): TrackCurve {
  const known = afar.get(values);
  if (known) return known;
  const made = { depths: curve.depths, ...fromAfar(curve, SWING_RULE) };
  afar.set(values, made);
  return made;
}

/** Answers of the models to draw: the current ones, and the previous ones. */
export interface Answers {
  now: readonly (Answer | null)[];
  before: readonly (Answer | null)[];
}

const alongs = (answers: readonly (Answer | null)[], operation: string): Along[] =>
  answers.flatMap((answer) => answer?.tracks.filter((track) => track.operation === operation) ?? []);

/** The tracks of an operation. */
export function shownTracks(answers: Answers, operation: string): ShownTrack[] {
  const found = [alongs(answers.before, operation), alongs(answers.now, operation)];
  const tracks = TRACKS.map(([name, title, dimension, leastSpan]): ShownTrack => {
    const curves = found.flatMap((alongs, age) =>
      alongs.flatMap((along): ShownCurve[] => {
        const values = along[name];
        if (!values) return [];
        const { name: model, colour, dash } = MODELS[along.model];
        const curve = { depths: column(along.md_m), values: column(values) };
        const far = SWINGS.includes(name) ? farOf(values, curve) : undefined;
        return [{ name: age ? model : `${model}, before`, curve, far, look: { colour, dash, ghost: age === 0 } }];
      }),
    );
    return { title, dimension, curves, leastSpan };
  });
  const well = answers.now.find((answer) => answer)?.well;
  if (well) {
    const curve = { depths: column(well.md_m), values: column(well.dogleg_severity_rad_per_m) };
    const curves = [{ name: "well", curve, look: { colour: "var(--text)" } }];
    tracks.push({ title: "Dogleg severity", dimension: "dogleg severity", curves, leastSpan: DOGLEG_SPAN });
  }
  return tracks.filter((track) => track.curves.length > 0);
}

/** Returns the form of a curve for these depths. */
export const drawnOf = ({ curve, far }: ShownCurve, [from, to]: Interval): TrackCurve =>
  far && to - from > FAR_M ? far : curve;

/** Returns the range of the axis of a track over these depths. */
export function rangeOf({ curves, dimension, leastSpan }: ShownTrack, view: Interval): Interval {
  const ends = curves.flatMap((one) => {
    const { depths, values, between } = drawnOf(one, view);
    return [values, ...(between ? [between] : [])].map((column) => extent(depths, column, view));
  });
  const low = Math.min(...ends.map((end) => end[0]));
  const high = Math.max(...ends.map((end) => end[1]));
  return domain(low, high, false, si(1, dimension), leastSpan);
}

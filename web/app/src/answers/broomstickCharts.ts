// The charts of a broomstick: trip in to the left, rotate off bottom in the middle, trip out to the right.

import type { DepthChart, DepthLine, LoadLimit } from "../../../components/depth_chart.ts";
import type { Broomstick, BroomstickCurve, Numbers } from "../api/answers";

/** Operations with a curve of hook load, and those with one of torque, in words. */
const LOADS: Readonly<Record<string, string>> = { trip_in: "trip in", rotate_off_bottom: "rotate off bottom", trip_out: "trip out" };
const TORQUES: Readonly<Record<string, string>> = { rotate_off_bottom: "rotate off bottom", drill: "drill", ream: "ream", back_ream: "back ream" };
/** Levels from the lowest to the highest friction. */
const DASHES: Readonly<Record<string, readonly number[] | null>> = { low: [1.5, 3], expected: null, high: [6, 3] };

const numbers = (column: Numbers): number[] => column.map((value) => value ?? NaN);

/** `0.3`, or `0.2 / 0.3` if sections differ. */
function frictionText({ frictions }: Broomstick, name: string): string {
  const coefficients = frictions.find((level) => level.name === name)?.coefficients ?? [];
  const texts = coefficients.map((value) => String(Number(value.toFixed(3))));
  return texts.filter((text, i) => text !== texts[i - 1]).join(" / ");
}

type Column = "hook_load_N" | "surface_torque_N_m";

function linesOf(found: Broomstick, names: Readonly<Record<string, string>>, column: Column, ghost: boolean): DepthLine[] {
  const line = (curve: BroomstickCurve): DepthLine[] => {
    const name = names[curve.operation];
    // The hook load of rotation off bottom does not depend on friction.
    const alike = column === "hook_load_N" && curve.operation === "rotate_off_bottom";
    if (name === undefined || (alike && curve.friction !== "expected")) return [];
    const friction = frictionText(found, curve.friction);
    const end = alike ? name : curve.friction === "expected" ? `${name} ${friction}` : friction;
    return [
      {
        name: alike ? name : `${name}, friction ${friction}`,
        end,
        depths: numbers(curve.bit_depth_m),
        values: numbers(curve[column]),
        colour: `var(--operation-${curve.operation}, var(--text))`,
        dash: DASHES[curve.friction] ?? null,
        ghost,
      },
    ];
  };
  return found.curves.flatMap(line);
}

const limit = (name: string, value: number | null): LoadLimit[] => (value === null ? [] : [{ name, value }]);

/** Charts of hook load and torque; `before` is drawn pale below them. */
export function broomstickCharts(found: Broomstick, before: Broomstick | null, bitDepth: number | null): DepthChart[] {
  const deepest = Math.max(1, ...found.curves.flatMap((curve) => numbers(curve.bit_depth_m)).filter(Number.isFinite));
  const lines = (names: Readonly<Record<string, string>>, column: Column): DepthLine[] => [
    ...(before ? linesOf(before, names, column, true) : []),
    ...linesOf(found, names, column, false),
  ];
  const charts: DepthChart[] = [
    {
      title: "Hook load, without block",
      dimension: "force",
      lines: lines(LOADS, "hook_load_N"),
      limits: limit("hoist", found.hoist_N),
      depths: [0, deepest],
      now: bitDepth,
      leastSpan: 50e3,
    },
    {
      title: "Torque at the surface",
      dimension: "torque",
      lines: lines(TORQUES, "surface_torque_N_m"),
      limits: limit("top drive", found.top_drive_N_m),
      depths: [0, deepest],
      now: bitDepth,
      leastSpan: 1e3,
    },
  ];
  return charts.filter((chart) => chart.lines.length > 0);
}

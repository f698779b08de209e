// The axis of a quantity across the top of a chart: ticks with numbers in the unit of the reader.

import { numberText, niceAbove } from "./shown";

/** Height of the axis, pixels. */
export const AXIS = 17;

/** Smallest distance of two numbers of the axis, pixels. */
const APART = 40;

export const FONT = "10.5px system-ui, sans-serif";

/** Decimals of a tick, by the step between ticks. */
const decimalsOf = (step: number): number => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));

const tickText = (value: number, decimals: number): string => (value === 0 ? "0" : value.toFixed(decimals).replace("-", "\u2212"));

/** Draws ticks, their numbers and lines down the chart, from `low` to `high`, SI, for a unit of `factor`. */
export function drawAxis(
  to: CanvasRenderingContext2D, width: number, height: number,
  low: number, high: number, factor: number, grid: string, muted: string,
): void {
  to.lineWidth = 1;
  to.strokeStyle = grid;
  to.fillStyle = muted;
  to.font = FONT;
  to.textBaseline = "alphabetic";
  to.beginPath();
  to.moveTo(0, AXIS + 0.5);
  to.lineTo(width, AXIS + 0.5);
  if (high > low && width > 0) {
    const [from, end] = [low / factor, high / factor];
    const step = niceAbove(((end - from) * APART) / width);
    const decimals = decimalsOf(step);
    for (let place = Math.ceil(from / step - 1e-9) * step; place <= end + 1e-9 * step; place += step) {
      const value = Math.abs(place) < 1e-9 * step ? 0 : place;
      const x = Math.min(Math.round(((value - from) / (end - from)) * width) + 0.5, width - 0.5);
      to.moveTo(x, AXIS - 4);
      to.lineTo(x, height);
      const text = tickText(value, decimals);
      const half = to.measureText(text).width / 2;
      to.textAlign = x < half ? "left" : x > width - half ? "right" : "center";
      to.fillText(text, x < half ? 0 : x > width - half ? width : x, AXIS - 6);
    }
    to.textAlign = "left";
  }
  to.stroke();
}

/** A limit of a chart: its SI value, and its label with the value in the unit of the reader. */
export interface DrawnLimit {
  value: number;
  label: string;
}

/** The label of a limit. */
export const limitLabel = (label: string, value: number, factor: number): string => `${label} ${numberText(value / factor, 3)}`;

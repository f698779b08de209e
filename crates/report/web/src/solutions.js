// Which model and operation a curve belongs to, and how it looks.

import { dashOf, shapeOf } from "./marker.js";
import { line } from "./palette.js";
import { state } from "./state.js";

/** `trip_out` as people write it. */
export const spoken = (operation) => operation.replaceAll("_", " ");
export const modelName = (model) => (model === "soft" ? "soft string" : "dynamics");

/** Operations in the order in which they were solved. */
export const operations = (report) => [...new Set(report.solved.map((solved) => solved.operation))];

/** Whether two models stand beside each other. */
const bothModels = (report) => new Set(report.solved.map((other) => other.model)).size > 1;

/**
 * How a curve looks: operations differ by colour and marker, and by dash too where one model solved them; models differ by
 * dash; with one operation models differ by colour too, and nothing has markers.
 */
export function look(report, solved) {
  const all = operations(report);
  const soft = solved.model === "soft";
  const both = bothModels(report);
  const place = all.length === 1 && both && soft ? 1 : all.indexOf(solved.operation);
  return {
    colour: line(place),
    dash: both ? (soft ? dashOf(1) : null) : dashOf(place),
    shape: all.length > 1 ? shapeOf(place) : null,
    place,
  };
}

/** What tells a curve from all others, for those that are hidden. */
export const curveId = (solved) => `${solved.model} ${solved.operation}`;

/** The name of a curve, no longer than needed. */
export function curveName(report, solved) {
  if (operations(report).length === 1) return modelName(solved.model);
  const models = new Set(report.solved.map((other) => other.model)).size;
  return models === 1 ? spoken(solved.operation) : `${spoken(solved.operation)}, ${modelName(solved.model)}`;
}

/** What a model answered for the operation that the reader looks at. */
export const chosen = (report, model) =>
  report.solved.find((solved) => solved.operation === state.operation && solved.model === model);

/** The operation in time that the reader looks at; none where dynamics did not solve it. */
export const chosenRun = (report) => report.runs.find((run) => run.operation === state.operation);

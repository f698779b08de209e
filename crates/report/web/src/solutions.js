// Which model and operation a curve belongs to, and how it looks.

import { line } from "./palette.js";
import { state } from "./state.js";

/** `trip_out` as people write it. */
export const spoken = (operation) => operation.replaceAll("_", " ");
export const modelName = (model) => (model === "soft" ? "soft string" : "dynamics");

/** Operations in the order in which they were solved. */
export const operations = (report) => [...new Set(report.solved.map((solved) => solved.operation))];

/** Colour and stroke: operations differ by colour and models by stroke; with one operation models differ by both. */
export function look(report, solved) {
  const all = operations(report);
  const soft = solved.model === "soft";
  const both = new Set(report.solved.map((other) => other.model)).size > 1;
  const place = all.indexOf(solved.operation);
  return {
    colour: line(all.length === 1 && both && soft ? 1 : place),
    dashed: both && soft,
  };
}

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

// Which model and operation a curve belongs to, and how it looks.

import { dashOf, shapeOf } from "../../../../web/components/marker.ts";
import { colour, line } from "../../../../web/components/palette.ts";
import { state } from "./state.js";

/** `trip_out` as people write it. */
export const readable = (operation) => operation.replaceAll("_", " ");
/** What is known of the model that solved it: names, and whether it is in time. */
export const modelOf = (report, solved) => report.models.find(({ name }) => name === solved.model);
export const modelName = (report, solved) => modelOf(report, solved).long_name;

/** Operations in the order in which they were solved. */
export const operations = (report) => [...new Set(report.solved.map((solved) => solved.operation))];

/**
 * How a curve looks: operations differ by colour and marker, and by dash too where one model solved them; models differ by
 * dash; with one operation models differ by colour too, and nothing has markers.
 */
export function look(report, solved) {
  const all = operations(report);
  const model = report.models.indexOf(modelOf(report, solved));
  const several = report.models.length > 1;
  const place = all.length === 1 && several ? model : all.indexOf(solved.operation);
  return {
    colour: all.length === 1 && several ? line(model) : colour(`operation-${solved.operation}`),
    dash: dashOf(several ? model : place),
    hollow: !report.models[model].in_time,
    shape: all.length > 1 ? shapeOf(place) : null,
    place,
  };
}

/** What identifies a curve, for those that are hidden. */
export const curveId = (solved) => `${solved.model} ${solved.operation}`;

/** The name of a curve, no longer than needed. */
export function curveName(report, solved) {
  if (operations(report).length === 1) return modelName(report, solved);
  const operation = readable(solved.operation);
  return report.models.length === 1 ? operation : `${operation}, ${modelName(report, solved)}`;
}

/** What was solved of the chosen operation, the most detailed first. */
export const chosen = (report) =>
  report.models.flatMap(({ name }) =>
    report.solved.filter((solved) => solved.operation === state.operation && solved.model === name),
  );

/** Whether a model has numbers of an operation, and whether it has the string along the hole: one without an answer has neither. */
export const hasNumbers = (solved) => solved.key_results.length > 0;
export const hasProfile = (solved) => Boolean(solved.profile.md_m?.length);

/** The first that has numbers; the first of all where none has. */
const answered = (all) => all.find(hasNumbers) ?? all[0];

/** The most detailed answer of the chosen operation: of all models, of those in time, of those at rest. */
export const chosenAnswer = (report) => answered(chosen(report));
export const chosenInTime = (report) => answered(chosen(report).filter((solved) => modelOf(report, solved).in_time));
export const chosenAtRest = (report) => answered(chosen(report).filter((solved) => !modelOf(report, solved).in_time));

/** Operations of which some model has numbers. */
export const answeredOperations = (report) =>
  operations(report).filter((operation) => report.solved.some((solved) => solved.operation === operation && hasNumbers(solved)));

/** The chosen operation in time; none where dynamics did not solve it. */
export const chosenRun = (report) => report.runs.find((run) => run.operation === state.operation);

// Actions on a case of the list.

export type Action = "rename" | "copy" | "delete";

/** The actions with their titles. */
export const ACTIONS = [
  ["rename", "Rename"],
  ["copy", "Copy"],
  ["delete", "Delete"],
] as const satisfies readonly (readonly [Action, string])[];

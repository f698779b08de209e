// The commands that the page can start, and their requests.

import type { Work } from "../api/jobs";

export type Command = Work["kind"];

/** The commands with descriptions, in the order of planning a well. */
export const COMMANDS: readonly { kind: Command; title: string; does: string }[] = [
  { kind: "plan", title: "Plan", does: "Torque and drag at every depth of the bit, with low, expected and high friction" },
  { kind: "run", title: "Run", does: "Every operation of the case, by soft string, stiff string or dynamics" },
  { kind: "reach", title: "Reach", does: "The depth that the well can reach, and the limit that stops it" },
  { kind: "bha", title: "Assembly", does: "Static analysis of the bottom-hole assembly: contacts, side force, tilt" },
  { kind: "modes", title: "Modes", does: "Natural frequencies, critical speeds and torsional stability" },
  { kind: "calibrate", title: "Calibrate", does: "Friction factors from readings at the surface" },
  { kind: "sweep", title: "Sweep", does: "The case with all combinations of some values" },
  { kind: "bit_test", title: "Bit test", does: "The bit alone on its rock, at every weight and speed" },
  { kind: "study", title: "Study", does: "The cases of a study file, with its figures and tables" },
];

/** All fields of the form, for any command. */
export interface Filled {
  models: string[];
  csv: boolean;
  overlay: string;
  from: string;
  to: string;
  frictions: string;
  operations: string[];
  no_helix_friction: boolean;
  operation: string;
  whole: boolean;
  toolface: string;
  weight: string;
  inclination: string;
  build: string;
  data: string;
  one_factor: boolean;
  by_section: boolean;
  friction_around: boolean;
  block_weight: boolean;
  bit_torque: boolean;
  hold: string;
  predicts: string;
  check_dynamics: boolean;
  vary: string;
  keep: string;
  study: string;
}

export const unfilled = (): Filled => ({
  models: [],
  csv: false,
  overlay: "",
  from: "",
  to: "",
  frictions: "",
  operations: [],
  no_helix_friction: false,
  operation: "",
  whole: false,
  toolface: "",
  weight: "",
  inclination: "",
  build: "",
  data: "",
  one_factor: false,
  by_section: false,
  friction_around: false,
  block_weight: false,
  bit_torque: false,
  hold: "",
  predicts: "soft",
  check_dynamics: false,
  vary: "",
  keep: "",
  study: "",
});

const optional = (text: string): string | null => (text.trim() === "" ? null : text.trim());
const lines = (text: string): string[] => text.split("\n").map((line) => line.trim()).filter((line) => line !== "");

/** `0.2, 0.3` as numbers. */
function numbers(text: string): number[] {
  const words = text.split(",").map((word) => word.trim()).filter((word) => word !== "");
  return words.map((word) => {
    const number = Number(word);
    if (!Number.isFinite(number)) throw new Error(`${word} is not a friction factor: expected a number such as 0.3`);
    return number;
  });
}

/** Returns the request; throws a sentence if the form is invalid. */
export function workOf(kind: Command, filled: Filled): Work {
  const { operation, data, study } = filled;
  switch (kind) {
    case "run":
      return { kind, models: filled.models, csv: filled.csv };
    case "plan":
      return { kind, overlay: optional(filled.overlay) };
    case "reach":
      return {
        kind,
        from: optional(filled.from),
        to: optional(filled.to),
        frictions: numbers(filled.frictions),
        operations: filled.operations,
        no_helix_friction: filled.no_helix_friction,
      };
    case "bha":
      return {
        kind,
        operation: optional(operation),
        whole: filled.whole,
        toolface: optional(filled.toolface),
        weight: optional(filled.weight),
        inclination: optional(filled.inclination),
        build: optional(filled.build),
      };
    case "modes":
      return { kind, operation: optional(operation) };
    case "calibrate":
      if (data === "") throw new Error("Choose the file of the readings.");
      return {
        kind,
        data,
        one_factor: filled.one_factor,
        by_section: filled.by_section,
        friction_around: filled.friction_around,
        block_weight: filled.block_weight,
        bit_torque: filled.bit_torque,
        hold: lines(filled.hold),
        model: filled.predicts,
        check_dynamics: filled.check_dynamics,
      };
    case "sweep":
      return { kind, vary: lines(filled.vary), keep: optional(filled.keep) };
    case "study":
      if (study === "") throw new Error("Choose the study.");
      return { kind, study };
    case "bit_test":
      return { kind };
  }
}

/** Lines such as `friction=0.3` as values by keys. */
export function setOf(text: string): Record<string, string> {
  return Object.fromEntries(
    lines(text).map((line) => {
      const [key = "", ...value] = line.split("=");
      if (value.length === 0) throw new Error(`${line}: expected KEY=VALUE`);
      return [key.trim(), value.join("=").trim()];
    }),
  );
}

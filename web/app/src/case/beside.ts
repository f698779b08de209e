// What can stand beside the form.

import type { Component } from "svelte";
import type { Change } from "../api/cases";

/** What every panel is given. */
export interface PanelProps {
  /** The case. */
  id: string;
  /** What stands in the editor now. */
  text: string;
  /** Whether it was checked and has no error. */
  sound: boolean;
  /** Changes the case. */
  change: (...changes: Change[]) => void;
}

export interface Panel {
  name: string;
  title: string;
  /** Fetched when it is first shown. */
  load: () => Promise<{ default: Component<PanelProps> | Component }>;
}

/** The panels, from left to right; the first is shown until one says otherwise. */
export const PANELS: Panel[] = [
  { name: "text", title: "TOML", load: () => import("./text/TextEditor.svelte") },
  { name: "answers", title: "Answers", load: () => import("./AnswersPanel.svelte") },
  ...(__ALONE__ ? [] : [{ name: "work", title: "Run", load: () => import("./WorkPanel.svelte") }]),
];

export async function panelOf(panel: Panel): Promise<Component<PanelProps>> {
  const found: unknown = (await panel.load()).default;
  return found as Component<PanelProps>;
}

// Panels next to the form.

import type { Component } from "svelte";
import type { PanelProps } from "./panel";

export interface Panel {
  name: string;
  title: string;
  /** Fetched when first displayed. */
  load: () => Promise<{ default: Component<PanelProps> | Component }>;
}

/** The panels, from left to right; only the first is visible initially. */
export const PANELS: Panel[] = [
  { name: "text", title: "TOML", load: () => import("./text/TextEditor.svelte") },
  { name: "answers", title: "Answers", load: () => import("./AnswersPanel.svelte") },
  ...(__ALONE__ ? [] : [{ name: "work", title: "Run", load: () => import("./WorkPanel.svelte") }]),
];

export async function panelOf(panel: Panel): Promise<Component<PanelProps>> {
  const found: unknown = (await panel.load()).default;
  return found as Component<PanelProps>;
}

// Panels below the form, on demand.

import type { Component } from "svelte";
import type { PanelProps } from "./panel";

export interface Panel {
  name: string;
  title: string;
  /** Fetched when first displayed. */
  load: () => Promise<{ default: Component<PanelProps> | Component }>;
}

/** The panels; at most one is visible. */
export const PANELS: Panel[] = [
  { name: "text", title: "TOML", load: () => import("./text/TextEditor.svelte") },
  ...(__ALONE__ ? [] : [{ name: "work", title: "Run", load: () => import("./WorkPanel.svelte") }]),
];

export async function panelOf(panel: Panel): Promise<Component<PanelProps>> {
  const found: unknown = (await panel.load()).default;
  return found as Component<PanelProps>;
}

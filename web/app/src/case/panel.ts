// Properties of every panel below the form.

import type { Change } from "../api/cases";

export interface PanelProps {
  /** The case. */
  id: string;
  /** Current text in the editor. */
  text: string;
  /** Whether the text was checked without errors. */
  valid: boolean;
  /** Changes the case. */
  change: (...changes: Change[]) => void;
  /** Replaces a text by a new one made from it. */
  replace: (made: { base: string; text: string }) => void;
}

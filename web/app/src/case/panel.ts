// What every panel beside the form is given.

import type { Change } from "../api/cases";

export interface PanelProps {
  /** The case. */
  id: string;
  /** What stands in the editor now. */
  text: string;
  /** Whether it was checked and has no error. */
  valid: boolean;
  /** Changes the case. */
  change: (...changes: Change[]) => void;
  /** Puts a text, which was made of another one, in its place. */
  replace: (made: { base: string; text: string }) => void;
}

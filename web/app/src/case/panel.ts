// What every panel beside the form is given.

import type { Change } from "../api/cases";

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

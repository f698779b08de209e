// The open case: its text, the parsed values and the unsaved changes. Form and text editor both change it here.

import {
  checkCase,
  dropDraft,
  editCase,
  readCase,
  saveCase,
  saveDraft,
  type CaseText,
  type Change,
  type Checked,
  type Table,
} from "../api/cases";
import { ApiError, wasAborted, type Diagnostic } from "../api/client";
import { History, type Origin } from "./history";
import { applied } from "./values";

/** Pause in typing before the text is checked, ms. */
const CHECK_MS = 120;
/** Pause in typing before the draft is saved, ms. */
const DRAFT_MS = 700;

/** Line ends of the text here; a file with Windows line ends is saved with them. */
const plain = (text: string): string => text.replaceAll("\r\n", "\n");
const hasWindowsLines = (text: string): boolean => text.includes("\r\n");

const NOTHING: Checked = {
  diagnostics: [],
  values: null,
  quantities: {},
  layout: {
    stations: { md_m: [], inclination_rad: [], azimuth_rad: [], dogleg_severity_rad_per_m: [] },
    tie_in: null,
    path: null,
    hole: [],
    string: [],
  },
};

export class OpenCase {
  readonly id: string;
  readonly path: string;
  #text = $state.raw("");
  /** Last known text of the file. */
  #saved = $state.raw("");
  #revision = "";
  #windowsLines = false;
  #values = $state.raw<Table>({});
  #checked = $state.raw(NOTHING);
  /** The text that `#checked` is about. */
  #checkedText = $state.raw<string | null>(null);
  /** Changed text of the file, about which the user will decide later. */
  #postponed: string | null = null;
  #history = new History();
  #steps = $state({ undo: false, redo: false });
  #edits: Promise<void> = Promise.resolve();
  #drafts: Promise<void> = Promise.resolve();
  /** Changes that are displayed and not yet in the text. */
  #pending = 0;
  #checking: AbortController | null = null;
  #checkTimer = 0;
  #draftTimer = 0;
  #closed = false;
  /** A check of the file was requested while it was being saved. */
  #lookDue = false;

  /** Time at which the draft was saved, ms; null if there are no unsaved changes or no draft yet. */
  keptAt = $state<number | null>(null);
  saving = $state(false);
  /** An earlier draft that was restored. */
  restored = $state.raw<{ modified_ms: number; fileIsOther: boolean } | null>(null);
  /** Text of the file that was changed while it was open here. */
  conflict = $state.raw<CaseText | null>(null);
  /** The file was changed elsewhere, and reloaded without loss here. */
  renewed = $state(false);
  problem = $state.raw<unknown>(null);

  private constructor(file: CaseText) {
    this.id = file.id;
    this.path = file.path;
    this.#saved = plain(file.text);
    this.#revision = file.revision;
    this.#windowsLines = hasWindowsLines(file.text);
    this.#text = this.#saved;
    const { draft } = file;
    if (draft && draft.text !== this.#saved) {
      this.#text = draft.text;
      this.keptAt = draft.modified_ms;
      const fileIsOther = draft.base_revision !== file.revision;
      this.restored = { modified_ms: draft.modified_ms, fileIsOther };
    }
  }

  static async open(id: string): Promise<OpenCase> {
    const opened = new OpenCase(await readCase(id));
    await opened.#check();
    return opened;
  }

  get text(): string {
    return this.#text;
  }

  get values(): Table {
    return this.#values;
  }

  get checked(): Checked {
    return this.#checked;
  }

  get diagnostics(): Diagnostic[] {
    return this.#checked.diagnostics;
  }

  /** Whether the text is TOML, so that the form can change it. */
  get isToml(): boolean {
    return this.#checked.values !== null;
  }

  /** Whether the current text was checked without errors. */
  get valid(): boolean {
    return this.#checkedText === this.#text && !this.diagnostics.some(({ level }) => level === "error");
  }

  get dirty(): boolean {
    return this.#text !== this.#saved;
  }

  get canUndo(): boolean {
    return this.#steps.undo;
  }

  get canRedo(): boolean {
    return this.#steps.redo;
  }

  /** Sets the text from typing. */
  type(text: string): void {
    this.#put(text, "typing");
  }

  /** Changes keys: displayed at once, then applied to the text by the server, which keeps comments. */
  change(...changes: Change[]): Promise<void> {
    if (changes.length === 0) return this.#edits;
    this.#values = changes.reduce(applied, this.#values);
    this.#pending += 1;
    this.#edits = this.#edits.then(() => this.#edit(changes));
    return this.#edits;
  }

  async #edit(changes: Change[]): Promise<void> {
    try {
      for (;;) {
        const base = this.#text;
        const { text } = await editCase(this.id, base, changes);
        // Text typed meanwhile is not lost: the change is applied to it.
        if (this.#text !== base) continue;
        this.#pending -= 1;
        this.#put(text, "edit");
        this.problem = null;
        return;
      }
    } catch (problem) {
      this.#pending -= 1;
      this.problem = problem;
      this.#checkSoon(0);
    }
  }

  /** Replaces the text by one made from it, as a step that can be undone. */
  replace({ base, text }: { base: string; text: string }): void {
    this.#edits = this.#edits.then(() => {
      if (this.#text === base) this.#put(text, "edit");
      else this.problem = new Error("The case was changed meanwhile: no value was applied.");
    });
  }

  undo(): void {
    this.#edits = this.#edits.then(() => this.#step(this.#history.undo(this.#text)));
  }

  redo(): void {
    this.#edits = this.#edits.then(() => this.#step(this.#history.redo(this.#text)));
  }

  #step(text: string | undefined): void {
    if (text === undefined) return;
    this.#text = text;
    this.#noteSteps();
    this.#checkSoon(0);
    this.#draftSoon();
  }

  #put(text: string, origin: Origin): void {
    if (text === this.#text) return;
    this.#history.leave(this.#text, origin, Date.now());
    this.#text = text;
    this.#noteSteps();
    this.#checkSoon(origin === "typing" ? CHECK_MS : 0);
    this.#draftSoon();
  }

  #noteSteps(): void {
    this.#steps.undo = this.#history.canUndo;
    this.#steps.redo = this.#history.canRedo;
  }

  #checkSoon(after_ms: number): void {
    clearTimeout(this.#checkTimer);
    this.#checkTimer = window.setTimeout(() => void this.#check(), after_ms);
  }

  async #check(): Promise<void> {
    this.#checking?.abort();
    const checking = new AbortController();
    this.#checking = checking;
    const text = this.#text;
    try {
      const checked = await checkCase(this.id, text, checking.signal);
      if (text !== this.#text || this.#closed) return;
      // For a text that is not valid TOML, the last valid values remain.
      const drawn = checked.values === null ? { ...checked, layout: this.#checked.layout } : checked;
      this.#checked = drawn;
      this.#checkedText = text;
      if (checked.values !== null && this.#pending === 0) this.#values = checked.values;
    } catch (problem) {
      if (!wasAborted(problem)) this.problem = problem;
    }
  }

  #draftSoon(): void {
    clearTimeout(this.#draftTimer);
    this.#draftTimer = window.setTimeout(() => void this.keepDraft(), DRAFT_MS);
  }

  /** Saves the text as a draft, one request at a time; removes the draft if the text equals the file. */
  keepDraft(closing = false): Promise<void> {
    clearTimeout(this.#draftTimer);
    // A closing page does not wait for requests.
    if (closing) return this.#keep(true);
    this.#drafts = this.#drafts.then(() => this.#keep(false));
    return this.#drafts;
  }

  async #keep(closing: boolean): Promise<void> {
    const text = this.#text;
    try {
      if (this.dirty) await saveDraft(this.id, text, this.#revision, closing);
      else await dropDraft(this.id);
      if (text === this.#text) this.keptAt = this.dirty ? Date.now() : null;
      if (!this.dirty) this.restored = null;
    } catch (problem) {
      this.problem = problem;
    }
  }

  /** Restores the text of the file; undo restores the draft. */
  async discardDraft(): Promise<void> {
    this.restored = null;
    this.#put(this.#saved, "edit");
    await this.keepDraft();
  }

  /** Saves to the file, unless it was changed: `conflict` then has its text. */
  async save(): Promise<void> {
    await this.#edits;
    // A pending draft would remain after the save.
    await this.#drafts;
    await this.#saveOver(this.#revision);
  }

  /** Saves over the changed file. */
  async saveMine(): Promise<void> {
    if (this.conflict) await this.#saveOver(this.conflict.revision);
  }

  async #saveOver(revision: string): Promise<void> {
    const text = this.#text;
    this.saving = true;
    clearTimeout(this.#draftTimer);
    try {
      const lines = this.#windowsLines ? text.replaceAll("\n", "\r\n") : text;
      const saved = await saveCase(this.id, lines, revision);
      this.#revision = saved.revision;
      this.#postponed = null;
      this.#saved = text;
      this.keptAt = null;
      this.restored = null;
      this.conflict = null;
      this.problem = null;
      if (this.dirty) this.#draftSoon();
    } catch (problem) {
      if (problem instanceof ApiError && problem.kind === "conflict") await this.#meet();
      else this.problem = problem;
    } finally {
      this.saving = false;
      if (this.#lookDue) void this.lookAgain();
    }
  }

  async #meet(): Promise<void> {
    try {
      this.conflict = await readCase(this.id);
    } catch (problem) {
      this.problem = problem;
    }
  }

  /** Loads the changed file; undo restores the previous text. */
  async takeTheirs(): Promise<void> {
    const theirs = this.conflict;
    if (!theirs) return;
    this.conflict = null;
    this.restored = null;
    this.#follow(theirs);
    await this.keepDraft();
  }

  #follow(file: CaseText): void {
    this.#saved = plain(file.text);
    this.#revision = file.revision;
    this.#windowsLines = hasWindowsLines(file.text);
    this.#postponed = null;
    this.#put(this.#saved, "edit");
  }

  /** Leaves both unchanged; the choice is offered again at the next save. */
  decideLater(): void {
    this.#postponed = this.conflict?.revision ?? null;
    this.conflict = null;
  }

  /** Checks whether the file was changed; without unsaved changes, its text is loaded. */
  async lookAgain(): Promise<void> {
    this.#lookDue = this.saving;
    if (this.saving || this.conflict || this.#closed) return;
    try {
      const file = await readCase(this.id);
      if (file.revision === this.#revision || file.revision === this.#postponed || this.saving) return;
      if (this.dirty) this.conflict = file;
      else {
        this.#follow(file);
        this.renewed = true;
      }
    } catch {
      // An unreadable file is reported at the next save.
    }
  }

  /** Ends all activity; unsaved changes are kept as a draft. */
  close(): void {
    if (this.#closed) return;
    this.#closed = true;
    clearTimeout(this.#checkTimer);
    this.#checking?.abort();
    if (this.dirty) void this.keepDraft();
    else clearTimeout(this.#draftTimer);
  }
}

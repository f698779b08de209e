// State shared by the parts of the editor.

import { getContext, setContext } from "svelte";
import { LiveAnswers } from "../answers/liveAnswers.svelte";
import type { Diagnostic } from "../api/client";
import type { OpenCase } from "./openCase.svelte";

/** A key and its description in the schema. */
export interface About {
  key: string;
  text: string;
}

export class Editor {
  readonly opened: OpenCase;
  /** Answers of the current text. */
  readonly live: LiveAnswers;
  /** Description of the key in focus. */
  about = $state.raw<About | null>(null);
  /** The key that the form should go to; a new object each time. */
  sought = $state.raw<{ key: string } | null>(null);
  /** The place that the text editor should go to. */
  soughtPlace = $state.raw<{ start: number; end: number } | null>(null);

  constructor(opened: OpenCase) {
    this.opened = opened;
    this.live = new LiveAnswers(opened.id);
  }

  /** The most severe diagnostic of a key, and with `deep` of the keys in it. */
  diagnosticOf(key: string, deep = false): Diagnostic | undefined {
    const { diagnostics } = this.opened;
    const firstOf = (level: string) =>
      diagnostics.find((one) => one.level === level && (one.key === key || (deep && one.key?.startsWith(`${key}.`))));
    return firstOf("error") ?? firstOf("warning") ?? firstOf("note");
  }
}

const KEY = Symbol("editor");

export const setEditor = (editor: Editor): Editor => setContext(KEY, editor);
export const getEditor = (): Editor => getContext<Editor>(KEY);

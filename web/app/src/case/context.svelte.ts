// What the parts of the editor share.

import { getContext, setContext } from "svelte";
import type { Diagnostic } from "../api/client";
import type { OpenCase } from "./openCase.svelte";

/** A key and what the schema says of it. */
export interface About {
  key: string;
  text: string;
}

export class Editor {
  readonly opened: OpenCase;
  /** What is told of the key that is worked on. */
  about = $state.raw<About | null>(null);
  /** The key to which the form was asked to go; a new object each time. */
  sought = $state.raw<{ key: string } | null>(null);
  /** The place to which the text was asked to go. */
  soughtPlace = $state.raw<{ start: number; end: number } | null>(null);

  constructor(opened: OpenCase) {
    this.opened = opened;
  }

  /** What is to be said of a key, or of what lies in it where `deep`. The worst comes first. */
  said(key: string, deep = false): Diagnostic | undefined {
    const { diagnostics } = this.opened;
    const of = (level: string) =>
      diagnostics.find((one) => one.level === level && (one.key === key || (deep && one.key?.startsWith(`${key}.`))));
    return of("error") ?? of("warning") ?? of("note");
  }
}

const KEY = Symbol("editor");

export const setEditor = (editor: Editor): Editor => setContext(KEY, editor);
export const getEditor = (): Editor => getContext<Editor>(KEY);

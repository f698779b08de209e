// The text of the case in an editor. Undo and redo are those of the case, because the form also changes the text.

import { defaultKeymap } from "@codemirror/commands";
import { bracketMatching, HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { lintGutter, setDiagnostics, type Diagnostic as Mark } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Annotation, EditorState, type Extension } from "@codemirror/state";
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";
import type { Diagnostic } from "../../api/client";

/** Marks changes from the case, as opposed to typing. */
const fromCase = Annotation.define<boolean>();

const COLOURS = HighlightStyle.define([
  { tag: tags.comment, color: "var(--muted)" },
  { tag: tags.string, color: "var(--good)" },
  { tag: [tags.number, tags.atom, tags.bool], color: "var(--accent)" },
  { tag: [tags.propertyName, tags.variableName], color: "var(--text)" },
  { tag: [tags.bracket, tags.heading], color: "var(--accent)" },
]);

const LOOKS = EditorView.theme({
  "&": { color: "var(--text)", backgroundColor: "var(--paper)", height: "100%", fontSize: "13px" },
  ".cm-content": { caretColor: "var(--text)", fontFamily: "ui-monospace, 'DejaVu Sans Mono', monospace" },
  ".cm-gutters": { backgroundColor: "var(--page)", color: "var(--muted)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "color-mix(in srgb, var(--accent) 8%, transparent)" },
  "&.cm-focused": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
  "&.cm-focused .cm-selectionBackground, .cm-selectionBackground": {
    backgroundColor: "color-mix(in srgb, var(--accent) 25%, transparent) !important",
  },
  ".cm-cursor": { borderLeftColor: "var(--text)" },
  ".cm-panels": { backgroundColor: "var(--page)", color: "var(--text)" },
  ".cm-tooltip": { backgroundColor: "var(--paper)", color: "var(--text)", border: "1px solid var(--frame)" },
  ".cm-textfield, .cm-button": {
    backgroundColor: "var(--paper)",
    backgroundImage: "none",
    color: "var(--text)",
    border: "1px solid var(--frame)",
  },
  ".cm-lintRange-error": { backgroundImage: "none", borderBottom: "2px solid var(--over)" },
  ".cm-lintRange-warning": { backgroundImage: "none", borderBottom: "2px solid var(--near)" },
  ".cm-lintRange-info": { backgroundImage: "none", borderBottom: "2px dotted var(--accent)" },
  ".cm-diagnostic": { whiteSpace: "pre-wrap" },
});

export interface Hooks {
  typed: (text: string) => void;
}

export class TomlEditor {
  readonly #view: EditorView;

  /** In a shadow root, because the editor generates its styles, which the policy of the page does not allow. */
  constructor(host: HTMLElement, text: string, hooks: Hooks) {
    const root = host.attachShadow({ mode: "open" });
    const listener = EditorView.updateListener.of((update) => {
      const own = update.transactions.some((one) => one.annotation(fromCase));
      if (update.docChanged && !own) hooks.typed(update.state.doc.toString());
    });
    const extensions: Extension[] = [
      lineNumbers(),
      lintGutter(),
      drawSelection(),
      highlightActiveLine(),
      highlightActiveLineGutter(),
      highlightSelectionMatches(),
      bracketMatching(),
      search({ top: true }),
      StreamLanguage.define(toml),
      syntaxHighlighting(COLOURS),
      keymap.of([...defaultKeymap, ...searchKeymap]),
      EditorView.contentAttributes.of({ "aria-label": "The case file as TOML", tabindex: "0" }),
      LOOKS,
      listener,
    ];
    this.#view = new EditorView({ state: EditorState.create({ doc: text, extensions }), parent: root, root });
    this.#view.dom.style.height = "100%";
  }

  /** Displays a text; only differences are changed, so that cursor and view are kept. */
  show(text: string): void {
    const before = this.#view.state.doc.toString();
    if (before === text) return;
    const least = Math.min(before.length, text.length);
    let from = 0;
    while (from < least && before[from] === text[from]) from += 1;
    let same = 0;
    while (same < least - from && before.at(-1 - same) === text.at(-1 - same)) same += 1;
    const insert = text.slice(from, text.length - same);
    this.#view.dispatch({ changes: { from, to: before.length - same, insert }, annotations: fromCase.of(true) });
  }

  /** Underlines the diagnostics of the text. */
  mark(diagnostics: Diagnostic[]): void {
    const { length } = this.#view.state.doc;
    const marks = diagnostics.flatMap(({ start, end, file, level, message, label, help }): Mark[] => {
      if (start === null || file !== null || start > length) return [];
      const lines = [label === "" ? message : `${message}: ${label}`, ...help];
      const severity = level === "error" || level === "warning" ? level : "info";
      const to = Math.min(length, Math.max(end ?? start, start + 1));
      return [{ from: Math.min(start, to), to, severity, message: lines.join("\n") }];
    });
    this.#view.dispatch(setDiagnostics(this.#view.state, marks));
  }

  /** Selects a place and takes the focus. */
  go(start: number, end: number): void {
    const { length } = this.#view.state.doc;
    const [anchor, head] = [Math.min(start, length), Math.min(end, length)];
    this.#view.dispatch({
      selection: { anchor, head },
      effects: EditorView.scrollIntoView(anchor, { y: "center" }),
      annotations: fromCase.of(true),
    });
    this.#view.focus();
  }

  close(): void {
    this.#view.destroy();
  }
}

// Live strings of this page, each in its own worker.

import { ApiError } from "../api/client";
import type { LiveEntry } from "../api/live";
import { OPEN, type Line } from "../api/line";
import { quick } from "./cases";
import { Desk, unpack } from "./desk";
import * as folder from "./folder";
import * as moments from "./kept";

/** Largest number of live strings, because each requires a core of its own. */
const MOST = 2;

interface Live {
  desk: Desk;
  case: string;
  /** Reason why it ended. */
  ended: string | null;
  line: LineHere | null;
  /** Its last status message. */
  status: string;
}

const strings = new Map<string, Live>();

function stringOf(id: string): Live {
  const found = strings.get(id);
  if (!found) throw new ApiError(404, "not_found", "there is no such live string");
  if (found.ended !== null) throw new ApiError(410, "ended", found.ended);
  return found;
}

/** A connection to a string, in place of a socket. */
class LineHere implements Line {
  onopen: Line["onopen"] = null;
  onmessage: Line["onmessage"] = null;
  onclose: Line["onclose"] = null;
  readyState = OPEN;
  readonly #live: Live;

  constructor(live: Live) {
    this.#live = live;
    live.line = this;
    live.desk.onMessage = (data) => {
      if (typeof data === "string" && data.startsWith('{"type":"status"')) live.status = data;
      this.onmessage?.(new MessageEvent("message", { data }));
      if (typeof data !== "string") live.desk.say({ taken: true });
    };
    // Deferred, because the caller sets its listeners after the constructor.
    queueMicrotask(() => {
      this.onopen?.(new Event("open"));
      live.desk.say({ attend: true });
    });
  }

  send(text: string): void {
    this.#live.desk.say({ say: text });
  }

  close(): void {
    this.readyState = 3;
    this.#live.line = null;
    this.#live.desk.onMessage = null;
    this.onclose?.(new CloseEvent("close"));
  }
}

export function lineTo(id: string): Line {
  return new LineHere(stringOf(id));
}

async function begin(request: object, caseName: string, bytes?: ArrayBuffer): Promise<{ id: string }> {
  const running = [...strings.values()].filter((live) => live.ended === null);
  if (running.length >= MOST) throw new ApiError(429, "too_many", `${MOST} strings are live already: end one of them first`);
  const id = crypto.randomUUID?.() ?? String(Math.random()).slice(2);
  const desk = new Desk();
  const live: Live = { desk, case: caseName, ended: null, line: null, status: "{}" };
  try {
    unpack<LiveEntry>(await desk.ask("begin", { ...request, id }, bytes));
  } catch (problem) {
    desk.end();
    throw problem;
  }
  strings.set(id, live);
  desk.ended = (why) => finish(live, why);
  return { id };
}

/** Ends a string, and notifies its viewer. */
function finish(live: Live, why: string): void {
  live.ended = why;
  live.desk.end();
  const last = { ...(JSON.parse(live.status) as object), type: "status", state: "ended", sentence: why };
  live.line?.onmessage?.(new MessageEvent("message", { data: JSON.stringify(last) }));
}

export const beginNew = (body: { case: string; text: string }): Promise<{ id: string }> =>
  begin({ asks: "begin", file: body.case, beside: folder.beside(body.text), body }, body.case);

export async function list(): Promise<LiveEntry[]> {
  const running = [...strings].filter(([, live]) => live.ended === null);
  return Promise.all(running.map(async ([, { desk }]) => unpack<LiveEntry>(await desk.ask("ask", { asks: "entry" }))));
}

export function end(id: string): void {
  finish(stringOf(id), "this string was ended by a user");
}

/** Sends a request to a string. */
export async function ask<T>(id: string, asks: string, body: object = {}): Promise<T> {
  const live = stringOf(id);
  const text = folder.fileOf(live.case)?.text ?? "";
  const caseText = "text" in body && typeof body.text === "string" ? body.text : text;
  return unpack<T>(await live.desk.ask("ask", { asks, file: live.case, beside: folder.beside(caseText), body }));
}

async function moment(id: string, checkpoint: number | null): Promise<moments.Kept> {
  const { status, bytes } = await stringOf(id).desk.ask("keep", { asks: "keep", body: { checkpoint } });
  if (status !== 200) unpack({ status, bytes });
  const known = unpack<Omit<moments.Kept, "bytes">>(await quick.ask("kept", {}, bytes));
  return { ...known, name: String(Date.now()), modified_ms: Date.now(), bytes };
}

const go = ({ case: caseName, text, bytes }: moments.Kept): Promise<{ id: string }> => begin({ asks: "begin", file: caseName, beside: folder.beside(text) }, caseName, bytes);

export const branch = async (id: string, checkpoint: number | null): Promise<{ id: string }> => go(await moment(id, checkpoint));

export async function keep(id: string, checkpoint: number | null): Promise<{ name: string }> {
  const saved = await moment(id, checkpoint);
  await moments.put(saved);
  return { name: saved.name };
}

export const goOn = async (name: string): Promise<{ id: string }> => go(await moments.get(name));

// Live strings of this page, each in a worker of its own.

import { ApiError } from "../api/client";
import type { LiveEntry } from "../api/live";
import { OPEN, type Line } from "../api/line";
import { quick } from "./cases";
import { Desk, said } from "./desk";
import * as folder from "./folder";
import * as kept from "./kept";

/** So many at once: each has the processor for itself only as long as there are cores. */
const MOST = 2;

interface Live {
  desk: Desk;
  case: string;
  /** What was said when it ended. */
  ended: string | null;
  line: LineHere | null;
  /** How it was doing last, as it was told. */
  status: string;
}

const strings = new Map<string, Live>();

function stringOf(id: string): Live {
  const found = strings.get(id);
  if (!found) throw new ApiError(404, "not_found", "there is no such live string");
  if (found.ended !== null) throw new ApiError(410, "ended", found.ended);
  return found;
}

/** A line to a string: what a socket is elsewhere. */
class LineHere implements Line {
  onopen: Line["onopen"] = null;
  onmessage: Line["onmessage"] = null;
  onclose: Line["onclose"] = null;
  readyState = OPEN;
  readonly #live: Live;

  constructor(live: Live) {
    this.#live = live;
    live.line = this;
    live.desk.told = (data) => {
      if (typeof data === "string" && data.startsWith('{"type":"status"')) live.status = data;
      this.onmessage?.(new MessageEvent("message", { data }));
      if (typeof data !== "string") live.desk.say({ taken: true });
    };
    // Who opens a line listens to it a moment later.
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
    this.#live.desk.told = null;
    this.onclose?.(new CloseEvent("close"));
  }
}

export function lineTo(id: string): Line {
  return new LineHere(stringOf(id));
}

async function begin(request: object, of: string, bytes?: ArrayBuffer): Promise<{ id: string }> {
  const running = [...strings.values()].filter((live) => live.ended === null);
  if (running.length >= MOST) throw new ApiError(429, "too_many", `${MOST} strings are live already: end one of them first`);
  const id = crypto.randomUUID?.() ?? String(Math.random()).slice(2);
  const desk = new Desk();
  const live: Live = { desk, case: of, ended: null, line: null, status: "{}" };
  try {
    said<LiveEntry>(await desk.ask("begin", { ...request, id }, bytes));
  } catch (problem) {
    desk.end();
    throw problem;
  }
  strings.set(id, live);
  desk.ended = (why) => finish(live, why);
  return { id };
}

/** Ends a string, and tells who looks at it. */
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
  return Promise.all(running.map(async ([, { desk }]) => said<LiveEntry>(await desk.ask("ask", { asks: "entry" }))));
}

export function end(id: string): void {
  finish(stringOf(id), "this string was ended by a user");
}

/** Asks a string something. */
export async function ask<T>(id: string, asks: string, body: object = {}): Promise<T> {
  const live = stringOf(id);
  const text = folder.fileOf(live.case)?.text ?? "";
  const of = "text" in body && typeof body.text === "string" ? body.text : text;
  return said<T>(await live.desk.ask("ask", { asks, file: live.case, beside: folder.beside(of), body }));
}

async function moment(id: string, checkpoint: number | null): Promise<kept.Kept> {
  const { status, bytes } = await stringOf(id).desk.ask("keep", { asks: "keep", body: { checkpoint } });
  if (status !== 200) said({ status, bytes });
  const known = said<Omit<kept.Kept, "bytes">>(await quick.ask("kept", {}, bytes));
  return { ...known, name: String(Date.now()), modified_ms: Date.now(), bytes };
}

const go = ({ case: of, text, bytes }: kept.Kept): Promise<{ id: string }> => begin({ asks: "begin", file: of, beside: folder.beside(text) }, of, bytes);

export const branch = async (id: string, checkpoint: number | null): Promise<{ id: string }> => go(await moment(id, checkpoint));

export async function keep(id: string, checkpoint: number | null): Promise<{ name: string }> {
  const of = await moment(id, checkpoint);
  await kept.put(of);
  return { name: of.name };
}

export const goOn = async (name: string): Promise<{ id: string }> => go(await kept.get(name));

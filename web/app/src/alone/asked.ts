// Requests of the page without a server: engines in workers answer them.

import { ApiError, type Method } from "../api/client";
import type { request as Served } from "../served/asked";
import * as cases from "./cases";
import { Desk } from "./desk";
import * as moments from "./kept";
import * as strings from "./strings";

export { lineTo } from "./strings";

/** Workers for tasks of seconds: soft and stiff string are solved in parallel, so that neither waits for the other. */
const solvers = { soft: new Desk(), other: new Desk() };

/** Body of a request about a case. */
type OfCase = { text: string; revision: string; file_name: string; models?: string[] };

async function ofCase(method: Method, id: string, action: string, body: OfCase, query: URLSearchParams, signal?: AbortSignal): Promise<unknown> {
  switch (`${method} ${action}`) {
    case "GET ":
      return cases.open(id);
    case "PUT ":
      return cases.save(id, body);
    case "DELETE ":
      return cases.remove(id, query.get("revision") ?? "");
    case "POST rename":
      return cases.rename(id, body.file_name);
    case "POST copy":
      return cases.copy(id, body.file_name);
    case "PUT draft":
      return cases.keepDraft(id, body);
    case "DELETE draft":
      return cases.discardDraft(id);
    case "POST check":
      return cases.ofText("check", id, body, cases.quick, signal);
    case "POST edit":
      return cases.engine("edit", body);
    case "POST apply":
      return cases.ofText("apply", id, body);
    case "POST answer":
      return cases.ofText("answer", id, body, body.models?.join() === "soft" ? solvers.soft : solvers.other, signal);
    case "POST broomstick":
    case "POST assembly":
      return cases.ofText(action, id, body, solvers.other, signal);
    default:
      return nothing();
  }
}

async function ofString(method: Method, id: string, action: string, body: { checkpoint: number | null }): Promise<unknown> {
  switch (`${method} ${action}`) {
    case "GET ":
      return strings.ask(id, "layout");
    case "DELETE ":
      return strings.end(id);
    case "GET recording":
      return strings.ask(id, "recording");
    case "POST rewind":
    case "POST schedule":
      return strings.ask(id, action, body);
    case "POST branch":
      return strings.branch(id, body.checkpoint);
    case "POST keep":
      return strings.keep(id, body.checkpoint);
    default:
      return nothing();
  }
}

function nothing(): never {
  throw new ApiError(404, "not_found", "This requires the wholestring program: the browser version cannot do it.");
}

async function answer(method: Method, path: string, body: unknown, signal?: AbortSignal): Promise<unknown> {
  const { pathname, searchParams } = new URL(path, "http://here");
  const [noun = "", id = "", action = ""] = pathname.slice(1).split("/").map(decodeURIComponent);
  if (id !== "" && noun === "cases") return ofCase(method, id, action, body as OfCase, searchParams, signal);
  if (id !== "" && noun === "live") return ofString(method, id, action, body as { checkpoint: number | null });
  switch (`${method} ${noun}${id === "" ? "" : "/"}`) {
    case "GET session":
      return { ...(await cases.engine<{ version: string }>("program")), folder_name: "in this browser only" };
    case "GET schema":
    case "GET units":
    case "GET examples":
      return cases.engine(noun);
    case "GET examples/":
      return cases.engine("example", { name: id });
    case "GET catalogue":
      return cases.engine(noun, { word: searchParams.get("word") ?? "" }, cases.quick, signal);
    case "POST survey":
      return cases.engine(noun, body as object);
    case "GET cases":
      return cases.list();
    case "POST cases":
      return cases.create(body as Parameters<typeof cases.create>[0]);
    case "GET live":
      return strings.list();
    case "POST live":
      return strings.beginNew(body as { case: string; text: string });
    case "GET kept-strings":
      return moments.all();
    case "POST kept-strings/":
      return strings.goOn(id);
    case "DELETE kept-strings/":
      return moments.remove(id);
    default:
      return nothing();
  }
}

/** Sends a request to the engine, in the form of a request to the server. */
export const request: typeof Served = async <T>(method: Method, path: string, body?: unknown, signal?: AbortSignal): Promise<T> => {
  signal?.throwIfAborted();
  return (await answer(method, path, body, signal)) as T;
};


import { request } from "#asked";
import type { Session } from "./types";

export const session = (): Promise<Session> => request("GET", "/session");

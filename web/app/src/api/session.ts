import { request } from "./client";

export interface Session {
  version: string;
  folder_name: string;
}

export const session = (): Promise<Session> => request("GET", "/session");

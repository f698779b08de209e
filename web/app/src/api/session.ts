import { request } from "#asked";

export interface Session {
  version: string;
  folder_name: string;
}

export const session = (): Promise<Session> => request("GET", "/session");

// Moments of live strings that are kept in this browser, to be continued.

import { ApiError } from "../api/client";
import type { KeptString } from "../api/live";

/** A moment as it is kept: what a list says of it, its text, and the bytes that the engine made of it. */
export interface Kept extends KeptString {
  text: string;
  bytes: ArrayBuffer;
}

const STORE = "strings";

function opened(): Promise<IDBDatabase> {
  return new Promise((found, lost) => {
    const asked = indexedDB.open("wholestring", 1);
    asked.onupgradeneeded = () => asked.result.createObjectStore(STORE, { keyPath: "name" });
    asked.onsuccess = () => found(asked.result);
    asked.onerror = () => lost(new ApiError(507, "full", "This browser keeps no strings."));
  });
}

async function done<T>(mode: IDBTransactionMode, of: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const base = await opened();
  try {
    return await new Promise<T>((found, lost) => {
      const asked = of(base.transaction(STORE, mode).objectStore(STORE));
      asked.onsuccess = () => found(asked.result);
      asked.onerror = () => lost(new ApiError(507, "full", "This browser keeps no more strings."));
    });
  } finally {
    base.close();
  }
}

/** Those that are kept, the latest first. */
export async function all(): Promise<KeptString[]> {
  const found = await done<Kept[]>("readonly", (store) => store.getAll() as IDBRequest<Kept[]>);
  return found.sort((a, b) => b.modified_ms - a.modified_ms);
}

export async function get(name: string): Promise<Kept> {
  const found = await done("readonly", (store) => store.get(name) as IDBRequest<Kept | undefined>);
  if (!found) throw new ApiError(404, "not_found", "there is no such kept string");
  return found;
}

export const put = (of: Kept): Promise<IDBValidKey> => done("readwrite", (store) => store.put(of));
export const remove = (name: string): Promise<undefined> => done("readwrite", (store) => store.delete(name));

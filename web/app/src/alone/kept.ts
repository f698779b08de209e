// Checkpoints of live strings, stored in this browser to be continued.

import { ApiError } from "../api/client";
import type { KeptString } from "../api/live";

/** A stored checkpoint: its entry in lists, the text of the case, and the bytes of the engine. */
export interface Kept extends KeptString {
  text: string;
  bytes: ArrayBuffer;
}

const STORE = "strings";

function opened(): Promise<IDBDatabase> {
  return new Promise((found, lost) => {
    const opening = indexedDB.open("wholestring", 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore(STORE, { keyPath: "name" });
    opening.onsuccess = () => found(opening.result);
    opening.onerror = () => lost(new ApiError(507, "full", "This browser cannot store strings."));
  });
}

async function done<T>(mode: IDBTransactionMode, makeRequest: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const base = await opened();
  try {
    return await new Promise<T>((found, lost) => {
      const pending = makeRequest(base.transaction(STORE, mode).objectStore(STORE));
      pending.onsuccess = () => found(pending.result);
      pending.onerror = () => lost(new ApiError(507, "full", "The storage of this browser is full: no more strings can be kept."));
    });
  } finally {
    base.close();
  }
}

/** All stored checkpoints, the latest first. */
export async function all(): Promise<KeptString[]> {
  const found = await done<Kept[]>("readonly", (store) => store.getAll() as IDBRequest<Kept[]>);
  return found.sort((a, b) => b.modified_ms - a.modified_ms);
}

export async function get(name: string): Promise<Kept> {
  const found = await done("readonly", (store) => store.get(name) as IDBRequest<Kept | undefined>);
  if (!found) throw new ApiError(404, "not_found", "there is no such kept string");
  return found;
}

export const put = (moment: Kept): Promise<IDBValidKey> => done("readwrite", (store) => store.put(moment));
export const remove = (name: string): Promise<undefined> => done("readwrite", (store) => store.delete(name));

// A connection to a live string: text and bytes are received, text is sent. A WebSocket is one.

export interface Line {
  onopen: ((event: Event) => void) | null;
  onmessage: ((event: MessageEvent<string | ArrayBuffer>) => void) | null;
  onclose: ((event: CloseEvent) => void) | null;
  /** 1 while it is open. */
  readonly readyState: number;
  send(text: string): void;
  close(): void;
}

/** The state of an open connection. */
export const OPEN = 1;

// Whether the page is being printed, on a light background and with its own width.

let printing = false;

addEventListener("beforeprint", () => (printing = true));
addEventListener("afterprint", () => (printing = false));

/** Whether the current drawing is for print. */
export const isPrinting = (): boolean => printing;

// Whether the page is on its way to paper, which is light and of a width of its own.

let printing = false;

addEventListener("beforeprint", () => (printing = true));
addEventListener("afterprint", () => (printing = false));

/** Whether what is drawn now goes to paper. */
export const isPrinting = (): boolean => printing;

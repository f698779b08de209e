declare module "virtual:palette.css";

/** Whether this page has no server, and an engine of its own. */
declare const __ALONE__: boolean;

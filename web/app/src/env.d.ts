/** Whether this page has an engine of its own instead of a server. */
declare const __ALONE__: boolean;

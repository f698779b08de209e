// Creation of elements. Text is always set as text, so that no name in a report is parsed as HTML.

const SVG = "http://www.w3.org/2000/svg";

/** Listener of an event; the attribute name has its kind: `onclick`. */
export type Listener = (event: never) => void;
/** Value of an attribute: null or undefined omits it, true sets it without a value. */
export type Attributes = Readonly<Record<string, string | number | boolean | null | undefined | Listener>>;
export type Child = Node | string | number | false | null | undefined | readonly Child[];

function append(element: Element, child: Child): void {
  if (child === null || child === undefined || child === false) return;
  if (typeof child === "string" || typeof child === "number") element.append(String(child));
  else if (child instanceof Node) element.append(child);
  else for (const one of child) append(element, one);
}

function filled<E extends HTMLElement | SVGElement>(element: E, attributes: Attributes, children: readonly Child[]): E {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(name.slice(2), value as EventListener);
    // As an attribute it would be refused under a policy that forbids inline styles.
    else if (name === "style") element.style.cssText = String(value);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  append(element, children);
  return element;
}

export function el<K extends keyof HTMLElementTagNameMap>(
  name: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  return filled(document.createElement(name), attributes, children);
}

export function svg<K extends keyof SVGElementTagNameMap>(
  name: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  return filled(document.createElementNS(SVG, name), attributes, children);
}

/** A choice among a few buttons: value, text of the button, and its accessible label if different. */
export function choice(
  label: string,
  options: readonly (readonly [value: string, text: Child, label?: string | null])[],
  chosen: string | null,
  choose: (value: string) => void,
): HTMLDivElement {
  const buttons: HTMLButtonElement[] = options.map(([value, text, label]) => {
    const button = el("button", { type: "button", "aria-pressed": String(value === chosen), "data-value": value, "aria-label": label, title: label }, text);
    button.addEventListener("click", () => {
      for (const other of buttons) other.setAttribute("aria-pressed", String(other === button));
      choose(value);
    });
    return button;
  });
  return el("div", { class: "choice", role: "group", "aria-label": label }, buttons);
}

/** A drop-down list. */
export function select(
  label: string,
  options: readonly (readonly [value: string, text: string])[],
  chosen: string | null,
  choose: (value: string) => void,
): HTMLLabelElement {
  const list = el(
    "select",
    {},
    options.map(([value, text]) => el("option", { value, selected: value === chosen }, text)),
  );
  list.addEventListener("change", () => choose(list.value));
  return el("label", { class: "select" }, label, list);
}

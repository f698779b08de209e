// Actions of the tests of the editor.
import { check, until } from "./harness.mjs";

/** The displayed text of the TOML editor; the whole text if it is short. */
export const tomlText = (page) =>
  page.evaluate(() => {
    // The editor is fetched when first displayed.
    const lines = document.querySelector(".panel .text")?.shadowRoot.querySelectorAll(".cm-line") ?? [];
    return [...lines].map((line) => line.textContent).join("\n");
  });

/** Waits until the TOML contains a text. */
export const untilToml = (page, words, sentence) => until(async () => (await tomlText(page)).includes(words), sentence ?? `the text holds ${words}`);

/** Opens a case of the list, with its text. */
export async function openCase(page, name) {
  await page.getByRole("link", { name, exact: true }).first().click();
  await showText(page);
}

/** Shows the text of the open case. */
export async function showText(page) {
  await page.waitForSelector(".editor");
  await page.getByRole("button", { name: "TOML", exact: true }).click();
  await page.waitForSelector(".editor .cm-content");
}

/** Shows a section of the case. */
export async function section(page, title) {
  await page.getByRole("navigation", { name: "Sections of the case" }).getByRole("button", { name: title, exact: true }).click();
  await page.getByRole("heading", { level: 2, name: title, exact: true }).waitFor();
}

/** The text of a cell of a grid, counted from 1 as the page numbers rows. */
export const cell = (page, grid, row, column) =>
  page.getByRole("grid", { name: grid }).locator(`[aria-rowindex="${row + 1}"] [aria-colindex="${column + 1}"]`);

export const cellText = async (page, grid, row, column) => (await cell(page, grid, row, column).innerText()).trim();

/** Waits until a cell shows a text. */
export const untilCell = (page, grid, row, column, text) =>
  until(async () => (await cellText(page, grid, row, column)) === text, `row ${row}, column ${column} of ${grid} shows ${text}`);

/** Puts a text into the clipboard. */
export const toClipboard = (page, text) => page.evaluate((text) => navigator.clipboard.writeText(text), text);
export const fromClipboard = (page) => page.evaluate(() => navigator.clipboard.readText());

/** Fails if the page has logged complaints. */
export const quiet = (page) => check(page.complaints.length === 0, `the page complains: ${page.complaints.join("; ")}`);

// Actions of the tests of the driller's seat.
import { readFileSync } from "node:fs";

// Chromium treats a page from a folder as cross-origin, and would not let it open a socket to the server.
export const FLAGS = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-features=LocalNetworkAccessChecks"];

/** The id of the only case. */
export async function caseId(page) {
  return page.evaluate(async () => (await (await fetch("/api/cases")).json())[0].id);
}

/** Goes to the seat of the only case; begins its string if none is live. */
export async function sit(page, begins = true) {
  const id = await caseId(page);
  await page.evaluate((id) => (location.hash = `#/seat/${id}`), id);
  if (begins) {
    await page.getByRole("button", { name: /^Begin/ }).first().click();
  }
  await page.getByRole("button", { name: "Run", exact: true }).or(page.getByRole("button", { name: "Pause" })).waitFor({ timeout: 60_000 });
  return id;
}

export const time = async (page) => Number(await page.locator(".clock").getAttribute("data-time"));
export const runs = (page) => page.getByRole("button", { name: "Run", exact: true }).click();
export const pause = async (page) => {
  await page.getByRole("button", { name: "Pause" }).click();
  await page.getByRole("button", { name: "Run", exact: true }).waitFor();
};
export const knob = (page, name) => page.getByRole("slider", { name });
export const pace = (page, name) => page.getByRole("group", { name: "Pace" }).getByRole("button", { name, exact: true }).click();

/** Data of the strip charts from the CSV download of the page: rows by the names of the columns. */
export async function strips(page) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "CSV" }).click()]);
  const [head, ...lines] = readFileSync(await download.path(), "utf8").trim().split("\n");
  const names = head.split(",");
  return lines.map((line) => Object.fromEntries(line.split(",").map((value, k) => [names[k], value === "" ? NaN : Number(value)])));
}

// A new case from a survey: the commented example with the stations and depths of the survey.

import { checkCase, createCase, deleteCase, editCase, readCase, readExample, saveCase, type Change, type PastedSurvey } from "../api/cases";
import { readSchema } from "../api/lookup";
import { kindOf, type Scalar } from "../case/kinds";
import { asList, asTable, at } from "../case/values";
import { intoCase, stationRows } from "../case/well/survey";

/** Depth of the casing in the example, m, and the largest part of a shorter well that is cased. */
const CASED_M = 900;
const CASED_PART = 0.5;

const metres = (md_m: number): string => `${Number(md_m.toFixed(3))} m`;

async function cells(): Promise<Scalar[]> {
  const kind = kindOf((await readSchema()).properties?.well?.properties?.stations ?? {});
  return kind.is === "rows" ? kind.cells : [];
}

/** Creates a case file with this survey; returns its id. */
export async function caseOfSurvey(fileName: string, survey: PastedSurvey): Promise<string> {
  const example = await readExample("my-well");
  const { id } = await createCase(fileName, example.text, example.beside);
  try {
    const { values } = await checkCase(id, example.text);
    const case_ = asTable(values ?? undefined);
    const last_m = survey.stations.md_m.at(-1) ?? 0;
    const holes = asList(at(case_, "well.hole")).length;
    const cased_m = Math.min(CASED_M, CASED_PART * last_m);
    const changes: Change[] = [
      { set: "name", to: fileName.replace(/\.toml$/i, "") },
      ...intoCase(case_, stationRows(survey.stations, await cells()), survey.tie_in),
      { set: "well.hole.0.to", to: metres(holes > 1 ? cased_m : last_m) },
      ...(holes > 1 ? [{ set: `well.hole.${holes - 1}.to`, to: metres(last_m) }] : []),
      { set: "operation.bit_depth", to: metres(last_m) },
    ];
    const { text } = await editCase(id, example.text, changes);
    await saveCase(id, text, (await readCase(id)).revision);
    return id;
  } catch (problem) {
    // A case with the survey of the example would be mistaken for that of the reader.
    await readCase(id).then(({ revision }) => deleteCase(id, revision), () => undefined);
    throw problem;
  }
}

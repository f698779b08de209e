// The page of a run, of a bit test, or of an assembly at rest.

import "./style.css";
import { bhaPage } from "./bha.js";
import { bitTestPage } from "./bit_test.js";
import { readReport } from "./data.js";
import { runPage } from "./run.js";
import { useDimensions } from "./units.js";

const report = readReport();
useDimensions(report.dimensions, report.units);
const shows = report.sweeps ? bhaPage : report.bottoms ? bitTestPage : runPage;
shows(report);
document.documentElement.dataset.ready = "";

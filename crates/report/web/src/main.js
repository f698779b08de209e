// The page of a run, or of a bit test.

import "./style.css";
import { bitTestPage } from "./bit_test.js";
import { readReport } from "./data.js";
import { runPage } from "./run.js";
import { useDimensions } from "./units.js";

const report = readReport();
useDimensions(report.dimensions, report.units);
(report.bottoms ? bitTestPage : runPage)(report);
document.documentElement.dataset.ready = "";

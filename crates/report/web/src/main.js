// The page of a run, of a bit test, or of a static BHA analysis.

import "../../../../web/components/drawings.css";
import "./style.css";
import { bhaPage } from "./bha.js";
import { bitTestPage } from "./bit_test.js";
import { readReport } from "./data.js";
import { runPage } from "./run.js";
import { usePageUnits } from "./page_units.js";

const report = readReport();
usePageUnits(report.dimensions, report.units);
const shows = report.sweeps ? bhaPage : report.bottoms ? bitTestPage : runPage;
shows(report);
document.documentElement.dataset.ready = "";

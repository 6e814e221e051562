// SPDX-License-Identifier: MIT
// Brings the page to life. All that it says is there without this script, but for the 3D views.
import plotStyle from "uplot/dist/uPlot.min.css";
import { showAlign } from "./align_page";
import { readReport } from "./data";
import { element } from "./dom";
import { showExperiment } from "./experiment_page";
import { showOdometry } from "./odometry_page";

const report = readReport();
document.head.append(element("style", "", plotStyle));
document.documentElement.classList.add("live");
const stage = document.getElementById("stage") ?? document.body;
if (report.align) showAlign(report.align, report.charts, stage);
else if (report.odometry) showOdometry(report.odometry, report.charts, stage);
else showExperiment(report.charts);

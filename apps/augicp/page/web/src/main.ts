// SPDX-License-Identifier: MIT
// Brings the page to life. All that it says is there without this script, but for the 3D views.
import plotStyle from "uplot/dist/uPlot.min.css";
import { showAlign } from "./align_page";
import { readReport } from "./data";
import { element } from "./dom";
import { showExperiment } from "./experiment_page";
import { noView } from "./missing";
import { showOdometry } from "./odometry_page";
import { showTrajectories } from "./trajectories_page";

async function start(stage: HTMLElement): Promise<void> {
  const report = readReport();
  document.head.append(element("style", "", plotStyle));
  document.documentElement.classList.add("live");
  if (report.align) await showAlign(report.align, report.charts, stage);
  else if (report.odometry) await showOdometry(report.odometry, report.charts, stage);
  else if (report.trajectories) await showTrajectories(report.trajectories, report.charts, stage);
  else showExperiment(report.charts);
}

const stage = document.getElementById("stage") ?? document.body;
void start(stage)
  .catch((reason: unknown) => { stage.append(noView("The page cannot be shown whole", reason)); })
  .finally(() => { document.documentElement.classList.add("ready"); });

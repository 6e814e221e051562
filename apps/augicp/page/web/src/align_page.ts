// SPDX-License-Identifier: MIT
// Two clouds, before, between and after.
import { makeCharts } from "./chart";
import { CloudPoints, Colouring } from "./cloud_points";
import { type AlignData, type ChartData, isFinitePose } from "./data";
import { directionLines } from "./direction_lines";
import { button, element, select, toggle } from "./dom";
import { freeArrows } from "./free_arrows";
import { PairLines } from "./pair_lines";
import { makeSteps } from "./steps";
import { Survey } from "./survey";
import { Viewer } from "./stage/viewer";

const kIdentity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

class AlignScene {
  readonly viewer: Viewer;
  private readonly survey: Survey;
  private readonly source: CloudPoints;
  private readonly target: CloudPoints;
  private readonly pairs: PairLines;
  private readonly arrows;
  private readonly sourceDirections;
  private readonly targetDirections;
  private readonly colouring = { residual: false, structure: false };

  constructor(private readonly align: AlignData) {
    this.survey = new Survey(align);
    this.viewer = new Viewer("Both clouds in 3D: arrow keys rotate, with Shift they move, + and - zoom, 0 shows all", this.survey.home(0));
    this.source = new CloudPoints(align.source, "--source", align.extent, align.residual_scale);
    this.target = new CloudPoints(align.target, "--target", align.extent, align.residual_scale);
    this.pairs = new PairLines(align.source);
    this.arrows = freeArrows(align.free_motions, 0.5 * align.extent);
    this.sourceDirections = directionLines(align.source, align.direction_length);
    this.targetDirections = directionLines(align.target, align.direction_length);
    this.viewer.scene.add(this.target, this.source, this.pairs, this.targetDirections, this.sourceDirections, this.arrows);
  }

  showStep(step: number): void {
    const given = this.align.poses[step];
    const pose = isFinitePose(given) ? given : kIdentity;
    this.source.pose = pose;
    this.pairs.pose = pose;
    this.sourceDirections.matrix.fromArray(pose);
    this.sourceDirections.matrixWorldNeedsUpdate = true;
    this.viewer.invalidate();
  }

  toggles(): HTMLElement {
    const row = element("div", "toggles");
    const add = (text: string, title: string, pressed: boolean, change: (on: boolean) => void): void => {
      row.append(toggle(text, title, pressed, (on) => { change(on); this.viewer.invalidate(); }));
    };
    add("Target", "The fixed cloud", true, (on) => { this.target.visible = on; });
    add("Source", "The moving cloud", true, (on) => { this.source.visible = on; });
    add("Pairs", "Lines from source points to their partners under the final pose", false, (on) => { this.pairs.visible = on; });
    add("Residuals", "Source points by the distance to their final partner", false, (on) => { this.colouring.residual = on; this.recolour(); });
    add("Normals, tangents", "Directions of some points", false, (on) => { this.sourceDirections.visible = this.targetDirections.visible = on; });
    add("Structure", "Planar, edge or none", false, (on) => { this.colouring.structure = on; this.recolour(); });
    if (this.arrows.children.length > 0)
      add("Free motions", "What the data leave open", true, (on) => { this.arrows.visible = on; });
    add("Grid", "Lines on the ground", true, (on) => { this.viewer.showGround(on); });
    const up = select("Up", "Which way is up", this.survey.upwards.map(({ name }) => name), (index) => { this.viewer.setHome(this.survey.home(index)); });
    row.append(up, button("Fit", "Show all (0, or a double click)", () => { this.viewer.reset(); }));
    return row;
  }

  private recolour(): void {
    const plain = this.colouring.structure ? Colouring.Structure : Colouring.Plain;
    this.target.colouring = plain;
    this.source.colouring = this.colouring.residual ? Colouring.Residual : plain;
    const legend = document.getElementById("view-legend");
    legend?.replaceChildren(...this.legend());
  }

  private legend(): HTMLElement[] {
    const item = (name: string, text: string): HTMLElement => {
      const made = element("span", "", text);
      made.prepend(element("i", name));
      return made;
    };
    const { residual, structure } = this.colouring;
    const scale = `${Number(this.align.residual_scale.toPrecision(2))} m and more to the partner`;
    const residuals = [item("ramp", `0 to ${scale}`), item("none", "no partner")];
    const structures = [item("planar", "planar"), item("edge", "edge"), item("none", "none")];
    if (structure) return residual ? [...residuals, ...structures.slice(0, 2)] : structures;
    return residual ? [item("target", "target"), ...residuals] : [item("target", "target"), item("source", "source")];
  }
}

function addCopyButton(): void {
  const matrix = document.getElementById("matrix");
  if (!matrix) return;
  const copy = element("button", "copy", "Copy");
  copy.type = "button";
  copy.addEventListener("click", () => {
    const select = (): void => { getSelection()?.selectAllChildren(matrix); copy.textContent = "Selected"; };
    const { clipboard } = navigator as Partial<Navigator>; // only where the browser trusts the page
    if (clipboard) clipboard.writeText(matrix.textContent).then(() => { copy.textContent = "Copied"; }, select);
    else select();
  });
  const line = element("div", "with-copy");
  matrix.before(line);
  line.append(...[matrix.parentElement?.querySelector("p")].filter((part) => part instanceof HTMLElement), copy);
}

export function showAlign(align: AlignData, charts: ChartData[], stage: HTMLElement): void {
  addCopyButton();
  const live = makeCharts(charts, (x) => { steps.show(x); });
  const legend = element("div", "view-legend");
  legend.id = "view-legend";
  stage.append(legend);
  let scene: AlignScene | null = null;
  try {
    scene = new AlignScene(align);
    stage.prepend(scene.viewer.element);
    stage.append(scene.toggles());
  } catch {
    stage.prepend(element("p", "notice", "This browser has no WebGL: the clouds cannot be drawn."));
  }
  const steps = makeSteps(align.poses.length, "Iteration", align.step_texts, (step) => {
    scene?.showStep(step);
    for (const chart of live) chart.mark(step);
  });
  legend.after(steps.element);
  steps.show(align.poses.length - 1);
}

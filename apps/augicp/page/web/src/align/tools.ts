// SPDX-License-Identifier: MIT
// The tools of the view, their state, and the address that keeps it.
import { button, element, select, toggle } from "../dom";
import type { Steps } from "../steps";
import { keepLink, numbersOf, numbersText, readLink, restoreCamera } from "../tools/link";
import { pictureTools } from "../tools/picture_tools";
import { pointSize } from "../tools/point_size";
import { Probe } from "../tools/probe";
import { Section } from "../tools/section";
import type { ModeName } from "../colour/modes";
import type { Colours } from "./colours";
import { layerToggles } from "./layers";
import type { AlignScene } from "./scene";

// The guess on the left, the step that is shown on the right.
function sideBySide(scene: AlignScene): HTMLButtonElement {
  return toggle("Before and after", "The guess on the left, the iteration shown on the right", false, (on) => {
    scene.viewer.panes = on ? [() => { scene.showPose(scene.poseAt(0)); }, () => { scene.showPose(scene.pose); }] : [];
  });
}

export class AlignTools {
  readonly element = element("div", "tools");
  private readonly section: Section;

  constructor(private readonly scene: AlignScene, private readonly colours: Colours, stage: HTMLElement) {
    const { survey, viewer } = scene;
    this.section = new Section(scene, survey.home(0).points);
    viewer.element.append(new Probe(scene, this.section).element);
    const up = select("Up", "Which way is up", survey.upwards.map(({ name }) => name), (index) => { this.setUp(index); });
    const layers = layerToggles(scene);
    layers.append(sideBySide(scene));
    const view = element("div", "toggles");
    view.append(colours.chooser, pointSize((factor) => { scene.sizeFactor = factor; }), up, button("Fit", "Show all (0, or a double click)", () => { viewer.reset(); }), ...pictureTools(viewer, stage, "alignment.png"));
    this.element.append(layers, view, this.section.element);
    this.setUp(0);
  }

  // From the page's address, and from now on into it.
  follow(steps: Steps): void {
    const { viewer, data } = this.scene;
    const link = readLink();
    const step = numbersOf(link["step"], 1);
    if (step) steps.show(step[0] ?? 0);
    if (link["colour"] !== undefined) this.colours.show(link["colour"] as ModeName, numbersOf(link["range"], 2) as [number, number] | null);
    this.section.state = numbersOf(link["section"], 6);
    restoreCamera(viewer, link["camera"]);
    viewer.onDraw = keepLink(viewer, () => {
      const { mode, range } = this.colours.state;
      const section = this.section.state;
      return {
        step: steps.step === data.poses.length - 1 ? "" : String(steps.step),
        colour: mode === "cloud" ? "" : mode,
        range: range && mode !== "cloud" && mode !== "structure" ? numbersText(range) : "",
        section: section ? numbersText(section) : "",
      };
    });
  }

  private setUp(index: number): void {
    const home = this.scene.survey.home(index);
    this.scene.viewer.setHome(home);
    this.colours.setUp(home.up);
  }
}

// SPDX-License-Identifier: MIT
// The axes of the target's frame in a corner, as the camera sees them. A click on an end looks along that axis.
import { type Camera, Vector3 } from "three";
import { element } from "../dom";

const kSvg = "http://www.w3.org/2000/svg";
const kSize = 76;
const kReach = 25;
const kNames = ["x", "y", "z"] as const;

function svgElement<Name extends keyof SVGElementTagNameMap>(name: Name, attributes: Record<string, string>): SVGElementTagNameMap[Name] {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

interface Arm {
  group: SVGGElement;
  line: SVGLineElement;
  disc: SVGCircleElement;
  text: SVGTextElement;
  axis: Vector3;
}

function armOf(axis: number, onPick: (direction: Vector3) => void): Arm {
  const name = kNames[axis] ?? "x";
  const group = svgElement("g", { class: `axis ${name}`, role: "button", "aria-label": `Look along the ${name} axis`, tabindex: "0" });
  const text = svgElement("text", { "text-anchor": "middle", "dominant-baseline": "central" });
  text.textContent = name;
  const arm = { group, line: svgElement("line", {}), disc: svgElement("circle", { r: "8" }), text, axis: new Vector3().setComponent(axis, 1) };
  group.append(arm.line, arm.disc, text);
  const pick = (): void => { onPick(arm.axis); };
  group.addEventListener("click", pick);
  group.addEventListener("keydown", (event) => { if (event.key === "Enter") pick(); });
  return arm;
}

export class AxesGizmo {
  readonly element = element("div", "gizmo");
  private readonly arms: Arm[];
  private readonly svg = svgElement("svg", { viewBox: `${-kSize / 2} ${-kSize / 2} ${kSize} ${kSize}`, width: String(kSize), height: String(kSize) });

  // onPick: with the direction from what is seen to the eye.
  constructor(onPick: (toEye: Vector3) => void) {
    this.element.title = "Axes of the target's frame; click one to look along it";
    this.arms = [0, 1, 2].map((axis) => armOf(axis, onPick));
    this.element.append(this.svg);
  }

  update(camera: Camera): void {
    const inView = (axis: Vector3): Vector3 => axis.clone().transformDirection(camera.matrixWorldInverse);
    const seen = this.arms.map((arm) => ({ arm, end: inView(arm.axis) })).sort((one, other) => one.end.z - other.end.z);
    for (const { arm, end } of seen) {
      const [x, y] = [String(kReach * end.x), String(-kReach * end.y)];
      arm.line.setAttribute("x2", x);
      arm.line.setAttribute("y2", y);
      for (const [part, across, down] of [[arm.disc, "cx", "cy"], [arm.text, "x", "y"]] as const) {
        part.setAttribute(across, x);
        part.setAttribute(down, y);
      }
    }
    this.svg.replaceChildren(...seen.map(({ arm }) => arm.group));
  }
}

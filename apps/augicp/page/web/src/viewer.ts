// SPDX-License-Identifier: MIT
// A 3D view that draws when something changed, and not otherwise.
import { Color, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { ViewData } from "./data";
import { cssColour, element, onColourScheme } from "./dom";

const kTurn_rad = 0.06;
const kView_deg = 50;

export class Viewer {
  readonly scene = new Scene();
  readonly element = element("div", "view");
  private readonly camera = new PerspectiveCamera(kView_deg, 1, 0.01, 1000);
  private readonly renderer = new WebGLRenderer({ antialias: true });
  private controls: OrbitControls;
  private isWaiting = false;

  // Throws where the browser has no WebGL.
  constructor(label: string, extent: number, view: ViewData) {
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute("aria-label", label);
    canvas.setAttribute("role", "img");
    this.element.append(canvas);
    this.camera.near = extent / 1000;
    this.camera.far = extent * 100;
    this.controls = this.controlsFor(view);
    canvas.addEventListener("keydown", (event) => { this.onKey(event); });
    new ResizeObserver(() => { this.resize(); }).observe(this.element);
    this.recolour();
    onColourScheme(() => { this.recolour(); });
  }

  lookFrom(view: ViewData): void {
    this.controls.dispose();
    this.controls = this.controlsFor(view);
    this.invalidate();
  }

  // Draws in the next frame, once, however often it is called before.
  invalidate(): void {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(this.draw);
  }

  private readonly draw = (): void => {
    this.isWaiting = false;
    this.renderer.render(this.scene, this.camera);
  };

  // New ones for each view: they do not notice that up has become another direction.
  private controlsFor(view: ViewData): OrbitControls {
    this.camera.up.set(...view.up);
    this.camera.position.set(...view.eye);
    const controls = new OrbitControls(this.camera, this.renderer.domElement);
    controls.target.set(...view.target);
    controls.addEventListener("change", () => { this.invalidate(); });
    controls.update();
    return controls;
  }

  private recolour(): void {
    this.scene.background = new Color(cssColour("--scene"));
    this.invalidate();
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    // The same breadth on a narrow screen as on a square one.
    const half = Math.tan((kView_deg * Math.PI) / 360);
    this.camera.fov = (360 / Math.PI) * Math.atan(half / Math.min(1, this.camera.aspect));
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }

  private onKey(event: KeyboardEvent): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const side = new Vector3().crossVectors(this.camera.up, offset).normalize();
    const turns: Record<string, () => Vector3> = {
      ArrowLeft: () => offset.applyAxisAngle(this.camera.up, -kTurn_rad),
      ArrowRight: () => offset.applyAxisAngle(this.camera.up, kTurn_rad),
      ArrowUp: () => offset.applyAxisAngle(side, -kTurn_rad),
      ArrowDown: () => offset.applyAxisAngle(side, kTurn_rad),
      "+": () => offset.multiplyScalar(0.9),
      "-": () => offset.multiplyScalar(1.1),
    };
    const turn = turns[event.key];
    if (!turn) return;
    this.camera.position.copy(this.controls.target).add(turn());
    this.controls.update();
    event.preventDefault();
  }
}

// SPDX-License-Identifier: MIT
// A 3D view that draws when something changed, and not otherwise.
import { Color, PerspectiveCamera, Scene, Sphere, Vector3, WebGLRenderer } from "three";
import { cssColour, element, onColourScheme } from "../dom";
import { AxesGizmo } from "./axes_gizmo";
import { Detail } from "./detail";
import { fitted, type Look, type Opening } from "./framing";
import { type Ground, groundGrid } from "./ground_grid";
import { Orbit } from "./orbit";
import { ScaleBar } from "./scale_bar";

const kView_deg = 50;

// The first look, and the one after a double click: all points, seen from a direction.
export interface Home {
  points: Vector3[]; // in the page
  toEye: Vector3;
  up: Vector3;
}

export class Viewer {
  readonly scene = new Scene();
  readonly element = element("div", "view");
  readonly camera = new PerspectiveCamera(kView_deg, 1, 0.01, 1000);
  readonly renderer = new WebGLRenderer({ antialias: true });
  readonly canvas = this.renderer.domElement;
  private readonly orbit = new Orbit(this.camera, this.canvas, () => { this.isAtHome = false; this.invalidate(); }, () => { this.reset(); }, (isMoving) => { this.detail.moving = isMoving; this.invalidate(); });
  readonly detail = new Detail();
  private readonly gizmo = new AxesGizmo((toEye) => { this.lookAlong(toEye); });
  private readonly scaleBar = new ScaleBar();
  private readonly around = new Sphere();
  private ground: Ground | null = null;
  private prepare: readonly (() => void)[] = [];
  private isWaiting = false;
  private isAtHome = true;

  onDraw: () => void = () => undefined; // after each picture

  // Throws where the browser has no WebGL.
  constructor(label: string, private home: Home) {
    const { canvas } = this;
    canvas.tabIndex = 0;
    canvas.setAttribute("aria-label", label);
    canvas.setAttribute("role", "img");
    this.element.append(canvas, this.gizmo.element, this.scaleBar.element);
    this.orbit.guard(this.element);
    this.setHome(home);
    new ResizeObserver(() => { this.resize(); }).observe(this.element);
    this.recolour();
    onColourScheme(() => { this.recolour(); });
  }

  // The length of a cell of the ground's grid, metres.
  get cell(): number {
    return this.ground?.cell ?? 0;
  }

  get target(): Vector3 {
    return this.orbit.target;
  }

  setHome(home: Home): void {
    this.home = home;
    this.around.setFromPoints(home.points);
    const isShown = this.ground?.lines.visible ?? true;
    if (this.ground) this.scene.remove(this.ground.lines);
    this.ground = groundGrid(home.points, home.up);
    this.ground.lines.visible = isShown;
    this.scene.add(this.ground.lines);
    this.reset();
  }

  showGround(isShown: boolean): void {
    if (this.ground) this.ground.lines.visible = isShown;
    this.invalidate();
  }

  reset(): void {
    this.lookFrom(fitted(this.home.points, this.home.toEye, this.home.up, this.opening()));
    this.isAtHome = true;
  }

  // Fits the points, seen along an axis. A hint of the home's direction, so that straight down has an up in the picture.
  lookAlong(toEye: Vector3): void {
    const tilted = toEye.clone().normalize().addScaledVector(this.home.toEye, 1e-3);
    this.lookFrom(fitted(this.home.points, tilted, this.home.up, this.opening()));
  }

  lookFrom(look: Look): void {
    this.orbit.look(look);
    this.isAtHome = false;
    this.invalidate();
  }

  // Draws in the next frame, once, however often it is called before.
  invalidate(): void {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(this.draw);
  }

  // The picture as a file.
  png(): Promise<Blob | null> {
    this.draw(); // what was drawn before is gone
    return new Promise((done) => { this.canvas.toBlob(done, "image/png"); });
  }

  // At once, for who reads the canvas in the same moment.
  drawNow(): void {
    this.draw();
  }

  get isHome(): boolean {
    return this.isAtHome;
  }

  // Several pictures side by side, from the same eye: each function prepares one of them. None: one picture.
  set panes(prepare: readonly (() => void)[]) {
    this.prepare = prepare;
    this.element.classList.toggle("split", prepare.length > 1);
    this.adoptAspect();
  }

  get isSplit(): boolean {
    return this.prepare.length > 1;
  }

  get state(): Look {
    const { position: eye, up } = this.camera;
    return { eye: eye.clone(), target: this.target, up: up.clone() };
  }

  private render(): void {
    const { renderer, scene, camera } = this;
    const { clientWidth: width, clientHeight: height } = this.element;
    const count = Math.max(1, this.prepare.length);
    renderer.setScissorTest(count > 1);
    for (let i = 0; i < count; ++i) {
      this.prepare[i]?.();
      const [left, across] = [Math.round((i * width) / count), Math.round(width / count)];
      renderer.setViewport(left, 0, across, height);
      renderer.setScissor(left, 0, across, height);
      renderer.render(scene, camera);
    }
  }

  private readonly draw = (now_ms = performance.now()): void => {
    this.isWaiting = false;
    this.detail.adapt(now_ms);
    const { camera } = this;
    const distance = camera.position.distanceTo(this.around.center);
    const radius = Math.max(this.around.radius, 0.05 * distance);
    camera.near = Math.max(distance - 1.5 * radius, radius / 500);
    camera.far = distance + 4 * radius;
    camera.updateProjectionMatrix();
    this.render();
    this.onDraw();
    this.gizmo.update(camera);
    this.scaleBar.update(camera, this.target, this.element.clientHeight);
  };

  private opening(): Opening {
    const upwards = Math.tan((kView_deg * Math.PI) / 360);
    return { across: upwards * this.camera.aspect, upwards };
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
    this.adoptAspect();
  }

  private adoptAspect(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0) return;
    this.camera.aspect = width / height / Math.max(1, this.prepare.length);
    if (this.isAtHome) this.reset();
    this.invalidate();
  }
}

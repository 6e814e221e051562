// SPDX-License-Identifier: MIT
// Moves a camera by mouse, touch and keys. Until the picture has the focus, the wheel and a finger up or down scroll the page.
import { type PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { element } from "../dom";
import type { Look } from "./framing";

const kTurn_rad = 0.06;
const kShift = 0.05; // of the distance, a key
const kHint_ms = 1500;

export class Orbit {
  private controls: OrbitControls | null = null;
  private readonly hint = element("p", "wheel-hint", "Click the picture to zoom with the wheel");

  constructor(
    private readonly camera: PerspectiveCamera,
    private readonly canvas: HTMLCanvasElement,
    private readonly onChange: () => void,
    private readonly onReset: () => void,
    private readonly onMoving: (isMoving: boolean) => void, // while a button or a finger is down
  ) {
    this.hint.hidden = true;
    canvas.addEventListener("keydown", (event) => { this.onKey(event); });
    canvas.addEventListener("dblclick", onReset);
    for (const event of ["focus", "blur"]) canvas.addEventListener(event, () => { this.adoptTouch(); });
  }

  // The picture's holder, which sees the wheel before the picture does.
  guard(holder: HTMLElement): void {
    holder.append(this.hint);
    let timer = 0;
    holder.addEventListener("wheel", (event) => {
      if (document.activeElement === this.canvas || event.target !== this.canvas) return;
      event.stopPropagation();
      this.hint.hidden = false;
      window.clearTimeout(timer);
      timer = window.setTimeout(() => { this.hint.hidden = true; }, kHint_ms);
    }, { capture: true });
  }

  get target(): Vector3 {
    return this.controls?.target.clone() ?? new Vector3();
  }

  // New controls each time: they do not notice that up has become another direction.
  look({ eye, target, up }: Look): void {
    this.controls?.dispose();
    this.camera.up.copy(up);
    this.camera.position.copy(eye);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.target.copy(target);
    this.controls.update();
    this.controls.addEventListener("change", this.onChange);
    this.controls.addEventListener("start", () => { this.onMoving(true); });
    this.controls.addEventListener("end", () => { this.onMoving(false); });
    this.adoptTouch();
    this.onChange();
  }

  private adoptTouch(): void {
    this.canvas.style.touchAction = document.activeElement === this.canvas ? "none" : "pan-y";
  }

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "0") this.onReset();
    else if (!this.moved(event.key, event.shiftKey)) return;
    event.preventDefault();
  }

  // Whether the key is one that moves.
  private moved(key: string, isShift: boolean): boolean {
    const { controls, camera } = this;
    if (!controls) return false;
    const offset = camera.position.clone().sub(controls.target);
    const right = new Vector3().setFromMatrixColumn(camera.matrix, 0);
    const above = new Vector3().setFromMatrixColumn(camera.matrix, 1);
    const turn = (axis: Vector3, sign: number) => (): Vector3 => offset.applyAxisAngle(axis, sign * kTurn_rad);
    const shift = (axis: Vector3, sign: number) => (): Vector3 => {
      controls.target.addScaledVector(axis, sign * kShift * offset.length());
      return offset;
    };
    const arrows: Record<string, () => Vector3> = isShift
      ? { ArrowLeft: shift(right, -1), ArrowRight: shift(right, 1), ArrowUp: shift(above, 1), ArrowDown: shift(above, -1) }
      : { ArrowLeft: turn(camera.up, -1), ArrowRight: turn(camera.up, 1), ArrowUp: turn(right, -1), ArrowDown: turn(right, 1) };
    const move = { ...arrows, "+": () => offset.multiplyScalar(0.9), "-": () => offset.multiplyScalar(1 / 0.9) }[key];
    if (!move) return false;
    camera.position.copy(controls.target).add(move());
    controls.update();
    return true;
  }
}

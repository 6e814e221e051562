// SPDX-License-Identifier: MIT
// The choice of what colours show, its range, and the legend.
import { type DataTexture, Matrix4, Vector3 } from "three";
import type { CloudPoints } from "../cloud_points";
import { kModes, type Mode, type ModeName, type Range } from "../colour/modes";
import { type Palette, paletteTexture } from "../colour/palette";
import { RangeControl } from "../colour/range_control";
import { element, select } from "../dom";
import type { AlignScene } from "./scene";

const kMaxSamples = 20000;

export class Colours {
  readonly chooser: HTMLLabelElement;
  readonly legend = element("div", "view-legend");
  readonly range: RangeControl;
  private readonly modes: readonly Mode[];
  private readonly textures = new Map<Palette, DataTexture>();
  private readonly list: HTMLSelectElement;
  private chosen: Range | null = null;
  private up = new Vector3(0, 0, 1);
  private mode: Mode = kModes[0] as Mode;

  constructor(private readonly scene: AlignScene) {
    const hasIntensities = [scene.source, scene.target].some(({ cloud }) => cloud.intensities !== null);
    const hasColours = [scene.source, scene.target].some(({ cloud }) => cloud.colours !== null);
    this.modes = kModes.filter(({ name }) => (name !== "intensity" || hasIntensities) && (name !== "rgb" || hasColours));
    this.range = new RangeControl((range) => { this.setRange(range); });
    this.chooser = select("Colour", "What the colour of a point shows", this.modes.map(({ label }) => label), (index) => { this.show(this.modes[index]?.name ?? "cloud", null); });
    this.list = this.chooser.querySelector("select") as HTMLSelectElement;
    this.show("cloud", null);
  }

  get state(): { mode: ModeName; range: Range | null } {
    return { mode: this.mode.name, range: this.chosen };
  }

  // range: null for the one that suits the values.
  show(name: ModeName, range: Range | null): void {
    const index = Math.max(0, this.modes.findIndex((mode) => mode.name === name));
    this.mode = this.modes[index] ?? this.mode;
    this.list.selectedIndex = index;
    const { source, target } = this.scene;
    source.colour(this.mode.code, this.textureOf(this.mode.palette));
    target.colour(this.mode.code, this.textureOf(this.mode.palette));
    this.range.show(this.mode, this.values(), range);
    this.legend.replaceChildren(...this.items());
    this.scene.viewer.invalidate();
  }

  setUp(up: Vector3): void {
    this.up = up;
    this.scene.source.upwards = this.scene.target.upwards = up;
    if (this.mode.name === "height") this.show("height", null);
  }

  private setRange(range: Range): void {
    this.chosen = range;
    this.scene.source.range = this.scene.target.range = range;
    this.scene.viewer.invalidate();
  }

  private textureOf(palette: Palette | null): DataTexture | null {
    if (!palette) return null;
    const made = this.textures.get(palette) ?? paletteTexture(palette);
    this.textures.set(palette, made);
    return made;
  }

  // Of some points; the clouds' order spreads any beginning over the whole.
  private values(): number[] {
    const { source, target } = this.scene;
    const known = (values: Float32Array | null): number[] => [...(values ?? []).slice(0, kMaxSamples)].filter((value) => !Number.isNaN(value));
    if (this.mode.name === "distance") return known(source.cloud.distances);
    if (this.mode.name === "intensity") return [...known(source.cloud.intensities), ...known(target.cloud.intensities)];
    if (this.mode.name === "height") return [...this.heights(target, null), ...this.heights(source, this.scene.pose)];
    return [];
  }

  private heights({ cloud }: CloudPoints, pose: readonly number[] | null): number[] {
    const matrix = pose ? new Matrix4().fromArray(pose) : new Matrix4();
    const count = Math.min(cloud.count, kMaxSamples);
    return Array.from({ length: count }, (_, i) => new Vector3().fromArray(cloud.points, 3 * i).applyMatrix4(matrix).dot(this.up));
  }

  private items(): HTMLElement[] {
    const item = (name: string, text: string): HTMLElement => {
      const made = element("span", "", text);
      made.prepend(element("i", name));
      return made;
    };
    if (this.mode.name === "cloud") return [item("target", "target (fixed)"), item("source", "source (moving)")];
    if (this.mode.name === "structure") return [item("planar", "planar"), item("edge", "edge"), item("none", "none")];
    const title = element("span", "", this.mode.label);
    return this.mode.grey === "" ? [title] : [title, item("none", `grey: ${this.mode.grey}`)];
  }
}

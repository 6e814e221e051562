// SPDX-License-Identifier: MIT
// A cloud as points on the graphics card: colours, poses and cuts change by uniforms, nothing is made or copied while drawing.
import { BufferAttribute, BufferGeometry, Color, type DataTexture, Matrix4, Points, ShaderMaterial, type Texture, Vector2, Vector3 } from "three";
import type { Cloud } from "./cloud";
import { kFragmentShader, kVertexShader } from "./cloud_shader";
import { cssColour, onColourScheme } from "./dom";

// In place of a number that is not there: graphics cards need not know NaN.
const kFar = 1e15;
const kColours = ["planar", "edge", "none"] as const;

// A colour as it stands in the style sheet; the shader writes it to the screen as it is.
const raw = (name: string): Color => new Color().setStyle(cssColour(name), "srgb-linear");

const known = (values: Float32Array<ArrayBuffer> | null, count: number): Float32Array<ArrayBuffer> =>
  values ? values.map((value) => (Number.isNaN(value) ? kFar : value)) : new Float32Array(count).fill(kFar);

function geometryOf(cloud: Cloud): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(cloud.points, 3));
  geometry.setAttribute("direction", new BufferAttribute(cloud.directions, 3, true));
  geometry.setAttribute("structure", new BufferAttribute(cloud.structures, 1));
  geometry.setAttribute("intensity", new BufferAttribute(known(cloud.intensities, cloud.count), 1));
  geometry.setAttribute("rgb", new BufferAttribute(cloud.colours ?? new Uint8Array(3 * cloud.count), 3, true));
  geometry.setAttribute("offSurface", new BufferAttribute(known(cloud.distances, cloud.count), 1));
  geometry.setAttribute("offDirection", new BufferAttribute(cloud.distanceDirections ?? new Int8Array(3 * cloud.count), 3, true));
  return geometry;
}

export class CloudPoints extends Points<BufferGeometry, ShaderMaterial> {
  private readonly values;

  // plainColour: a CSS variable; extent: of what the points fill, metres.
  constructor(readonly cloud: Cloud, private readonly plainColour: string, extent: number) {
    const values = {
      colouring: { value: 0 },
      hasColours: { value: cloud.colours !== null },
      range: { value: new Vector2(0, 1) },
      palette: { value: null as Texture | null },
      up: { value: new Vector3(0, 0, 1) },
      finalPose: { value: new Matrix4() },
      boxLow: { value: new Vector3().setScalar(-kFar) },
      boxHigh: { value: new Vector3().setScalar(kFar) },
      pointSize: { value: (0.9 * extent) / Math.sqrt(cloud.count + 1) }, // about their spacing
      sizeFactor: { value: 1 },
      pixels: { value: 700 },
      plain: { value: new Color() },
      planar: { value: new Color() },
      edge: { value: new Color() },
      none: { value: new Color() },
    };
    super(geometryOf(cloud), new ShaderMaterial({ uniforms: values, vertexShader: kVertexShader, fragmentShader: kFragmentShader }));
    this.values = values;
    const recolour = (): void => {
      values.plain.value = raw(this.plainColour);
      for (const name of kColours) values[name].value = raw(`--${name}`);
    };
    recolour();
    onColourScheme(recolour);
    this.matrixAutoUpdate = false;
    this.frustumCulled = false; // one object, and it is nearly always in view
    // The height of the picture in its own pixels, so that points cover the same part of it in a file.
    this.onBeforeRender = (renderer): void => { values.pixels.value = renderer.getDrawingBufferSize(new Vector2()).y; };
  }

  // code: see kModes; palette: none where no numbers are shown.
  colour(code: number, palette: DataTexture | null): void {
    this.values.colouring.value = code;
    this.values.palette.value = palette;
  }

  set range([low, high]: readonly [number, number]) {
    this.values.range.value.set(low, high);
  }

  set upwards(up: Vector3) {
    this.values.up.value.copy(up);
  }

  set sizeFactor(factor: number) {
    this.values.sizeFactor.value = factor;
  }

  set box({ low, high }: { low: Vector3; high: Vector3 }) {
    this.values.boxLow.value.copy(low);
    this.values.boxHigh.value.copy(high);
  }

  // Under which the distances of the cloud are stored.
  set finalPose(pose: readonly number[]) {
    this.values.finalPose.value.fromArray(pose);
  }

  set pose(pose: readonly number[]) {
    this.matrix.fromArray(pose);
    this.matrixWorldNeedsUpdate = true;
  }
}

// SPDX-License-Identifier: MIT
// Lines from source points to their partners; the source's ends move with its pose, on the graphics card.
import { BufferAttribute, BufferGeometry, Color, LineSegments, Matrix4, ShaderMaterial } from "three";
import { type CloudData, floats } from "./data";
import { cssColour, onColourScheme } from "./dom";

// More would be a solid block.
const kMaxPairs = 2500;

const kVertexShader = `
  attribute float isSource;
  uniform mat4 pose;
  void main() {
    vec4 inPage = isSource > 0.5 ? pose * vec4(position, 1.0) : vec4(position, 1.0);
    gl_Position = projectionMatrix * viewMatrix * inPage;
  }`;

const kFragmentShader = `
  uniform vec3 colour;
  void main() { gl_FragColor = vec4(colour, 0.75); }`;

function geometryOf(source: CloudData): BufferGeometry {
  const points = floats(source.points);
  const partners = floats(source.partners ?? "");
  const paired: number[] = [];
  for (let i = 0; 3 * i < partners.length; ++i) if (!Number.isNaN(partners[3 * i])) paired.push(i);
  const stride = Math.max(1, Math.ceil(paired.length / kMaxPairs));
  const positions: number[] = [];
  const ends: number[] = [];
  for (let i = 0; i < paired.length; i += stride) {
    const at = 3 * (paired[i] ?? 0);
    positions.push(...points.subarray(at, at + 3), ...partners.subarray(at, at + 3));
    ends.push(1, 0);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute("isSource", new BufferAttribute(new Float32Array(ends), 1));
  return geometry;
}

export class PairLines extends LineSegments<BufferGeometry, ShaderMaterial> {
  private readonly poseMatrix: Matrix4;

  constructor(source: CloudData) {
    const pose = new Matrix4();
    const colour = { value: new Color() };
    const recolour = (): void => { colour.value.setStyle(cssColour("--pairs"), "srgb-linear"); };
    recolour();
    onColourScheme(recolour);
    super(geometryOf(source), new ShaderMaterial({
      uniforms: { pose: { value: pose }, colour },
      vertexShader: kVertexShader,
      fragmentShader: kFragmentShader,
      transparent: true,
    }));
    this.poseMatrix = pose;
    this.frustumCulled = false;
  }

  set pose(values: readonly number[]) {
    this.poseMatrix.fromArray(values);
  }
}

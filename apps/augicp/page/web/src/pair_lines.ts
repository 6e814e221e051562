// SPDX-License-Identifier: MIT
// Lines between corresponding points; the source's ends move with its pose, on the graphics card.
import { BufferAttribute, BufferGeometry, Color, LineSegments, Matrix4, ShaderMaterial } from "three";
import { cssColour, onColourScheme } from "./dom";

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

export class PairLines extends LineSegments<BufferGeometry, ShaderMaterial> {
  private readonly poseMatrix: Matrix4;

  // ends: points of the source and of the target in the page, in turn, three floats each.
  constructor(ends: Float32Array<ArrayBuffer>) {
    const pose = new Matrix4();
    const colour = { value: new Color() };
    const recolour = (): void => { colour.value.setStyle(cssColour("--pairs"), "srgb-linear"); };
    recolour();
    onColourScheme(recolour);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(ends, 3));
    geometry.setAttribute("isSource", new BufferAttribute(Float32Array.from({ length: ends.length / 3 }, (_, i) => 1 - (i % 2)), 1));
    super(geometry, new ShaderMaterial({
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

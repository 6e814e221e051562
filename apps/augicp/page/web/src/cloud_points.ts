// SPDX-License-Identifier: MIT
// A cloud as points on the graphics card: colours and poses change by uniforms, nothing is made or copied while drawing.
import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from "three";
import { type CloudData, floats, signedBytes, unsignedBytes } from "./data";
import { cssColour, onColourScheme } from "./dom";

export enum Colouring {
  Plain,
  Structure,
  Residual,
}

const kVertexShader = `
  attribute vec3 direction;
  attribute float structure;
  attribute vec3 partner;
  uniform vec3 plain, planar, edge, none, low, middle, high;
  uniform float colouring, residualScale, pointSize, pixels;
  varying vec3 colour;

  vec3 residualColour(float residual) {
    if (residual > 1e14) return none;
    float share = clamp(residual / residualScale, 0.0, 1.0);
    return share < 0.5 ? mix(low, middle, 2.0 * share) : mix(middle, high, 2.0 * share - 1.0);
  }

  void main() {
    vec4 inPage = modelMatrix * vec4(position, 1.0);
    vec4 inView = viewMatrix * inPage;
    gl_Position = projectionMatrix * inView;
    gl_PointSize = clamp(pointSize * pixels / max(-inView.z, 1e-6), 1.4 * pixels / 700.0, 5.0 * pixels / 700.0);
    colour = plain;
    if (colouring == 1.0) colour = structure == 1.0 ? planar : structure == 2.0 ? edge : none;
    if (colouring == 2.0) colour = residualColour(distance(inPage.xyz, partner));
    vec3 normal = mat3(viewMatrix) * mat3(modelMatrix) * direction;
    float facing = structure == 1.0 ? abs(dot(normalize(normal), normalize(inView.xyz))) : 0.7;
    colour *= 0.35 + 0.65 * facing;
  }`;

const kFragmentShader = `
  varying vec3 colour;
  void main() {
    if (length(gl_PointCoord - 0.5) > 0.5) discard;
    gl_FragColor = vec4(colour, 1.0);
  }`;

// In place of a partner that is not there: graphics cards need not know NaN.
const kFar = 1e15;

const kColours = ["planar", "edge", "none", "low", "middle", "high"] as const;

// A colour as it stands in the style sheet; the shader writes it to the screen as it is.
function raw(name: string): Color {
  return new Color().setStyle(cssColour(name), "srgb-linear");
}

function geometryOf(cloud: CloudData): BufferGeometry {
  const points = floats(cloud.points);
  const count = points.length / 3;
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  const directions = cloud.directions === undefined ? new Int8Array(3 * count) : signedBytes(cloud.directions);
  geometry.setAttribute("direction", new BufferAttribute(directions, 3, true));
  const structures = cloud.structures === undefined ? new Uint8Array(count) : unsignedBytes(cloud.structures);
  geometry.setAttribute("structure", new BufferAttribute(structures, 1));
  const partners = cloud.partners === undefined ? new Float32Array(3 * count).fill(kFar) : floats(cloud.partners);
  partners.forEach((value, i) => { if (Number.isNaN(value)) partners[i] = kFar; });
  geometry.setAttribute("partner", new BufferAttribute(partners, 3));
  return geometry;
}

export class CloudPoints extends Points<BufferGeometry, ShaderMaterial> {
  // plainColour: a CSS variable; extent: of what the points fill, metres.
  constructor(cloud: CloudData, plainColour: string, extent: number, residualScale: number) {
    const geometry = geometryOf(cloud);
    const uniforms: Record<string, { value: unknown }> = {
      colouring: { value: Colouring.Plain },
      residualScale: { value: residualScale },
      pointSize: { value: (0.9 * extent) / Math.sqrt(geometry.getAttribute("position").count + 1) }, // about their spacing
      pixels: { value: 700 * Math.min(window.devicePixelRatio, 2) },
    };
    const recolour = (): void => {
      uniforms["plain"] = Object.assign(uniforms["plain"] ?? {}, { value: raw(plainColour) });
      for (const name of kColours) uniforms[name] = Object.assign(uniforms[name] ?? {}, { value: raw(`--${name}`) });
    };
    recolour();
    onColourScheme(recolour);
    super(geometry, new ShaderMaterial({ uniforms, vertexShader: kVertexShader, fragmentShader: kFragmentShader }));
    this.matrixAutoUpdate = false;
    this.frustumCulled = false; // one object, and it is nearly always in view
  }

  set colouring(value: Colouring) {
    const uniform = this.material.uniforms["colouring"];
    if (uniform) uniform.value = value;
  }

  set pose(values: readonly number[]) {
    this.matrix.fromArray(values);
    this.matrixWorldNeedsUpdate = true;
  }
}

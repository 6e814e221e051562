// SPDX-License-Identifier: MIT
// Places, sizes and colours of points. A distance from the surface changes with the pose by the motion along its direction.

export const kVertexShader = `
  attribute vec3 direction;
  attribute float structure, intensity, offSurface;
  attribute vec3 offDirection, rgb;
  uniform vec3 plain, planar, edge, none, up, boxLow, boxHigh;
  uniform vec2 range;
  uniform sampler2D palette;
  uniform mat4 finalPose;
  uniform bool hasColours;
  uniform float colouring, pointSize, sizeFactor, pixels;
  varying vec3 colour;
  const float kFar = 1e14;

  vec3 ofPalette(float value) {
    if (abs(value) > kFar) return none;
    return texture2D(palette, vec2(clamp((value - range.x) / (range.y - range.x), 0.002, 0.998), 0.5)).rgb;
  }

  float distanceNow(vec3 inPage) {
    vec3 moved = inPage - (finalPose * vec4(position, 1.0)).xyz;
    return offSurface > kFar ? offSurface : offSurface + dot(offDirection, moved);
  }

  void main() {
    vec4 inPage = modelMatrix * vec4(position, 1.0);
    vec4 inView = viewMatrix * inPage;
    gl_Position = projectionMatrix * inView;
    if (any(lessThan(inPage.xyz, boxLow)) || any(greaterThan(inPage.xyz, boxHigh))) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    float size = pointSize * pixels / max(-inView.z, 1e-6);
    gl_PointSize = sizeFactor * clamp(size, 1.4 * pixels / 700.0, 5.0 * pixels / 700.0);
    colour = plain;
    if (colouring == 1.0) colour = structure == 1.0 ? planar : structure == 2.0 ? edge : none;
    if (colouring == 2.0) colour = ofPalette(distanceNow(inPage.xyz));
    if (colouring == 3.0) colour = ofPalette(dot(inPage.xyz, up));
    if (colouring == 4.0) colour = ofPalette(intensity);
    if (colouring == 5.0) colour = hasColours ? rgb : none;
    vec3 normal = mat3(viewMatrix) * mat3(modelMatrix) * direction;
    float facing = structure == 1.0 ? abs(dot(normalize(normal), normalize(inView.xyz))) : 0.7;
    colour *= colouring >= 2.0 ? 0.8 + 0.2 * facing : 0.35 + 0.65 * facing;
  }`;

export const kFragmentShader = `
  varying vec3 colour;
  void main() {
    if (length(gl_PointCoord - 0.5) > 0.5) discard;
    gl_FragColor = vec4(colour, 1.0);
  }`;

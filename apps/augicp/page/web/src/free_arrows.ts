// SPDX-License-Identifier: MIT
// The motions that the data leave open: a double arrow along an axis, an arc with arrow heads about it, or both.
import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, TorusGeometry, Vector3 } from "three";
import type { FreeMotion } from "./data";
import { cssColour } from "./dom";

const kArc_rad = 1.6 * Math.PI;

// Along y, as three's cylinders are; size is its length.
function doubleArrow(size: number, material: MeshBasicMaterial): Group {
  const group = new Group();
  group.add(new Mesh(new CylinderGeometry(0.012 * size, 0.012 * size, 0.84 * size), material));
  for (const side of [1, -1]) {
    const head = new Mesh(new ConeGeometry(0.045 * size, 0.14 * size, 24), material);
    head.position.y = 0.43 * side * size;
    if (side < 0) head.rotation.x = Math.PI;
    group.add(head);
  }
  return group;
}

// About y.
function turnArrow(size: number, material: MeshBasicMaterial): Group {
  const radius = 0.25 * size;
  const group = new Group();
  const arc = new Mesh(new TorusGeometry(radius, 0.012 * size, 12, 64, kArc_rad), material);
  arc.rotation.x = -Math.PI / 2;
  group.add(arc);
  const head = new Mesh(new ConeGeometry(0.045 * size, 0.14 * size, 24), material);
  head.position.set(radius * Math.cos(kArc_rad), 0, -radius * Math.sin(kArc_rad));
  // The tangent of the arc's end.
  head.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(-Math.sin(kArc_rad), 0, -Math.cos(kArc_rad)));
  group.add(head, new Mesh(new CylinderGeometry(0.004 * size, 0.004 * size, size), material));
  return group;
}

export function freeArrows(motions: readonly FreeMotion[], size: number): Group {
  const all = new Group();
  const material = new MeshBasicMaterial({ color: cssColour("--free"), depthTest: false, transparent: true, opacity: 0.95 });
  for (const motion of motions) {
    const numbers = [...motion.axis, ...motion.point];
    if (numbers.length !== 6 || numbers.some((value) => value === null)) continue;
    const [x = 0, y = 0, z = 0, px = 0, py = 0, pz = 0] = numbers as number[];
    const arrow = new Group();
    if (motion.kind !== "rotation") arrow.add(doubleArrow(size, material));
    if (motion.kind !== "translation") arrow.add(turnArrow(size, material));
    arrow.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(x, y, z).normalize());
    arrow.position.set(px, py, pz);
    all.add(arrow);
  }
  all.traverse((part) => { part.renderOrder = 10; });
  return all;
}

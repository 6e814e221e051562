// SPDX-License-Identifier: MIT
// Both clouds and what is drawn between them.
import { type Group, type LineSegments, Vector3 } from "three";
import type { Cloud } from "../cloud";
import { CloudPoints } from "../cloud_points";
import { type AlignData, isFinitePose } from "../data";
import { directionLines } from "../direction_lines";
import { freeArrows } from "../free_arrows";
import { PairLines } from "../pair_lines";
import { unpackedPoints } from "../packed";
import { lengthText } from "../stage/lengths";
import { Viewer } from "../stage/viewer";
import { Survey } from "../survey";
import { cloudOf } from "../cloud";
import type { Picked } from "../tools/pick";
import { type Bounds, coordinates, kStructures, type Probed } from "../tools/probed";

const kIdentity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export class AlignScene implements Probed {
  readonly viewer: Viewer;
  readonly survey: Survey;
  readonly source: CloudPoints;
  readonly target: CloudPoints;
  readonly pairs: PairLines;
  readonly arrows: Group;
  readonly directions: [LineSegments, LineSegments]; // of the source, of the target
  pose: readonly number[] = kIdentity; // of the source in the page

  // Throws where the browser has no WebGL.
  constructor(readonly data: AlignData, source: Cloud, target: Cloud, pairs: Float32Array<ArrayBuffer>) {
    this.survey = new Survey(data, source, target);
    this.viewer = new Viewer("Both clouds in 3D: arrow keys rotate, with Shift they move, + and - zoom, 0 shows all", this.survey.home(0));
    this.source = new CloudPoints(source, "--source", data.extent);
    this.target = new CloudPoints(target, "--target", data.extent);
    this.source.finalPose = this.poseAt(data.poses.length - 1);
    this.pairs = new PairLines(pairs);
    this.arrows = freeArrows(data.free_motions, 0.5 * data.extent);
    this.directions = [directionLines(source, data.direction_length), directionLines(target, data.direction_length)];
    for (const points of [this.source, this.target]) this.viewer.detail.add(points);
    this.viewer.scene.add(this.target, this.source, this.pairs, ...this.directions, this.arrows);
  }

  static async of(data: AlignData): Promise<AlignScene> {
    const [source, target, pairs] = await Promise.all([cloudOf(data.source), cloudOf(data.target), unpackedPoints(data.pairs)]);
    return new AlignScene(data, source, target, pairs);
  }

  get clouds(): readonly CloudPoints[] {
    return [this.target, this.source];
  }

  get zero(): readonly number[] {
    return this.data.zero;
  }

  set box(box: Bounds) {
    this.source.box = this.target.box = box;
    this.viewer.invalidate();
  }

  set sizeFactor(factor: number) {
    this.source.sizeFactor = this.target.sizeFactor = factor;
    this.viewer.invalidate();
  }

  describe({ points, index, place }: Picked): string[] {
    const isSource = points === this.source;
    const lines = [
      `${isSource ? "Source" : "Target"} point, ${kStructures[points.cloud.structures[index] ?? 0] ?? ""}`,
      `target frame ${coordinates(place.clone().add(new Vector3(...this.data.zero)))}`,
    ];
    if (isSource) lines.push(`source frame ${coordinates(this.inSource(place))}`);
    const distance = points.cloud.distances?.[index] ?? NaN;
    if (!Number.isNaN(distance)) lines.push(`${lengthText(distance)} from the target's surface, at the end`);
    const intensity = points.cloud.intensities?.[index] ?? NaN;
    if (!Number.isNaN(intensity)) lines.push(`intensity ${Number(intensity.toPrecision(4))}`);
    return lines;
  }

  poseAt(step: number): readonly number[] {
    const pose = this.data.poses[step];
    return isFinitePose(pose) ? pose : kIdentity;
  }

  showPose(pose: readonly number[]): void {
    this.source.pose = this.pairs.pose = pose;
    this.directions[0].matrix.fromArray(pose);
    this.directions[0].matrixWorldNeedsUpdate = true;
  }

  // By the pose that is shown.
  private inSource(place: Vector3): Vector3 {
    return place.clone().applyMatrix4(this.source.matrix.clone().invert()).add(new Vector3(...this.data.source_zero));
  }

  showStep(step: number): void {
    this.pose = this.poseAt(step);
    this.showPose(this.pose);
    this.viewer.invalidate();
  }
}

// SPDX-License-Identifier: MIT
// The trajectory, the map along it, and what the sensor saw at a frame.
import { Vector3 } from "three";
import type { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { CloudPoints } from "../cloud_points";
import { kSequential, paletteTexture } from "../colour/palette";
import { type FrameData, isFinitePose, type OdometryData } from "../data";
import { unpackedPoints } from "../packed";
import { type Fitted, robustExtent, samplesOf } from "../stage/framing";
import { homeDirection } from "../stage/home";
import { type Home, Viewer } from "../stage/viewer";
import type { Picked } from "../tools/pick";
import { type Bounds, coordinates, type Probed } from "../tools/probed";
import { type Kept, keptClouds, mapOf } from "./map";
import { EstimatedPath, lines, type PathColour, pyramid, sensorAxes } from "./trajectory";

const kByTime = 4; // in the shader: the map's intensities are times
const kPlain = 0;
const kSeenSize = 0.7; // the map around it stays visible

function positions(frames: readonly FrameData[]): Float32Array {
  return new Float32Array(frames.flatMap(({ pose }) => (isFinitePose(pose) ? pose.slice(12, 15) : [])));
}

export class OdometryScene implements Probed {
  readonly viewer: Viewer;
  readonly map: CloudPoints;
  readonly path: EstimatedPath;
  private readonly sensor: LineSegments2;
  private readonly palette = paletteTexture(kSequential);
  private seen: CloudPoints | null = null; // at the frame
  private shown: Kept | null = null;
  private isSeenShown = true;
  private shownBox: Bounds | null = null;
  private factor = 1;
  readonly points: readonly Vector3[]; // some of all that is drawn

  constructor(private readonly data: OdometryData, kept: readonly Kept[], truth: Float32Array<ArrayBuffer>) {
    const map = mapOf(data, kept);
    const up = new Vector3(...data.view.up);
    const parts: Fitted[] = [positions(data.frames), truth, map.points].map((points) => ({ points }));
    const points = samplesOf(parts);
    this.points = points;
    const home: Home = { points, toEye: homeDirection(up, new Vector3(...data.view.ahead)), up };
    this.viewer = new Viewer("Trajectory in 3D: arrow keys rotate, with Shift they move, + and - zoom, 0 shows all", home);
    this.map = new CloudPoints(map, "--none", robustExtent(points));
    this.map.range = [0, Math.max(1e-9, data.frames.at(-1)?.time ?? 1)];
    this.path = new EstimatedPath(data.frames);
    this.sensor = (data.lidar ? sensorAxes : pyramid)(0.08 * data.extent);
    this.viewer.detail.add(this.map);
    this.viewer.scene.add(this.map, lines(truth, "--target", 2.5), this.path, this.sensor);
  }

  static async of(data: OdometryData, kept: readonly Kept[]): Promise<OdometryScene> {
    return new OdometryScene(data, kept, await unpackedPoints(data.truth));
  }

  get clouds(): readonly CloudPoints[] {
    return this.seen ? [this.map, this.seen] : [this.map];
  }

  get zero(): readonly number[] {
    return this.data.zero;
  }

  set box(box: Bounds) {
    this.shownBox = box;
    for (const cloud of this.clouds) cloud.box = box;
    this.viewer.invalidate();
  }

  set sizeFactor(factor: number) {
    this.factor = this.map.sizeFactor = factor;
    if (this.seen) this.seen.sizeFactor = kSeenSize * factor;
    this.viewer.invalidate();
  }

  describe({ points, index, place }: Picked): string[] {
    const isMap = points === this.map;
    const seen = this.data.lidar ? "Point of the scan" : "Point of the local model";
    const lines = [isMap ? "Point of the map" : seen, `${this.data.has_truth ? "ground truth's" : "world"} frame ${coordinates(place.clone().add(new Vector3(...this.data.zero)))}`];
    if (isMap) lines.push(`from the frame at ${Number((points.cloud.intensities?.[index] ?? 0).toPrecision(4))} s`);
    return lines;
  }

  show(frame: number, kept: Kept | null): void {
    const pose = this.data.frames[frame]?.pose;
    this.sensor.visible = isFinitePose(pose);
    if (isFinitePose(pose)) this.sensor.matrix.fromArray(pose);
    this.sensor.matrixWorldNeedsUpdate = true;
    if (kept !== this.shown) this.showSeen(kept);
    this.viewer.invalidate();
  }

  colour(colour: PathColour): void {
    this.path.recolour(colour);
    this.map.colour(colour === "time" ? kByTime : kPlain, colour === "time" ? this.palette : null);
    this.viewer.invalidate();
  }

  set isSeenVisible(on: boolean) {
    this.isSeenShown = on;
    if (this.seen) this.seen.visible = on;
    this.viewer.invalidate();
  }

  private showSeen(kept: Kept | null): void {
    this.shown = kept;
    if (this.seen) {
      this.viewer.scene.remove(this.seen);
      this.seen.geometry.dispose();
      this.seen.material.dispose();
      this.seen = null;
    }
    const pose = kept?.frame.model_pose;
    if (!kept?.cloud || !isFinitePose(pose)) return;
    this.seen = new CloudPoints(kept.cloud, "--s2", 0.6 * (kept.frame.model_extent ?? 1));
    this.seen.sizeFactor = kSeenSize * this.factor;
    if (this.shownBox) this.seen.box = this.shownBox;
    this.seen.pose = pose;
    this.seen.visible = this.isSeenShown;
    this.viewer.scene.add(this.seen);
  }
}

export { keptClouds };

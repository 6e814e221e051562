// SPDX-License-Identifier: MIT
// How many points are drawn while the view moves: fewer after a slow picture, more after a fast one. At rest all are
// drawn.
import type { Points } from "three";

const kFirst = 250_000;
const kLeast = 30_000;
const kSlow_ms = 45; // between two pictures; slower ones get fewer points
const kFast_ms = 25;

export class Detail {
  private readonly clouds: Points[] = [];
  private budget = kFirst;
  private isMoving = false;
  private last_ms = 0;

  // The order of a cloud's points spreads any beginning over the whole.
  add(cloud: Points): void {
    this.clouds.push(cloud);
  }

  set moving(isMoving: boolean) {
    this.isMoving = isMoving;
    this.last_ms = 0;
  }

  // Before each picture, with its time.
  adapt(now_ms: number): void {
    if (this.isMoving && this.last_ms > 0) {
      const elapsed_ms = now_ms - this.last_ms;
      if (elapsed_ms > kSlow_ms) this.budget = Math.max(kLeast, 0.7 * this.budget);
      else if (elapsed_ms < kFast_ms) this.budget *= 1.15;
    }
    this.last_ms = now_ms;
    const counts = this.clouds.map(({ geometry }) => geometry.getAttribute("position").count);
    const total = counts.reduce((sum, count) => sum + count, 0);
    this.budget = Math.min(this.budget, Math.max(total, kFirst));
    const share = this.isMoving ? Math.min(1, this.budget / Math.max(1, total)) : 1;
    this.clouds.forEach(({ geometry }, i) => { geometry.setDrawRange(0, Math.ceil(share * (counts[i] ?? 0))); });
  }
}

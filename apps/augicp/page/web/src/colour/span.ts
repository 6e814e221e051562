// SPDX-License-Identifier: MIT
// Two sliders for the lower and the upper end of a range.
import { element } from "../dom";

const kSteps = 500;

export class Span {
  readonly element = element("span", "span");
  private readonly ends: [HTMLInputElement, HTMLInputElement];
  private readonly texts = [element("span", "span-end"), element("span", "span-end")] as const;
  private domain: [number, number] = [0, 1];
  private describe: (value: number) => string = String;

  constructor(label: string, private readonly onChange: (low: number, high: number) => void) {
    const slider = (name: string): HTMLInputElement => {
      const made = element("input");
      made.type = "range";
      made.max = String(kSteps);
      made.setAttribute("aria-label", `${label}, ${name}`);
      made.addEventListener("input", () => { this.change(made); });
      return made;
    };
    this.ends = [slider("lower end"), slider("upper end")];
    this.element.append(this.texts[0], ...this.ends, this.texts[1]);
  }

  show(domain: [number, number], [low, high]: readonly [number, number], describe: (value: number) => string): void {
    this.domain = domain;
    this.describe = describe;
    const step = (value: number): string => String(Math.round((kSteps * (value - domain[0])) / (domain[1] - domain[0])));
    [this.ends[0].value, this.ends[1].value] = [step(low), step(high)];
    this.label(low, high);
  }

  private label(low: number, high: number): void {
    [low, high].forEach((value, i) => {
      const text = this.describe(value);
      if (this.texts[i as 0 | 1].textContent !== text) this.texts[i as 0 | 1].textContent = text;
      this.ends[i as 0 | 1].setAttribute("aria-valuetext", text);
    });
  }

  // The other end gives way.
  private change(moved: HTMLInputElement): void {
    const [low, high] = this.ends;
    if (Number(low.value) >= Number(high.value)) {
      const other = moved === low ? high : low;
      other.value = String(Number(moved.value) + (moved === low ? 1 : -1));
    }
    const value = ({ value: step }: HTMLInputElement): number => this.domain[0] + (Number(step) / kSteps) * (this.domain[1] - this.domain[0]);
    this.label(value(low), value(high));
    this.onChange(value(low), value(high));
  }
}

// SPDX-License-Identifier: MIT
// The legend of a palette: a histogram in its colours, and the range that it spans.
import { element } from "../dom";
import { quantile } from "../stage/sampled";
import { type Mode, type Range, rangeFor } from "./modes";
import { cssColourAt, gradient } from "./palette";
import { Span } from "./span";

const kBins = 90;
const kHeight = 34;

// Beyond the range on both sides, so that it can be widened; without strays.
function domainFor(values: readonly number[], [low, high]: Range): Range {
  const margin = high - low;
  return [Math.min(low, Math.max(quantile(values, 0.002), low - margin)), Math.max(high, Math.min(quantile(values, 0.998), high + margin))];
}

function counts(values: readonly number[], [low, high]: Range): number[] {
  const bins = new Array<number>(kBins).fill(0);
  for (const value of values) {
    const bin = Math.floor((kBins * (value - low)) / (high - low));
    if (bin >= 0 && bin < kBins) bins[bin] = (bins[bin] ?? 0) + 1;
  }
  return bins;
}

export class RangeControl {
  readonly element = element("div", "range-control");
  private readonly canvas = element("canvas");
  private readonly bar = element("div", "palette");
  private readonly span: Span;
  private values: readonly number[] = [];
  private mode: Mode | null = null;
  private domain: Range = [0, 1];

  constructor(private readonly onChange: (range: Range) => void) {
    this.span = new Span("Colour range", (low, high) => { this.draw([low, high]); this.onChange([low, high]); });
    this.canvas.width = kBins * 2;
    this.canvas.height = kHeight;
    this.canvas.setAttribute("role", "img");
    this.element.append(this.canvas, this.bar, this.span.element);
    this.element.hidden = true;
  }

  // range: what was chosen before; none: the one that suits the values.
  show(mode: Mode, values: readonly number[], range: Range | null): void {
    this.element.hidden = mode.palette === null;
    if (!mode.palette) return;
    this.mode = mode;
    this.values = values;
    const chosen = range ?? rangeFor(mode, values);
    this.domain = domainFor(values, rangeFor(mode, values));
    this.domain = [Math.min(this.domain[0], chosen[0]), Math.max(this.domain[1], chosen[1])];
    this.bar.style.background = gradient(mode.palette);
    this.span.show(this.domain, chosen, mode.text);
    this.canvas.setAttribute("aria-label", `Histogram: ${mode.label}`);
    this.draw(chosen);
    this.onChange(chosen);
  }

  private draw([low, high]: Range): void {
    const context = this.canvas.getContext("2d");
    const { mode, domain } = this;
    if (!context || !mode?.palette) return;
    const bins = counts(this.values, domain);
    const most = Math.max(1, ...bins);
    const width = domain[1] - domain[0];
    context.clearRect(0, 0, this.canvas.width, kHeight);
    bins.forEach((count, i) => {
      const value = domain[0] + ((i + 0.5) / kBins) * width;
      context.fillStyle = cssColourAt(mode.palette ?? [], (value - low) / (high - low));
      const height = count === 0 ? 0 : Math.max(1, (kHeight * count) / most);
      context.fillRect(2 * i, kHeight - height, 2, height);
    });
    this.bar.style.marginLeft = `${(100 * (low - domain[0])) / width}%`;
    this.bar.style.marginRight = `${(100 * (domain[1] - high)) / width}%`;
  }
}

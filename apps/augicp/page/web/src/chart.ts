// SPDX-License-Identifier: MIT
// Takes the place of a figure's SVG: the same curves, with the values at the pointer.
import uPlot from "uplot";
import type { ChartData, Maybe } from "./data";
import { cssColour, element, onColourScheme } from "./dom";

const kDashes = [[], [7, 4], [2, 3], [9, 3, 2, 3], [4, 2], [1, 3]];
const kHeight = 190;
const kWholeSteps = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000];

export interface LiveChart {
  mark(x: number): void;
}

const positive = (values: Maybe[], isLog: boolean): Maybe[] =>
  isLog ? values.map((value) => (value !== null && value > 0 ? value : null)) : values;

function stroke(index: number): string {
  return cssColour(`--s${index % kDashes.length}`);
}

function seriesOf(chart: ChartData): { series: uPlot.Series[]; values: Maybe[][]; bands: uPlot.Band[] } {
  const series: uPlot.Series[] = [{ label: chart.x_label }];
  const values: Maybe[][] = [];
  const bands: uPlot.Band[] = [];
  chart.series.forEach((data, index) => {
    const dash = kDashes[index % kDashes.length] ?? [];
    series.push({ label: data.name, stroke: () => stroke(index), width: 1.75, dash, points: { show: chart.x.length < 3 } });
    values.push(positive(data.y, chart.log_y));
    if (!data.low || !data.high) return;
    bands.push({ series: [series.length + 1, series.length], fill: () => `${stroke(index)}26` });
    for (const edge of [data.low, data.high]) {
      series.push({ stroke: "transparent", points: { show: false } });
      values.push(positive(edge, chart.log_y));
    }
  });
  return { series, values, bands };
}

function digits(value: number): string {
  return value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e6) ? String(Number(value.toPrecision(6))) : value.toExponential(2).replace(/\.?0+e/, "e");
}

// The values at the pointer, beside it.
function tooltip(chart: ChartData): uPlot.Plugin {
  const box = element("div", "tooltip");
  box.hidden = true;
  const show = (plot: uPlot): void => {
    const index = plot.cursor.idx ?? null;
    const left = plot.cursor.left ?? -1;
    box.hidden = index === null || left < 0;
    if (index === null) return;
    const rows = [element("div", "tooltip-x", `${chart.x_label}: ${digits(chart.x[index] ?? NaN)}`)];
    chart.series.forEach((data, number) => {
      const row = element("div", "", `${data.name}: `);
      const value = data.y[index] ?? null;
      row.append(element("b", "", value === null ? "–" : digits(value)));
      const key = element("i");
      key.style.background = stroke(number);
      row.prepend(key);
      rows.push(row);
    });
    box.replaceChildren(...rows);
    const over = plot.over.clientWidth;
    box.style.left = left > over / 2 ? "" : `${left + 12}px`;
    box.style.right = left > over / 2 ? `${over - left + 12}px` : "";
  };
  return { hooks: { init: (plot) => { plot.over.append(box); }, setCursor: show } };
}

// A vertical line at the step shown elsewhere on the page.
function marker(at: { x: number | null }): uPlot.Plugin {
  const draw = (plot: uPlot): void => {
    if (at.x === null) return;
    const { ctx, bbox } = plot;
    const x = Math.round(plot.valToPos(at.x, "x", true));
    ctx.save();
    ctx.strokeStyle = cssColour("--marker");
    ctx.lineWidth = window.devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  };
  return { hooks: { draw } };
}

// Powers of ten, a few of them; of a range without two of these 1, 2 and 5 times them.
function logSplits(low: number, high: number): number[] {
  const first = Math.ceil(Math.log10(low) - 1e-9);
  const last = Math.floor(Math.log10(high) + 1e-9);
  const stride = Math.max(1, Math.ceil((last - first + 1) / 6));
  const powers = Array.from({ length: last - first + 3 }, (_, i) => first - 1 + i);
  const splits =
    last - first >= 1
      ? powers.filter((power) => (power - first) % stride === 0).map((power) => 10 ** power)
      : powers.flatMap((power) => [1, 2, 5].map((factor) => factor * 10 ** power));
  return splits.filter((value) => value >= low && value <= high);
}

function axes(chart: ChartData): uPlot.Axis[] {
  const common = {
    stroke: () => cssColour("--muted"),
    grid: { stroke: () => cssColour("--grid"), width: 1 },
    ticks: { show: false },
    font: "11px system-ui, sans-serif",
    labelFont: "11px system-ui, sans-serif",
    labelSize: 16,
    labelGap: 0,
  };
  const numbers = (_: uPlot, splits: Maybe[]): string[] => splits.map((value) => (value === null ? "" : digits(value)));
  return [
    { ...common, label: chart.x_label, size: 24, values: numbers, ...(chart.x.every(Number.isInteger) ? { incrs: kWholeSteps } : {}) },
    {
      ...common,
      label: chart.y_label,
      size: 58,
      values: numbers,
      ...(chart.log_y ? { filter: (_: uPlot, splits: number[]) => splits, splits: (_: uPlot, __: number, low: number, high: number) => logSplits(low, high) } : {}),
    },
  ];
}

// onPick is called with the index of the value that was clicked.
export function makeChart(figure: HTMLElement, chart: ChartData, onPick?: (index: number) => void): LiveChart {
  const { series, values, bands } = seriesOf(chart);
  const at: { x: number | null } = { x: null };
  const holder = element("div", "plot");
  const isLog = chart.log_y;
  const plot = new uPlot({
    width: Math.max(200, figure.clientWidth),
    height: kHeight,
    padding: [8, 10, 0, 0],
    legend: { show: false },
    cursor: { y: false, drag: { x: false, y: false }, points: { size: 6 } },
    scales: {
      x: { time: false },
      y: { distr: isLog ? 3 : 1, range: [chart.y_range[0], chart.y_range[1]] },
    },
    axes: axes(chart),
    series,
    bands,
    plugins: [tooltip(chart), marker(at)],
  }, [chart.x, ...values] as uPlot.AlignedData, holder);
  figure.querySelector(":scope > svg")?.replaceWith(holder);
  new ResizeObserver(() => { if (figure.clientWidth > 0) plot.setSize({ width: figure.clientWidth, height: kHeight }); }).observe(figure);
  onColourScheme(() => { plot.redraw(); });
  plot.over.addEventListener("click", () => {
    const index = plot.cursor.idx;
    if (onPick && typeof index === "number") onPick(index);
  });
  return { mark: (x) => { at.x = x; plot.redraw(false); } };
}

// Every figure that has a chart.
export function makeCharts(charts: readonly ChartData[], onPick?: (x: number) => void): LiveChart[] {
  return [...document.querySelectorAll<HTMLElement>("figure[data-chart]")].flatMap((figure) => {
    const chart = charts[Number(figure.dataset["chart"])];
    return chart ? [makeChart(figure, chart, (index) => { onPick?.(chart.x[index] ?? 0); })] : [];
  });
}

// SPDX-License-Identifier: MIT
// The slider through iterations or frames, by mouse, touch, buttons and keyboard.
import { button, element } from "./dom";

export interface Steps {
  readonly element: HTMLElement;
  readonly step: number;
  show(step: number): void;
}

const kFrameTime_ms = 120;

// Whether what has the focus uses the key itself.
function isForItself({ target, key }: KeyboardEvent): boolean {
  if (target instanceof HTMLButtonElement || target instanceof SVGElement) return key === " " || key === "Enter";
  return target instanceof HTMLInputElement || target instanceof HTMLCanvasElement || target instanceof HTMLSelectElement;
}

// onShow is called with every step shown; names say what the ends are.
export function makeSteps(count: number, label: string, texts: readonly string[], onShow: (step: number) => void): Steps {
  const slider = element("input");
  slider.type = "range";
  slider.min = "0";
  slider.max = String(count - 1);
  slider.setAttribute("aria-label", label);
  const text = element("output", "step-text");
  const show = (step: number): void => {
    const within = Math.max(0, Math.min(count - 1, Math.round(step)));
    slider.value = String(within);
    text.textContent = texts[within] ?? "";
    slider.setAttribute("aria-valuetext", text.textContent);
    onShow(within);
  };
  slider.addEventListener("input", () => {
    stop();
    show(Number(slider.value));
  });

  let timer = 0;
  const play = button("Play", "Play (space)", () => {
    if (timer !== 0) {
      stop();
      return;
    }
    if (Number(slider.value) === count - 1) show(0);
    play.textContent = "Stop";
    timer = window.setInterval(() => {
      show(Number(slider.value) + 1);
      if (Number(slider.value) === count - 1) stop();
    }, kFrameTime_ms);
  });
  const stop = (): void => {
    window.clearInterval(timer);
    timer = 0;
    play.textContent = "Play";
  };
  const go = (title: string, sign: string, step: () => number): HTMLButtonElement =>
    button(sign, title, () => {
      stop();
      show(step());
    });
  const keys: Record<string, () => number> = {
    ArrowLeft: () => Number(slider.value) - 1,
    ArrowRight: () => Number(slider.value) + 1,
    Home: () => 0,
    End: () => count - 1,
  };
  window.addEventListener("keydown", (event) => {
    if (isForItself(event) || event.ctrlKey || event.metaKey || event.altKey) return;
    const step = keys[event.key];
    if (event.key === " ") play.click();
    else if (step) show(step());
    else return;
    event.preventDefault();
  });

  const row = element("div", "steps");
  const line = element("div", "step-line");
  line.append(
    go("First (Home)", "|‹", () => 0),
    go("Back (left arrow)", "‹", () => Number(slider.value) - 1),
    slider,
    go("Forward (right arrow)", "›", () => Number(slider.value) + 1),
    go("Last (End)", "›|", () => count - 1),
    play,
  );
  row.append(line, text);
  return { element: row, show, get step() { return Number(slider.value); } };
}

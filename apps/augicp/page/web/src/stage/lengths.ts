// SPDX-License-Identifier: MIT
// Round lengths, and lengths in words.

// The largest of 1, 2 and 5 times powers of ten that is not above a length.
export function roundBelow(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length) + 1e-12);
  return ([5, 2, 1].find((factor) => factor * power <= length * (1 + 1e-12)) ?? 1) * power;
}

const kUnits = [[1000, "km"], [1, "m"], [0.01, "cm"], [0.001, "mm"], [1e-6, "\u00b5m"]] as const;

// A length as text, in the largest unit in which the number is at least 1.
export function lengthText(length_m: number, digits = 3): string {
  if (length_m === 0) return "0 m";
  const [unit, name] = kUnits.find(([unit]) => Math.abs(length_m) >= unit * (1 - 1e-9)) ?? [1e-6, "\u00b5m"];
  return `${Number((length_m / unit).toPrecision(digits))} ${name}`;
}

// SPDX-License-Identifier: MIT
// The matrix of the page, in the form that the reader chooses, to copy.
import { copyButton } from "../copy";
import { element, select } from "../dom";
import { transformTexts } from "./transform_texts";

// matrix: rows of the transform with all digits.
export function showTransforms(matrix: readonly (readonly number[])[], shown: HTMLElement): void {
  const texts = transformTexts(matrix);
  const use = element("p", "use", texts[0]?.use);
  const first = shown.textContent;
  const chooser = select("Form", "Other programs", texts.map(({ name }) => name), (index) => {
    const chosen = texts[index];
    shown.textContent = index === 0 ? first : (chosen?.text ?? "");
    use.textContent = chosen?.use ?? "";
  });
  const line = element("div", "with-copy");
  line.append(chooser, copyButton(() => shown));
  shown.before(line);
  shown.after(use);
}

// SPDX-License-Identifier: MIT
// Copies the text of an element, or selects it where the browser does not let a page copy.
import { button } from "./dom";

export function copyButton(source: () => HTMLElement): HTMLButtonElement {
  const made = button("Copy", "Copy to the clipboard", () => {
    const text = source();
    const select = (): void => { getSelection()?.selectAllChildren(text); made.textContent = "Selected"; };
    const { clipboard } = navigator as Partial<Navigator>; // only where the browser trusts the page
    if (clipboard) clipboard.writeText(text.textContent).then(() => { made.textContent = "Copied"; }, select);
    else select();
  });
  made.classList.add("copy");
  return made;
}

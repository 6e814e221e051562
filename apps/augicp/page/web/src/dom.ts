// SPDX-License-Identifier: MIT
// Elements. Text enters by textContent alone, so that it stays text.

export function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  className = "",
  text = "",
): HTMLElementTagNameMap[Name] {
  const made = document.createElement(name);
  if (className !== "") made.className = className;
  if (text !== "") made.textContent = text;
  return made;
}

export function button(text: string, title: string, onClick: () => void): HTMLButtonElement {
  const made = element("button", "", text);
  made.type = "button";
  made.title = title;
  made.addEventListener("click", onClick);
  return made;
}

// A button that stays pressed. onChange is called at once with its first state.
export function toggle(text: string, title: string, pressed: boolean, onChange: (pressed: boolean) => void): HTMLButtonElement {
  const show = (state: boolean): void => {
    made.setAttribute("aria-pressed", String(state));
    onChange(state);
  };
  const made = button(text, title, () => {
    show(made.getAttribute("aria-pressed") !== "true");
  });
  made.classList.add("toggle");
  show(pressed);
  return made;
}

// One of several. onChange is called at once with the first.
export function choice(names: readonly string[], title: string, onChange: (index: number) => void): HTMLElement {
  const group = element("span", "choice");
  group.setAttribute("role", "group");
  group.setAttribute("aria-label", title);
  const show = (chosen: number): void => {
    buttons.forEach((made, index) => {
      made.setAttribute("aria-pressed", String(index === chosen));
    });
    onChange(chosen);
  };
  const buttons = names.map((name, index) =>
    button(name, `${title}: ${name}`, () => {
      show(index);
    }),
  );
  group.append(...buttons);
  show(0);
  return group;
}

// One of several in a list that opens. onChange is not called at first.
export function select(label: string, title: string, names: readonly string[], onChange: (index: number) => void): HTMLLabelElement {
  const holder = element("label", "select", label);
  holder.title = title;
  const list = element("select");
  list.setAttribute("aria-label", label);
  list.append(...names.map((name) => element("option", "", name)));
  list.addEventListener("change", () => { onChange(list.selectedIndex); });
  holder.append(list);
  return holder;
}

// The value of a CSS variable of the page, which depends on the reader's colour scheme.
export function cssColour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

export function onColourScheme(change: () => void): void {
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", change);
}

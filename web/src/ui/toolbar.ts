// SPDX-License-Identifier: Apache-2.0
import { el, icon } from "./dom";
import { icons } from "./icons";

export interface Tool {
  icon: keyof typeof icons;
  name: string;
  key: string;
  /** Absent for tools that do one thing at once. */
  isOn?: () => boolean;
  run: () => void;
  isHidden?: boolean;
}

/** The row of tools at the bottom; `refresh` shows anew which are on. */
export class Toolbar {
  readonly element = el("div", { class: "toolbar glass", role: "toolbar", "aria-label": "View" });
  private readonly buttons: [HTMLButtonElement, Tool][] = [];

  constructor(groups: Tool[][]) {
    groups.forEach((tools, i) => {
      if (i > 0) this.element.append(el("span", { class: "gap" }));
      for (const tool of tools) if (!tool.isHidden) this.element.append(this.button(tool));
    });
    this.refresh();
  }

  refresh(): void {
    for (const [button, tool] of this.buttons) if (tool.isOn) button.setAttribute("aria-pressed", `${tool.isOn()}`);
  }

  private button(tool: Tool): HTMLButtonElement {
    const label = `${tool.name} (${tool.key})`;
    const button = el(
      "button",
      { type: "button", "aria-label": label, "data-tip": label, "data-tool": tool.icon, onclick: () => tool.run() },
      icon(icons[tool.icon]),
    );
    this.buttons.push([button, tool]);
    return button;
  }
}

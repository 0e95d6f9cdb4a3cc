// SPDX-License-Identifier: Apache-2.0

export type ThemeName = "light" | "dark";

/** What the system prefers until the person chooses. */
export class Theme {
  private chosen: ThemeName | undefined;
  private readonly system = matchMedia("(prefers-color-scheme: dark)");

  constructor(private readonly changed: () => void) {
    this.system.addEventListener("change", () => this.apply());
    document.documentElement.dataset.theme = this.name;
  }

  get name(): ThemeName {
    return this.chosen ?? (this.system.matches ? "dark" : "light");
  }

  toggle(): void {
    this.chosen = this.name === "dark" ? "light" : "dark";
    this.apply();
  }

  private apply(): void {
    document.documentElement.dataset.theme = this.name;
    this.changed();
  }
}

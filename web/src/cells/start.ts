// SPDX-License-Identifier: Apache-2.0
import "../style.css";
import "./cells.css";

/** What every page tells tests of itself. */
export interface PageHook {
  ready: boolean;
  error?: string;
}

function answer(hook: PageHook): void {
  (window as unknown as { quoinView: PageHook }).quoinView = hook;
}

/** Makes the page once it was painted, so that "Loading" is seen; what goes wrong is told where whoever opened it looks. */
export function start(make: (host: HTMLElement) => { hook(): PageHook }): void {
  const message = document.getElementById("message") as HTMLElement;
  const run = () => {
    try {
      answer(make(document.getElementById("app") as HTMLElement).hook());
      message.hidden = true;
    } catch (error) {
      const heading = document.createElement("strong");
      heading.textContent = "This page cannot be shown.";
      const text = document.createElement("span");
      text.textContent = error instanceof Error ? error.message : String(error);
      message.className = "notice";
      message.setAttribute("role", "alert");
      message.replaceChildren(heading, text);
      answer({ ready: false, error: text.textContent });
    }
  };
  requestAnimationFrame(() => setTimeout(run));
}

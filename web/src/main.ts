// SPDX-License-Identifier: Apache-2.0
import "./style.css";
import { readScene } from "./scene_data";
import { Viewer } from "./viewer";

const message = document.getElementById("message") as HTMLElement;

/** In the page, where whoever opened it looks. */
function tell(title: string, explanation: string): void {
  message.className = "notice";
  message.setAttribute("role", "alert");
  const heading = document.createElement("strong");
  heading.textContent = title;
  const text = document.createElement("span");
  text.textContent = explanation;
  message.replaceChildren(heading, text);
  message.hidden = false;
  window.quoinView = { ready: false, error: `${title} ${explanation}` };
}

/** Who draws; empty when nobody does. */
function graphicsDevice(): string {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return "";
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return name || "unknown";
}

function start(): void {
  try {
    const scene = readScene();
    const device = graphicsDevice();
    if (!device) {
      tell(
        "This browser cannot draw in 3D.",
        "The page needs WebGL 2. It may be switched off in the browser's settings, or the graphics driver may be missing; another browser may do.",
      );
      return;
    }
    const viewer = new Viewer(document.getElementById("app") as HTMLElement, scene, device, tell);
    window.quoinView = viewer.testHook();
    message.hidden = true;
  } catch (error) {
    tell("This page cannot be shown.", error instanceof Error ? error.message : String(error));
  }
}

// After the page was painted once, so that "Loading" is seen while a large scene is unpacked.
requestAnimationFrame(() => setTimeout(start));

// SPDX-License-Identifier: MIT
import "./style.css";

import type { Chapter, OpenChapter } from "./chapter";
import { chapters } from "./chapters";
import { element, required } from "./dom";
import { loadEngine, messageOf } from "./engine";
import { HelpDialog } from "./help";
import { isMeshFile } from "./meshes/mesh_files";
import { Overlay } from "./overlay";
import { isReport, isSceneFile } from "./scene/files";
import { Stage } from "./stage";
import { AddressBar, readPlace } from "./state";
import { Theme } from "./theme";

async function start(): Promise<void> {
  const theme = new Theme();
  const stage = new Stage(required("canvas", HTMLCanvasElement), theme);
  const overlayRoot = document.getElementById("overlay");
  if (!(overlayRoot instanceof SVGSVGElement)) throw new Error("the page has no element #overlay");
  const overlay = new Overlay(overlayRoot, stage);
  const panel = required("panel", HTMLElement);
  const caption = required("caption", HTMLElement);
  const help = new HelpDialog(required("help-dialog", HTMLDialogElement));
  const tabs = required("tabs", HTMLElement);
  const address = new AddressBar();
  const graze = await loadEngine();
  const first = chapters[0];
  let open: OpenChapter | undefined;

  const show = (chapter: Chapter, parameters: URLSearchParams): void => {
    address.forget();
    open?.close();
    open = undefined;
    stage.clear();
    overlay.clear();
    panel.replaceChildren();
    panel.scrollTop = 0;
    caption.textContent = "";
    document.title = `${chapter.title} · graze`;
    for (const tab of tabs.querySelectorAll("a")) {
      const isCurrent = tab.dataset["chapter"] === chapter.id;
      tab.removeAttribute("aria-current");
      if (isCurrent) tab.setAttribute("aria-current", "page");
      if (isCurrent) tab.scrollIntoView({ block: "nearest", inline: "nearest" });
    }
    const changed = (): void => address.write(() => ({ chapter: chapter.id, parameters: open?.parameters() ?? parameters }));
    const say = (text: string): void => {
      if (caption.textContent !== text) caption.textContent = text;
    };
    open = chapter.open({ graze, stage, overlay, panel, parameters, changed, say });
    changed();
    document.documentElement.dataset["chapter"] = chapter.id;
  };

  const follow = (): void => {
    if (open !== undefined && address.isOwn(location.hash)) return;
    const place = readPlace(location.hash);
    const usual = !isReport ? first : chapters.find((known) => known.id === "scene");
    const chapter = chapters.find((known) => known.id === place.chapter) ?? usual;
    if (chapter !== undefined) show(chapter, place.parameters);
  };

  tabs.append(...chapters.map((chapter) => element("a", { href: `#${chapter.id}`, "data-chapter": chapter.id }, chapter.title)));
  required("theme", HTMLButtonElement).addEventListener("click", () => theme.toggle());
  required("help", HTMLButtonElement).addEventListener("click", () => help.toggle());
  required("zoom-in", HTMLButtonElement).addEventListener("click", () => stage.zoomBy(1.25));
  required("zoom-out", HTMLButtonElement).addEventListener("click", () => stage.zoomBy(0.8));
  required("fit", HTMLButtonElement).addEventListener("click", () => stage.fit());
  window.addEventListener("hashchange", follow);
  window.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || isTyping(event.target) || help.isOpen) return;
    if (open?.onKey?.(event) === true || onKey(event.key)) event.preventDefault();
  });
  const onKey = (key: string): boolean => {
    const actions: Record<string, () => void> = {
      "?": () => help.toggle(),
      t: () => theme.toggle(),
      "+": () => stage.zoomBy(1.25),
      "=": () => stage.zoomBy(1.25),
      "-": () => stage.zoomBy(0.8),
      "0": () => stage.fit(),
      ArrowLeft: () => stage.nudge(-1, 0),
      ArrowRight: () => stage.nudge(1, 0),
      ArrowUp: () => stage.nudge(0, 1),
      ArrowDown: () => stage.nudge(0, -1),
    };
    const chapter = chapters[Number(key) - 1];
    if (chapter !== undefined) location.hash = chapter.id;
    else actions[key]?.();
    return chapter !== undefined || actions[key] !== undefined;
  };
  listenToFiles((files) => {
    const current = document.documentElement.dataset["chapter"];
    const isMesh = files.some(isMeshFile) || (current === "meshes" && !files.some(isSceneFile));
    const wanted = chapters.find((known) => known.id === (isMesh ? "meshes" : "scene"));
    if (wanted !== undefined && current !== wanted.id) {
      history.replaceState(null, "", `#${wanted.id}`);
      show(wanted, new URLSearchParams());
    }
    open?.onFiles?.(files);
  });
  follow();
}

/** Accepts files dropped anywhere on the page. */
function listenToFiles(onFiles: (files: readonly File[]) => void): void {
  const stage = required("stage", HTMLElement);
  const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;
  window.addEventListener("dragover", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    stage.classList.add("dropping");
  });
  window.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) stage.classList.remove("dropping");
  });
  window.addEventListener("drop", (event) => {
    stage.classList.remove("dropping");
    if (!hasFiles(event)) return;
    event.preventDefault();
    onFiles([...(event.dataTransfer?.files ?? [])]);
  });
}

/** True for elements in which letters and arrow keys have their own meaning. */
function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement || target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
}

start().catch((error: unknown) => {
  const text = element("p", { class: "message", role: "alert" }, `The page cannot start: ${messageOf(error)}`);
  document.querySelector("main")?.replaceChildren(element("div", { class: "failure" }, text));
});

// Starts the page. The engine is loaded, the catalogue is read, and the design in the address is shown. If
// the address contains no design, the start screen is shown.

import "../../../gearwright/figure/figure_style.css";
import "../../../gearwright/figure/figure_script.js";
import "../../../gearwright/figure/turn_script.js";
import "../../../gearwright/figure/zoom_script.js";
import "./style/page.css";
import "./style/spec.css";
import "./style/views.css";
import { makeWorker, wasmBytes } from "gearwright:parts";
import { setCatalogue } from "./catalogue";
import { h, sentenceOf } from "./elements";
import { ContactView } from "./contact/contact_view";
import { doorOf } from "./door";
import { EngineLink } from "./engine_link";
import { textOf } from "./link";
import { LoadView } from "./load/load_view";
import { MeshView } from "./mesh/mesh_view";
import { DriveView } from "./drive/drive_view";
import { Page } from "./page";
import { RatingView } from "./rating/rating_view";
import { ScatterView } from "./scatter/scatter_view";
import { SearchView } from "./search/search_view";
import { SheetView } from "./sheet";
import { ShiftsView } from "./shifts/shifts_view";
import { SolidView } from "./solid/solid_view";
import { bench } from "./workbench";

const kReading = 12_000; // ms for which a message is shown, enough to read a sentence

async function begin(): Promise<void> {
  bench.front = new EngineLink(makeWorker, wasmBytes);
  bench.back = new EngineLink(makeWorker, wasmBytes);
  bench.press = new EngineLink(makeWorker, wasmBytes);
  bench.seek = new EngineLink(makeWorker, wasmBytes);
  setCatalogue(await bench.front.call("catalogue", undefined as never));
  const page = new Page([
    new MeshView(),
    new DriveView(),
    new SolidView(),
    new ContactView(),
    new LoadView(),
    new RatingView(),
    new ScatterView(),
    new ShiftsView(),
    new SearchView(),
    new SheetView(),
  ]);
  window.gearwright = doorOf(page);
  const fromAddress = async () => {
    try {
      const text = await textOf(location.hash);
      if (text !== null && text !== bench.text) page.begin(text);
      return text !== null;
    } catch (reason) {
      page.showStarts();
      page.notify(sentenceOf(reason), kReading);
      return true;
    }
  };
  addEventListener("hashchange", () => void fromAddress());
  if (!(await fromAddress())) page.showStarts();
  performance.mark("ready");
  document.documentElement.dataset["ready"] = "true";
}

begin().catch((reason) => {
  document.body.replaceChildren(
    h(
      "main",
      { class: "broken" },
      h("h1", {}, "Gearwright"),
      h(
        "p",
        { role: "alert" },
        `The engine did not start: ${sentenceOf(reason)}.`,
      ),
      h(
        "p",
        {},
        "A browser with WebAssembly exceptions is needed: Chromium 95, Firefox 100, Safari 15.2 or newer.",
      ),
    ),
  );
});

// The tab "drive" shows the scheme of a drive, its power flow and its curves under load.

import { scroller } from "../elements";
import { Figures } from "../figure_slot";
import type { Tab } from "../tabs";
import { bench } from "../workbench";

export class DriveView implements Tab {
  readonly id = "drive";
  readonly ofDrives = "only";
  private readonly figures = new Figures(undefined, () => {
    this.shown = "";
    void this.refresh();
  });
  readonly picture = this.figures.element;
  readonly element = scroller("side-room", "drive", this.picture);
  shown = "";

  async refresh(): Promise<void> {
    const text = bench.good?.text;
    if (text === this.shown) return;
    this.shown = "";
    if (text === undefined) return this.figures.show([]);
    const question = { text, width: this.figures.fit() };
    const figures = await bench.about(bench.front, "drive", "driveFigures", question);
    if (!figures || bench.good?.text !== text) return;
    this.figures.show(figures);
    this.shown = text;
    // The load along the teeth takes seconds, so it is computed beside the other results.
    const loaded = await bench.about(bench.back, "drive load", "driveLoadFigures", question);
    if (loaded && this.shown === text) this.figures.show(loaded, false);
  }
}

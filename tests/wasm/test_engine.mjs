// Tests the interface of engine.d.ts: shapes, errors, poses, work in steps.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { inflateRawSync } from "node:zlib";
import { loadEngine, source } from "./engine.mjs";

const { engine, failed } = await loadEngine();
const example = (name) => readFileSync(path.join(source, "examples", `${name}.toml`), "utf8");
const near = (a, b, tolerance) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

const tests = {
  a_refusal_is_an_object_with_its_line() {
    const session = engine.open("[gear1]\nteeth = 17\nnormal_module_mm = -2\n");
    assert.ok(failed(session));
    assert.equal(session.error.key, "gear1.normal_module_mm");
    assert.equal(session.error.line, 3);
    const said = JSON.parse(engine.run("pair", "[gear1\n"));
    assert.ok(failed(said));
    assert.match(said.error.message, /line 1/);
    assert.ok(failed(JSON.parse(engine.run("bake", "[gear1]\nteeth = 17"))));
    assert.ok(failed(engine.toToml('{"gear1": null}')));
    assert.ok(failed(JSON.parse(engine.run("pair", "x".repeat(5 << 20)))));
  },

  corrections_are_found() {
    const { compensate } = JSON.parse(engine.run("compensate", example("misaligned_pair")));
    assert.deepEqual(compensate.corrections.map((one) => one.key), ["gear1.lead_slope_um", "gear1.lead_crowning_um"]);
    assert.ok(compensate.after.continuous_peak_to_peak_arcsec < compensate.before.continuous_peak_to_peak_arcsec);
    assert.ok(compensate.after.edge_share < compensate.before.edge_share);
  },

  text_and_tree_are_one() {
    for (const name of ["helical_pair", "circular_arc_drive", "gearbox_search"]) {
      const tree = JSON.parse(engine.toJson(example(name)));
      assert.deepEqual(JSON.parse(engine.toJson(engine.toToml(JSON.stringify(tree)))), tree);
    }
    const text = example("helical_pair");
    const edited = engine.edit(text, "gear1.teeth", "19");
    assert.equal(JSON.parse(engine.toJson(edited)).gear1.teeth, 19);
    assert.equal(edited.split("#").length, text.split("#").length);
  },

  the_catalogue_knows_every_key_of_a_result() {
    const { inputs, quantities } = JSON.parse(engine.catalogue());
    const table = (name) => quantities.find((t) => t.name === name).quantities;
    const said = JSON.parse(engine.run("pair", example("helical_pair")));
    for (const [name, record] of [["gear", said.gears[0]], ["pair", said.pair], ["verdict", said.verdict]])
      for (const key of Object.keys(record)) assert.ok(table(name).some((q) => q.key === key), `${name}.${key}`);
    // Every table of the schema of results exists.
    for (const name of Object.keys(JSON.parse(engine.schema("result")).$defs))
      assert.ok(quantities.some((t) => t.name.replaceAll(" ", "_") === name), `no table ${name}`);
    assert.equal(inputs[0].name, "spec");
    const gear = inputs.find((t) => t.name === "gear");
    assert.ok(gear.keys.find((k) => k.key === "teeth").required);
    const names = new Set(inputs.map((t) => t.name));
    for (const t of inputs) for (const k of t.keys) for (const n of k.tables) assert.ok(names.has(n), n);
    assert.ok(JSON.parse(engine.schema("spec")).$schema && JSON.parse(engine.schema("result")).$schema);
  },

  load_in_steps_is_load_at_once_and_its_picture_is_the_answers() {
    const text = example("loaded_pair").replace("positions = 32", "positions = 6\naccuracy = \"draft\"");
    const session = engine.open(text);
    const once = engine.run("load", text);
    for (let again = 0; again < 2; ++again) {
      // the second time with cached tables
      const work = session.load();
      let steps = 0;
      for (let state = work.step(1); !state.finished; state = work.step(1)) {
        assert.ok(!failed(state), JSON.stringify(state));
        assert.ok(state.done < state.of && ++steps < 100);
      }
      const { json } = work.result();
      assert.equal(json, once);
      const said = JSON.parse(json).load.torques;
      const torques = work.rows().map((rows) => Number(rows.find((row) => row.id === "load.torque_Nm").texts[0]));
      assert.deepEqual(torques, said.map((torque) => torque.torque_Nm));
      for (const [t, torque] of said.entries()) {
        const figures = new Map(work.figures(t, 600).map((one) => [one.id, one]));
        const greatest = (id, curve) =>
          Math.max(...figures.get(id).data.curves[curve].points.map((point) => point[1]));
        assert.equal(greatest("mesh-stiffness", t), torque.mesh_stiffness_N_per_mm_um.max);
        assert.equal(greatest("pressure-along", 0), torque.max_pressure_MPa);
        for (const gear of [0, 1]) assert.equal(greatest("root-stress-turn", gear), torque.max_root_stress_MPa[gear]);
        assert.ok(figures.get("pressure2").html.includes("<svg"));
      }
      work.delete();
    }
    assert.equal(engine.open(example("helical_pair")).load().error.key, "load.torque_Nm");
    session.delete();
  },

  rows_are_the_numbers_of_the_json() {
    const session = engine.open(example("misaligned_pair"));
    const row = (rows, id) => rows.find((one) => one.id === id);
    const shown = (text, value) => assert.equal(text, value.toFixed(text.split(".")[1]?.length ?? 0));
    const { gears, pair } = JSON.parse(session.json("pair"));
    const rows = session.rows("pair");
    shown(row(rows, "pair.backlash.normal_mm").texts[0], pair.backlash.normal_mm);
    for (const gear of [0, 1]) shown(row(rows, "gears.tip_diameter_mm").texts[gear], gears[gear].tip_diameter_mm);
    session.showIn("in");
    const inInch = row(session.rows("pair"), "pair.center_distance_mm");
    assert.equal(inInch.unit, "in");
    shown(inInch.texts[0], pair.center_distance_mm / 25.4);
    const { contact } = JSON.parse(session.json("contact"));
    shown(row(session.rows("contact"), "contact.peak_to_peak_arcsec").texts[0], contact.peak_to_peak_arcsec);
    assert.deepEqual(session.rows("rate"), []);
    session.delete();
  },

  a_pose_puts_the_flanks_together() {
    for (const name of ["helical_pair", "misaligned_pair", "ring_pair", "crossed_pair"]) {
      const session = engine.open(example(name));
      for (const rotation of [-3, 0, 5.5]) {
        const at = session.contactPoint(rotation);
        if (at.kind === "none") continue;
        // The point lies on both gears at the diameters and heights of the contact result.
        for (const gear of [1, 2]) {
          const x = session.pose(gear, rotation);
          const axis = [x[8], x[9], x[10]];
          const d = at.point_mm.map((c, i) => c - x[12 + i]);
          const z = d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
          const r = Math.hypot(...d.map((c, i) => c - z * axis[i]));
          near(z, at.height_mm[gear - 1], 1e-9);
          near(2 * r, at.diameter_mm[gear - 1], 1e-9);
          near(Math.hypot(...axis), 1, 1e-12);
        }
        if (name === "misaligned_pair") assert.notEqual(session.pose(1, rotation)[8], 0);
      }
      session.delete();
    }
  },

  the_parts_of_a_drive_turn_with_its_speed_ratios() {
    for (const name of ["drives/planetary_set", "drives/robot_joint", "drives/two_stage_gearbox"]) {
      const session = engine.open(example(name));
      const solids = session.driveSolids();
      assert.ok(!failed(solids), JSON.stringify(solids));
      const { drive } = JSON.parse(session.json("drive"));
      assert.deepEqual(solids.bodies.map((body) => body.name).sort(), Object.keys(drive.bodies).sort());
      for (const { name, ratio } of solids.bodies) assert.equal(ratio, drive.bodies[name].speed_ratio);
      for (const part of solids.parts) {
        assert.equal(part.turn, drive.bodies[solids.bodies[part.body].name].speed_ratio);
        assert.ok((part.mesh === null) === (part.same !== null) && (part.mesh ?? solids.parts[part.same].mesh).indices.length);
        // Planets are on a circle about the axis of the carrier. All other parts stay on their axes.
        const off = Math.hypot(part.pose[12] - part.about[0], part.pose[13] - part.about[1]);
        if (solids.bodies[part.body].rides) near(off, drive.center_distance_mm, 1e-9);
        else assert.equal(off, 0);
      }
      session.delete();
    }
  },

  contact_in_columns_is_contact_in_json() {
    const session = engine.open(example("misaligned_pair"));
    const { contact } = JSON.parse(session.json("contact"));
    const curve = session.contactCurve(contact.positions.length);
    assert.equal(curve.peakToPeakArcsec, contact.peak_to_peak_arcsec);
    contact.positions.forEach((p, i) => {
      assert.equal(curve.columns.transmission_error_arcsec[i], p.transmission_error_arcsec);
      assert.equal(curve.columns.kind[i], p.kind);
      assert.equal(curve.columns.point_mm[3 * i + 1], p.point_mm[1]);
      if (p.ellipse) assert.equal(curve.columns["ellipse.semi_minor_mm"][i], p.ellipse.semi_minor_mm);
    });
    const gap = session.gapMap(0, 0, 9, 17);
    assert.equal(gap.gap.length, 9 * 17);
    const work = session.pattern(32, 17, 17);
    while (!work.step(5).finished);
    assert.equal(work.result()[1].gap.length, 17 * 17);
    const map = session.errorMap({ key: "crossing_deg", from: -0.05, to: 0.05, n: 3 },
      { key: "center_distance_mm", from: 0, to: 0.1, n: 2 }, 16);
    let step;
    do step = map.step(1); while (!step.finished);
    assert.ok(map.result().peakToPeakArcsec.every((v) => v >= 0));
    assert.ok(failed(session.errorMap({ key: "crossing", from: 0, to: 1, n: 2 }, { key: "axial_mm", from: 0, to: 1, n: 2 })));
  },

  the_chart_of_shifts_has_the_point_where_it_is() {
    const session = engine.open(example("helical_pair"));
    const chart = session.shiftRegion();
    assert.ok(!failed(chart), JSON.stringify(chart));
    assert.ok(Object.values(chart.borders).length > 2 && Object.values(chart.borders).every(Boolean));
    assert.equal(chart.inside, chart.margin >= 0);
  },

  a_search_in_steps_is_the_search() {
    const text = example("gearbox_search");
    const search = engine.openSearch(text);
    assert.ok(!failed(search), JSON.stringify(search));
    let steps = 0;
    while (!search.step(20).finished) steps += 1;
    assert.equal(search.result().json, engine.run("search", text));
    assert.match(search.take(1), /\[gear1\]/);
    assert.ok(failed(search.take(100000000)));
    assert.match(new TextDecoder().decode(search.report().subarray(0, 40)), /<!doctype html>/i);
    search.delete();
    assert.ok(steps > 0);
  },

  files_are_files() {
    const session = engine.open(example("helical_pair"));
    const start = (kind, gear = 0) => {
      const bytes = session.file(kind, gear, 0.05);
      assert.ok(!failed(bytes), JSON.stringify(bytes));
      return Buffer.from(bytes);
    };
    assert.equal(start("glb").toString("latin1", 0, 4), "glTF");
    const stl = start("stl", 1);
    assert.equal(stl.length, 84 + 50 * stl.readUInt32LE(80));
    assert.match(start("dxf", 1).toString("utf8", 0, 200), /SECTION/);
    assert.match(start("svg", 2).toString("utf8", 0, 200), /<svg/);
    assert.match(start("report").toString("utf8", 0, 60), /<!doctype html>/i);
    // A 3MF file is a ZIP archive. zlib must be able to unpack its parts, although it did not pack them.
    const zip = start("3mf", 1);
    let at = 0;
    let model = "";
    while (zip.readUInt32LE(at) === 0x04034b50) {
      const [packed, size, name, extra] = [zip.readUInt32LE(at + 18), zip.readUInt32LE(at + 22),
        zip.readUInt16LE(at + 26), zip.readUInt16LE(at + 28)];
      const from = at + 30 + name + extra;
      const content = inflateRawSync(zip.subarray(from, from + packed));
      assert.equal(content.length, size);
      if (zip.toString("utf8", at + 30, at + 30 + name).endsWith(".model")) model = content.toString();
      at = from + packed;
    }
    assert.match(model, /<\/model>/);
    assert.ok(zip.length < model.length / 2);
  },
};

let bad = 0;
for (const [name, test] of Object.entries(tests)) {
  try {
    test();
    console.log(`ok    ${name}`);
  } catch (e) {
    bad += 1;
    console.log(`FAIL  ${name}\n${e.stack}`);
  }
}
process.exit(bad ? 1 : 0);

// Validates values with ajv: one JSON line {"name", "value"} each on stdin, one line {"name",
// "valid", "why"} each on stdout. The schema file is the argument.
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import Ajv2020 from "ajv/dist/2020.js";

// strictRequired requires `required` next to its `properties`, which an anyOf of alternatives does
// not satisfy.
const ajv = new Ajv2020({ strict: true, strictRequired: false, strictTypes: false, allErrors: false });
const validate = ajv.compile(JSON.parse(readFileSync(process.argv[2], "utf8")));
for await (const line of createInterface({ input: process.stdin })) {
  const { name, value } = JSON.parse(line);
  const valid = validate(value);
  const why = (validate.errors ?? []).map((e) => `${e.instancePath} ${e.message}`).join("; ");
  process.stdout.write(JSON.stringify({ name, valid, why }) + "\n");
}

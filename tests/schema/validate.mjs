// Validates values with ajv. Each line of stdin is {"name", "value"} in JSON, and each line of stdout is
// {"name", "valid", "why"}. The argument is the schema file.
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import Ajv2020 from "ajv/dist/2020.js";

// strictRequired demands that `properties` accompany each `required`. A list of alternatives (anyOf) does not
// satisfy this.
const ajv = new Ajv2020({ strict: true, strictRequired: false, strictTypes: false, allErrors: false });
const validate = ajv.compile(JSON.parse(readFileSync(process.argv[2], "utf8")));
for await (const line of createInterface({ input: process.stdin })) {
  const { name, value } = JSON.parse(line);
  const valid = validate(value);
  const why = (validate.errors ?? []).map((e) => `${e.instancePath} ${e.message}`).join("; ");
  process.stdout.write(JSON.stringify({ name, valid, why }) + "\n");
}

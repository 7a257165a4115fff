// Reads a Parquet file with DuckDB, an independent reader.
//
//   node read_parquet.mjs FILE SQL
//
// The rows of FILE (a pattern like 'shards/*.parquet' too) are the view `data`, in their order; the
// name is getvariable('file'), as in  select * from parquet_metadata(getvariable('file')).
//
// Prints the result as a JSON list, one object a row on a line of its own. Doubles are printed so that
// they read back to the same bits, -0.0 among them; integers beyond 2^53, NaN and the infinities are
// strings ("9223372036854775807", "NaN", "-Infinity"), bytes are taken as UTF-8 text.
// Exit status 1 with a message: DuckDB is not installed, or refuses the file or the query.
import {createRequire} from 'node:module';

function fail(message) {
  console.error(`read_parquet: ${message}`);
  process.exit(1);
}

function json(value) {
  if (value === null || value === undefined) return 'null';
  if (typeof value === 'bigint') {
    return Number.isSafeInteger(Number(value)) ? String(value) : `"${value}"`;
  }
  if (typeof value === 'number') {
    if (!Number.isFinite(value)) return `"${value}"`;
    return Object.is(value, -0) ? '-0.0' : String(value);  // String(-0) is 0
  }
  if (value instanceof Uint8Array) return JSON.stringify(Buffer.from(value).toString('utf8'));
  if (Array.isArray(value)) return `[${value.map(json).join(',')}]`;
  if (typeof value === 'object' && !(value instanceof Date)) {
    return `{${Object.entries(value).map(([k, v]) => `${JSON.stringify(k)}:${json(v)}`).join(',')}}`;
  }
  return JSON.stringify(value);
}

const quoted = (text) => `'${text.replaceAll("'", "''")}'`;

const [file, sql] = process.argv.slice(2);
if (sql === undefined) fail('usage: node read_parquet.mjs FILE SQL');
let duckdb;
try {
  duckdb = createRequire(import.meta.url)('@duckdb/node-api');
} catch (error) {
  fail(`DuckDB is not installed (tools/install_npm_tools.sh): ${error.message}`);
}
try {
  const instance = await duckdb.DuckDBInstance.create(':memory:', {
    autoinstall_known_extensions: 'false', preserve_insertion_order: 'true'});
  const connection = await instance.connect();
  await connection.run(`set variable file = ${quoted(file)}`);
  await connection.run(`create view data as select * from read_parquet(${quoted(file)})`);
  const reader = await connection.runAndReadAll(sql);
  const rows = reader.getRowObjectsJS().map(json);
  process.stdout.write(rows.length ? `[\n${rows.join(',\n')}\n]\n` : '[]\n');
} catch (error) {
  fail(error.message);
}

// Reads a Parquet file with DuckDB, an independent reader.
//
//   node read_parquet.mjs FILE SQL
//
// The rows of FILE, in their order, are the view `data`. FILE may be a pattern such as 'shards/*.parquet'.
// Its name is getvariable('file'), as in  select * from parquet_metadata(getvariable('file')).
//
// The script prints the result as a JSON list with one object (row) per line. Doubles, including -0.0, are
// printed so that reading them gives the same bits. Integers beyond 2^53, NaN and infinities are strings
// ("9223372036854775807", "NaN", "-Infinity"). Bytes are read as UTF-8 text. Exit status 1, with a message:
// DuckDB is not installed, or it rejects the file or the query.
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

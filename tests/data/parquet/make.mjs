// SPDX-License-Identifier: GPL-3.0-or-later
// node make.mjs FOLDER: writes these files again, with apache-arrow 21.2, parquet-wasm 0.8, hyparquet-writer 0.17 and
// @duckdb/node-api 1.5 of npm.
import fs from 'fs';
import * as arrow from 'apache-arrow';
import * as pw from 'parquet-wasm';
import {parquetWriteBuffer} from 'hyparquet-writer';
import {DuckDBInstance} from '@duckdb/node-api';
const out = process.argv[2];
fs.mkdirSync(out, {recursive: true});
const n = 201;
const c = {t_ms: [], x: [], y: [], z: [], qw: [], qx: [], qy: [], qz: [], jaw: []};
for (let i = 0; i < n; ++i) {
  const s = i / 200, a = Math.PI / 4 * s;
  const row = {t_ms: 500 + 20 * i, x: 0.1 + 0.2 * s, y: -0.05, z: 0.3, qw: Math.cos(a), qx: 0, qy: 0, qz: Math.sin(a), jaw: 1.2 - 1.5 * s};
  for (const k in row) c[k].push(row[k]);
}
const f64 = (v) => arrow.vectorFromArray(v, new arrow.Float64);
const vectors = () => Object.fromEntries(Object.entries(c).map(([k, v]) => [k, f64(v)]));
function write(name, v, props) {
  const table = pw.Table.fromIPCStream(arrow.tableToIPC(new arrow.Table(v), 'stream'));
  fs.writeFileSync(out + '/' + name, pw.writeParquet(table, props));
}
const P = () => new pw.WriterPropertiesBuilder();
{ // pages of version 2, gzip, a time stamp in milliseconds, lists and text beside
  const v = vectors();
  v.t_ms = arrow.vectorFromArray(c.t_ms.map((t) => new Date(t)), new arrow.TimestampMillisecond);
  v.state = arrow.vectorFromArray(c.x.map((x) => [x, 1]), new arrow.List(new arrow.Field('item', new arrow.Float32, true)));
  v.note = arrow.vectorFromArray(c.x.map((_, i) => (i % 3 ? 'a, "b"' : null)), new arrow.Utf8);
  write('arrow-gzip-2.parquet', v, P().setCompression(pw.Compression.GZIP).setWriterVersion(pw.WriterVersion.V2).setDictionaryEnabled(true).setMaxRowGroupSize(64).build());
}
write('arrow-zstd.parquet', vectors(), P().setCompression(pw.Compression.ZSTD).setDictionaryEnabled(true).build());
{ // gaps: rows without a pose
  const v = vectors();
  for (const k of ['x', 'y', 'z', 'qw', 'qx', 'qy', 'qz']) v[k] = f64(c[k].map((x, i) => (i === 0 || i === 98 ? null : x)));
  write('arrow-gaps.parquet', v, P().setCompression(pw.Compression.SNAPPY).setDictionaryEnabled(false).setMaxRowGroupSize(50).build());
}
write('arrow-brotli.parquet', {x: f64([1, 2])}, P().setCompression(pw.Compression.BROTLI).build());
{
  const t = c.t_ms.map((x) => BigInt(x));
  const columnData = [{name: 't_ms', data: t, type: 'INT64'}, ...Object.keys(c).filter((k) => k !== 't_ms').map((k) => ({name: k, data: c[k], type: 'DOUBLE'}))];
  fs.writeFileSync(out + '/hyparquet.parquet', Buffer.from(parquetWriteBuffer({columnData})));
}
const db = await (await DuckDBInstance.create(':memory:')).connect();
await db.run('create table k(t_ms integer, x double, y double, z double, qw double, qx double, qy double, qz double, jaw float)');
for (let i = 0; i < n; ++i) await db.run(`insert into k values (${Object.keys(c).map((k) => c[k][i]).join(',')})`);
await db.run(`copy k to '${out}/duckdb.parquet' (format parquet)`);
await db.run(`copy k to '${out}/duckdb-delta.parquet' (format parquet, compression zstd, parquet_version v2)`);
await db.run(`create table m as select * from (values ('S_B1.txt','GRS 1',12),('S_B1.txt','GRS 2',13),('S_C2.txt','GRS 1',22)) as t(recording,rater,score)`);
await db.run(`copy m to '${out}/marks.parquet' (format parquet)`);

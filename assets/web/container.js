// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the binary answers of the server: "TRS1", length of the JSON, JSON, arrays.

const kTypes = { f32: Float32Array, i16: Int16Array, u16: Uint16Array, u32: Uint32Array, u8: Uint8Array, i8: Int8Array };
const kHead = 8;

/// Returns {meta, arrays: {name: typed array}}, views into `buffer` where possible. Throws RangeError if it
/// is malformed.
export function readContainer(buffer) {
  const view = new DataView(buffer);
  if (buffer.byteLength < kHead || view.getUint32(0) !== 0x54525331) throw new RangeError('not a container');
  const length = view.getUint32(4, true);
  if (kHead + length > buffer.byteLength) throw new RangeError('the container breaks off');
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, kHead, length)));
  const arrays = {};
  for (const { name, type, offset, count, delta, scale } of head.arrays) {
    if (!(type in kTypes)) throw new RangeError(`unknown type ${type}`);
    const values = new kTypes[type](buffer, kHead + length + offset, count);
    arrays[name] = delta ? summedUp(values, delta, scale) : values;
  }
  return { meta: head.meta, arrays };
}

/// Sums differences to the value `stride` before, wrapping like the type; with `scale` the sums are
/// multiplied by it.
function summedUp(differences, stride, scale) {
  const sums = differences.slice();
  for (let i = stride; i < sums.length; ++i) sums[i] += sums[i - stride];
  return scale === undefined ? sums : Float32Array.from(sums, (value) => value * scale);
}

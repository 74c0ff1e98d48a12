// Reads traces/CELL.dobtrace of a run directory; the format stands in results/trace.h.
import { readFileSync } from "node:fs";
import { inflateSync } from "node:zlib";

/** {rate_Hz, rows, columns: name -> Float32Array} */
export function readTrace(file) {
  const bytes = readFileSync(file);
  const length = bytes.readUInt32LE(12);
  const { rate_Hz, rows, names } = JSON.parse(bytes.subarray(16, 16 + length).toString());
  const data = inflateSync(bytes.subarray(16 + length));
  const columns = new Map();
  names.forEach((name, i) => {
    const column = new DataView(new ArrayBuffer(4 * rows)); // the bytes of a column are sorted by significance
    for (let byte = 0; byte < 4; ++byte) {
      for (let row = 0; row < rows; ++row) column.setUint8(4 * row + byte, data[(4 * i + byte) * rows + row]);
    }
    columns.set(name, Float32Array.from({ length: rows }, (_, row) => column.getFloat32(4 * row, true)));
  });
  return { rate_Hz, rows, columns };
}

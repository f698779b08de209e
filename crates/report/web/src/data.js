// The report that stands in the page, its columns as typed arrays.

function bytes(text) {
  const binary = atob(text);
  const array = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) array[i] = binary.charCodeAt(i);
  return array.buffer;
}

/** Numbers of a packed column; a missing one is NaN. */
function unpacked(packed) {
  if (packed.f32 !== undefined) return new Float32Array(bytes(packed.f32));
  const [text, middle, step] = packed.i16;
  const short = new Int16Array(bytes(text));
  const values = new Float32Array(short.length);
  for (let i = 0; i < short.length; i++) values[i] = short[i] === -32768 ? NaN : middle + step * short[i];
  return values;
}

/** Unpacks every column in the tree. */
function unpackAll(value) {
  if (Array.isArray(value)) return value.map(unpackAll);
  if (value === null || typeof value !== "object") return value;
  if (typeof value.f32 === "string" || Array.isArray(value.i16)) return unpacked(value);
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, unpackAll(inner)]));
}

export function readReport() {
  return unpackAll(JSON.parse(document.getElementById("report").textContent));
}

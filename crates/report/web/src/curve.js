// A column against depth as a path, with no more points than pixels can show.

/** First index whose depth is not above `depth`. */
export function below(depths, depth) {
  let low = 0;
  let high = depths.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (depths[middle] < depth) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Indices that show between two depths, one more on either side. */
export function inView(depths, [from, to]) {
  return [Math.max(below(depths, from) - 1, 0), Math.min(below(depths, to) + 1, depths.length)];
}

/** The value at a depth, between its neighbours. */
export function valueAt(depths, values, depth) {
  if (depths.length === 0 || depth < depths[0] - 1 || depth > depths[depths.length - 1] + 1) return NaN;
  const next = Math.min(Math.max(below(depths, depth), 1), depths.length - 1);
  const span = depths[next] - depths[next - 1];
  const part = span > 0 ? Math.min(Math.max((depth - depths[next - 1]) / span, 0), 1) : 0;
  return values[next - 1] + part * (values[next] - values[next - 1]);
}

/** Smallest and largest of the values in view. */
export function extent(depths, values, view) {
  let [low, high] = [Infinity, -Infinity];
  const [first, end] = inView(depths, view);
  for (let i = first; i < end; i++) {
    if (values[i] < low) low = values[i];
    if (values[i] > high) high = values[i];
  }
  return [low, high];
}

const point = (x, y) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** A path of the values in view; where several points fall on one row of pixels, the extremes of it. */
export function path(depths, values, view, x, y) {
  const [first, end] = inView(depths, view);
  const thin = end - first > 2 * Math.abs(y(view[1]) - y(view[0]));
  let text = "";
  let pen = "M";
  const add = (i) => {
    text += pen + point(x(values[i]), y(depths[i]));
    pen = "L";
  };
  let i = first;
  while (i < end) {
    if (!Number.isFinite(values[i])) {
      pen = "M";
      i++;
      continue;
    }
    if (!thin) {
      add(i++);
      continue;
    }
    const row = Math.round(y(depths[i]));
    let [low, high, last] = [i, i, i];
    while (last + 1 < end && Math.round(y(depths[last + 1])) === row && Number.isFinite(values[last + 1])) {
      last++;
      if (values[last] < values[low]) low = last;
      if (values[last] > values[high]) high = last;
    }
    for (const k of [...new Set([i, Math.min(low, high), Math.max(low, high), last])]) add(k);
    i = last + 1;
  }
  return text;
}

/** The area between two columns. */
export function area(depths, lows, highs, view, x, y) {
  const [first, end] = inView(depths, view);
  const step = Math.max(Math.floor((end - first) / (2 * Math.abs(y(view[1]) - y(view[0])) + 1)), 1);
  const there = [];
  const back = [];
  for (let i = first; i < end; i += step) {
    // Of rows that are left out the widest stays.
    let [low, high] = [Infinity, -Infinity];
    for (let k = i; k < Math.min(i + step, end); k++) {
      if (lows[k] < low) low = lows[k];
      if (highs[k] > high) high = highs[k];
    }
    if (!(low <= high)) continue;
    there.push(point(x(high), y(depths[i])));
    back.push(point(x(low), y(depths[i])));
  }
  return there.length > 1 ? `M${there.join("L")}L${back.reverse().join("L")}Z` : "";
}

/** The largest value within `reach` of each depth. */
export function largestNear(depths, values, reach) {
  const largest = new Float32Array(values.length);
  let from = 0;
  for (let i = 0; i < values.length; i++) {
    while (depths[from] < depths[i] - reach) from++;
    let high = -Infinity;
    for (let k = from; k < values.length && depths[k] <= depths[i] + reach; k++) high = Math.max(high, values[k]);
    largest[i] = high;
  }
  return largest;
}

/** Of the rows within `reach` of each depth the one with the largest value: a joint, of what joints do. */
export function rowOfLargest(depths, values, reach) {
  let [from, to] = [0, 0];
  return Uint32Array.from(values, (_, i) => {
    while (depths[from] < depths[i] - reach) from++;
    while (to < values.length && depths[to] <= depths[i] + reach) to++;
    let row = from;
    for (let k = from; k < to; k++) if (values[k] >= values[row]) row = k;
    return row;
  });
}

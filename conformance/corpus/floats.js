// Draws a scene of the corpus with Node.js, in double precision, as docs/corpus.md says.
//
//   node floats.js SCENE PICTURE [DEPTH PRIMITIVE]

const fs = require('fs');

const [sceneFile, ...files] = process.argv.slice(2);
const scene = JSON.parse(fs.readFileSync(sceneFile));
const { width, height } = scene;

// Twice the area of a triangle, positive if it is clockwise on the screen
const area = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);

function windings(contour, x, y) {
  let sum = 0;
  contour.forEach((from, i) => {
    const to = contour[(i + 1) % contour.length];
    const down = from[1] < to[1];
    const [[x0, y0], [x1, y1]] = down ? [from, to] : [to, from];
    if (y < y0 || y >= y1) return;
    if ((x - x0) * (y1 - y0) >= (y - y0) * (x1 - x0)) sum += down ? 1 : -1;
  });
  return sum;
}

const inSquare = ([x0, y0], half, x, y) => x0 - half <= x && x < x0 + half && y0 - half <= y && y < y0 + half;

const kinds = {
  polygon: {
    covers(p, x, y) {
      const sum = p.contours.reduce((all, contour) => all + windings(contour, x, y), 0);
      return p.fill === 'even-odd' ? sum % 2 !== 0 : sum !== 0;
    },
    depth(p, x, y) {
      const [a, b, c] = p.plane;
      if (a[2] === b[2] && a[2] === c[2]) return a[2];
      const up = area(c, a, [x, y]) * (b[2] - a[2]) + area(a, b, [x, y]) * (c[2] - a[2]);
      return a[2] + up / area(a, b, c);
    },
  },
  point: {
    covers: (p, x, y) => inSquare(p.at, p.half, x, y),
    depth: (p) => p.at[2],
  },
  line: {
    covers(p, x, y) {
      const on = (column) =>
        windings(p.quad, column, y) !== 0 || inSquare(p.from, 128, column, y) || inSquare(p.to, 128, column, y);
      const ends = p.quad.concat([p.from, p.to]).map(([end]) => end);
      let left = x;
      let right = x;
      while (left > Math.min(...ends) - 256 && !on(left)) left -= 256;
      while (right < Math.max(...ends) + 256 && !on(right)) right += 256;
      return on(left) && on(right);
    },
    depth({ from, to }, x, y) {
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      const square = dx * dx + dy * dy;
      const along = (x - from[0]) * dx + (y - from[1]) * dy;
      const t = square > 0 ? Math.min(Math.max(along / square, 0), 1) : 0;
      return from[2] + t * (to[2] - from[2]);
    },
  },
  sphere: {
    square: ({ center, radius }, x, y) => radius ** 2 - (x - center[0]) ** 2 - (y - center[1]) ** 2,
    covers: (p, x, y) => kinds.sphere.square(p, x, y) >= 0,
    depth: (p, x, y) => p.center[2] - p.depth_of_step * Math.sqrt(kinds.sphere.square(p, x, y)),
  },
};

function colorAt(p, x, y) {
  if (p.color) return p.color.map((part) => part / 255);
  const parts = p.w.map((w, i) => area(p.plane[(i + 1) % 3], p.plane[(i + 2) % 3], [x, y]) / w);
  const sum = parts[0] + parts[1] + parts[2];
  return [0, 1, 2, 3].map((c) => p.colors.reduce((all, color, i) => all + (parts[i] / sum) * (color[c] / 255), 0));
}

function blended(layers, x, y) {
  let t = 1;
  const sums = [0, 0, 0, 0];
  for (const layer of layers) {
    const [red, green, blue, a] = colorAt(layer, x, y);
    [red, green, blue, 1].forEach((part, i) => (sums[i] += t * a * part));
    t *= 1 - a;
  }
  return sums.map((part, i) => (i < 3 && sums[3] > 0 ? part / sums[3] : part));
}

const encode = (c) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);
const picture = Buffer.alloc(4 * width * height);
const depths = new Int32Array(width * height);
const indices = new Int32Array(width * height);
const sign = scene.depth_test.startsWith('greater') ? -1 : 1;
const last = scene.depth_test.endsWith('or-equal') ? -1 : 1;
const order = (a, b) => sign * (a.depth - b.depth) || last * (a.index - b.index);

for (let i = 0; i < width * height; i++) {
  const x = 256 * (i % width) + 128;
  const y = 256 * Math.floor(i / width) + 128;
  const background = { depth: scene.background_depth, index: -1, layer: { color: scene.background } };
  const fragments = scene.primitives
    .map((layer, index) => ({ layer, index }))
    .filter(({ layer }) => kinds[layer.kind].covers(layer, x, y))
    .map((fragment) => ({ ...fragment, depth: Math.floor(kinds[fragment.layer.kind].depth(fragment.layer, x, y) + 0.5) }))
    .filter((fragment) => order(fragment, background) < 0)
    .sort(order);
  fragments.push(background);
  const backdrop = fragments.findIndex(({ layer }) => !layer.translucent);
  const layers = fragments.slice(0, backdrop + 1).map(({ layer }) => layer);
  const color = layers.length > 1 ? blended(layers, x, y) : colorAt(layers[0], x, y);
  depths[i] = fragments[0].depth;
  indices[i] = fragments[0].index;
  color.forEach((part, c) => (picture[4 * i + c] = Math.floor(255 * (c < 3 ? encode(part) : part) + 0.5)));
}

function writeNpy(file, type, shape, data) {
  const text = `{'descr': '${type}', 'fortran_order': False, 'shape': (${shape.join(', ')}), }`.padEnd(117) + '\n';
  fs.writeFileSync(file, Buffer.concat([Buffer.from('\x93NUMPY\x01\x00\x76\x00' + text, 'latin1'), Buffer.from(data.buffer ?? data, data.byteOffset, data.byteLength)]));
}

writeNpy(files[0], '|u1', [height, width, 4], picture);
if (files.length > 1) {
  writeNpy(files[1], '<i4', [height, width], depths);
  writeNpy(files[2], '<i4', [height, width], indices);
}

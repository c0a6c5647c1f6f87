// Draws a file of triangles for peer.py with WebGL 2 in Chromium, where it is drawn by SwiftShader, on the processor.
//
//   node webgl.js FILE --side N --picture FILE --depth-test NAME --background R,G,B,A --background-depth D
//
// Chromium is the command in CHROMIUM, otherwise chromium.

const { execFileSync } = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

// Runs in the browser
function draw({ side, vertices, isFlat, test, background, backgroundDepth }) {
  const gl = document.createElement('canvas').getContext('webgl2');
  const debug = gl.getExtension('WEBGL_debug_renderer_info');
  const program = gl.createProgram();
  const varying = isFlat ? 'flat' : 'smooth';
  for (const [kind, text] of [
    [gl.VERTEX_SHADER, `in vec4 position, color; ${varying} out vec4 mixed;
      void main() { gl_Position = position; mixed = color; }`],
    [gl.FRAGMENT_SHADER, `precision highp float; ${varying} in vec4 mixed; out vec4 color;
      void main() { color = mixed; }`],
  ]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, `#version 300 es\n${text}`);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  for (const [format, attachment] of [
    [gl.SRGB8_ALPHA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT32F, gl.DEPTH_ATTACHMENT],
  ]) {
    const buffer = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    gl.renderbufferStorage(gl.RENDERBUFFER, format, side, side);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
  }
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(vertices), gl.STATIC_DRAW);
  ['position', 'color'].forEach((name, i) => {
    const at = gl.getAttribLocation(program, name);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, 4, gl.FLOAT, false, 32, 16 * i);
  });
  gl.viewport(0, 0, side, side);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc({ less: gl.LESS, 'less-or-equal': gl.LEQUAL, greater: gl.GREATER, 'greater-or-equal': gl.GEQUAL }[test]);
  gl.clearDepth(backgroundDepth);
  gl.clearColor(...background);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.drawArrays(gl.TRIANGLES, 0, vertices.length / 8);
  const pixels = new Uint8Array(4 * side * side);
  gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const renderer = gl.getParameter(debug.UNMASKED_RENDERER_WEBGL);
  document.body.textContent = JSON.stringify({ error: gl.getError(), renderer, pixels: [...pixels] });
}

const [file, ...words] = process.argv.slice(2);
const options = Object.fromEntries(words.flatMap((word, i) => (i % 2 ? [] : [[word.slice(2), words[i + 1]]])));
const side = Number(options.side);
const data = fs.readFileSync(file);
const count = data.readInt32LE(16);
const vertices = [];
for (let i = 0; i < count; i++) {
  const at = 88 + 16 * i;
  const w = data.readInt32LE(12) === 2 ? data.readFloatLE(88 + 16 * count + 4 * i) : 1;
  for (const k of [0, 1, 2]) vertices.push(data.readFloatLE(at + 4 * k) * w);
  vertices.push(w);
  for (const k of [12, 13, 14, 15]) vertices.push(data[at + k] / 255);
}
const input = {
  side, vertices, isFlat: data.readInt32LE(8) === 0, test: options['depth-test'],
  background: options.background.split(',').map(Number), backgroundDepth: Number(options['background-depth']),
};

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'webgl-'));
try {
  const page = path.join(folder, 'page.html');
  fs.writeFileSync(page, `<body><script>(${draw})(${JSON.stringify(input)})</script></body>`);
  const flags = ['--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
  const places = [`--user-data-dir=${folder}`, '--disable-dev-shm-usage', '--dump-dom', page];
  const stdio = ['ignore', 'pipe', 'ignore'];
  const html = execFileSync(process.env.CHROMIUM ?? 'chromium', [...flags, ...places], { stdio });
  const { error, renderer, pixels } = JSON.parse(`${html}`.match(/\{.*\}/)[0]);
  if (error || !renderer.includes('SwiftShader')) throw new Error(`WebGL of ${renderer} has error ${error}`);
  const rows = Array.from({ length: side }, (_, y) => pixels.slice(4 * side * y, 4 * side * (y + 1)));
  fs.writeFileSync(options.picture, Buffer.from(rows.reverse().flat()));
} finally {
  fs.rmSync(folder, { recursive: true });
}

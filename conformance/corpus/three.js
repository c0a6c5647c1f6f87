// Draws a file of triangles for peer.py with the SoftwareRenderer of three.js, in Node.js, and writes linear colours.
//
//   npm install three@0.106.2
//   node three.js FILE --side N --picture FILE
//
// Its samples are the upper left corners of pixels, so triangles are moved by half a pixel; it draws no back faces, so
// their vertices are exchanged; and it gives each triangle one colour. NODE_PATH is the folder with the package.

const fs = require('fs');
const path = require('path');

const [file, , sideText, , pictureFile] = process.argv.slice(2);
const side = Number(sideText);
const data = fs.readFileSync(file);
global.THREE = require('three');
const folder = path.join(path.dirname(require.resolve('three')), '../examples/js/renderers');
for (const name of ['Projector', 'SoftwareRenderer']) {
  (0, eval)(fs.readFileSync(path.join(folder, `${name}.js`), 'utf8'));
}

const image = { data: new Uint8ClampedArray(4 * side * side) };
const context = { getImageData: () => image, putImageData() {}, fillRect() {} };
const renderer = new THREE.SoftwareRenderer({ canvas: { getContext: () => context }, alpha: true });
renderer.setSize(side, side);

const scene = new THREE.Scene();
for (let i = 0; i < data.readInt32LE(16); i += 3) {
  const geometry = new THREE.Geometry();
  const at = 88 + 16 * i;
  for (const k of [0, 16, 32]) {
    const [x, y, z] = [0, 4, 8].map((axis) => data.readFloatLE(at + k + axis));
    geometry.vertices.push(new THREE.Vector3(x - 1 / side, y + 1 / side, -z));
  }
  const [a, b, c] = geometry.vertices;
  const isFront = (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);
  geometry.faces.push(isFront ? new THREE.Face3(0, 1, 2) : new THREE.Face3(0, 2, 1));
  const [red, green, blue] = data.subarray(at + 12);
  const color = new THREE.Color(red / 255, green / 255, blue / 255);
  const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color }));
  mesh.frustumCulled = false;
  scene.add(mesh);
}
renderer.render(scene, new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 1));
fs.writeFileSync(pictureFile, image.data);

// Loads a face whose wrinkles follow a blendshape, then one whose wrinkles follow an input, and prepares relief on the second. The page's
// title reports both activations, and whether relief loaded more files.
import { WrinkleLoaderPlugin, wrinklesOf } from 'furrow/three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

const POSITIONS = [0, 0, 0, 1, 0, 0, 0, 1, 0]
const NORMALS = [0, 0, 1, 0, 0, 1, 0, 0, 1]
const UVS = [0, 0, 1, 0, 0, 1]

/** PNG images of 4 x 4 pixels, base64: a flat normal map, and white. */
const FLAT =
  'iVBORw0KGgoAAAANSUhEUgAAAAQAAAAECAIAAAAmkwkpAAAACXBIWXMAAAPoAAAD6AG1e1JrAAAAEElEQVQImWNoaPgPRwzEcQA20R/xBjeDNgAAAABJRU5ErkJggg=='
const WHITE =
  'iVBORw0KGgoAAAANSUhEUgAAAAQAAAAECAIAAAAmkwkpAAAACXBIWXMAAAPoAAAD6AG1e1JrAAAAD0lEQVQImWP4jwQYiOMAANuQL9HsugRzAAAAAElFTkSuQmCC'

/** Returns a glTF file: a triangle with one blendshape, `jawOpen`, and one area, which the driver activates. */
function file(driver) {
  const data = new Float32Array([...POSITIONS, ...NORMALS, ...UVS])
  const uri = `data:application/octet-stream;base64,${btoa(String.fromCharCode(...new Uint8Array(data.buffer)))}`
  const curve = [
    [0, 0],
    [1, 1],
  ]
  const wrinkles = {
    layers: [{ name: 'skin', normalTexture: { index: 0 }, heightTexture: { index: 1, amplitude: 0.001 } }],
    areas: [{ name: 'nose', texture: { index: 1 } }],
    drivers: [{ ...driver, area: 'nose', curve }],
  }
  const attributes = { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }
  return JSON.stringify({
    asset: { version: '2.0' },
    extensionsUsed: ['FURROW_wrinkle_maps'],
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [
      {
        primitives: [{ attributes, material: 0, targets: [{ POSITION: 0 }] }],
        extras: { targetNames: ['jawOpen'] },
        weights: [0.5],
      },
    ],
    materials: [{ extensions: { FURROW_wrinkle_maps: wrinkles } }],
    textures: [{ source: 0 }, { source: 1 }],
    images: [FLAT, WHITE].map((bytes) => ({ uri: `data:image/png;base64,${bytes}` })),
    buffers: [{ byteLength: data.byteLength, uri }],
    bufferViews: [
      { buffer: 0, byteLength: 36 },
      { buffer: 0, byteOffset: 36, byteLength: 36 },
      { buffer: 0, byteOffset: 72, byteLength: 24 },
    ],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] },
      { bufferView: 1, componentType: 5126, count: 3, type: 'VEC3' },
      { bufferView: 2, componentType: 5126, count: 3, type: 'VEC2' },
    ],
  })
}

const scripts = () =>
  performance.getEntriesByType('resource').filter(({ name }) => name.endsWith('.js')).length

/** Loads the triangle with a driver, and returns its wrinkles. */
async function load(driver) {
  // The default, `near`, could load the code for relief before the test counts the loaded files.
  const loader = new GLTFLoader().register((parser) => new WrinkleLoaderPlugin(parser, { relief: 'off' }))
  const [wrinkles] = wrinklesOf(await loader.parseAsync(file(driver), ''))
  if (driver.type === 'input') wrinkles.inputs.set('stress', 0.25)
  wrinkles.update()
  return wrinkles
}

try {
  const morph = await load({ type: 'morph', targets: [{ name: 'jawOpen' }] })
  const input = await load({ type: 'input', name: 'stress' })
  const before = scripts()
  await input.reliefReady()
  const relief = scripts() > before ? 'relief fetched' : 'relief'
  document.title = `morph ${morph.getActivation('nose')}; input ${input.getActivation('nose')}; ${relief}`
} catch (error) {
  document.title = error.message
}

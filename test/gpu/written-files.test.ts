import { VRMLoaderPlugin } from '@pixiv/three-vrm'
import { readWrinkleMaps, wrinklesOf } from 'furrow/three'
import {
  AmbientLight,
  AnimationMixer,
  Box3,
  DirectionalLight,
  type Mesh,
  type Object3D,
  OrthographicCamera,
  Scene,
  Vector3,
} from 'three'
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { afterAll, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest'
import activations from '../fixtures/files-2026-11/pictures/activations.json'
import { createHarness, type Harness } from './harness.ts'

// Folder of files written by an earlier version, and of their pictures; see its README.md.
const FOLDER = '../fixtures/files-2026-11/'
const files = import.meta.glob('../fixtures/files-2026-11/**/*.{glb,vrm}', {
  query: '?url',
  eager: true,
  import: 'default',
})
const pictures = import.meta.glob('../fixtures/files-2026-11/pictures/*.png', {
  query: '?url',
  eager: true,
  import: 'default',
})

const NAMES = Object.keys(activations)
const PIXELS = 64
/** Largest allowed difference between two pictures, in any channel, 0..255. */
const TOLERANCE = 2
/** After this number of frames, shaders are compiled, textures are transcoded, and the wrinkles are visible. */
const FRAMES = 4

/** Blendshape weights of the tested pose. Each face has some of these blendshapes. */
const WEIGHTS: Readonly<Record<string, number>> = {
  browInnerUp: 0.7,
  browDownLeft: 0.3,
  browDownRight: 0.6,
  mouthSmileLeft: 0.8,
  mouthSmileRight: 0.5,
  jawOpen: 0.4,
  frontalis: 0.5,
  orbicularisOris: 0.3,
}

let harness: Harness
let loader: GLTFLoader
let ktx2: KTX2Loader

beforeAll(async () => {
  harness = await createHarness('webgl')
  ktx2 = new KTX2Loader().setTranscoderPath('/node_modules/three/examples/jsm/libs/basis/')
  ktx2.detectSupport(harness.renderer as never)
  loader = new GLTFLoader()
    .setKTX2Loader(ktx2)
    .setMeshoptDecoder(MeshoptDecoder)
    .register((parser) => new VRMLoaderPlugin(parser))
    // Without relief, because the frame in which relief appears varies.
    .register((parser) => new harness.Plugin(parser, { relief: 'off' }))
})
afterAll(() => {
  ktx2.dispose()
  harness.dispose()
})
// The faces have a driver of an unknown type, which logs a warning.
beforeEach(() => {
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  return () => vi.restoreAllMocks()
})

it('all files have pictures', () => {
  const paths = Object.keys(files).map((path) => path.slice(FOLDER.length))
  expect(NAMES.toSorted()).toEqual(paths.filter((path) => !path.endsWith('face.glb')).toSorted())
})

describe.each(NAMES)('%s', (name) => {
  it('has the picture and activations that were recorded when it was written', async () => {
    const gltf = await loader.loadAsync(files[FOLDER + name] as string)
    const [maps] = await readWrinkleMaps(gltf)
    const shown = await pose(gltf)
    expect(maps.set.areas.map((area) => area.name)).toEqual(Object.keys(shown))
    const expected: Record<string, number> = activations[name as keyof typeof activations]
    expect(Object.keys(shown)).toEqual(Object.keys(expected))
    for (const [area, value] of Object.entries(expected)) expect(shown[area], area).toBeCloseTo(value, 4)
    const picture = await draw(gltf.scene)
    const recorded = await read(pictures[`${FOLDER}pictures/${name.replaceAll(/[/.]/g, '-')}.png`] as string)
    expect(spread(recorded), 'the picture shows a face').toBeGreaterThan(50)
    expect(largestDifference(picture, recorded)).toBeLessThanOrEqual(TOLERANCE)
  })
})

/** Sets blendshapes, joints, inputs and animation time, and draws until the effect shows. Returns the activations. */
async function pose({ scene, animations }: GLTF): Promise<Record<string, number>> {
  const mesh = skinOf(scene)
  const wrinkles = wrinklesOf(mesh)!
  let seconds = 0
  wrinkles.clock = { now: () => 1000 * seconds }
  for (const [target, index] of Object.entries(mesh.morphTargetDictionary!)) {
    mesh.morphTargetInfluences![index] = WEIGHTS[target] ?? 0
  }
  const head = scene.getObjectByName('head')
  head?.quaternion.setFromAxisAngle(new Vector3(1, 0, 0), 0.25)
  head?.translateY(-0.01)
  wrinkles.inputs.set('age', 66)
  wrinkles.inputs.set('loudness', 75)
  const ageing = animations.find((clip) => clip.name === 'ageing')
  if (ageing) {
    const mixer = new AnimationMixer(scene)
    mixer.clipAction(ageing).play()
    mixer.setTime(0.8)
  }
  for (let i = 0; i < FRAMES; i++) {
    seconds += 0.05
    await draw(scene)
  }
  return Object.fromEntries(wrinkles.areaNames.map((area) => [area, wrinkles.getActivation(area)]))
}

function skinOf(scene: Object3D): Mesh {
  const meshes = scene.getObjectsByProperty('isMesh', true) as Mesh[]
  const skins = meshes.filter((mesh) => wrinklesOf(mesh))
  expect(skins.length).toBe(1)
  return skins[0]
}

/** Renders the face from the front, lit from above and from one side. Returns RGBA, rows from the bottom. */
function draw(face: Object3D): Promise<Uint8Array> {
  const light = new DirectionalLight(0xffffff, 2.5)
  light.position.set(-1, 1.2, 1)
  const scene = new Scene().add(face, light, new AmbientLight(0xffffff, 0.3))
  scene.updateMatrixWorld()
  const box = new Box3().setFromObject(skinOf(face), true)
  const centre = box.getCenter(new Vector3())
  const half = 0.55 * Math.max(box.max.x - box.min.x, box.max.y - box.min.y)
  const camera = new OrthographicCamera(-half, half, half, -half, 0, 10)
  camera.position.copy(centre).z += 5
  return harness.renderBytes(scene, camera, PIXELS)
}

/** Reads a picture file. Returns RGBA, rows from the bottom. */
async function read(url: string): Promise<Uint8Array> {
  const bitmap = await createImageBitmap(await (await fetch(url)).blob(), {
    colorSpaceConversion: 'none',
    imageOrientation: 'flipY',
  })
  const context = new OffscreenCanvas(PIXELS, PIXELS).getContext('2d')!
  context.drawImage(bitmap, 0, 0)
  return new Uint8Array(context.getImageData(0, 0, PIXELS, PIXELS).data)
}

const isColour = (_: number, i: number) => i % 4 !== 3

function spread(picture: Uint8Array): number {
  const colours = picture.filter(isColour)
  return Math.max(...colours) - Math.min(...colours)
}

function largestDifference(a: Uint8Array, b: Uint8Array): number {
  const other = b.filter(isColour)
  return a.filter(isColour).reduce((most, value, i) => Math.max(most, Math.abs(value - other[i])), 0)
}

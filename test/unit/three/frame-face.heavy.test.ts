import { readFileSync } from 'node:fs'
import type { Document } from '@gltf-transform/core'
import { dequantize, quantize } from '@gltf-transform/functions'
import { type FaceView, frameFace } from 'furrow/three'
import { MeshoptDecoder } from 'meshoptimizer/decoder'
import {
  BufferGeometry,
  Group,
  Mesh,
  type Object3D,
  OrthographicCamera,
  PerspectiveCamera,
  Vector3,
} from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { beforeAll, describe, expect, test } from 'vitest'
import { addBody, HEAD_HEIGHT, turnScene } from '../../avatar.ts'
import { SCANS } from '../../bare-faces/bare-faces.ts'
import {
  FORMATS,
  placeBySkeleton,
  quantiseCoordinates,
  rename,
  transformCoordinates,
} from '../cli/auto-changes.ts'
import { anyIO, HUMAN } from '../cli/auto-variants.ts'
import { toVRoid } from '../cli/vroid.ts'

/** Camera, and the point that it looks at, after it has framed a file. */
interface Shot {
  camera: PerspectiveCamera
  target: Vector3
}

type Change = (document: Document) => unknown

/** Bounds of the shipped face's skin, metres. */
const SKIN = { min: [-0.104, 0.62, -0.05], max: [0.104, 0.907, 0.17] }
const MIDDLE = new Vector3().fromArray([0, 1, 2].map((k) => (SKIN.min[k]! + SKIN.max[k]!) / 2))

const file = readFileSync(HUMAN)
let plain: Shot
beforeAll(async () => {
  plain = await frame(() => {})
})

test('the shipped face is seen from the front and fills most of the height', () => {
  const { camera, target } = plain
  expect(target.distanceTo(MIDDLE)).toBeLessThan(1e-3)
  expect([camera.position.x, camera.position.y]).toEqual([target.x, target.y])
  const [low, high] = [SKIN.min[1]!, SKIN.max[1]!].map((y) => onScreen(camera, 0, y, MIDDLE.z).y)
  expect(high! - low!).toBeGreaterThan(2 * 0.75)
  expect(high! - low!).toBeLessThan(2 * 0.95)
})

/** Variants of the shipped face, all in the same place. */
const SAME: readonly [string, Change][] = [
  ...Object.entries(FORMATS),
  ['with only unknown blendshape names', unname],
  ['of skinned meshes with quantised positions', (d) => d.transform(placeBySkeleton, quantize())],
  ['whose quantisation was undone', (d) => d.transform(quantize(), dequantize())],
]

test.each(SAME)('a face %s is framed like the original', async (_, change) => {
  expectLike(await frame(change), plain)
})

test('a VRoid avatar that looks along -Z, as in VRM 0, is seen from its front', async () => {
  expectLike(await frame(toVRoid), plain, 180)
})

test.each([0, 5, 30, 90, 145, 180, -90])(
  'a face turned by %d degrees is seen from the front',
  async (degrees) => {
    // A face that looks within ten degrees of an axis is seen along that axis.
    const seen = degrees === 5 ? 0 : degrees
    const { camera, target } = await frame((d) => turnScene(d, degrees))
    const back = camera.position.clone().sub(target).setY(0)
    expect(((Math.atan2(back.x, back.z) * 180) / Math.PI - seen + 540) % 360).toBeCloseTo(180, 0)
  },
)

test('a mirrored face is seen from the front', async () => {
  const { camera, target } = await frame((d) => {
    const mirrored = d.createNode('mirrored').setScale([-1, 1, 1])
    const scene = d.getRoot().listScenes()[0]!
    for (const child of scene.listChildren()) mirrored.addChild(child)
    scene.addChild(mirrored)
  })
  expect(camera.position.z).toBeGreaterThan(target.z)
})

test.each([0.01, 1, 100])('a face scaled by %d is framed the same', async (factor) => {
  const { camera, target } = await frame((d) => {
    for (const node of d.getRoot().listScenes()[0]!.listChildren()) node.setScale([factor, factor, factor])
  })
  expect(camera.position.distanceTo(plain.camera.position.clone().multiplyScalar(factor))).toBeLessThan(
    1e-3 * factor,
  )
  expect(camera.near).toBeLessThan(camera.position.distanceTo(target) - 0.2 * factor)
  expect(camera.far).toBeGreaterThan(camera.position.distanceTo(target) + 0.2 * factor)
})

describe('only the head of an avatar with a body is framed:', () => {
  const BODY_SHAPES = ['Body_Fat', 'Body_Thin', 'Body_Tall', 'Body_Young']

  test.each<[string, Change]>([
    ['skinned to joints in centimetres', (d) => addBody(d)],
    ['with quantised positions', (d) => d.transform((d) => addBody(d), quantize())],
    [
      'that looks along -Z',
      (d) =>
        d.transform(
          (d) => addBody(d),
          quantize(),
          (d) => turnScene(d, 180),
        ),
    ],
    ['with shapes of the whole body', (d) => addBody(d, BODY_SHAPES)],
    [
      'with shapes of the whole body, all of unknown names',
      (d) => d.transform((d) => addBody(d, BODY_SHAPES), unname),
    ],
    ['with shapes of the mouth alone', (d) => d.transform((d) => addBody(d), only(/^(jawOpen|mouth)/))],
    ['with shapes of a blink alone', (d) => d.transform((d) => addBody(d), only(/^eyeBlink/))],
    ['without blendshapes', (d) => d.transform((d) => addBody(d), only(/^$/))],
    ['without blendshapes, as a VRM 0', asVrm0((d) => addBody(d), only(/^$/))],
    [
      'with shapes of the whole body, all of unknown names, as a VRM 0',
      asVrm0((d) => addBody(d, BODY_SHAPES), unname),
    ],
  ])('%s', async (what, change) => {
    const { camera } = await frame(change)
    const side = Math.sign(camera.position.z)
    expect(side, 'in front').toBe(/-Z|VRM 0/.test(what) ? -1 : 1)
    const [crown, chin, feet] = [0.9, 0.66, -0.88].map(
      (y) => onScreen(camera, 0, HEAD_HEIGHT + y, 0.05 * side).y,
    )
    expect(crown).toBeLessThan(1)
    expect(crown! - chin!, 'the part of the height that the head takes').toBeGreaterThan(2 * 0.3)
    expect(chin).toBeGreaterThan(-1)
    expect(feet, 'below the picture').toBeLessThan(-1)
    const ear = onScreen(camera, 0.1, HEAD_HEIGHT + 0.77, 0).x
    expect(Math.abs(ear)).toBeLessThan(1)
    expect(onScreen(camera, 0, HEAD_HEIGHT + 0.77, 0).x).toBeCloseTo(0, 1)
  })
})

test.each(SCANS)('a scan without wrinkles is seen from the front', async ({ path }) => {
  const { camera, target } = shoot(
    await load(await (await anyIO()).readBinary(new Uint8Array(readFileSync(path)))),
  )
  expect(target.x).toBeCloseTo(0, 2)
  expect(camera.position.x).toBeCloseTo(0, 2)
  expect(camera.position.z).toBeGreaterThan(target.z)
})

test('views have the given angles, relative to the direction in which the face looks', async () => {
  const turned = await load(await changed((d) => turnScene(d, 90)))
  const from = (view: FaceView) => {
    const { camera, target } = shoot(turned, view)
    return camera.position.clone().sub(target).normalize()
  }
  const front = from({})
  // The face looks along +X, and the person's left is -Z.
  expect(front.x).toBeCloseTo(1, 3)
  expect(from({ yaw: 90 }).z).toBeCloseTo(-1, 2)
  expect(from({ pitch: 30 }).y).toBeCloseTo(0.5, 2)
  const distance = (view: FaceView) => {
    const { camera, target } = shoot(turned, view)
    return camera.position.distanceTo(target)
  }
  expect(distance({ zoom: 2 })).toBeLessThan(0.6 * distance({}))
})

test('expressions do not change the view', async () => {
  const scene = await load(await changed(() => {}))
  scene.traverse((object) => (object as Mesh).morphTargetInfluences?.fill(1))
  expectLike(shoot(scene), plain)
})

test('invalid vertices are ignored', async () => {
  const scene = await load(await changed(() => {}))
  scene.traverse((object) => (object as Mesh).geometry?.attributes.position.setX(3, Number.NaN))
  expectLike(shoot(scene), plain)
})

test('a narrow picture shows the complete head', async () => {
  const camera = new PerspectiveCamera(22, 0.4)
  frameFace(camera, await load(await changed(() => {})))
  camera.updateMatrixWorld()
  for (const x of [SKIN.min[0]!, SKIN.max[0]!]) {
    expect(Math.abs(onScreen(camera, x, MIDDLE.y, MIDDLE.z).x)).toBeLessThan(1)
  }
})

test('an object without triangles is refused', () => {
  const camera = new PerspectiveCamera(22, 1)
  for (const nothing of [new Group(), new Mesh(new BufferGeometry())]) {
    expect(() => frameFace(camera, nothing)).toThrow('frameFace: nothing to frame')
  }
})

test.each([0, 180])(
  'a VRM 0 without blendshapes is seen from the front when turned by %d degrees after loading',
  async (degrees) => {
    const scene = await load(await changed(asVrm0((d) => addBody(d), only(/^$/))))
    // This is what VRMUtils.rotateVRM0 does.
    scene.rotation.y = (degrees * Math.PI) / 180
    const { camera, target } = shoot(scene)
    expect(Math.sign(camera.position.z - target.z)).toBe(degrees === 0 ? -1 : 1)
  },
)

test.each([
  [1, 1],
  [3, 1],
  [0.4, 1],
  [1, 100],
])(
  'an orthographic picture %d times as wide as high, %d units high, shows the complete head',
  async (aspect, height) => {
    const [x, y] = [(height * aspect) / 2, height / 2]
    const camera = new OrthographicCamera(-x, x, y, -y)
    const target = frameFace(camera, await load(await changed(() => {})))
    camera.updateMatrixWorld()
    expect(target.distanceTo(MIDDLE)).toBeLessThan(1e-3)
    const onPicture = (of: 'min' | 'max') => new Vector3().fromArray(SKIN[of]).project(camera)
    const [low, high] = [onPicture('min'), onPicture('max')]
    const [width, tall] = [high.x - low.x, high.y - low.y]
    expect(Math.max(width, tall)).toBeLessThan(2)
    expect(Math.max(width, tall), 'not far away').toBeGreaterThan(2 * 0.6)
    for (const { z } of [low, high]) expect(Math.abs(z), 'between near and far').toBeLessThan(1)
    expect(camera.position.z).toBeGreaterThan(target.z)
  },
)

/** Changes a file, and turns it to look along -Z, like VRM 0. */
function asVrm0(...changes: Change[]): Change {
  return (d) => d.transform(...(changes as never[]), (d: Document) => turnScene(d, 180))
}

/** Replaces the names of blendshapes by unknown ones. Equal names stay equal. */
function unname(document: Document): void {
  const numbers = new Map<string, string>()
  const number = (name: string) => numbers.get(name) ?? numbers.set(name, `Key ${numbers.size}`).get(name)!
  for (const mesh of document.getRoot().listMeshes()) if (mesh.getExtras().targetNames) rename(mesh, number)
}

/** Keeps only the blendshapes whose names match. */
function only(pattern: RegExp): Change {
  return (document) => {
    for (const mesh of document.getRoot().listMeshes()) {
      const names = (mesh.getExtras().targetNames ?? []) as string[]
      for (const primitive of mesh.listPrimitives()) {
        for (const [i, target] of primitive.listTargets().entries()) {
          if (!pattern.test(names[i]!)) primitive.removeTarget(target)
        }
      }
      mesh.setWeights([]).setExtras({ targetNames: names.filter((name) => pattern.test(name)) })
    }
  }
}

async function changed(change: Change): Promise<Document> {
  const document = await (await anyIO()).readBinary(new Uint8Array(file))
  // Node cannot load images, and the camera does not need them.
  for (const texture of document.getRoot().listTextures())
    if (change !== transformCoordinates && change !== quantiseCoordinates) texture.dispose()
  await change(document)
  for (const texture of document.getRoot().listTextures()) texture.dispose()
  return document
}

async function load(document: Document): Promise<Object3D> {
  const bytes = await (await anyIO()).writeBinary(document)
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder)
  return (await loader.parseAsync(bytes.buffer as ArrayBuffer, '')).scene
}

function shoot(scene: Object3D, view?: FaceView): Shot {
  const camera = new PerspectiveCamera(22, 1)
  const target = frameFace(camera, scene, view)
  camera.updateMatrixWorld()
  return { camera, target }
}

async function frame(change: Change): Promise<Shot> {
  return shoot(await load(await changed(change)))
}

/** Rotates `other` about the vertical axis. Then expects that targets differ by less than 1 mm, and camera positions by less than 2 mm. */
function expectLike(shot: Shot, other: Shot, degrees = 0): void {
  const turned = (point: Vector3) =>
    point.clone().applyAxisAngle(new Vector3(0, 1, 0), (degrees * Math.PI) / 180)
  expect(shot.target.distanceTo(turned(other.target)), 'target').toBeLessThan(1e-3)
  expect(shot.camera.position.distanceTo(turned(other.camera.position)), 'camera').toBeLessThan(2e-3)
}

/** Projects a point into the picture, whose coordinates are -1 to 1 in both directions. */
function onScreen(camera: PerspectiveCamera, x: number, y: number, z: number): Vector3 {
  return new Vector3(x, y, z).project(camera)
}

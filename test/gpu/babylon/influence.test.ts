import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import { Matrix } from '@babylonjs/core/Maths/math.vector.js'
import '@babylonjs/core/Meshes/thinInstanceMesh.js'
import { Mesh } from '@babylonjs/core/Meshes/mesh.js'
import { VertexData } from '@babylonjs/core/Meshes/mesh.vertexData.js'
import type { Scene } from '@babylonjs/core/scene.js'
import type { GrayImage, WrinkleSet } from 'furrow'
import { Wrinkles } from 'furrow/babylon'
import { afterEach, describe, expect, it } from 'vitest'
import { randomSet } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { STEP } from '../difference.ts'
import {
  activationsOf,
  centreOf,
  AREA as EDGE_AREA,
  PIXELS as EDGE_PIXELS,
  edgeError,
  edgeSet,
  edgeSquares,
  FACES,
  SCALE,
} from '../edges.ts'
import { casesIn } from '../harness.ts'
import { influenceDifference, type UvTransform } from '../influence-difference.ts'
import { type BabylonHarness, ENGINES, harnessOn, square } from './harness.ts'

const CASES = casesIn(200)
const PIXELS = 32
const AREA = 32

/** Debug mode of Babylon.js that shows the roughness. */
const SHOW_ROUGHNESS = 63

describe.each(ENGINES)('influence in Babylon.js on %s', (name) => {
  const harness = harnessOn(name)
  afterEach(() => expect(harness.errors).toEqual([]))

  it(`is within 1/255 of the reference in ${CASES} random cases`, async () => {
    const random = seeded(2008)
    const scene = harness.createScene()
    let worst = 0
    // Disposes of a case only after the next one is drawn, so that the engine keeps the program that all cases use.
    let release = () => {}
    for (let i = 0; i < CASES; i++) {
      const count = 1 + Math.floor(random() * 64)
      const set = smooth(randomSet(random, count, AREA))
      const scale = 0.2 + random() * 1.2
      const offset = [random() * 0.4 - 0.2, random() * 0.4 - 0.2]
      const activations = set.areas.map(() => (random() < 0.3 ? 0 : Math.min(1, random() * (4 / count))))
      const { error, mesh } = await largestError(harness, scene, set, activations, { scale, offset })
      worst = Math.max(worst, error)
      release()
      mesh.setEnabled(false)
      release = () => mesh.dispose(false, true)
    }
    scene.dispose()
    expect(worst).toBeLessThanOrEqual(STEP)
  })

  it.each(['meshes', 'thin instances'])(
    'of %s matches the reference at the edges of UV space',
    async (kind) => {
      const scene = harness.createScene()
      const set = smooth(edgeSet())
      const material = roughnessMaterial(scene)
      const meshes = (kind === 'meshes' ? FACES : [0]).map(() => edgeMesh(scene, material))
      const scale = Matrix.Scaling(SCALE, SCALE, 1)
      const places = FACES.map((face) => scale.multiply(Matrix.Translation(...centreOf(face), 0)))
      if (kind === 'meshes')
        for (const [face, mesh] of meshes.entries()) mesh.bakeTransformIntoVertices(places[face])
      else meshes[0].thinInstanceAdd(places)
      const first = new Wrinkles(meshes[0], set, { areaSize: EDGE_AREA })
      const all = [first, ...meshes.slice(1).map((mesh) => new Wrinkles(mesh, first))]
      for (const face of FACES) {
        const [wrinkles, instance] = kind === 'meshes' ? [all[face], 0] : [first, face]
        for (const [i, value] of activationsOf(face).entries())
          wrinkles.setActivation(set.areas[i].name, value, instance)
      }
      const pixels = await harness.render(scene, EDGE_PIXELS)
      scene.dispose()
      expect(edgeError(set, (i) => 1 - pixels[i * 4])).toBeLessThanOrEqual(STEP)
    },
  )
})

function edgeMesh(scene: Scene, material: PBRMaterial): Mesh {
  const mesh = new Mesh('edges', scene)
  const { positions, uvs, triangles } = edgeSquares()
  const data = new VertexData()
  // Normals face the camera, which looks along +z.
  Object.assign(data, {
    positions,
    uvs,
    indices: triangles,
    normals: positions.map((_, i) => (i % 3 === 2 ? -1 : 0)),
  })
  data.applyToMesh(mesh)
  mesh.material = material
  return mesh
}

/** Returns a set whose fully wrinkled skin has roughness 0, so that the roughness of the square is 1 - influence. */
function smooth({ layers: [layer], areas }: WrinkleSet): WrinkleSet {
  const { width, height } = layer.normal as GrayImage
  return { layers: [{ ...layer, roughness: { width, height, data: new Uint8Array(width * height) } }], areas }
}

/** Creates a material that shows only its roughness. */
function roughnessMaterial(scene: Scene): PBRMaterial {
  const material = new PBRMaterial('skin', scene)
  return Object.assign(material, { metallic: 0, roughness: 1, debugMode: SHOW_ROUGHNESS, debugLimit: -1 })
}

async function largestError(
  harness: BabylonHarness,
  scene: Scene,
  set: WrinkleSet,
  activations: readonly number[],
  transform: UvTransform,
) {
  const mesh = square(scene, transform.scale, [...transform.offset])
  mesh.material = roughnessMaterial(scene)
  const wrinkles = new Wrinkles(mesh, set, { areaSize: AREA })
  for (const [i, area] of set.areas.entries()) wrinkles.setActivation(area.name, activations[i])
  const pixels = await harness.render(scene, PIXELS)
  const shown = (i: number) => 1 - pixels[i * 4]
  const error = influenceDifference(set, AREA, activations, transform, shown, PIXELS)
  return { error, mesh }
}

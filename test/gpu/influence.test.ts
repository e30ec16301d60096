import type { WrinkleSet } from 'furrow'
import {
  BufferAttribute,
  BufferGeometry,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Scene,
} from 'three'
import { beforeAll, describe, expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { STEP } from './difference.ts'
import {
  AREA,
  activationsOf,
  centreOf,
  edgeError,
  edgeSet,
  edgeSquares,
  FACES,
  PIXELS,
  SCALE,
} from './edges.ts'
import { casesOn, type Harness, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { influenceError } from './influence-error.ts'

describe.each(RENDERERS)('influence on %s', (name) => {
  const cases = casesOn(name)
  const harness = harnessOn(name)
  beforeAll(() => {
    console.info(`${name}: ${harness.adapter}`)
  })

  it(`is within 1/255 of the reference in ${cases} random cases`, async () => {
    const random = seeded(2008)
    let worst = 0
    // Disposes of a case only after the next one is drawn, so that the renderer keeps the program that all cases use.
    let release = () => {}
    for (let i = 0; i < cases; i++) {
      const count = 1 + Math.floor(random() * 64)
      const set = randomSet(random, count, 32)
      const scale = 0.2 + random() * 1.2
      const offset = [random() * 0.4 - 0.2, random() * 0.4 - 0.2]
      const activations = set.areas.map(() => (random() < 0.3 ? 0 : random() * (4 / count)))
      const { error, dispose } = await largestError(harness, set, activations, scale, offset)
      worst = Math.max(worst, error)
      release()
      release = dispose
    }
    release()
    expect(worst).toBeLessThanOrEqual(STEP)
  })

  it.each(['meshes', 'instances'])('of %s matches the reference at the edges of UV space', async (kind) => {
    const set = edgeSet()
    const meshes = kind === 'meshes' ? FACES.map(edgeMesh) : [edgeInstances()]
    const all = meshes.map((mesh) => new harness.Wrinkles(mesh, set, { areaSize: AREA }))
    const materials = all.map((wrinkles) => wrinkles.createInfluenceMaterial() as MeshStandardMaterial)
    for (const [i, mesh] of meshes.entries()) mesh.material = materials[i]
    const scene = new Scene().add(...meshes)
    const draw = (shownBy: (face: number) => number) => {
      for (const face of FACES) {
        const [wrinkles, instance] = kind === 'meshes' ? [all[face], 0] : [all[0], face]
        for (const [i, value] of activationsOf(shownBy(face)).entries())
          wrinkles.setActivation(set.areas[i].name, value, instance)
      }
      return harness.render(scene, squareCamera(), PIXELS)
    }
    // First draws the other area on all faces but one. The second picture must keep nothing of it.
    await draw((face) => face && face + 1)
    const pixels = await draw((face) => face)
    expect(edgeError(set, (i) => pixels[i * 4])).toBeLessThanOrEqual(STEP)
    for (const own of [...materials, ...all, ...meshes.map(({ geometry }) => geometry)]) own.dispose()
  })
})

function edgeGeometry(): BufferGeometry {
  const { positions, uvs, triangles } = edgeSquares()
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3))
  geometry.setAttribute('uv', new BufferAttribute(new Float32Array(uvs), 2))
  geometry.setIndex(triangles)
  geometry.computeVertexNormals()
  return geometry
}

function edgeMesh(face: number): Mesh<BufferGeometry, MeshStandardMaterial> {
  const mesh = new Mesh(edgeGeometry(), new MeshStandardMaterial())
  mesh.position.set(...centreOf(face), 0)
  mesh.scale.set(SCALE, SCALE, 1)
  return mesh
}

function edgeInstances(): InstancedMesh<BufferGeometry, MeshStandardMaterial> {
  const mesh = new InstancedMesh(edgeGeometry(), new MeshStandardMaterial(), FACES.length)
  for (const face of FACES)
    mesh.setMatrixAt(face, new Matrix4().makeScale(SCALE, SCALE, 1).setPosition(...centreOf(face), 0))
  return mesh
}

async function largestError(
  harness: Harness,
  set: WrinkleSet,
  activations: number[],
  scale: number,
  offset: number[],
) {
  const mesh = square(new MeshStandardMaterial(), scale, offset)
  const wrinkles = new harness.Wrinkles(mesh, set, { areaSize: 32 })
  const clamped = activations.map((activation) => Math.min(activation, 1))
  for (const [i, { name }] of set.areas.entries()) wrinkles.setActivation(name, clamped[i])
  return influenceError(harness, mesh, wrinkles, set, clamped, { scale, offset })
}

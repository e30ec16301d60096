import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { type Mesh, Ray, Vector3 } from 'three'
import { describe, expect, it } from 'vitest'
import { falloff } from '../../../../studio/src/paint/brush.ts'
import type { SkinPoint } from '../../../../studio/src/paint/paint-skin.ts'
import { SkinPicker } from '../../../../studio/src/paint/picker.ts'
import { skinPath } from '../../../../studio/src/paint/skin-path.ts'
import { SCANS } from '../../../bare-faces/bare-faces.ts'
import { loadInNode } from '../../three/node-loader.ts'
import { empty, onIslands, paint, paintSkin, placesOf } from './skins.ts'

const FACES = [
  ['human', fileURLToPath(new URL('../../../../faces/human.glb', import.meta.url)), 'skin'],
  ...SCANS.map(({ name, path }) => [name, path, 'face']),
].filter(([, path]) => existsSync(path))

describe.each(FACES)('painting on %s', async (_, path, name) => {
  const { scene } = await loadInNode(readFileSync(path))
  scene.updateMatrixWorld()
  const mesh = scene.getObjectByName(name) as Mesh
  const skin = paintSkin(mesh)
  const { surface } = skin
  const SIZE = 128
  const map = skin.mapOf(SIZE)
  const near = (x: number, y: number, z: number): SkinPoint => skin.mirrored([-x, y, z])

  it('measures in millimetres, in the coordinates of the face', () => {
    // The eyes are 63 mm apart, and the face is about twice as wide.
    const [left, right] = [near(200, 0, 0), near(-200, 0, 0)]
    expect(left.position[0] - right.position[0]).toBeGreaterThan(110)
    expect(left.position[0] - right.position[0]).toBeLessThan(200)
    expect(Math.abs(left.position[0] + right.position[0])).toBeLessThan(10)
  })

  it('has the same weights on both sides of each seam', () => {
    const seams = seamPoints(skin)
    const chosen = seams.filter((_, i) => i % Math.ceil(seams.length / 12) === 0)
    let beyond = 0
    for (const { position, triangles } of chosen) {
      const image = paint(empty(SIZE), { radius: 9, softness: 1 }, skin, { triangle: triangles[0], position })
      const places = [...placesOf(map, image)].map((place) => ({
        ...place,
        distance: Math.hypot(place.x - position[0], place.y - position[1], place.z - position[2]),
      }))
      // Compares the two triangles of the edge, also where they continue beyond their islands for filtering.
      const beside = places.filter(({ triangle, distance }) => triangles.includes(triangle) && distance < 9)
      const wrong = beside.filter(
        ({ weight, distance }) => Math.abs(weight - 255 * falloff(distance, 9, 1)) > 1,
      )
      expect(wrong).toEqual([])
      beyond += beside.filter(({ isBeyondIsland }) => isBeyondIsland).length
    }
    // The scan's texture has no seams.
    expect(beyond > 20 || seams.length === 0).toBe(true)
  })

  it('is the same whether a stroke has 5 points or 500', () => {
    const corners = [
      near(-35, 40, 20),
      near(-10, 50, 30),
      near(12, 42, 30),
      near(20, 55, 25),
      near(38, 38, 20),
    ]
    const points = corners.slice(1).flatMap((to, i) => divided(skinPath(surface, corners[i], to)!, 125))
    expect(points.length).toBe(500)
    const [few, many] = [corners, [corners[0], ...points]].map(
      (path) => paint(empty(SIZE), { radius: 6, flow: 0.3 }, skin, ...path).data,
    )
    expect(Math.max(...few)).toBeGreaterThan(250)
    expect(Math.max(...few.map((weight, i) => Math.abs(weight - many[i])))).toBeLessThanOrEqual(1)
  })

  it('does not reach the lower lip from the upper one', () => {
    const picker = new SkinPicker(skin.meshes, skin, skin.made)
    // Searches up the middle of the face. Between the lips, the path over the skin goes into the mouth.
    const centre = new Vector3()
    mesh.geometry.computeBoundingBox()
    mesh.geometry.boundingBox!.getCenter(centre).applyMatrix4(mesh.matrixWorld)
    const hits = Array.from({ length: 300 }, (__, i) => {
      const origin = new Vector3(centre.x, centre.y + (i - 150) * 0.001, centre.z + 2)
      return picker.pick(new Ray(origin, new Vector3(0, 0, -1)))
    }).filter((hit) => hit !== undefined)
    const mouth = hits.findIndex(({ position: [x, y] }, i) => {
      const next = hits[i + 1]
      return Math.abs(x) < 5 && y > -85 && y < -55 && next && !skinPath(surface, hits[i], next)
    })
    expect(mouth).toBeGreaterThanOrEqual(0)
    const [lower, upper] = [hits[mouth], hits[mouth + 1]]
    const image = paint(empty(SIZE), { radius: 5 }, skin, upper)
    const below = onIslands(skin, image).filter(({ triangle }) => triangle === lower.triangle)
    expect(Math.max(...image.data)).toBeGreaterThan(200)
    expect(below.filter(({ weight }) => weight > 0)).toEqual([])
  })
})

/** Returns the middle of each edge where the texture is cut, and the two triangles of the edge. */
function seamPoints({ skin: { uvs, indices }, surface }: ReturnType<typeof paintSkin>) {
  const { adjacent, corners, skinTriangles, pointOf, points } = surface
  const found: { position: SkinPoint['position']; triangles: [number, number] }[] = []
  for (let i = 0; i < adjacent.length; i++) {
    const [triangle, next] = [Math.floor(i / 3), adjacent[i]]
    if (next < triangle) continue
    const ends = [corners[i], corners[i % 3 === 2 ? i - 2 : i + 1]]
    const middles = [triangle, next].map((t) => {
      const vertices = [0, 1, 2].map((k) => indices[3 * skinTriangles[t] + k])
      const edge = ends.map((end) => vertices.find((vertex) => pointOf[vertex] === end)!)
      return [0, 1].map((k) => (uvs[2 * edge[0] + k] + uvs[2 * edge[1] + k]) / 2)
    })
    if (Math.hypot(middles[0][0] - middles[1][0], middles[0][1] - middles[1][1]) < 0.02) continue
    const [x, y, z] = [0, 1, 2].map((k) => (points[3 * ends[0] + k] + points[3 * ends[1] + k]) / 2)
    found.push({ position: [x, y, z], triangles: [triangle, next] })
  }
  return found
}

/** Returns points at equal distances along a path, including its end. */
function divided(path: readonly SkinPoint[], count: number): SkinPoint[] {
  const lengths = path.slice(1).map(({ position: [x, y, z] }, i) => {
    const [fromX, fromY, fromZ] = path[i].position
    return Math.hypot(x - fromX, y - fromY, z - fromZ)
  })
  const total = lengths.reduce((sum, length) => sum + length, 0)
  return Array.from({ length: count }, (_, n) => {
    if (n === count - 1) return path[path.length - 1]
    let left = (total * (n + 1)) / count
    let i = 0
    while (i < lengths.length - 1 && left > lengths[i]) left -= lengths[i++]
    const position = [0, 1, 2].map(
      (k) => path[i].position[k] + (left / lengths[i]) * (path[i + 1].position[k] - path[i].position[k]),
    )
    return { triangle: path[i].triangle, position: position as [number, number, number] }
  })
}

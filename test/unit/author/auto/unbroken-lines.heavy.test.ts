import { autoWrinkles, heightToNormal, type Skin } from 'furrow/author'
import { surfaceMetric } from 'furrow/internal'
import { beforeAll, describe, expect, test } from 'vitest'
import { unroll } from '../../../../packages/furrow/src/author/auto/surface/head-chart.ts'
import { poseOf } from '../../../../packages/furrow/src/author/auto/surface/pose.ts'
import { cornersOf, skinVertices } from '../../../../packages/furrow/src/author/skin/surface.ts'
import type { LaidStroke } from '../../../../packages/furrow/src/author/strokes/lay-out.ts'
import { barycentrics3 } from '../../../../packages/furrow/src/math/barycentrics.ts'
import { cross, degreesBetween, minus, plus, scaled, unit, type Vector, vectorAt } from '../../../vectors.ts'
import { decimatedSkin } from './decimated.ts'
import { FACES, facialCreases, type PreparedFace, prepareFace } from './faces.ts'

const SMILE = { mouthSmileLeft: 1, mouthSmileRight: 1, cheekSquintLeft: 0.6, cheekSquintRight: 0.6 }
const SIZE = 1024
const AGE = 45
/**
 * Largest angle between the shading of the mesh and of a smooth surface, degrees, by number of vertices. A line looks broken if `BREAK` or more
 * consecutive points, 0.5 mm apart, exceed the angle. With 1500 vertices, one triangle covers the last 9 mm of the fold, and a smile turns it.
 */
const TURNS = { 1500: 34, 2500: 19, 5000: 19 } as const
const BREAK = { 1500: 7, 2500: 4, 5000: 4 } as const
/** Length of a normal's (x, y) below which rounding to bytes can turn the direction of (x, y) by 19 degrees. */
const UNSEEN = 3 / 127.5

describe.each(FACES)('%s, smiling, without tangents', (_, path) => {
  describe.each([1500, 2500, 5000] as const)('with about %i vertices', (vertices) => {
    let skin: Skin

    beforeAll(async () => {
      skin = await decimatedSkin(path, vertices)
    })

    test('has the expected number of vertices', () => {
      expect(Math.abs(skin.positions.length / 3 / vertices - 1)).toBeLessThan(0.05)
    })

    test('has unbroken nasolabial folds of similar length on both sides', () => {
      const prepared = prepareFace(skin)
      const smile = new SmilingFace(prepared)
      const { layers, areas } = autoWrinkles(skin, { age: AGE, size: SIZE, frame: 'derivative' })
      const { heights, normal } = layers[areas.find(({ name }) => name === 'nasolabialLeft')!.layer]
      const onSmoothSkin = heightToNormal(heights, surfaceMetric(inMetres(prepared), SIZE), 'derivative')
      const lengths = ['Left', 'Right'].map((side) => {
        const fold = longestOf(prepared, `nasolabial${side}`)
        for (const bank of [-1, 1]) {
          const turned = smile.turnsAlong(fold, bank, normal.data, onSmoothSkin.data)
          expect(turned.length).toBeGreaterThan(0.8 * fold.depths.length)
          expect(longestRun(turned, (degrees) => degrees > TURNS[vertices])).toBeLessThan(BREAK[vertices])
        }
        return fold.depths.length
      })
      expect(Math.abs(lengths[0] / lengths[1] - 1)).toBeLessThan(0.3)
    })
  })
})

/** Smiling face, and the shading that renderers compute for it. */
class SmilingFace {
  readonly #prepared: PreparedFace
  readonly #points: Float64Array
  /** Normal of each point, weighted by area and not normalised. */
  readonly #normals: Float64Array
  /** Derivatives of the position, dP/du and dP/dv, at each vertex: weighted sums over the adjacent triangles. */
  readonly #derivatives: Float64Array

  constructor(prepared: PreparedFace) {
    const { face, skin } = prepared
    const { surface } = face
    this.#prepared = prepared
    this.#points = Float64Array.from(surface.points)
    for (const [target, weight] of poseOf(face.find, SMILE))
      for (const [i, offset] of face.offsets[target].entries()) this.#points[i] += weight * offset
    this.#normals = new Float64Array(surface.points.length)
    this.#derivatives = new Float64Array(6 * surface.pointOf.length)
    for (let triangle = 0; triangle < surface.corners.length / 3; triangle++) {
      const corners = cornersOf(surface, triangle)
      const [a, b, c] = corners.map((point) => vectorAt(this.#points, point))
      const normal = cross(minus(b, a), minus(c, a))
      for (const point of corners) for (let k = 0; k < 3; k++) this.#normals[3 * point + k] += normal[k]
      const derivatives = this.#derivativesOf(triangle)
      if (!derivatives.flat().every(Number.isFinite)) continue
      for (const vertex of skinVertices(skin, surface, triangle))
        for (const [i, value] of derivatives.flat().entries())
          this.#derivatives[6 * vertex + i] += Math.hypot(...normal) * value
    }
  }

  /** Returns angles between two shadings along one side of a fold: of the mesh with `map`, and of the smooth surface with `smoothMap`. */
  turnsAlong(fold: LaidStroke, bank: number, map: Uint8Array, smoothMap: Uint8Array): number[] {
    const { face, skin } = this.#prepared
    const turns: number[] = []
    for (let i = 1; i + 1 < fold.depths.length; i++) {
      const along = minus(vectorAt(fold.points, i + 1), vectorAt(fold.points, i - 1))
      const across = unit(cross(vectorAt(fold.normals, i), along))
      const hit = face.chart.find(
        unroll(...plus(vectorAt(fold.points, i), across, 0.5 * bank * fold.halfWidths[i])),
      )
      if (!hit) continue
      const corners = cornersOf(face.surface, hit.triangle)
      const vertices = skinVertices(skin, face.surface, hit.triangle)
      const weights = new Float64Array(3)
      barycentrics3(weights, face.surface.points, ...corners, Float64Array.from(hit.position))
      const mean = (values: readonly Vector[]) =>
        values.map((value, k) => scaled(value, weights[k])).reduce((a, b) => plus(a, b))
      const normal = unit(mean(corners.map((point) => unit(vectorAt(this.#normals, point)))))
      const [du, dv] = [0, 1].map((k) =>
        mean(vertices.map((vertex) => vectorAt(this.#derivatives, 2 * vertex + k))),
      )
      const [u, v] = [0, 1].map((k) =>
        Math.floor(SIZE * vertices.reduce((total, x, n) => total + weights[n] * skin.uvs[2 * x + k], 0)),
      )
      const texel = v * SIZE + u
      const shaded = leanOf(map, texel, frameOf(this.#derivativesOf(hit.triangle), normal))
      const smooth = leanOf(smoothMap, texel, frameOf([du, dv], normal))
      const isSeen = Math.hypot(...[0, 1].map((k) => smoothMap[4 * texel + k] / 127.5 - 1)) > UNSEEN
      turns.push(isSeen ? degreesBetween(shaded, smooth) : 0)
    }
    return turns
  }

  #derivativesOf(triangle: number): [Vector, Vector] {
    const { skin, face } = this.#prepared
    const [a, b, c] = cornersOf(face.surface, triangle).map((point) => vectorAt(this.#points, point))
    const [o, p, q] = skinVertices(skin, face.surface, triangle).map((i) => [
      skin.uvs[2 * i],
      skin.uvs[2 * i + 1],
    ])
    const [u1, v1, u2, v2] = [p[0] - o[0], p[1] - o[1], q[0] - o[0], q[1] - o[1]]
    const area = u1 * v2 - u2 * v1
    const [first, second] = [minus(b, a), minus(c, a)]
    return [
      plus(scaled(first, v2 / area), second, -v1 / area),
      plus(scaled(second, u1 / area), first, -u2 / area),
    ]
  }
}

/** Computes the tangent frame as `getTangentFrame` of three.js does for meshes without tangents. */
function frameOf([du, dv]: readonly Vector[], normal: Vector): [Vector, Vector] {
  const [tangent, bitangent] = [cross(dv, normal), cross(normal, du)]
  const longer = Math.max(Math.hypot(...tangent), Math.hypot(...bitangent))
  return [scaled(tangent, 1 / longer), scaled(bitangent, 1 / longer)]
}

/** Returns the tilt of the normal in a texel, as a vector in space. The bitangent points along v, and the y of a normal map against v. */
function leanOf(map: Uint8Array, texel: number, [tangent, bitangent]: [Vector, Vector]): Vector {
  const [x, y] = [0, 1].map((k) => map[4 * texel + k] / 127.5 - 1)
  return plus(scaled(tangent, x), bitangent, -y)
}

function longestOf(prepared: PreparedFace, name: string): LaidStroke {
  const { creases } = facialCreases(prepared, (AGE - 20) / 60).find(({ region }) => region.name === name)!
  return creases.reduce((a, b) => (b.depths.length > a.depths.length ? b : a))
}

function inMetres({ skin, face }: PreparedFace) {
  const positions = [...face.surface.pointOf].flatMap((point) => vectorAt(face.surface.points, point))
  return { ...skin, positions: positions.map((millimetres) => millimetres / 1000) }
}

function longestRun(values: readonly number[], isCounted: (value: number) => boolean): number {
  let [run, longest] = [0, 0]
  for (const value of values) {
    run = isCounted(value) ? run + 1 : 0
    longest = Math.max(longest, run)
  }
  return longest
}

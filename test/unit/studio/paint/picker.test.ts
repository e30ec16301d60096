import { FurrowError } from 'furrow'
import {
  Bone,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  Ray,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
  Vector3,
} from 'three'
import { describe, expect, it } from 'vitest'
import { BRUSH_DEFAULTS } from '../../../../studio/src/paint/brush.ts'
import { BrushStroke } from '../../../../studio/src/paint/brush-stroke.ts'
import { paintSurface } from '../../../../studio/src/paint/paint-skin.ts'
import { paintPolygon } from '../../../../studio/src/paint/polygon.ts'
import { readSkin } from '../../../../studio/src/paint/read-skin.ts'
import {
  ball,
  cutSheet,
  empty,
  meshOf,
  onIslands,
  paint,
  paintSkin,
  pickerOf,
  placesOf,
  plainSheet,
  pointNear,
  rayAt,
} from './skins.ts'

describe('picking', () => {
  it('finds the triangle, and the position at rest and in the texture', () => {
    const { picker, skin } = pickerOf(cutSheet())
    const hit = picker.pick(rayAt(0.012, 0.031))!
    for (const [k, value] of [12, 31, 0].entries()) expect(hit.position[k]).toBeCloseTo(value, 4)
    // The point is in the upper island, which is rotated.
    expect(hit.uv[0]).toBeCloseTo(0.98 - 0.4 * (21 / 40), 5)
    expect(hit.uv[1]).toBeCloseTo(0.02 + 0.9 * 0.62, 5)
    expect(hit.point.distanceTo(new Vector3(0.012, 0.031, 0))).toBeLessThan(1e-6)
    expect(hit.normal.z).toBeCloseTo(1, 6)
    const corners = [0, 1, 2].map((k) => 3 * skin.surface.corners[3 * hit.triangle + k])
    const mixed = corners.reduce((sum, at, k) => sum + hit.weights[k] * skin.surface.points[at], 0)
    expect(mixed).toBeCloseTo(12, 4)
  })

  it('finds nothing off the face, and nothing behind one-sided skin', () => {
    const { picker } = pickerOf(plainSheet())
    expect(picker.pick(rayAt(0.2, 0))).toBeUndefined()
    expect(picker.pick(new Ray(new Vector3(0, 0, -1), new Vector3(0, 0, 1)))).toBeUndefined()
    const both = plainSheet()
    both.material.side = DoubleSide
    expect(pickerOf(both).picker.pick(new Ray(new Vector3(0, 0, -1), new Vector3(0, 0, 1)))?.normal.z).toBe(
      -1,
    )
  })

  it('follows blendshapes and the node after `refit`, and still returns the position at rest', () => {
    const mesh = plainSheet()
    const { position } = mesh.geometry.attributes
    const offsets = Array.from({ length: position.count }, () => [0.3, 0, 0.05]).flat()
    mesh.geometry.morphAttributes.position = [new Float32BufferAttribute(offsets, 3)]
    mesh.geometry.morphTargetsRelative = true
    mesh.updateMorphTargets()
    const { picker } = pickerOf(mesh)
    mesh.morphTargetInfluences![0] = 1
    mesh.position.y = 0.2
    expect(picker.pick(rayAt(0.31, 0.22))).toBeUndefined()
    picker.refit()
    const hit = picker.pick(rayAt(0.31, 0.22))!
    for (const [k, value] of [10, 20, 0].entries()) expect(hit.position[k]).toBeCloseTo(value, 4)
    expect(hit.point.z).toBeCloseTo(0.05, 6)
    expect(picker.pick(rayAt(0.01, 0.02))).toBeUndefined()
  })

  it('follows joints after `refit`', () => {
    const { geometry, material } = plainSheet()
    const { count } = geometry.attributes.position
    geometry.setAttribute('skinIndex', new Uint16BufferAttribute(new Uint16Array(4 * count), 4))
    const weights = Array.from({ length: count }, () => [1, 0, 0, 0]).flat()
    geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4))
    const mesh = new SkinnedMesh(geometry, material)
    const bone = new Bone()
    new Group().add(mesh.add(bone))
    mesh.bind(new Skeleton([bone]))
    const { picker } = pickerOf(mesh)
    bone.position.set(0.4, 0, 0)
    bone.rotation.z = Math.PI / 2
    picker.refit()
    const hit = picker.pick(rayAt(0.41, 0.03))!
    for (const [k, value] of [30, -10, 0].entries()) expect(hit.position[k]).toBeCloseTo(value, 4)
  })

  it('treats the parts of a skin as one surface', () => {
    const [lower, upper] = [0, 0.5].map((from) =>
      meshOf({
        n: 20,
        m: 10,
        at: (i, j) => [100 * i - 50, 100 * (from + j / 2) - 50, 0, i, 1 - from - j / 2],
      }),
    )
    const { picker, skin } = pickerOf(lower, upper)
    expect(picker.pick(rayAt(0, 0.02))!.position[1]).toBeCloseTo(20, 4)
    expect(picker.pick(rayAt(0, -0.02))!.position[1]).toBeCloseTo(-20, 4)
    const image = paint(empty(64), { radius: 10 }, skin, picker.pick(rayAt(0, -0.002)))
    const painted = [...placesOf(skin.mapOf(64), image)].filter(({ weight }) => weight > 0)
    expect(painted.some(({ y }) => y > 2) && painted.some(({ y }) => y < -2)).toBe(true)
  })

  it('ignores invalid triangles and vertices', () => {
    const mesh = plainSheet()
    const { position } = mesh.geometry.attributes
    position.setX(0, Number.NaN)
    const { picker } = pickerOf(mesh)
    expect(picker.pick(rayAt(0.012, 0.031))!.position[0]).toBeCloseTo(12, 4)
    picker.refit()
    expect(picker.pick(rayAt(0.012, 0.031))!.position[0]).toBeCloseTo(12, 4)
  })

  it('refuses a mesh without texture coordinates, triangles or size', () => {
    const mesh = plainSheet()
    mesh.geometry.deleteAttribute('uv')
    expect(() => readSkin([mesh])).toThrow(FurrowError)
    const nothing = { positions: [], uvs: [], indices: [], targets: [] }
    expect(() => paintSurface(nothing)).toThrow(FurrowError)
    const { skin } = readSkin([plainSheet()])
    for (const scale of [0, -1, Number.NaN, Infinity])
      expect(() => paintSurface(skin, scale)).toThrow(FurrowError)
    expect(paintSurface(skin, 500).points.reduce((a, b) => Math.max(a, b))).toBeCloseTo(25, 4)
  })
})

describe('visible skin', () => {
  const { picker, skin } = pickerOf(ball())
  const sight = picker.sightFrom(new Vector3(0, 0, 1))

  it('is painted, and the far side is not', () => {
    const stroke = new BrushStroke(empty(128), { ...BRUSH_DEFAULTS, radius: 45, flow: 1 }, skin, sight)
    stroke.moveTo(pointNear(skin, 45, 0, 22))
    const places = onIslands(skin, stroke.end().image)
    // A camera 1 m away sees the part of a ball of 50 mm radius with z > 2.5 mm.
    const painted = places.filter(({ weight }) => weight > 0)
    expect(painted.filter(({ z }) => z > 5).length).toBeGreaterThan(50)
    expect(painted.filter(({ z }) => z < -1)).toEqual([])
    const all = paint(empty(128), { radius: 45 }, skin, pointNear(skin, 45, 0, 22))
    const behind = [...placesOf(skin.mapOf(128), all)].filter(({ z, weight }) => z < -5 && weight > 0)
    expect(behind.length).toBeGreaterThan(50)
  })

  it('is also the mirror image of visible points with mirror', () => {
    const fromLeft = picker.sightFrom(new Vector3(1, 0, 0.2))
    const settings = { ...BRUSH_DEFAULTS, radius: 12, flow: 1, mirror: true }
    const stroke = new BrushStroke(empty(128), settings, skin, fromLeft)
    stroke.moveTo(pointNear(skin, 45, 0, 22))
    const painted = [...placesOf(skin.mapOf(128), stroke.end().image)].filter(({ weight }) => weight > 100)
    const [left, right] = [painted.filter(({ x }) => x > 0), painted.filter(({ x }) => x < 0)]
    expect(right.length).toBeGreaterThan(10)
    expect(Math.abs(left.length - right.length)).toBeLessThanOrEqual(2)
  })

  it('does not include skin that other skin hides in the current pose', () => {
    const at = (z: number, v: number) => ({
      n: 10,
      m: 10,
      at: (i: number, j: number) => [60 * i - 30, 60 * j - 30, z, 0.05 + 0.9 * i, v - 0.4 * j] as const,
    })
    const mesh = meshOf(at(0, 0.95), at(20, 0.45))
    const { count } = mesh.geometry.attributes.position
    // The blendshape moves the front sheet aside.
    const offsets = Array.from({ length: count }, (_, i) => [i < count / 2 ? 0 : 0.2, 0, 0]).flat()
    mesh.geometry.morphAttributes.position = [new Float32BufferAttribute(offsets, 3)]
    mesh.geometry.morphTargetsRelative = true
    mesh.updateMorphTargets()
    const { picker, skin } = pickerOf(mesh)
    const behind = pointNear(skin, 0, 0, 0)
    const peak = () => {
      const stroke = new BrushStroke(empty(64), BRUSH_DEFAULTS, skin, picker.sightFrom(new Vector3(0, 0, 1)))
      stroke.moveTo(behind)
      return Math.max(...stroke.end().image.data)
    }
    expect(peak()).toBe(0)
    mesh.morphTargetInfluences![0] = 1
    picker.refit()
    expect(peak()).toBeGreaterThan(90)
  })
})

describe('a polygon on the skin', () => {
  const skin = paintSkin(cutSheet())
  const square = [
    [-20, -15],
    [20, -15],
    [20, 30],
    [-20, 30],
  ].map(([x, y]) => pointNear(skin, x, y))
  const settings = { mode: 'add', feather: 8, opacity: 1, mirror: false } as const

  it('fades across its outline, as wide as its feather, on both sides of a seam', () => {
    const { image, dirty } = paintPolygon(empty(256), square, settings, skin)
    let worst = 0
    for (const { x, y, weight, isBeyondIsland } of placesOf(skin.mapOf(256), image)) {
      if (isBeyondIsland && Math.abs(y - 10) > 1) continue
      const [dx, dy] = [Math.abs(x) - 20, Math.abs(y - 7.5) - 22.5]
      const outside = Math.hypot(Math.max(dx, 0), Math.max(dy, 0))
      const distance = outside > 0 ? outside : Math.max(dx, dy)
      const t = Math.min(Math.max(distance / 8 + 0.5, 0), 1)
      worst = Math.max(worst, Math.abs(weight - 255 * (1 - t * t * (3 - 2 * t))))
    }
    expect(worst).toBeLessThanOrEqual(1)
    expect(dirty).toBeDefined()
  })

  it('is the same with its points in reverse order, and has a hard edge without a feather', () => {
    const one = paintPolygon(empty(128), square, settings, skin).image
    expect(paintPolygon(empty(128), square.toReversed(), settings, skin).image.data).toEqual(one.data)
    const hard = paintPolygon(empty(128), square, { ...settings, feather: 0 }, skin).image
    expect(new Set(hard.data)).toEqual(new Set([0, 255]))
  })

  it('can reduce weights, and covers up to its opacity', () => {
    const removed = paintPolygon(empty(128, 200), square, { ...settings, mode: 'remove', opacity: 0.5 }, skin)
    expect(Math.min(...removed.image.data)).toBe(100)
  })

  it('is painted on both sides of the face with mirror', () => {
    const half = [
      [10, -20],
      [30, -20],
      [30, 0],
    ].map(([x, y]) => pointNear(skin, x, y))
    const { image } = paintPolygon(empty(128), half, { ...settings, mirror: true }, skin)
    const places = [...placesOf(skin.mapOf(128), image)].filter(({ weight }) => weight > 128)
    const right = places.filter(({ x }) => x < 0).length
    expect(right).toBeGreaterThan(20)
    expect(Math.abs(places.length - 2 * right)).toBeLessThan(0.1 * right)
  })

  it('does not cover the far side of a closed surface, or any hidden skin if only visible skin is wanted', () => {
    const { picker, skin } = pickerOf(ball())
    const front = [
      [-25, -25],
      [25, -25],
      [25, 25],
      [-25, 25],
    ].map(([x, y]) => pointNear(skin, x, y, 45))
    const painted = (image = paintPolygon(empty(128), front, settings, skin).image) =>
      [...placesOf(skin.mapOf(128), image)].filter(({ weight }) => weight > 0)
    expect(painted().length).toBeGreaterThan(100)
    expect(painted().filter(({ z, isBeyondIsland }) => z < 20 && !isBeyondIsland)).toEqual([])
    const sight = picker.sightFrom(new Vector3(1, 0, 0))
    const seen = painted(paintPolygon(empty(128), front, settings, skin, sight).image)
    expect(seen.length).toBeGreaterThan(20)
    expect(seen.filter(({ x, isBeyondIsland }) => x < 0 && !isBeyondIsland)).toEqual([])
  })

  it.each([
    ['two points', square.slice(0, 2), settings],
    ['points on a line', [square[0], square[1], square[0]], settings],
    ['a feather below 0', square, { ...settings, feather: -1 }],
    ['a feather that is NaN', square, { ...settings, feather: Number.NaN }],
    ['an opacity above 1', square, { ...settings, opacity: 1.5 }],
  ])('is refused: %s', (_, points, brush) => {
    expect(() => paintPolygon(empty(128), points, brush, skin)).toThrow(FurrowError)
  })
})

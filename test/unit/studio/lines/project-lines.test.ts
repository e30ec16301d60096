import { PerspectiveCamera } from 'three'
import { beforeEach, expect, test, vi } from 'vitest'
import type { LayerStroke } from '../../../../studio/src/document/document.ts'
import type { LineSkin } from '../../../../studio/src/lines/line-skin.ts'
import { LineProjection } from '../../../../studio/src/lines/project-lines.ts'
import { sampleDocument } from '../sample-document.ts'

const SIZE = [800, 600] as const

/** Skin on which every line has two points. */
const skin = {
  follow() {},
  lineOf: vi.fn((_: LayerStroke) => ({
    triangles: [0, 0],
    weights: Float64Array.of(1, 0, 0, 0, 1, 0),
    along: Float64Array.of(0, 1),
  })),
  picker: {
    poses: 0,
    sightFrom: () => () => true,
    positionOf: (_triangle: number, weights: ArrayLike<number>, out: { set(...xyz: number[]): unknown }) =>
      out.set(weights[0], 0, 0),
  },
}

let camera: PerspectiveCamera
let projection: LineProjection
const { strokes } = sampleDocument()
const project = (lines: readonly LayerStroke[], size: readonly [number, number] = SIZE) => {
  skin.lineOf.mockClear()
  const projected = projection.project(lines, skin as unknown as LineSkin, camera, size)
  return { projected, searched: skin.lineOf.mock.calls.map(([stroke]) => stroke) }
}

beforeEach(() => {
  camera = new PerspectiveCamera(30, SIZE[0] / SIZE[1])
  camera.position.z = 5
  projection = new LineProjection()
  project(strokes)
})

test('only a changed line is projected again', () => {
  const bent = { ...strokes[1] }
  const { projected, searched } = project(strokes.with(1, bent))
  expect(searched).toEqual([bent])
  expect(projected.map(({ stroke }) => stroke)).toEqual(strokes.with(1, bent))
  expect(project(strokes.with(1, bent)).searched).toEqual([])
})

test('all lines are projected again when the camera, the face or the stage changes', () => {
  const before = project(strokes).projected[0]
  camera.position.x = 1
  const moved = project(strokes)
  expect(moved.searched).toEqual(strokes)
  expect(moved.projected[0].x[0]).not.toBe(before.x[0])
  skin.picker.poses++
  expect(project(strokes).searched).toEqual(strokes)
  expect(project(strokes, [400, 300]).searched).toEqual(strokes)
})

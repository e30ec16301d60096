import { Ray, Vector3 } from 'three'
import { beforeEach, expect, it } from 'vitest'
import type { SkinHit } from '../../../../studio/src/paint/picker.ts'
import { Polygon } from '../../../../studio/src/tools/polygon.ts'
import { PolygonTool } from '../../../../studio/src/tools/polygon-tool.ts'
import { TexturePicker } from '../../../../studio/src/tools/texture-picker.ts'
import { pickerOf, plainSheet, pointerAt } from './skins.ts'

let polygon: Polygon
let tool: PolygonTool
let closed: (readonly SkinHit[])[]

let onTexture: PolygonTool

beforeEach(() => {
  const { skin, picker } = pickerOf(plainSheet())
  const texture = new TexturePicker(skin, picker, 64)
  closed = []
  polygon = new Polygon(() => {})
  tool = new PolygonTool({
    polygon,
    pick: ({ ray }) => picker.pick(ray),
    preparation: () => null,
    project: ({ point }) => ({ x: 1000 * point.x, y: 1000 * point.y }),
    close: () => closed.push(polygon.take()!),
  })
  onTexture = new PolygonTool({
    polygon,
    pick: ({ ray }) => texture.pick(ray),
    preparation: () => null,
    project: ({ uv: [u, v] }) => ({ x: 500 * u, y: 500 * v }),
    close: () => closed.push(polygon.take()!),
  })
})

/** Pointer at a position in millimetres, with one pixel per millimetre. */
const at = (x: number, y: number, others = {}) => pointerAt(x / 1000, y / 1000, { x, y, ...others })

function click(x: number, y: number): boolean {
  const isTaken = tool.begin(at(x, y))
  if (isTaken) tool.end()
  return isTaken
}

const places = (points: readonly SkinHit[]) =>
  points.map(({ position }) => position.slice(0, 2).map((value) => Math.round(value)))

it('a click adds a point, and a click near the first point closes the polygon', () => {
  click(0, 0)
  click(30, 0)
  click(3, 3)
  expect(closed).toEqual([])
  click(30, 30)
  click(4, -4)
  expect(closed.map(places)).toEqual([
    [
      [0, 0],
      [30, 0],
      [3, 3],
      [30, 30],
    ],
  ])
  expect(polygon.points).toEqual([])
})

it('a new point follows the pointer until it is released, and Escape removes it', () => {
  click(0, 0)
  tool.begin(at(10, 0))
  tool.move([at(20, 0), at(25, 5)])
  expect(places(polygon.points)).toEqual([
    [0, 0],
    [25, 5],
  ])
  tool.cancel()
  expect(places(polygon.points)).toEqual([[0, 0]])
})

it('two points enclose nothing, and points can be removed one at a time or all at once', () => {
  click(0, 0)
  click(30, 0)
  expect(polygon.take()).toBeNull()
  polygon.removeLast()
  expect(places(polygon.points)).toEqual([[0, 0]])
  polygon.clear()
  expect(polygon.points).toEqual([])
})

it('the pointer is left to the camera if it is off the face, or with Alt', () => {
  expect(click(200, 0)).toBe(false)
  expect(tool.begin(at(0, 0, { alt: true }))).toBe(false)
})

it('the points of a polygon can be placed on the face and on its texture in turn', () => {
  const inTexture = (u: number, v: number) => {
    const ray = new Ray(new Vector3(u, -v, 1), new Vector3(0, 0, -1))
    onTexture.begin({ ...at(0, 0), ray, x: 500 * u, y: 500 * v })
    onTexture.end()
  }
  click(-30, -30)
  inTexture(0.8, 0.8)
  click(30, 30)
  inTexture(0.2, 0.8)
  expect(closed.map(places)).toEqual([
    [
      [-30, -30],
      [30, -30],
      [30, 30],
    ],
  ])
})

import { BufferGeometry, Float32BufferAttribute, Mesh, PerspectiveCamera, Vector3 } from 'three'
import { expect, it } from 'vitest'
import { headFrame } from '../../../bench/auto/sheets/head-frame.ts'
import { type CloseUp, frameCloseUp } from '../../../stage/views.ts'
import { skinAt } from '../../skin-at.ts'

const FACE = 'faces/human.glb'
const frame = await headFrame(FACE)
const { positions, indices } = await skinAt(FACE)

/** Projects a point to the picture of a close-up, -1..1 in both directions. */
function project(view: CloseUp, point: Vector3): Vector3 {
  const geometry = new BufferGeometry().setIndex(Array.from(indices))
  geometry.setAttribute('position', new Float32BufferAttribute(Array.from(positions), 3))
  const camera = new PerspectiveCamera(1, 1)
  frameCloseUp(new Mesh(geometry), camera, view)
  camera.updateMatrixWorld()
  return point.clone().project(camera)
}

it.each([0, 30, -75])(
  'shows the point in the middle and the height from edge to edge, at yaw %i',
  async (yaw) => {
    const point = frame.pointAt(frame.landmarks.outerCorner, {})
    const height = 50 / frame.scale
    const view = { yaw, pitch: 0, light: 0, point, height }
    const middle = new Vector3(...point)
    const { x, y } = project(view, middle)
    expect(x).toBeCloseTo(0, 6)
    expect(y).toBeCloseTo(0, 6)
    const top = project(view, middle.clone().add(new Vector3(0, height / 2, 0)))
    expect(top.y).toBeCloseTo(1, 2)
  },
)

it('follows the skin that an expression moves', () => {
  const chin = [0, frame.landmarks.chin, frame.landmarks.tip[2]]
  const [, atRest] = frame.pointAt(chin, {})
  const [, opened] = frame.pointAt(chin, { jawOpen: 1 })
  expect((atRest - opened) * frame.scale).toBeGreaterThan(10)
})

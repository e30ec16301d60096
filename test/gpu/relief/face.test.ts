import { findTargets } from 'furrow'
import { frameFace } from 'furrow/three'
import {
  AmbientLight,
  Box3,
  Color,
  type Mesh,
  OrthographicCamera,
  PerspectiveCamera,
  Scene,
  Vector3,
} from 'three'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { Rng } from '../../../packages/furrow/src/math/rng.ts'
import { harnessOn, RENDERERS } from '../harness.ts'
import { distances, fractionWithin, type Outline, outlineOf, projectedOutline } from './outline.ts'
import { bandedFace, displacedSkin, type RaisedFace } from './raised-face.ts'

/** Width of a picture of the complete head, pixels. The first test draws outlines at twice this width, and converts distances to pixels of this width. */
const PIXELS = 1600
const FINE = 2 * PIXELS

/** Maximum distance by which relief moves the outline, in pixels of a picture that is 400 pixels wide. */
const NEAR = 3

/** Outlines computed in float64, by picture size. All renderers are compared with them. */
const outlines = new Map<number, Outline>()

const POSE = { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1, mouthSmileLeft: 0.5 }

describe.each(RENDERERS)('the shipped face on %s', (name) => {
  const harness = harnessOn(name)
  let face: RaisedFace
  beforeAll(async () => {
    face = await bandedFace(harness)
  })
  afterAll(() => {
    face.dispose()
  })

  function pose(weights: Record<string, number>): void {
    face.root.traverse((object) => {
      const { morphTargetDictionary, morphTargetInfluences } = object as Mesh
      if (!morphTargetDictionary) return
      morphTargetInfluences!.fill(0)
      for (const [target, weight] of Object.entries(weights)) {
        const targets = findTargets(target, Object.keys(morphTargetDictionary))
        for (const index of targets) morphTargetInfluences![index] = weight
      }
    })
  }

  /** Draws the skin in profile. Returns its outline, and the outline computed in float64. */
  function inProfile(size: number) {
    const box = new Box3().setFromObject(face.skin)
    const centre = box.getCenter(new Vector3())
    const side = Math.max(box.max.y - box.min.y, box.max.z - box.min.z)
    const camera = new OrthographicCamera(-side / 2, side / 2, side / 2, -side / 2, 0, 2)
    camera.position.set(-1, centre.y, centre.z)
    camera.lookAt(centre)
    const picture = async () => {
      const alone = new Scene().add(face.skin, new AmbientLight(0xffffff, 30))
      return outlineOf(await harness.renderBytes(alone, camera, size), size, size)
    }
    const reference = () => {
      const known = outlines.get(size)
      if (known) return known
      const { triangles, positions } = displacedSkin(face)
      const toPixels = (vertex: number, axis: number) =>
        ((positions[3 * vertex + axis] - centre.getComponent(axis)) / side + 0.5) * size
      const outline = projectedOutline(
        triangles,
        (vertex) => [toPixels(vertex, 2), toPixels(vertex, 1)],
        size,
      )
      outlines.set(size, outline)
      return outline
    }
    return { picture, reference }
  }

  it('has the outline of the float64 reference in profile, not the outline without relief', async () => {
    pose(POSE)
    const { picture, reference } = inProfile(FINE)
    await picture()
    const shown = await picture()
    face.wrinkles.relief = 'off'
    const plain = await picture()
    face.wrinkles.relief = 'on'
    const expected = reference()
    const pixels = (a: Outline, b: Outline) => distances(a, b).map((distance) => (distance * PIXELS) / FINE)
    expect(fractionWithin(0.5, pixels(shown, expected))).toBeGreaterThan(0.995)
    expect(Math.max(...forehead(pixels(plain, expected)))).toBeGreaterThan(1.5)
    // The bands of the height map are steeper than any wrinkle, so triangles of 1.2 mm approximate them less exactly.
    expect(Math.max(...forehead(pixels(shown, expected)))).toBeLessThan(0.6)
  })

  it.each([
    ['second', 1, 1200],
    ['third', 2, 600],
  ])('has the float64 outline with the %s, coarser version of the mesh', async (_, version, size) => {
    pose(POSE)
    const { picture, reference } = inProfile(size)
    await picture()
    const found = distances(await picture(), reference())
    // Rounding to whole pixels already adds an error of half a pixel.
    expect(fractionWithin(1, found)).toBeGreaterThan(0.995)
    const [{ geometry }] = face.skin.children.filter((child) => 'isReliefMesh' in child) as unknown as Mesh[]
    expect(geometry.drawRange.start).toBe(geometry.groups[version].start)
  })

  it('shows no background inside the head, in random views and poses', async () => {
    const rng = new Rng(17)
    const scene = new Scene().add(face.root, face.skin, new AmbientLight(0xffffff, 3))
    scene.background = new Color(0x00ff00)
    const targets = Object.keys(face.skin.morphTargetDictionary!)
    const size = 400
    // `WebGPURenderer` on WebGL 2 runs the same code as on WebGPU, so test fewer views.
    const views = name === 'webgpu on webgl2' ? 2 : 10
    for (let i = 0; i < views; i++) {
      pose(Object.fromEntries(targets.map((target) => [target, rng.next() < 0.1 ? rng.next() : 0])))
      const camera = new PerspectiveCamera(22, 1, 0.05, 10)
      frameFace(camera, face.root, { yaw: rng.uniform(-180, 180), pitch: rng.uniform(-20, 40), zoom: 1 })
      face.wrinkles.relief = 'on'
      const shown = await harness.renderBytes(scene, camera, size)
      face.wrinkles.relief = 'off'
      const plain = await harness.renderBytes(scene, camera, size)
      expect(holes(shown, plain, size)).toEqual([])
    }
  })
})

/** Returns the distances in the rows of the forehead. `found` is a result of `distances`. The face looks to the right. */
function forehead(found: number[]): number[] {
  const right = found.slice(found.length / 2)
  return right.slice(0.72 * right.length, 0.86 * right.length)
}

/** Returns the background pixels of `shown` that are far from all background of `plain`, the picture without relief. */
function holes(shown: Uint8Array, plain: Uint8Array, size: number): number[] {
  const isBackground = (pixels: Uint8Array, x: number, y: number) => {
    const i = 4 * (x + y * size)
    return pixels[i] === 0 && pixels[i + 1] === 255 && pixels[i + 2] === 0
  }
  const found: number[] = []
  for (let y = NEAR; y < size - NEAR; y++) {
    for (let x = NEAR; x < size - NEAR; x++) {
      if (!isBackground(shown, x, y)) continue
      let isNear = false
      for (let dy = -NEAR; dy <= NEAR; dy++) {
        for (let dx = -NEAR; dx <= NEAR; dx++) isNear ||= isBackground(plain, x + dx, y + dy)
      }
      if (!isNear) found.push(x + y * size)
    }
  }
  return found
}

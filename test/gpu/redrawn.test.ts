import type { GrayImage, RgbaImage, WrinkleSet } from 'furrow'
import type { WrinklesOptions } from 'furrow/three'
import { type DataTexture, MeshPhysicalMaterial } from 'three'
import { describe, expect, it, vi } from 'vitest'
import { layer } from '../cases.ts'
import { seeded } from '../random.ts'
import { drawn, FRAMES, MAP, SOON, UNSEEN, useFaces } from './auto-face.ts'
import { largestDifference } from './difference.ts'
import { LONGEST_TEST_RENDERERS, squareCamera } from './harness.ts'
import { normalMap } from './normal-map.ts'

/** Sides of pictures with sixteen pixels for each texel, and with one. */
const LARGE = 4 * MAP
const SMALL = MAP

/** Frames for which a face must be still before it has a map. */
const PATIENCE = 30

/** Of a composed map with its mipmaps. */
const BYTES = (MAP * MAP * 4 * 4) / 3

/** Waves of 16 to 64 texels: magnified, independent texels filter otherwise before they are mixed than after. */
function waves(seed: number, at: (wave: (texel: number) => number, x: number, y: number) => number[]) {
  const random = seeded(seed)
  const terms = Array.from({ length: 3 }, (_, i) => ({ count: i + 1, phase: 2 * Math.PI * random() }))
  const wave = (texel: number) =>
    terms.reduce(
      (sum, { count, phase }) => sum + Math.sin((2 * Math.PI * count * texel) / MAP + phase) / 3,
      0,
    )
  const texels = Array.from({ length: MAP * MAP }, (_, i) => at(wave, i % MAP, Math.floor(i / MAP)))
  return { width: MAP, height: MAP, data: Uint8Array.from(texels.flat(), (value) => 127.5 * value + 128) }
}

const normals = (seed: number): RgbaImage =>
  waves(seed, (wave, x, y) => {
    const slope = [0.25 * wave(x + y), 0.25 * wave(x - y)]
    return [...slope, Math.sqrt(1 - slope[0] ** 2 - slope[1] ** 2), 1]
  })

const gray = (seed: number): GrayImage => waves(seed, (wave, x, y) => [0.5 + wave(x - y) / 2])

/** Sums of three of these are not cut off at 1. */
const third = (image: GrayImage): GrayImage => ({ ...image, data: image.data.map((weight) => weight / 3) })

/** Normals only, and all that a composed map can hold. */
const NORMALS: WrinkleSet = {
  areas: [20, 21, 22].map((seed) => ({ name: `area${seed}`, weights: third(gray(seed)) })),
  layers: [layer('skin', 'replace', normals(5))],
}
const EVERYTHING: WrinkleSet = {
  areas: NORMALS.areas.map((area, i) => ({ ...area, layer: ['up', 'down'][i % 2] })),
  layers: [
    { ...layer('up', 'detail', normals(5)), occlusion: gray(8), blood: gray(9), bloodAmplitude: 0.8 },
    { ...layer('down', 'replace', normals(6)), occlusion: gray(10), blood: gray(11), bloodAmplitude: 0.8 },
  ],
}

/** A map of the material's own. */
function ownMap(seed: number): DataTexture {
  const map = normalMap(seed, MAP)
  map.image.data = normals(seed).data as Uint8Array
  return map
}

describe.each(LONGEST_TEST_RENDERERS)(
  'a face in the mode auto that is seen large while it moves, on %s',
  (name) => {
    const faces = useFaces(name)

    /** The face, and one beside it that is the same in the default mode. */
    function pair(set: WrinkleSet, options: WrinklesOptions = {}) {
      const material = () =>
        new MeshPhysicalMaterial({ normalMap: ownMap(2), aoMap: ownMap(7), roughness: 0.6 })
      const face = faces.face(options, material(), set)
      const wanted = faces.face({ mode: 'default' }, material(), set)
      const { renderer } = faces.harness
      /** Moves some of both. */
      const move = (frame: number) => {
        for (const { wrinkles } of [face, wanted]) {
          for (const [i, area] of wrinkles.areaNames.entries()) {
            if ((i + frame) % 3 === 0) wrinkles.setActivation(area, 0.6 + 0.4 * Math.sin(frame + i))
          }
        }
      }
      /** Draws frames to the canvas, in each of which the face moves or does not. */
      const frames = async (side: number, count: number, isMoving = true) => {
        renderer.setSize(side, side, false)
        for (let frame = 0; frame < count; frame++) {
          if (isMoving) move(frame)
          renderer.render(face.scene, squareCamera())
          await drawn(faces.harness)
        }
      }
      /** Draws them until it is shown so: what is compiled beside them takes some time. */
      const framesUntil = (side: number, how: Partial<typeof face.shown>, isMoving = true) =>
        vi.waitFor(async () => {
          await frames(side, 2 * FRAMES, isMoving)
          expect(face.shown).toMatchObject(how)
        }, SOON)
      const difference = async (side: number) => {
        const picture = (await faces.harness.renderBytes(face.scene, squareCamera(), side)).slice()
        return largestDifference(picture, await faces.harness.renderBytes(wanted.scene, squareCamera(), side))
      }
      const both = [face.wrinkles, wanted.wrinkles]
      return { ...face, both, move, frames, framesUntil, difference }
    }

    it.each([
      ['normals', NORMALS],
      ['occlusion and blood', EVERYTHING],
    ])('with %s shows a composed map that is redrawn, and the same picture', async (_, set) => {
      const { shown, move, framesUntil, difference } = pair(set)
      await framesUntil(LARGE, { isComposed: true, isSampled: false })
      for (let frame = 0; frame < 5; frame++) {
        move(frame)
        expect(await difference(LARGE)).toBeLessThanOrEqual(UNSEEN)
        expect(shown.isComposed).toBe(true)
      }
    })

    it('takes no dual map, and has one when it is seen smaller', async () => {
      const { framesUntil, difference } = pair(NORMALS, { textureBudget: 2.1 * BYTES })
      await framesUntil(LARGE, { isComposed: true, isDual: false })
      await framesUntil(SMALL, { isComposed: false, isDual: true })
      expect(await difference(SMALL)).toBeLessThanOrEqual(UNSEEN)
      await framesUntil(LARGE, { isComposed: true, isDual: false })
      expect(await difference(LARGE)).toBeLessThanOrEqual(UNSEEN)
    })

    it('finds an area that the page takes away while the map is drawn for the first time', async () => {
      const { both, scene, frames, framesUntil, difference } = pair(NORMALS)
      const { name: last } = NORMALS.areas.at(-1)!
      for (const wrinkles of both) wrinkles.setActivation(last, 1)
      // Up to the frame after which it is drawn, which waits for a later task.
      faces.harness.renderer.setSize(SMALL, SMALL, false)
      for (let frame = 0; frame <= PATIENCE + 1; frame++) faces.harness.renderer.render(scene, squareCamera())
      for (const wrinkles of both) wrinkles.removeArea(last)
      await frames(SMALL, 2, false)
      await new Promise((resolve) => setTimeout(resolve, 500))
      await frames(SMALL, 2, false)
      expect(await difference(SMALL)).toBeLessThanOrEqual(UNSEEN)
      await framesUntil(SMALL, { isComposed: true }, false)
      expect(await difference(SMALL)).toBeLessThanOrEqual(UNSEEN)
    })

    it('finds areas that the page takes away between two frames', async () => {
      const { wrinkles, shown, move, framesUntil, difference } = pair(NORMALS)
      await framesUntil(LARGE, { isComposed: true })
      for (const { name: area } of NORMALS.areas.slice(1)) wrinkles.setActivation(area, 0)
      const before = await difference(LARGE)
      expect(before).toBeGreaterThan(UNSEEN)
      for (const { name: area } of NORMALS.areas.slice(1)) wrinkles.removeArea(area)
      expect(await difference(LARGE)).toBe(before)
      move(1)
      expect(shown.isComposed).toBe(true)
    })
  },
)

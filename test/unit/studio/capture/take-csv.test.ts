import { expect, it } from 'vitest'
import { readLiveLinkFace } from '../../../../studio/src/capture/live-link-face.ts'
import { takeCsv } from '../../../../studio/src/capture/take-csv.ts'
import { takeOfCapture } from '../../../../studio/src/capture/take-of-capture.ts'
import { framesOf, motionOf, type Take, weightsOf } from '../../../../studio/src/document/take.ts'

/** Returns weights that differ in each key frame. */
const wave = (frames: number, phase: number) =>
  Array.from({ length: frames }, (_, i) => 0.5 + 0.5 * Math.sin(i / 7 + phase))

function takeOf(frames: number, names: readonly string[]): Take {
  const times = Array.from({ length: frames }, (_, i) => i / 60)
  return {
    name: 'Smile',
    motion: motionOf(
      times,
      names.map((name, i) => [name, wave(frames, i)]),
    ),
  }
}

const read = (take: Take) => readLiveLinkFace(new File(takeCsv(take), 'Smile.csv'))

it.each([2, 30, 60, 61, 150, 4000])('a take of %i key frames is read again exactly', async (frames) => {
  const take = takeOf(frames, ['jawOpen', 'browInnerUp', 'mouthSmileLeft'])
  const { motion, name } = takeOfCapture(await read(take), ['jawOpen'])
  expect(name).toBe('Smile')
  // The file has the order of the app.
  expect(motion.names).toEqual(['JawOpen', 'MouthSmileLeft', 'BrowInnerUp'])
  const order = [0, 2, 1].map((i) => weightsOf(take.motion, i))
  for (const [i, weights] of order.entries()) expect(weightsOf(motion, i)).toEqual(weights)
})

it('the file has the columns of the app: 52 blendshapes and 9 rotations', () => {
  const [header, row] = takeCsv(takeOf(2, ['jawOpen'])).map((line) => line.trim().split(','))
  expect(header.slice(0, 3)).toEqual(['Timecode', 'BlendShapeCount', 'EyeBlinkLeft'])
  expect(header.slice(52)).toEqual([
    'NoseSneerRight',
    'TongueOut',
    ...['HeadYaw', 'HeadPitch', 'HeadRoll', 'LeftEyeYaw', 'LeftEyePitch', 'LeftEyeRoll'],
    ...['RightEyeYaw', 'RightEyePitch', 'RightEyeRoll'],
  ])
  expect(new Set(header).size).toBe(63)
  expect(row.slice(0, 2)).toEqual(['00:00:00:00', '61'])
  expect(row[header.indexOf('JawOpen')]).toBe('0.5')
})

it('blendshapes that ARKit lacks follow, and halves become one blendshape of ARKit', async () => {
  const { weights } = await read(takeOf(3, ['my, shape', 'browInnerUpLeft', 'browInnerUpRight']))
  expect([...weights.keys()].at(-1)).toBe('my__shape')
  const halves = [wave(3, 1), wave(3, 2)]
  const means = halves[0].map((weight, i) => (weight + halves[1][i]) / 2)
  for (const [i, weight] of weights.get('BrowInnerUp')!.entries()) expect(weight).toBeCloseTo(means[i], 4)
})

it('only key frames between the in and out points are written', async () => {
  const take = takeOf(120, ['jawOpen'])
  const { motion } = takeOfCapture(await read({ ...take, range: [0.5, 1] }), ['jawOpen'])
  expect(framesOf(motion)).toBe(31)
  expect(motion.weights).toEqual(take.motion.weights.slice(30, 61))
})

import { autoWrinkles, type Skin } from 'furrow/author'
import { expect, test } from 'vitest'

const SETTINGS = { size: 64, areaSize: 32 }

/** Edge length of the cubes that form the hand, metres. The hand has a palm and five fingers, one cube apart. */
const CELL = 0.005
const FINGERS = 5
const [WIDTH, DEPTH, PALM, LENGTH] = [3, 3, 16, 14]
const PITCH = WIDTH + 1

const isPalm = (y: number) => y < PALM
const fingerOf = (x: number) => Math.floor(x / PITCH)

function isSolid(x: number, y: number, z: number): boolean {
  const isInside = x >= 0 && x < FINGERS * PITCH - 1 && y >= 0 && y < PALM + LENGTH && z >= 0 && z < DEPTH
  return isInside && (isPalm(y) || x % PITCH < WIDTH)
}

/** Returns the outer faces of all cubes, each with separate texels. */
function hand(): Omit<Skin, 'targets'> {
  const corners: number[] = []
  const along = [0, 1, 2]
  for (let x = 0; x < FINGERS * PITCH; x++)
    for (let y = 0; y < PALM + LENGTH; y++)
      for (let z = 0; z < DEPTH; z++) {
        const cell = [x, y, z] as const
        if (!isSolid(...cell)) continue
        for (const k of along) {
          for (const side of [0, 1]) {
            const next = along.map((d) => cell[d]! + (d === k ? 2 * side - 1 : 0)) as [number, number, number]
            if (isSolid(...next)) continue
            const [a, b] = side ? [(k + 1) % 3, (k + 2) % 3] : [(k + 2) % 3, (k + 1) % 3]
            for (const [i, j] of [
              [0, 0],
              [1, 0],
              [1, 1],
              [0, 1],
            ] as const)
              corners.push(
                ...along.map((d) => CELL * (cell[d]! + (d === k ? side : d === a ? i : d === b ? j : 0))),
              )
          }
        }
      }
  const quads = corners.length / 12
  const columns = Math.ceil(Math.sqrt(quads))
  const at = (quad: number, corner: number) => [
    ((quad % columns) + (corner === 1 || corner === 2 ? 0.9 : 0.1)) / columns,
    (Math.floor(quad / columns) + (corner > 1 ? 0.9 : 0.1)) / columns,
  ]
  return {
    positions: corners,
    uvs: Array.from({ length: 4 * quads }, (_, i) => at(Math.floor(i / 4), i % 4)).flat(),
    indices: Array.from({ length: quads }, (_, i) => [0, 1, 2, 0, 2, 3].map((k) => 4 * i + k)).flat(),
  }
}

/** Returns the offsets of a blendshape. `move` returns the offset of a finger's vertex, given its height above the palm. */
function target({ positions }: Pick<Skin, 'positions'>, move: (finger: number, above: number) => number[]) {
  return Float32Array.from(positions, (_, i) => {
    const first = i - (i % 3)
    const above = positions[first + 1]! - CELL * PALM
    return above > 0 ? move(fingerOf(positions[first]! / CELL + 0.5), above)[i % 3]! : 0
  })
}

const spread = (skin: Pick<Skin, 'positions'>, moves = (_: number) => true) =>
  target(skin, (finger, above) => (moves(finger) ? [0.4 * (finger - 2) * above, 0, 0] : [0, 0, 0]))
const curled = (skin: Pick<Skin, 'positions'>, moves = (_: number) => true) =>
  target(skin, (finger, above) => (moves(finger) ? [0, -0.5 * above, above] : [0, 0, 0]))

function handWith(moves: readonly ((skin: Pick<Skin, 'positions'>) => Float32Array)[]): Skin {
  const skin = hand()
  return { ...skin, targets: moves.map((move, i) => ({ name: `target_${i}`, offsets: move(skin) })) }
}

test('a hand whose fingers part like lips gets no lines, and a reason', () => {
  const { areas, emptyReason } = autoWrinkles(handWith([spread, curled]), SETTINGS)
  expect(areas).toEqual([])
  expect(emptyReason).toContain('looks like a head')
})

test('a hand whose fingers move one at a time is not taken for a face', () => {
  const moves = Array.from({ length: FINGERS }, (_, i) =>
    [spread, curled].map((move) => (skin: Pick<Skin, 'positions'>) => move(skin, (finger) => finger === i)),
  )
  const { landmarks, expressions } = autoWrinkles(handWith(moves.flat()), SETTINGS)
  expect(landmarks).toBeUndefined()
  expect(expressions).toEqual([])
})

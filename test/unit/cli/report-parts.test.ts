import { describe, expect, test } from 'vitest'
import { changedRect } from '../../../packages/cli/src/auto/report/changed-rect.ts'
import { posesOf } from '../../../packages/cli/src/auto/report/poses.ts'
import {
  COLOUR_SCALE,
  colourStrain,
  MAX_COMPRESSION,
} from '../../../packages/cli/src/auto/report/strain-colours.ts'
import { Steps } from '../../../packages/cli/src/auto/steps.ts'
import { html } from '../../../packages/cli/src/markup.ts'
import { STRAIGHT } from '../../drivers.ts'

const made = (...targets: string[]) => ({
  targets,
  areas: [],
  layers: [],
  warnings: [],
  landmarks: undefined,
})

describe('poses', () => {
  test("use the face's names of blendshapes, including those of left and right halves", () => {
    const poses = posesOf(
      made('browInnerUp_L', 'browInnerUp_R', 'BrowOuterUp.L', 'brow_outer_up_right', 'jawOpen'),
    )
    expect(poses).toEqual([
      {
        name: 'Surprise',
        targets: {
          browInnerUp_L: 1,
          browInnerUp_R: 1,
          'BrowOuterUp.L': 1,
          brow_outer_up_right: 1,
          jawOpen: 0.2,
        },
      },
      { name: 'Left brow alone', targets: { 'BrowOuterUp.L': 1, browInnerUp_L: 0.8 } },
    ])
  })

  test('leave out expressions whose required shapes are missing, and keep those whose optional shapes are missing', () => {
    expect(posesOf(made('mouthSmileLeft', 'cheekSquintLeft', 'noseSneerLeft', 'noseSneerRight'))).toEqual([
      { name: 'Sneer', targets: { noseSneerLeft: 1, noseSneerRight: 1 } },
    ])
  })

  test('of a body are the blendshapes that wrinkle it most', () => {
    const area = (compression: number, ...links: [string, number][]) => ({
      name: 'any',
      layer: 0,
      weights: { width: 1, height: 1, data: new Uint8Array(1) },
      driver: {
        type: 'morph' as const,
        area: 'any',
        targets: links.map(([name, weight]) => ({ name, weight })),
        rule: 'sum' as const,
        curve: STRAIGHT as [number, number][],
      },
      compression,
      error: 0,
      lines: 1,
    })
    const body = {
      ...made('a', 'b'),
      areas: [area(0.1, ['a', 0.2], ['b', 0.9]), area(0.3, ['a', 1], ['b', -1]), area(0.2, ['a', 1])],
    }
    expect(posesOf(body)).toEqual([
      { name: 'a', targets: { a: 1 } },
      { name: 'b', targets: { b: 1 } },
    ])
  })
})

test('the picture of compression uses the colours of the scale, and is transparent where no skin is', () => {
  const last = COLOUR_SCALE.length - 1
  const compressions = [
    ...COLOUR_SCALE.map((_, i) => (MAX_COMPRESSION * i) / last),
    1,
    MAX_COMPRESSION / last / 2,
  ]
  const data = Float32Array.from([...compressions, Number.NaN])
  const pixels = colourStrain({ width: data.length, height: 1, data })
  const middle = [0, 1, 2].map((k) => (COLOUR_SCALE[0][k]! + COLOUR_SCALE[1][k]!) / 2)
  const wanted = [...COLOUR_SCALE, COLOUR_SCALE[last], middle].map((rgb) => [...rgb, 255])
  for (const [i, rgba] of [...wanted, [0, 0, 0, 0]].entries()) {
    for (const [k, value] of rgba.entries())
      expect(Math.abs(pixels[4 * i + k]! - value)).toBeLessThanOrEqual(1)
  }
})

describe('the rectangle in which pictures differ', () => {
  const [width, height] = [40, 60]
  const picture = (...spots: [number, number][]) => {
    const pixels = new Uint8Array(4 * width * height).fill(100)
    for (const [x, y] of spots) pixels[4 * (y * width + x) + 1] = 200
    return pixels
  }

  test('contains all differences with a margin', () => {
    const rect = changedRect([picture(), picture([15, 20]), picture([20, 40])], width, height)
    expect(rect).toEqual({ left: 12, top: 17, width: 12, height: 27 })
  })

  test('ends at the edges, and covers everything if nothing moves', () => {
    const whole = { left: 0, top: 0, width, height }
    expect(changedRect([picture(), picture([0, 0], [39, 59])], width, height)).toEqual(whole)
    expect(changedRect([picture(), picture()], width, height)).toEqual(whole)
  })
})

test('markup escapes texts and keeps markup', () => {
  const name = `<a href="x">'&`
  expect(html`<p title="${name}">${[html`<b>${name}</b>`, undefined, 7]}</p>`.text).toBe(
    '<p title="&lt;a href=&quot;x&quot;&gt;&#39;&amp;"><b>&lt;a href=&quot;x&quot;&gt;&#39;&amp;</b>7</p>',
  )
})

test('steps go from 0 to their number, with parts of a step in between', () => {
  const progress: [number, number, string | undefined][] = []
  const steps = new Steps((...all) => void progress.push(all as (typeof progress)[number]), 3)
  steps.begin('read')
  steps.begin('draw')
  for (const done of [0, 1, 2]) steps.part(done, 2)
  steps.begin('write')
  expect(progress).toEqual([
    [0, 3, 'read'],
    [1, 3, 'draw'],
    [1, 3, 'draw 1/2'],
    [1.5, 3, 'draw 2/2'],
    [2, 3, 'draw 2/2'],
    [2, 3, 'write'],
  ])
  expect(steps.times().map(({ step }) => step)).toEqual(['read', 'draw', 'write'])
})

import { readdirSync } from 'node:fs'
import type { Region } from './pixels.ts'

/** Pages of all examples. */
export const EXAMPLES = readdirSync(new URL('../../examples/', import.meta.url)).filter((name) =>
  name.endsWith('.html'),
)

/** The forehead of the shipped face in the examples' framing. */
export const FOREHEAD: Region = { left: 0.4, top: 0.14, right: 0.6, bottom: 0.36 }

/** Blendshape weights for normals.html. */
export const CHEEKS_PUFFED = 'cheekPuff=1&mouthPucker=0.7'

/** Examples with one face that is surprised repeatedly. */
export const PORTRAITS = ['minimal.html', 'webgpu.html']

export const BROWS: Region = { left: 0.4, top: 0.1, right: 0.6, bottom: 0.3 }

/** Slider values by name; `true` presses a button or radio button. */
export type Controls = Record<string, number | true>

/**
 * Examples of drivers: query that shows wrinkles, controls that remove them, and the region where they appear. Left is the person's right.
 */
export const DRIVERS: readonly (readonly [page: string, driven: string, atRest: Controls, region: Region])[] =
  [
    ['age.html', '?age=75', { age: 20 }, BROWS],
    ['expressions.html', '?happy=0.7&surprised=0.6', { happy: 0, surprised: 0 }, BROWS],
    ['inputs.html', '?stress=100', { stress: 0 }, BROWS],
    ['joints.html', '?fist=1', { fist: 0 }, { left: 0.4, top: 0.45, right: 0.6, bottom: 0.95 }],
    ['joints.html', '?model=neck&turn=1', { turn: 0 }, { left: 0.5, top: 0.55, right: 0.65, bottom: 0.75 }],
    ['key-frames.html', '?time=2.2', { seconds: 0 }, BROWS],
    ['muscles.html', '?expression=surprise', { neutral: true }, BROWS],
  ]

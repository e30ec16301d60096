// Measures the wrinkles of one head: node measure-identity.mjs head.glb. Prints a `MeasuredIdentity` as JSON.

import { AUTO_DEFAULTS, type AutoOptions, autoWrinkles } from 'furrow/author'
import { measureStrain } from '../../../packages/furrow/src/author/auto/strain/measure-strain.ts'
import { prepareSkin } from '../../../packages/furrow/src/author/auto/surface/prepare-skin.ts'
import { peakMemory } from '../../../test/fuzz/peak-memory.ts'
import { skinAt } from '../../../test/skin-at.ts'
import { countForeheadLines, foreheadMovement } from './forehead.ts'
import { lineSpacing } from './line-spacing.ts'
import { type Age, COMPARED_AGE, type MeasuredIdentity, type Pattern } from './measured.ts'
import { regionOf, skinLines } from './skin-lines.ts'

/** Small maps, to save time. Lines do not depend on the size of the maps. */
const SMALL = { size: 16, areaSize: 16 } satisfies AutoOptions

const [path = ''] = process.argv.slice(2)
const skin = await skinAt(path)
const first = autoWrinkles(skin, { age: COMPARED_AGE })
const { user, system } = process.cpuUsage()
const megabytes = peakMemory() / 1e6
const prepared = prepareSkin(skin)
const { face } = prepared
if (!face) throw new Error(`bench: no face was detected, got ${path}`)
const { seed } = first

function patternAt(
  age: Age,
  options: AutoOptions,
  made = autoWrinkles(skin, { ...SMALL, ...options, age }),
): Pattern {
  const lines = skinLines(skin, face!, made)
  const linesOf = (name: string) => lines.filter(({ region }) => region === name)
  const spacings: Record<string, number> = {}
  for (const { region } of filmsAt(age)) {
    const name = regionOf(region.name)
    const spacing = lineSpacing(linesOf(name), region.spacing)
    if (spacing !== undefined) spacings[name] = spacing / region.spacing
  }
  return {
    foreheadLines: countForeheadLines(linesOf('forehead')),
    spacings,
    lines: lines.map(({ region, length, samples }) => ({
      region,
      length,
      uvs: samples.map(({ uv }) => [rounded(uv[0]), rounded(uv[1])]),
    })),
  }
}

/** Returns the regions whose lines `autoWrinkles` computes from the compression of skin, and the compression in each. */
function filmsAt(age: Age) {
  const settings = { ...AUTO_DEFAULTS, seed, ageFraction: (age - 20) / 60, maxAreas: AUTO_DEFAULTS.areas }
  return measureStrain(prepared, settings).regions.flatMap(({ region, tensors }) =>
    'film' in region ? [{ region, tensors }] : [],
  )
}

function rounded(value: number): number {
  return Math.round(value * 1e5) / 1e5
}

const forehead = filmsAt(COMPARED_AGE).find(({ region }) => regionOf(region.name) === 'forehead')!
const identity: MeasuredIdentity = {
  forehead: foreheadMovement(face, forehead.region.film, forehead.tensors),
  byAge: { 30: patternAt(30, {}), 50: patternAt(50, {}, first), 70: patternAt(70, {}) },
  reseeded: patternAt(COMPARED_AGE, { seed: seed ^ 1 }),
  seconds: (user + system) / 1e6,
  megabytes,
}
process.stdout.write(JSON.stringify(identity))

import type { Skin } from 'furrow/author'
import { LINE_REGIONS } from 'furrow/internal'
import { placedFace } from '../../../packages/furrow/src/author/auto/surface/detect-face.ts'
import { mean, median } from '../../statistics.ts'
import { compareRegion, compareSides } from './compare-patterns.ts'
import { AGES, COMPARED_AGE, type MeasuredIdentity, type Pattern } from './measured.ts'
import { SkinCharts } from './skin-charts.ts'
import { regionOf } from './skin-lines.ts'

const REGIONS = [...new Set(LINE_REGIONS.map(regionOf))]
/** Regions in which anatomy determines the positions of lines. All people have these lines in similar positions. */
const ANCHORED: readonly string[] = ['glabella', 'nose', 'nasolabial', 'mouthCorner']
/** Maxima of k: between people, between seeds, and between sides. */
const MAXIMA = { anchored: [0.75, 0.75, 0.75], others: [0.4, 0.4, 0.6] } as const
/** Number of other people with whom each person is compared. */
const OTHERS = 3

/**
 * Returns Markdown tables about the wrinkles of several people.
 *
 * @param reference skin on which patterns are compared. Its layout of texture coordinates is that of all the people.
 */
export function identityTables(people: readonly MeasuredIdentity[], reference: Skin): string[] {
  const charts = new SkinCharts(reference, placedFace(reference)!.scale)
  const ages = AGES.join(', ')
  const heads = {
    ages: ['', 'target', ...AGES.map((age) => `${age}`)],
    faces: ['', 'target', 'value'],
    regions: ['region', 'k of people', 'seeds', 'sides', `lines at ${ages}`, `length at ${ages}`],
  }
  return [
    ...table(heads.faces, faceRows(people)),
    '',
    ...table(heads.ages, ageRows(people)),
    '',
    ...table(
      heads.regions,
      REGIONS.map((region) => regionRow(charts, region, people)),
    ),
  ]
}

function faceRows(people: readonly MeasuredIdentity[]): string[][] {
  const row = (
    name: string,
    target: string,
    digits: number,
    measure: (person: MeasuredIdentity) => number,
  ) => [name, target, span(people.map(measure), digits)]
  return [
    row('forehead converges at, %', '61 ± 10', 0, ({ forehead }) => 100 * forehead.convergence),
    row('forehead shortens by, mm', '8 to 13', 1, ({ forehead }) => forehead.shortening),
    row('film of the forehead shortens by, mm', '8 to 13', 1, ({ forehead }) => forehead.filmShortening),
    row('CPU time, s', 'at most 8', 1, ({ seconds }) => seconds),
    row('peak memory, MB', '', 0, ({ megabytes }) => megabytes),
  ]
}

function ageRows(people: readonly MeasuredIdentity[]): string[][] {
  const atAges = (measure: (pattern: Pattern) => number | undefined, digits: number) =>
    AGES.map((age) =>
      span(
        people.map(({ byAge }) => measure(byAge[age])),
        digits,
      ),
    )
  const folding = new Set(
    people.flatMap(({ byAge }) => AGES.flatMap((age) => Object.keys(byAge[age].spacings))),
  )
  return [
    ['forehead lines', '4', ...atAges(({ foreheadLines }) => foreheadLines, 0)],
    ...REGIONS.filter((region) => folding.has(region)).map((region) => [
      `spacing / wavelength, \`${region}\``,
      '0.85 to 1.15',
      ...atAges(({ spacings }) => spacings[region], 2),
    ]),
  ]
}

function regionRow(charts: SkinCharts, region: string, people: readonly MeasuredIdentity[]): string[] {
  const patterns = people.map(({ byAge }) => byAge[COMPARED_AGE].lines)
  const compare = (i: number, others: Pattern['lines']) => compareRegion(charts, region, patterns[i]!, others)
  const distances = Array.from({ length: Math.min(OTHERS, people.length - 1) }, (_, i) => i + 1)
  const ofPeople = patterns.flatMap((_, i) =>
    distances.map((distance) => compare(i, patterns[(i + distance) % patterns.length]!)),
  )
  const ofSeeds = people.map(({ reseeded }, i) => compare(i, reseeded.lines))
  const ofSides = patterns.map((lines) => compareSides(charts, region, lines))
  const atAges = (measure: (lengths: readonly number[]) => number, digits: number) =>
    AGES.map((age) =>
      mean(
        people.map(({ byAge }) =>
          measure(byAge[age].lines.filter((line) => line.region === region).map(({ length }) => length)),
        ),
      ).toFixed(digits),
    ).join(', ')
  const maxima = ANCHORED.includes(region) ? MAXIMA.anchored : MAXIMA.others
  return [
    `\`${region}\``,
    ...[ofPeople, ofSeeds, ofSides].map((values, i) => {
      const value = mean(known(values))
      return value > maxima[i]! ? `**${fixed(value, 2)}**` : fixed(value, 2)
    }),
    atAges((lengths) => lengths.length, 1),
    atAges((lengths) => lengths.reduce((sum, length) => sum + length, 0), 0),
  ]
}

/** Formats the median and the range of the middle four fifths. */
function span(values: readonly (number | undefined)[], digits: number): string {
  const sorted = known(values).sort((a, b) => a - b)
  const at = (fraction: number) => sorted[Math.round(fraction * (sorted.length - 1))]!
  if (sorted.length === 0) return ''
  return `${fixed(median(sorted), digits)} (${fixed(at(0.1), digits)} to ${fixed(at(0.9), digits)})`
}

function known(values: readonly (number | undefined)[]): number[] {
  return values.filter((value) => value !== undefined)
}

/** Formats a number. Returns an empty string for NaN, which is the mean of an empty list. */
function fixed(value: number, digits: number): string {
  return Number.isNaN(value) ? '' : value.toFixed(digits)
}

function table(head: readonly string[], rows: readonly (readonly string[])[]): string[] {
  return [head, head.map(() => '---'), ...rows].map((row) => `| ${row.join(' | ')} |`)
}

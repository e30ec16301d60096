import type { FaceTrackerOptions } from 'furrow/three'
import { type Calibrated, combine, measurePerson, type Results } from './measure.ts'

/** Number of persons in each group. */
const PERSONS = 40

/** Numbers of the first person in each group. Defaults may be tuned on the first group only. */
const FIRST = { tuned: 1, tested: 1001 } as const

/** Targets, with the label of their row. */
export const TARGETS: readonly [name: keyof Results, label: string, target: string, digits: number][] = [
  ['sneer', 'sneer where the truth is 1', 'at least 0.5', 2],
  ['neutral', 'highest weight of a neutral face', 'at most 0.02', 2],
  ['jitter', 'change per frame of a held smile', 'at most 0.03', 3],
  ['step', 'a step reaches 90% after', 'at most 100 ms', 0],
  ['ramp', 'lag of a ramp of one second', 'at most 33 ms', 0],
  ['sine', 'kept part of a sine of 1 Hz and 0.1', 'at least 0.8', 2],
  ['speech', 'highest sneer in speech', '', 2],
]

const COLUMNS: readonly [label: string, calibrated: Calibrated, options: FaceTrackerOptions, fps: number][] =
  [
    ['raw scores', 'nothing', { filter: null }, 30],
    ['neutral', 'neutral', {}, 30],
    ['neutral and range', 'neutral and range', {}, 30],
    ['the same, 24 Hz', 'neutral and range', {}, 24],
    ['the same, 60 Hz', 'neutral and range', {}, 60],
  ]

/** Measures all columns, and formats them as a Markdown table. */
export function trackerTable(group: keyof typeof FIRST): string[] {
  const results = COLUMNS.map(([, calibrated, options, fps]) =>
    combine(
      Array.from({ length: PERSONS }, (_, i) => measurePerson(FIRST[group] + i, calibrated, options, fps)),
    ),
  )
  const rows = TARGETS.map(([name, label, target, digits]) => {
    const unit = target.endsWith(' ms') ? ' ms' : ''
    return [label, target, ...results.map((result) => result[name].toFixed(digits) + unit)]
  })
  const head = ['', 'target', ...COLUMNS.map(([label]) => label)]
  return [head, head.map(() => '---'), ...rows].map((cells) =>
    `| ${cells.join(' | ')} |`.replace('|  |', '| |'),
  )
}

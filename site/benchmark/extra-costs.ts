import type { Result } from '../../bench/report.ts'

/** Frame time that moving wrinkles add on one renderer, as bars of a chart. */
export interface ExtraCosts {
  renderer: string
  adapter: string
  plainMs: number
  bars: Bar[]
}

export interface Bar {
  name: string
  /** Added frame time, as a fraction of the frame time without wrinkles. */
  extra: number
  /** Length of the bar relative to the longest bar of all renderers, 0..1. */
  length: number
}

const TITLES = { webgl: 'WebGL 2', webgpu: 'WebGPU' }
const MAPS = { normals: '', all: ', all maps', onset: ', all maps and onset' }

/** Computes the bars of each measured renderer, in the order of the results. */
export function extraCosts(results: readonly Result[]): ExtraCosts[] {
  const moving = results.filter(({ still }) => !still)
  const longest = Math.max(...moving.map(({ ratioToPlain }) => ratioToPlain - 1))
  return [...new Set(moving.map(({ renderer }) => renderer))].map((renderer) => {
    const own = moving.filter((result) => result.renderer === renderer)
    const { adapter, medianMs: plainMs } = own.find(({ variant }) => variant === 'plain')!
    const bars = own
      .filter(({ variant }) => variant !== 'plain')
      .map(({ variant, maps, ratioToPlain }) => {
        const extra = ratioToPlain - 1
        // Measurement noise can make a face with wrinkles slightly faster than without.
        return { name: variant + MAPS[maps], extra, length: Math.max(0, extra) / longest }
      })
    return { renderer: TITLES[renderer], adapter, plainMs, bars }
  })
}

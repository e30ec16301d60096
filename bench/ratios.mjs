// How much more than the plain face Furrow's modes cost, in the few cases that a change is watched by: `npm run ratios`.

import { readFileSync, writeFileSync } from 'node:fs'
import { chromiumHost } from './hosts.mjs'
import { serve } from './serve.mjs'

const FIGURES = new URL('ratios.json', import.meta.url)

/** What a ratio to the plain face may grow by before anybody is told. */
const ALLOWED = 0.05

const SIZE = { width: 800, height: 600 }
const PLAN = { rounds: 4, variants: ['plain', 'furrow', 'composed', 'auto'] }

/** Ratios to the plain face by renderer, variant and whether areas move, of the same cases as the quick benchmark's. */
export async function measureRatios() {
  const server = await serve()
  try {
    const { listCases, RENDERER_KINDS } = await server.ssrLoadModule('/bench/case.ts')
    const { toResults } = await server.ssrLoadModule('/bench/report.ts')
    const host = await chromiumHost(server)
    const face = new URL('/faces/human.glb', server.resolvedUrls.local[0]).href
    const ratios = {}
    for (const renderer of RENDERER_KINDS) {
      const page = await host.open()
      const setup = { ...SIZE, renderer, ...(await page.open(renderer, SIZE.width, SIZE.height, face)) }
      for (const benchCase of listCases(true)) {
        for (const result of toResults(benchCase, setup, await page.measure(benchCase, PLAN))) {
          const maps = benchCase.maps === 'all' ? ', all maps' : ''
          const name = `${renderer}, ${result.variant}, ${benchCase.still ? 'still' : 'moving'}${maps}`
          if (result.variant !== 'plain') ratios[name] = Number(result.ratioToPlain.toFixed(3))
        }
      }
      await page.close()
    }
    await host.close()
    return ratios
  } finally {
    await server.close()
  }
}

/** The repository's figures. */
export function readFigures() {
  return JSON.parse(readFileSync(FIGURES, 'utf8'))
}

/** Makes what is measured now the figures. */
export function writeFigures(ratios) {
  writeFileSync(FIGURES, `${JSON.stringify(ratios, null, 2)}\n`)
}

/** One line about each that has grown by more than is allowed; what has no figure is new, and has not grown. */
export function warnings(ratios, figures) {
  return Object.entries(ratios)
    .filter(([name, ratio]) => ratio > figures[name] + ALLOWED)
    .map(([name, ratio]) => {
      const change = `from ${figures[name].toFixed(2)} to ${ratio.toFixed(2)} of the plain face`
      return `frame: ${name} has grown ${change}; measure again on an idle machine, and if it must, run \`npm run ratios -- --write\``
    })
}

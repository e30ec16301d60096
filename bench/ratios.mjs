// Measures the frame times of Furrow's modes relative to the plain face, in the few cases of `npm run ratios`.

import { readFileSync, writeFileSync } from 'node:fs'
import { chromiumHost } from './hosts.mjs'
import { serve } from './serve.mjs'

const FIGURES = new URL('ratios.json', import.meta.url)

/** Growth of a ratio without a warning. */
const ALLOWED = 0.05

const SIZE = { width: 400, height: 300 }
const ROUNDS = 2

/** Lists the variants to measure in a case. Still faces are skipped: the default mode costs the same as moving. */
function variantsOf({ still, maps }) {
  if (still) return []
  return maps === 'all' ? ['furrow'] : ['furrow', 'composed']
}

/** Measures the ratios to the plain face with wanted names. */
async function measureRatios(isWanted) {
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
        const variants = variantsOf(benchCase)
        const nameOf = (variant) => nameRatio(renderer, variant, benchCase)
        if (!variants.some((variant) => isWanted(nameOf(variant)))) continue
        const measured = await page.measure(benchCase, { rounds: ROUNDS, variants: ['plain', ...variants] })
        for (const { variant, ratioToPlain } of toResults(benchCase, setup, measured)) {
          if (variant !== 'plain') ratios[nameOf(variant)] = Number(ratioToPlain.toFixed(3))
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

function nameRatio(renderer, variant, { still, maps }) {
  return `${renderer}, ${variant}, ${still ? 'still' : 'moving'}${maps === 'all' ? ', all maps' : ''}`
}

/** Measures ratios, and repeats those above their figures: other processes may slow down single variants. */
export async function measureTwice(figures) {
  const first = await measureRatios(() => true)
  const suspect = grownNames(first, figures)
  if (suspect.length === 0) return first
  const second = await measureRatios((name) => suspect.includes(name))
  return Object.fromEntries(
    Object.entries(first).map(([name, ratio]) => [name, Math.min(ratio, second[name] ?? ratio)]),
  )
}

/** Reads the repository's figures. */
export function readFigures() {
  return JSON.parse(readFileSync(FIGURES, 'utf8'))
}

/** Stores ratios as the repository's figures. */
export function writeFigures(ratios) {
  writeFileSync(FIGURES, `${JSON.stringify(ratios, null, 2)}\n`)
}

/** Returns one warning per ratio that has grown. */
export function warnings(ratios, figures) {
  return grownNames(ratios, figures).map((name) => {
    const change = `from ${figures[name].toFixed(2)} to ${ratios[name].toFixed(2)} of the plain face`
    return `frame: ${name} has grown ${change}; measure again on an idle machine, and if intended, run \`npm run ratios -- --write\``
  })
}

/** Lists the ratios that have grown. Ratios without a figure are new. */
function grownNames(ratios, figures) {
  return Object.keys(ratios).filter((name) => ratios[name] > figures[name] + ALLOWED)
}

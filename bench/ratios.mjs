// Measures ratios for `npm run ratios`: the frame time of a Furrow mode divided by the frame time of the face without wrinkles.

import { readFileSync, writeFileSync } from 'node:fs'
import { chromiumHost } from './hosts.mjs'
import { serve } from './serve.mjs'

const FIGURES = new URL('ratios.json', import.meta.url)

/** A ratio may exceed its stored figure by this much without a warning. */
const ALLOWED = 0.05

const SIZE = { width: 400, height: 300 }
const ROUNDS = 2

/** Lists the variants to measure in a case. Still faces are skipped, because the default mode costs the same for still and moving faces. */
function variantsOf({ still, maps }) {
  if (still) return []
  return maps === 'normals' ? ['furrow', 'composed'] : ['furrow']
}

/** Measures the ratios whose names `isWanted` accepts. Returns them by name. */
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

const MAPS = { normals: '', all: ', all maps', onset: ', all maps and onset' }

function nameRatio(renderer, variant, { still, maps }) {
  return `${renderer}, ${variant}, ${still ? 'still' : 'moving'}${MAPS[maps]}`
}

/**
 * Measures all ratios, and repeats the measurement of ratios that exceed their stored figures. Keeps the smaller of both values, because other processes
 * may have slowed down the first measurement.
 */
export async function measureTwice(figures) {
  const first = await measureRatios(() => true)
  const suspect = grownNames(first, figures)
  if (suspect.length === 0) return first
  const second = await measureRatios((name) => suspect.includes(name))
  return Object.fromEntries(
    Object.entries(first).map(([name, ratio]) => [name, Math.min(ratio, second[name] ?? ratio)]),
  )
}

export function readFigures() {
  return JSON.parse(readFileSync(FIGURES, 'utf8'))
}

export function writeFigures(ratios) {
  writeFileSync(FIGURES, `${JSON.stringify(ratios, null, 2)}\n`)
}

/** Returns a warning for each ratio that exceeds its stored figure by more than `ALLOWED`. */
export function warnings(ratios, figures) {
  return grownNames(ratios, figures).map((name) => {
    const change = `from ${figures[name].toFixed(2)} to ${ratios[name].toFixed(2)} times the frame time of the plain face`
    return `frame: ${name} has grown ${change}; measure again on an idle machine. If the growth is intended, run \`npm run ratios -- --write\``
  })
}

/** Lists the names of ratios that have grown by more than `ALLOWED`. Ratios without a stored figure are not listed. */
function grownNames(ratios, figures) {
  return Object.keys(ratios).filter((name) => ratios[name] > figures[name] + ALLOWED)
}

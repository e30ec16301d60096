// How much more than the plain face Furrow's modes cost, in the few cases that a change is watched by: `npm run ratios`.

import { readFileSync, writeFileSync } from 'node:fs'
import { chromiumHost } from './hosts.mjs'
import { serve } from './serve.mjs'

const FIGURES = new URL('ratios.json', import.meta.url)

/** What a ratio to the plain face may grow by before anybody is told. */
const ALLOWED = 0.05

const SIZE = { width: 400, height: 300 }
const ROUNDS = 2

/** The variants that are watched in a case of the quick benchmark. The default mode costs the same for a face that holds still. */
function variantsIn({ still, maps }) {
  if (still) return []
  return maps === 'all' ? ['furrow'] : ['furrow', 'composed']
}

/** Ratios to the plain face by renderer, variant and whether areas move, of cases with a name that is wanted. */
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
        const variants = variantsIn(benchCase)
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

/** Ratios, of which those that seem to have grown are measured twice: other work of the machine slows one variant and not the next. */
export async function measureTwice(figures) {
  const once = await measureRatios(() => true)
  const suspect = grownNames(once, figures)
  if (suspect.length === 0) return once
  const again = await measureRatios((name) => suspect.includes(name))
  return Object.fromEntries(
    Object.entries(once).map(([name, ratio]) => [name, Math.min(ratio, again[name] ?? ratio)]),
  )
}

/** The repository's figures. */
export function readFigures() {
  return JSON.parse(readFileSync(FIGURES, 'utf8'))
}

/** Makes what is measured now the figures. */
export function writeFigures(ratios) {
  writeFileSync(FIGURES, `${JSON.stringify(ratios, null, 2)}\n`)
}

/** One line about each that has grown by more than is allowed. */
export function warnings(ratios, figures) {
  return grownNames(ratios, figures).map((name) => {
    const change = `from ${figures[name].toFixed(2)} to ${ratios[name].toFixed(2)} of the plain face`
    return `frame: ${name} has grown ${change}; measure again on an idle machine, and if it must, run \`npm run ratios -- --write\``
  })
}

/** What has no figure is new, and has not grown. */
function grownNames(ratios, figures) {
  return Object.keys(ratios).filter((name) => ratios[name] > figures[name] + ALLOWED)
}

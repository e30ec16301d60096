// `node bench/load/run.mjs [--rounds 9] [--renderer webgl] [--json FILE] [--pictures FOLDER]`: measures the time from a file's bytes to the
// first frame with the face, with and without wrinkles.

import { copyFileSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { cpus, tmpdir } from 'node:os'
import { join } from 'node:path'
import { parseArgs } from 'node:util'
import { build, preview } from 'vite'
import { SOURCES } from '../../scripts/lib/sources.mjs'
import { ROOT, runServed, serve } from '../serve.mjs'

const { values: options } = parseArgs({
  options: {
    rounds: { type: 'string', default: '9' },
    renderer: { type: 'string', multiple: true, default: ['webgl', 'webgpu'] },
    json: { type: 'string' },
    pictures: { type: 'string' },
  },
})
const rounds = Number(options.rounds)
const VARIANTS = ['plain', 'furrow']

const server = await serve()
await runServed(server, run)

async function run() {
  const { median, roundOrder } = await server.ssrLoadModule('/bench/statistics.ts')
  const { launchBrowser, newPage } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
  const folder = mkdtempSync(join(tmpdir(), 'furrow-load-'))
  const site = await serveBuilt(folder)
  const browser = await launchBrowser()
  const rows = []
  try {
    const first = async (renderer, variant, picture) => {
      // A new page compiles its shaders again.
      const page = await newPage(browser)
      await page.setViewportSize({ width: 800, height: 600 })
      await page.goto(new URL('/bench/load/page.html', site.resolvedUrls.local[0]).href)
      await page.waitForFunction(() => 'firstFrame' in window)
      const times = await page.evaluate(([a, b]) => window.firstFrame(a, b), [renderer, variant])
      if (picture) await page.screenshot({ path: picture })
      await page.close()
      return times
    }
    for (const renderer of options.renderer) {
      const times = []
      // The first round is not counted, because it also starts the browser's GPU process.
      for (let i = 0; i <= rounds; i++) {
        const round = {}
        for (const k of roundOrder(VARIANTS.length, i)) {
          const variant = VARIANTS[k]
          const hasPicture = i === 0 && options.pictures
          const picture = hasPicture && join(options.pictures, `${renderer}-${variant}.png`)
          round[variant] = await first(renderer, variant, picture)
        }
        if (i > 0) times.push(round)
      }
      for (const name of ['parsed', 'drawn', 'longest']) {
        rows.push({
          renderer,
          name,
          plain: median(times.map(({ plain }) => plain[name])),
          furrow: median(times.map(({ furrow }) => furrow[name])),
          added: median(times.map(({ plain, furrow }) => furrow[name] - plain[name])),
        })
      }
    }
  } finally {
    await browser.close()
    await new Promise((resolve) => site.httpServer.close(resolve))
    rmSync(folder, { recursive: true })
  }
  process.stdout.write(
    `${cpus()[0].model}, ${cpus().length} cores, medians of ${rounds} rounds, in milliseconds\n`,
  )
  const columns = [...VARIANTS, 'added']
  process.stdout.write(line(['', '', ...columns]))
  for (const row of rows) {
    process.stdout.write(line([row.renderer, row.name, ...columns.map((name) => row[name].toFixed(0))]))
  }
  if (options.json) writeFileSync(options.json, `${JSON.stringify(rows, null, 2)}\n`)
}

async function serveBuilt(outDir) {
  await build({
    root: ROOT,
    configFile: false,
    logLevel: 'silent',
    resolve: SOURCES.resolve,
    build: { outDir, emptyOutDir: true, rolldownOptions: { input: join(ROOT, 'bench/load/page.html') } },
  })
  copyFileSync(join(ROOT, 'faces/human.glb'), join(outDir, 'human.glb'))
  return preview({
    root: ROOT,
    configFile: false,
    logLevel: 'silent',
    build: { outDir },
    preview: { host: '127.0.0.1', port: 0 },
  })
}

function line(cells) {
  return `${cells.map((cell) => cell.padStart(10)).join('')}\n`
}

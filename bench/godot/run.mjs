// `npm run bench:godot [-- --size 400x300 --rounds 3 --frames 8]`: measures the frame time of one face and of 50 faces in Godot's web engine,
// with and without wrinkles.

import { parseArgs } from 'node:util'
import { serveGodot } from '../../scripts/lib/godot.mjs'
import { parseRounds, parseSize } from '../options.mjs'
import { launchTimed, openPage, runServed, serve } from '../serve.mjs'

const CROWD = 50

/** Variants in the order of each round. `plain` with moving blendshapes is the divisor of `moving`. */
const VARIANTS = {
  'plain, moving': { wrinkled: false, moving: true },
  'furrow, moving': { wrinkled: true, moving: true },
  'plain, still': { wrinkled: false, moving: false },
  'furrow, still': { wrinkled: true, moving: false },
}

const { values: options } = parseArgs({
  options: {
    size: { type: 'string', default: '400x300' },
    rounds: { type: 'string', default: '3' },
    frames: { type: 'string', default: '8' },
  },
})

const server = await serve([serveGodot()])
await runServed(server, async () => {
  const { width, height } = parseSize(options.size)
  const rounds = parseRounds(options.rounds)
  const { median, ratio } = await server.ssrLoadModule('/bench/statistics.ts')
  const browser = await launchTimed(server)
  try {
    const page = await openPage(server, browser, '/bench/godot/page.html', 'callGodot')
    page.on('console', (message) => message.type() === 'error' && process.stderr.write(`${message.text()}\n`))
    for (const copies of [1, CROWD]) {
      await page.evaluate((args) => window.openFaces(...args), [copies, '/faces/human.glb', copies])
      const call = (method, args) =>
        page.evaluate((words) => window.callGodot(...words), [method, { id: copies, ...args }])
      await call('prepare_timing', { width, height })
      const times = Object.fromEntries(Object.keys(VARIANTS).map((name) => [name, []]))
      for (let round = 0; round < rounds; round++) {
        for (const [name, variant] of Object.entries(VARIANTS)) {
          times[name].push(await call('time_frames', { ...variant, frames: Number(options.frames) }))
        }
      }
      const phases = await call('time_phases', { frames: 40 })
      await call('close', {})
      process.stdout.write(
        `${copies}: drivers and influence take ${phases.toFixed(2)} ms of the CPU per frame\n`,
      )
      for (const motion of ['moving', 'still']) {
        const [plain, furrow] = [times[`plain, ${motion}`], times[`furrow, ${motion}`]]
        const [plainTime, furrowTime] = [plain, furrow].map((all) => `${median(all).toFixed(1)} ms`)
        process.stdout.write(
          `${copies} ${motion}: plain ${plainTime}, furrow ${furrowTime}, ratio ${ratio(furrow, plain).toFixed(3)}\n`,
        )
      }
    }
  } finally {
    await browser.close()
  }
})

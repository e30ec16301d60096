// `npm run bench:godot:picture`: renders the picture of godot/README.md. It shows `faces/human.glb` in three.js, Babylon.js and Godot, in the
// same pose, under the same camera and lamps.

import { mkdtemp, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { serveGodot } from '../../scripts/lib/godot.mjs'
import { composeRow, differenceOf } from '../cycles/compose.mjs'
import { openPage, ROOT, runServed, serve } from '../serve.mjs'

const FACE = '/faces/human.glb'

const server = await serve([serveGodot()])
await runServed(server, async () => {
  const folder = await mkdtemp(join(tmpdir(), 'furrow-godot-'))
  const files = ['three', 'babylon', 'godot'].map((name) => join(folder, `${name}.png`))
  try {
    const { launchBrowser } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
    const { LAMPS, SIZE, AMBIENT, ENGINES_SHOT } = await server.ssrLoadModule('/bench/cycles/shots.ts')
    const write = (file, base64) => writeFile(file, Buffer.from(base64, 'base64'))
    const browser = await launchBrowser()
    try {
      const three = await openPage(server, browser, '/bench/cycles/page.html?webgl', 'pose')
      const { camera, activations } = await three.evaluate(
        (args) => globalThis.pose(...args),
        [FACE, ENGINES_SHOT],
      )
      await write(files[0], (await three.evaluate(() => globalThis.draw('default'))).split(',')[1])
      await three.close()
      const babylon = await openPage(server, browser, '/bench/cycles/babylon.html?webgl', 'drawWithBabylon')
      const drawn = await babylon.evaluate(
        (args) => globalThis.drawWithBabylon(...args),
        [FACE, ENGINES_SHOT, camera],
      )
      await write(files[1], drawn.url.split(',')[1])
      await babylon.close()
      const godot = await openPage(server, browser, '/bench/godot/page.html', 'callGodot')
      await godot.evaluate((args) => window.openFaces(...args), [1, FACE, 1])
      const args = { id: 1, shot: ENGINES_SHOT, size: SIZE, camera, lamps: LAMPS, ambient: AMBIENT }
      const shown = await godot.evaluate((words) => window.callGodot(...words), ['draw_shot', args])
      await write(files[2], shown.png)
      console.info(`Babylon.js: ${differenceOf(drawn.activations, activations)}`)
      console.info(`Godot: ${differenceOf(shown.activations, activations)}`)
    } finally {
      await browser.close()
    }
    await composeRow(files, SIZE, 480, join(ROOT, 'docs/figures/godot.jpg'))
  } finally {
    await rm(folder, { recursive: true, force: true })
  }
})

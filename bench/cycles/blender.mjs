// `npm run cycles:blender`: renders the pictures of docs/blender.md and docs/conformance.md. They show `faces/human.glb` in three.js and Babylon.js,
// each on WebGL and WebGPU, and in Cycles, imported by the Blender extension. `npm run test:blender` installs Blender.

import { execFile } from 'node:child_process'
import { existsSync } from 'node:fs'
import { mkdtemp, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { openPage, ROOT, runServed, serve } from '../serve.mjs'
import { composeRow, differenceOf } from './compose.mjs'

const PYTHON = join(ROOT, 'blender/.venv-4.5/bin/python')
const LAMP_ANGLE = 4
const SAMPLES = 48
/** Width of each picture in pixels, in a row of two pictures. */
const WIDTH = 560
/** Width of each picture in pixels, in a row of five pictures. */
const WIDTH_OF_FIVE = 400

const server = await serve()
await runServed(server, async () => {
  if (!existsSync(PYTHON))
    throw new Error('cycles:blender: Blender is missing; run `npm run test:blender` first')
  const folder = await mkdtemp(join(tmpdir(), 'furrow-blender-'))
  const file = (name) => join(folder, name)
  try {
    const { launchBrowser } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
    const { LAMPS, SIZE, AMBIENT, ENGINES_SHOT } = await server.ssrLoadModule('/bench/cycles/shots.ts')
    const write = (name, url) => writeFile(file(`${name}.png`), Buffer.from(url.split(',')[1], 'base64'))
    const browser = await launchBrowser()
    let description
    try {
      for (const [name, search] of Object.entries({
        three: '',
        'three-webgl': '?webgl',
        'three-webgpu': '?webgpu',
      })) {
        const page = await openPage(server, browser, `/bench/cycles/page.html${search}`, 'pose')
        description = await page.evaluate((shot) => globalThis.pose('/faces/human.glb', shot), ENGINES_SHOT)
        await write(name, await page.evaluate(() => globalThis.draw('default')))
        await page.close()
      }
      for (const backend of ['webgl', 'webgpu']) {
        const page = await openPage(
          server,
          browser,
          `/bench/cycles/babylon.html?${backend}`,
          'drawWithBabylon',
        )
        const { url, activations } = await page.evaluate(
          ([shot, camera]) => globalThis.drawWithBabylon('/faces/human.glb', shot, camera),
          [ENGINES_SHOT, description.camera],
        )
        await write(`babylon-${backend}`, url)
        await page.close()
        console.info(`Babylon.js on ${backend}: ${differenceOf(activations, description.activations)}`)
      }
    } finally {
      await browser.close()
    }
    const { camera, activations } = description
    const face = join(ROOT, 'faces/human.glb')
    const scene = {
      face,
      targets: ENGINES_SHOT.targets,
      camera,
      activations,
      lamps: LAMPS,
      lampAngle: LAMP_ANGLE,
      ambient: AMBIENT,
    }
    await writeFile(file('scene.json'), JSON.stringify({ ...scene, samples: SAMPLES, size: SIZE }))
    const { stdout } = await promisify(execFile)(PYTHON, [
      join(ROOT, 'bench/cycles/blender.py'),
      file('scene.json'),
      folder,
    ])
    console.info(
      stdout
        .split('\n')
        .filter((line) => line.startsWith('furrow:'))
        .join('\n'),
    )
    const pictures = (...names) => names.map((name) => file(`${name}.png`))
    const figure = (name) => join(ROOT, `docs/figures/${name}.jpg`)
    await composeRow(pictures('three', 'blender'), SIZE, WIDTH, figure('blender'))
    const five = pictures('three-webgl', 'three-webgpu', 'babylon-webgl', 'babylon-webgpu', 'blender')
    await composeRow(five, SIZE, WIDTH_OF_FIVE, figure('engines'))
  } finally {
    await rm(folder, { recursive: true, force: true })
  }
})

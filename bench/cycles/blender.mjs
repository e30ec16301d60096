// The picture of docs/blender.md: the shipped face by three.js with Furrow, and by Cycles with the nodes and drivers that the extension
// for Blender imports: `npm run cycles:blender`, after `npm run test:blender` has installed Blender.

import { execFile } from 'node:child_process'
import { existsSync } from 'node:fs'
import { mkdtemp, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { promisify } from 'node:util'
import sharp from 'sharp'
import { openPage, ROOT, runServed, serve } from '../serve.mjs'

const PYTHON = join(ROOT, 'blender/.venv-4.5/bin/python')
const BACKGROUND = { r: 40, g: 40, b: 40 }
/** Degrees that a lamp spans. */
const LAMP_ANGLE = 4
const SAMPLES = 48
const GAP = 8
/** Width of one picture of the four. */
const WIDTH = 560
/** The forehead, as fractions of a picture's side. */
const CROP = { left: 0.22, top: 0.2, width: 0.5, height: 0.26 }

const SHOT = {
  name: 'blender',
  face: 'human',
  age: 45,
  targets: {
    browInnerUp: 1,
    browOuterUpLeft: 1,
    browOuterUpRight: 1,
    mouthSmileLeft: 0.7,
    mouthSmileRight: 0.7,
  },
  view: { yaw: 10, pitch: 4, zoom: 1.5 },
  relief: 'off',
}

const server = await serve()
await runServed(server, async () => {
  if (!existsSync(PYTHON))
    throw new Error('cycles:blender: Blender is missing; run `npm run test:blender` first')
  const folder = await mkdtemp(join(tmpdir(), 'furrow-blender-'))
  const file = (name) => join(folder, name)
  try {
    const { launchBrowser } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
    const { LAMPS, SIZE, SURROUNDINGS } = await server.ssrLoadModule('/bench/cycles/shots.ts')
    const browser = await launchBrowser()
    let description
    try {
      const page = await openPage(server, browser, '/bench/cycles/page.html', 'pose')
      description = await page.evaluate((shot) => globalThis.pose('/faces/human.glb', shot), SHOT)
      const url = await page.evaluate(() => globalThis.draw('default'))
      await writeFile(file('three.png'), Buffer.from(url.split(',')[1], 'base64'))
    } finally {
      await browser.close()
    }
    const { camera, activations } = description
    const face = join(ROOT, 'faces/human.glb')
    const scene = {
      face,
      targets: SHOT.targets,
      camera,
      activations,
      lamps: LAMPS,
      lampAngle: LAMP_ANGLE,
      surroundings: SURROUNDINGS,
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
    const pictures = ['three', 'blender'].map((name) => file(`${name}.png`))
    await compose(pictures, SIZE, join(ROOT, 'docs/figures/blender.jpg'))
  } finally {
    await rm(folder, { recursive: true, force: true })
  }
})

/** From left to right three.js and Blender; below their foreheads. */
async function compose(pictures, side, path) {
  const part = Object.fromEntries(
    Object.entries(CROP).map(([name, value]) => [name, Math.round(value * side)]),
  )
  const cropHeight = Math.round((WIDTH * part.height) / part.width)
  const layers = await Promise.all(
    pictures.flatMap((picture, i) => {
      const left = i * (WIDTH + GAP)
      const flat = () => sharp(picture).flatten({ background: BACKGROUND })
      const whole = flat().resize(WIDTH, WIDTH).png().toBuffer()
      const crop = flat().extract(part).resize(WIDTH, cropHeight).png().toBuffer()
      return [
        whole.then((input) => ({ input, left, top: 0 })),
        crop.then((input) => ({ input, left, top: WIDTH + GAP })),
      ]
    }),
  )
  const size = { width: 2 * WIDTH + GAP, height: WIDTH + GAP + cropHeight }
  await sharp({ create: { ...size, channels: 3, background: '#fff' } })
    .composite(layers)
    .jpeg({ quality: 85 })
    .toFile(path)
}

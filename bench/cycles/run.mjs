// `npm run cycles`: renders faces with Furrow and Blender's Cycles under the same lights, and compares them. See README.md.

import { execFile, spawn } from 'node:child_process'
import { existsSync } from 'node:fs'
import { mkdir, rm, writeFile } from 'node:fs/promises'
import { join } from 'node:path'
import { parseArgs, promisify } from 'node:util'
import sharp from 'sharp'
import { openPage, ROOT, runServed, serve } from '../serve.mjs'

const HERE = join(ROOT, 'bench/cycles')
const FACES = { human: join(ROOT, 'faces/human.glb'), scan: join(ROOT, '../shared/real-face/ict-face.glb') }

/** Python packages: Blender as a module, Pillow for image files, and FLIP. They take 1.2 GB. */
const PACKAGES = ['bpy==4.5.15', 'pillow==12.0.0', 'flip-evaluator==1.7']

/** Angular diameter of each light in degrees. Larger values make shadows softer. */
const LAMP_ANGLE = 4
const GAP = 8
const BACKGROUND = { r: 40, g: 40, b: 40 }

const { values: options } = parseArgs({
  options: {
    only: { type: 'string', multiple: true },
    samples: { type: 'string', default: '64' },
    python: { type: 'string' },
    output: { type: 'string', default: join(ROOT, 'docs/figures/cycles') },
  },
})
const CACHE = join(ROOT, 'node_modules/.cache/furrow-cycles')
const run = promisify(execFile)
const server = await serve()
await runServed(server, main)

async function main() {
  const { launchBrowser } = await server.ssrLoadModule('/packages/cli/src/browser.ts')
  const { SHOTS } = await server.ssrLoadModule('/bench/cycles/shots.ts')
  const shots = selectShots(SHOTS)
  const python = options.python ?? (await install())
  await mkdir(options.output, { recursive: true })
  const browser = await launchBrowser()
  const rows = []
  try {
    for (const shot of shots) {
      say(`${shot.name}: Furrow`)
      const page = await openPage(server, browser, '/bench/cycles/page.html', 'pose')
      rows.push([shot.name, ...(await compare(shot, page, python))])
      await page.close()
    }
  } finally {
    await browser.close()
  }
  const head = ['picture', 'with wrinkles', 'without']
  for (const row of [head, ...rows]) process.stdout.write(`${row.map((cell) => format(cell)).join('')}\n`)
}

/** Renders a shot with three.js and with Cycles. Returns the mean FLIP error of the picture with wrinkles, and of the picture without. */
async function compare(shot, page, python) {
  const { denseSkin } = await server.ssrLoadModule('/bench/cycles/dense-skin.ts')
  const { LAMPS, SIZE, AMBIENT } = await server.ssrLoadModule('/bench/cycles/shots.ts')
  const folder = join(CACHE, shot.name)
  await rm(folder, { recursive: true, force: true })
  await mkdir(folder, { recursive: true })
  const file = (name) => join(folder, name)
  await furrow(
    'auto',
    FACES[shot.face],
    '-o',
    file('face.glb'),
    '--age',
    shot.age,
    '--size',
    '2048',
    '--replace',
  )
  await furrow('unpack', file('face.glb'), '-o', file('wrinkles'))
  const description = await page.evaluate(
    ([address, shot]) => globalThis.pose(address, shot),
    [`/node_modules/.cache/furrow-cycles/${shot.name}/face.glb`, shot],
  )
  for (const mode of ['default', 'off']) {
    const url = await page.evaluate((mode) => globalThis.draw(mode), mode)
    await writeFile(file(`${mode}.png`), Buffer.from(url.split(',')[1], 'base64'))
  }
  const skin = await denseSkin(description, file('wrinkles'))
  say(`${shot.name}: Cycles, ${skin.triangles.length / 3} triangles`)
  for (const [name, data] of Object.entries(skin)) {
    await writeFile(file(`${name}.bin`), new Uint8Array(data.buffer, data.byteOffset, data.byteLength))
  }
  await writeFile(
    file('scene.json'),
    JSON.stringify({
      face: FACES[shot.face],
      skin: description.skin.name,
      targets: shot.targets,
      camera: description.camera,
      lamps: LAMPS,
      lampAngle: LAMP_ANGLE,
      ambient: AMBIENT,
      samples: Number(options.samples),
      size: SIZE,
    }),
  )
  await pass(python, join(HERE, 'render.py'), file('scene.json'), file('cycles.png'))
  const box = ['left', 'top', 'width', 'height'].map((side) => Math.round(shot.crop[side] * SIZE))
  const pictures = ['off', 'default'].map((mode) => file(`${mode}.png`))
  const { stdout } = await run(python, [
    join(HERE, 'compare.py'),
    file('cycles.png'),
    ...box.map(String),
    file('difference.png'),
    ...pictures,
  ])
  const [without, withWrinkles] = JSON.parse(stdout)
  await compose(
    [...pictures, file('cycles.png')],
    file('difference.png'),
    box,
    join(options.output, `${shot.name}.jpg`),
  )
  return [withWrinkles, without]
}

/**
 * Writes a figure with two rows. The first row shows `pictures`: without wrinkles, with wrinkles, and by Cycles. The second row shows the
 * crop in which FLIP compares the pictures: the map of errors, then the second and the third picture.
 */
async function compose(pictures, difference, [left, top, width, height], path) {
  const side = 600
  const full = pictures.map((picture) =>
    sharp(picture).flatten({ background: BACKGROUND }).resize(side, side),
  )
  const crops = pictures.map((picture) =>
    sharp(picture).flatten({ background: BACKGROUND }).extract({ left, top, width, height }),
  )
  crops[0] = sharp(difference)
  const cropHeight = Math.round((side * height) / width)
  const rows = [
    ...full.map((image, i) => ({ image, left: i * (side + GAP), top: 0 })),
    ...crops.map((image, i) => ({
      image: image.resize(side, cropHeight),
      left: i * (side + GAP),
      top: side + GAP,
    })),
  ]
  const layers = await Promise.all(
    rows.map(async ({ image, ...at }) => ({ input: await image.png().toBuffer(), ...at })),
  )
  const size = { width: 3 * side + 2 * GAP, height: side + GAP + cropHeight }
  await sharp({ create: { ...size, channels: 3, background: '#fff' } })
    .composite(layers)
    .jpeg({ quality: 88 })
    .toFile(path)
}

function selectShots(shots) {
  const unknown = options.only?.find((name) => !shots.some((shot) => shot.name === name))
  if (unknown === undefined) return shots.filter(({ name, face }) => isWanted(name) && hasFace(face))
  const allowed = shots.map(({ name }) => name).join(', ')
  throw new Error(`cycles: unknown picture, got "${unknown}", allowed: ${allowed}; name one of these`)
}

function isWanted(name) {
  return options.only === undefined || options.only.includes(name)
}

/** Returns whether the file of a face exists. The scan is not part of this repository. */
function hasFace(face) {
  return existsSync(FACES[face])
}

/** Installs Blender as a Python module if it is missing. Returns the path of the Python interpreter. */
async function install() {
  const environment = join(CACHE, 'python')
  const python = join(environment, 'bin/python')
  if (existsSync(join(environment, 'installed'))) return python
  say('installing Blender as a Python module')
  await pass('python3', '-m', 'venv', '--clear', environment)
  await pass(python, '-m', 'pip', 'install', '--quiet', ...PACKAGES)
  await writeFile(join(environment, 'installed'), '')
  return python
}

async function furrow(...args) {
  await run(process.execPath, [join(ROOT, 'packages/cli/dist/main.js'), ...args.map(String)])
}

async function pass(program, ...args) {
  const child = spawn(program, args, { stdio: ['ignore', 'pipe', 'pipe'] })
  let printed = ''
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (text) => (printed += text))
  const [code] = await new Promise((resolve, reject) => {
    child.on('error', reject)
    child.on('close', (...ended) => resolve(ended))
  })
  if (code !== 0) throw new Error(`cycles: ${program} failed\n${printed.slice(-4000)}`)
}

function say(line) {
  process.stderr.write(`${line}\n`)
}

function format(cell) {
  return (typeof cell === 'number' ? cell.toFixed(4) : cell).padStart(16)
}

import { execFile } from 'node:child_process'
import { copyFile } from 'node:fs/promises'
import { join, resolve } from 'node:path'
import { promisify } from 'node:util'
import { ROOT } from '../lib/run.mjs'

export const FACE = join(ROOT, 'faces/human.glb')
/** A scanned face outside the repository. Its figures are skipped if it is missing. */
export const SCAN = join(ROOT, '../shared/real-face/ict-face.glb')

/** Faces that get automatic wrinkles. A path is absolute, or relative to the root of a checkout (this one or `BEFORE`). */
const SOURCES = { human: 'faces/human.glb', 'human-2': 'faces/human-2.glb', scan: SCAN }

/** Ages of the automatic wrinkles, years. */
export const AGES = [30, 50, 70]

/** Checkout of an earlier version, already built, for comparison. */
export const BEFORE = process.env.FURROW_BEFORE && resolve(process.env.FURROW_BEFORE)

/** For each skin colour, the factors on the base colour map, linear sRGB. */
export const SKINS = { light: [1, 1, 1], medium: [0.62, 0.55, 0.48], dark: [0.18, 0.15, 0.13] }
/** Path of `FACE` with automatic wrinkles, once it has been written. */
let wrinkled

/** For each face, a function that writes the face to a file. */
export const FACES = {
  'human-2': (file) => copyFile(join(ROOT, SOURCES['human-2']), file),
  images: (file) => pack(file),
  arrays: (file) => pack(file, '--ktx2'),
  lossless: (file) => compress(file, true),
  lossy: (file) => compress(file, false),
  guide: (file) => auto(FACE, file),
  furrows: (file) => auto(FACE, file, 70, '--furrows', '--size', '2048'),
  ...Object.fromEntries(
    Object.entries(SKINS).flatMap(([name, factor]) => [
      [name, (file) => tint(file, factor, false)],
      [`${name}Pale`, (file) => tint(file, factor, true)],
    ]),
  ),
  ...Object.fromEntries(
    Object.entries(SOURCES).flatMap(([name, source]) => [
      ...AGES.map((age) => [`${name}${age}`, (file) => auto(resolve(ROOT, source), file, age)]),
      [`${name}Before`, (file) => autoBefore(resolve(BEFORE, source), file)],
    ]),
  ),
}

async function pack(file, ...options) {
  const { packCommand } = await import('../../packages/cli/dist/commands/pack.js')
  const args = [join(ROOT, 'faces/human'), '--face', FACE, '--size', '512', '-o', file, ...options]
  await packCommand.parseAsync(args, { from: 'user' })
}

async function auto(face, file, age, ...options) {
  const { autoCommand } = await import('../../packages/cli/dist/commands/auto.js')
  const ageOption = age === undefined ? [] : ['--age', String(age)]
  const args = [face, '-o', file, ...ageOption, '--replace', ...options]
  await autoCommand.parseAsync(args, { from: 'user' })
}

/** Generates wrinkles with the earlier version, for the greatest age. */
async function autoBefore(face, file) {
  const command = join(BEFORE, 'packages/cli/dist/main.js')
  const options = ['-o', file, '--age', String(Math.max(...AGES)), '--replace']
  await promisify(execFile)(process.execPath, [command, 'auto', face, ...options])
}

/**
 * Writes the face with another skin colour.
 *
 * @param isPale whether to turn off blood, so that no expression makes the skin redder or paler.
 */
async function tint(file, factor, isPale) {
  const { transformFile } = await import('../lib/transform.mjs')
  if (!wrinkled) {
    wrinkled = `${file}.auto.glb`
    await auto(FACE, wrinkled, 45)
  }
  await transformFile(wrinkled, file, [
    (document) => {
      for (const material of document.getRoot().listMaterials()) {
        const wrinkles = material.getExtension('FURROW_wrinkle_maps')
        if (!wrinkles) continue
        material.setBaseColorFactor([...factor, 1])
        if (isPale) for (const layer of wrinkles.listLayers()) layer.setBloodAmplitude(0)
      }
    },
  ])
}

async function compress(file, lossless) {
  const { compressing, transformFile } = await import('../lib/transform.mjs')
  await transformFile(FACE, file, compressing(lossless))
}

import { execFile } from 'node:child_process'
import { join, resolve } from 'node:path'
import { promisify } from 'node:util'
import { ROOT } from '../lib/run.mjs'

export const FACE = join(ROOT, 'faces/human.glb')
/** A scanned face that is not in this repository; without it, its figures are not rendered. */
export const SCAN = join(ROOT, '../shared/real-face/ict-face.glb')

/** Faces that get automatic wrinkles; relative to a checkout. */
const SOURCES = { human: 'faces/human.glb', 'human-2': 'faces/human-2.glb', scan: SCAN }

/** Years for which automatic wrinkles are made. */
export const AGES = [30, 50, 70]

/** A checkout of an earlier version, built, whose faces and automatic wrinkles are shown beside those of now. */
export const BEFORE = process.env.FURROW_BEFORE && resolve(process.env.FURROW_BEFORE)

/** The shipped face and two darker ones: what its base colour is multiplied by, in linear sRGB. */
export const SKINS = { light: [1, 1, 1], medium: [0.62, 0.55, 0.48], dark: [0.18, 0.15, 0.13] }
/** The file of the shipped face with automatic wrinkles, which is made once. */
let wrinkled

/** The files that appear in figures, and the functions that write them. */
export const FACES = {
  images: (file) => pack(file),
  arrays: (file) => pack(file, '--ktx2'),
  lossless: (file) => shrink(file, true),
  lossy: (file) => shrink(file, false),
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
  const args = [face, '-o', file, '--age', String(age), '--replace', ...options]
  await autoCommand.parseAsync(args, { from: 'user' })
}

/** Wrinkles for the greatest age by the earlier version. */
async function autoBefore(face, file) {
  const command = join(BEFORE, 'packages/cli/dist/main.js')
  const options = ['-o', file, '--age', String(Math.max(...AGES)), '--replace']
  await promisify(execFile)(process.execPath, [command, 'auto', face, ...options])
}

/** @param isPale whether the blood stays as it is at rest. */
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

async function shrink(file, lossless) {
  const { shrinking, transformFile } = await import('../lib/transform.mjs')
  await transformFile(FACE, file, shrinking(lossless))
}

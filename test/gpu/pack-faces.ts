import { mkdirSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Transform } from '@gltf-transform/core'
import { draco, quantize, textureCompress } from '@gltf-transform/functions'
import type { Command } from 'commander'
import { ktx2 } from 'ktx2-encoder/gltf-transform'
import sharp from 'sharp'
import { compressing, transformFile } from '../../scripts/lib/transform.mjs'
import { BARE_FACES } from '../bare-faces/bare-faces.ts'
import { drawAndPack } from '../bare-faces/draw-and-pack.ts'
import { type CommandName, commandOf } from '../commands.ts'

export { BARE_FACES }

const FACES = fileURLToPath(new URL('../../faces', import.meta.url))

/** Transforms that users apply before publishing, and the file each starts from. */
const TRANSFORMED: Record<string, [from: string, ...transforms: Transform[]]> = {
  transformed: ['shipped', ...compressing(true)],
  'transformed-lossy': ['shipped', ...compressing(false)],
  draco: ['images', draco()],
  quantized: ['images', quantize()],
  // One image each, as written by tools without support for arrays.
  ktx2: [
    'images',
    textureCompress({ encoder: sharp, targetFormat: 'png', resize: [512, 512] }),
    basis(/color/i, true),
    basis(/.*/, false),
  ],
  ...Object.fromEntries(
    BARE_FACES.map((_, i) => [`drawn-${i}-transformed`, [`drawn-${i}`, ...compressing(true)]]),
  ),
}

/**
 * Packs files for tests in the browser, each once:
 * - `shipped`: the shipped face
 * - `images`, `arrays`: the shipped face with maps of 512 x 512 in both forms
 * - `bare-N`: the faces of `BARE_FACES`; `drawn-N`: the same with drawn wrinkles
 * - names of `TRANSFORMED`: those files after glTF-Transform
 *
 * @param folder an empty folder.
 * @returns function from a name to the path of its file.
 */
export function facePacker(folder: string): (name: string) => Promise<string> {
  const packed = new Map<string, Promise<string>>()
  // Commands keep the options of their last run, so only one runs at a time.
  let last: Promise<unknown> = Promise.resolve()
  const run = (name: CommandName, ...words: string[]) => {
    last = last.catch(() => {}).then(async () => runAlone(await commandOf(name), words))
    return last
  }
  const pathOf = (name: string) => {
    const path = packed.get(name) ?? make(name)
    packed.set(name, path)
    return path
  }

  async function make(name: string): Promise<string> {
    const path = join(folder, `${name}.glb`)
    const [, kind, index] = /^(bare|drawn)-(\d+)$/.exec(name) ?? []
    const face = BARE_FACES[Number(index)]
    if (name === 'shipped') return join(FACES, 'human.glb')
    if (kind === 'bare') return face.path
    if (kind === 'drawn') {
      mkdirSync(join(folder, name))
      return drawAndPack(face, join(folder, name), run)
    }
    if (name === 'images' || name === 'arrays') {
      const options = ['--face', await pathOf('shipped'), '--size', '512', '--json']
      await run(
        'pack',
        join(FACES, 'human'),
        '-o',
        path,
        ...options,
        ...(name === 'arrays' ? ['--ktx2'] : []),
      )
      return path
    }
    const [from, ...transforms] = TRANSFORMED[name]
    await transformFile(await pathOf(from), path, transforms)
    return path
  }
  return pathOf
}

/** Runs a command without the options of its last run. */
export function runAlone(command: Command, words: string[]): Promise<unknown> {
  for (const option of command.options) {
    command.setOptionValueWithSource(option.attributeName(), option.defaultValue, 'default')
  }
  return command.parseAsync(words, { from: 'user' })
}

function basis(slots: RegExp, isColour: boolean): Transform {
  return ktx2({
    slots,
    isUASTC: true,
    generateMipmap: true,
    isPerceptual: isColour,
    isSetKTX2SRGBTransferFunc: isColour,
    enableDebug: false,
    imageDecoder: async (bytes: Uint8Array) => {
      const { data, info } = await sharp(bytes).ensureAlpha().raw().toBuffer({ resolveWithObject: true })
      return { data: new Uint8Array(data), width: info.width, height: info.height }
    },
  })
}

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

/** Files that users make with glTF-Transform: name, source, and transforms. */
const TRANSFORMED: Record<string, [from: string, ...transforms: Transform[]]> = {
  transformed: ['shipped', ...compressing(true)],
  'transformed-lossy': ['shipped', ...compressing(false)],
  draco: ['images', draco()],
  quantized: ['images', quantize()],
  // Compresses each image separately, like tools without support for arrays.
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
 * Returns a function that makes the files for tests in the browser. It makes each file once:
 * - `shipped`: the shipped face
 * - `images`, `arrays`: the shipped face with maps of 512 x 512, as PNG images and as KTX 2 arrays
 * - `bare-N`: the faces of `BARE_FACES`; `drawn-N`: these faces with drawn wrinkles
 * - names in `TRANSFORMED`: files transformed by glTF-Transform
 *
 * @param folder an empty folder.
 * @returns function that takes a name and returns the path of the file.
 */
export function facePacker(folder: string): (name: string) => Promise<string> {
  const packed = new Map<string, Promise<string>>()
  // A command keeps the options of its last run, so runs must not overlap.
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

/** Runs a command after resetting the options of its last run. */
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

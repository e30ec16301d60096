import { copyFileSync, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { Logger, NodeIO, type Transform } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { dedup, draco, meshopt, prune, quantize, textureCompress } from '@gltf-transform/functions'
import draco3d from 'draco3d'
import { FurrowWrinkleMaps } from 'furrow/gltf'
import { ktx2 } from 'ktx2-encoder/gltf-transform'
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer'
import sharp from 'sharp'
import type { TestProject } from 'vitest/node'
import { packCommand } from '../../packages/cli/src/commands/pack.ts'

declare module 'vitest' {
  export interface ProvidedContext {
    /**
     * Address of a folder with `images.glb` and `arrays.glb`, the shipped face with maps of 512 x 512 in both forms, `shipped.glb`,
     * that face itself, and those of `TRANSFORMED`, as glTF-Transform leaves them.
     */
    packedFaces: string
  }
}

/** Packs what tests in the browser load. */
export default async function packFaces({ provide }: TestProject): Promise<() => void> {
  const folder = mkdtempSync(join(tmpdir(), 'furrow-faces-'))
  const faces = fileURLToPath(new URL('../../faces', import.meta.url))
  const face = ['--face', join(faces, 'human.glb'), '--size', '512', '--json']
  for (const [name, form] of [
    ['images', []],
    ['arrays', ['--ktx2']],
  ] as const) {
    const output = join(folder, `${name}.glb`)
    await packCommand.parseAsync([join(faces, 'human'), '-o', output, ...face, ...form], { from: 'user' })
  }
  copyFileSync(join(faces, 'human.glb'), join(folder, 'shipped.glb'))
  for (const [name, [from, ...transforms]] of Object.entries(TRANSFORMED)) {
    await writeTransformed(join(folder, `${from}.glb`), join(folder, `${name}.glb`), transforms)
  }
  provide('packedFaces', `/@fs${folder}`)
  return () => rmSync(folder, { recursive: true })
}

const webp = (lossless: boolean) =>
  textureCompress({ encoder: sharp, targetFormat: 'webp', resize: [512, 512], lossless })

const imageDecoder = async (bytes: Uint8Array) => {
  const { data, info } = await sharp(bytes).ensureAlpha().raw().toBuffer({ resolveWithObject: true })
  return { data: new Uint8Array(data), width: info.width, height: info.height }
}

const basis = (slots: RegExp, isColour: boolean) =>
  ktx2({
    slots,
    isUASTC: true,
    generateMipmap: true,
    isPerceptual: isColour,
    isSetKTX2SRGBTransferFunc: isColour,
    enableDebug: false,
    imageDecoder,
  })

/** What users do to files before they publish them, and to which file. */
const TRANSFORMED: Record<string, [from: string, ...transforms: Transform[]]> = {
  transformed: ['shipped', dedup(), prune(), webp(true), meshopt({ encoder: MeshoptEncoder })],
  'transformed-lossy': ['shipped', dedup(), prune(), webp(false), meshopt({ encoder: MeshoptEncoder })],
  draco: ['images', draco()],
  quantized: ['images', quantize()],
  // One image each, as tools write them that know of no arrays.
  ktx2: ['images', basis(/color/i, true), basis(/.*/, false)],
}

async function writeTransformed(input: string, output: string, transforms: Transform[]): Promise<void> {
  await MeshoptEncoder.ready
  const io = new NodeIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .registerExtensions([...ALL_EXTENSIONS, FurrowWrinkleMaps])
    .registerDependencies({
      'meshopt.decoder': MeshoptDecoder,
      'meshopt.encoder': MeshoptEncoder,
      'draco3d.encoder': await draco3d.createEncoderModule(),
    })
  const document = await io.read(input)
  await document.transform(...transforms)
  await io.write(output, document)
}

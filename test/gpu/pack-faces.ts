import { copyFileSync, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { Logger, NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { dedup, meshopt, prune, textureCompress } from '@gltf-transform/functions'
import { FurrowWrinkleMaps } from 'furrow/gltf'
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer'
import sharp from 'sharp'
import type { TestProject } from 'vitest/node'
import { packCommand } from '../../packages/cli/src/commands/pack.ts'

declare module 'vitest' {
  export interface ProvidedContext {
    /**
     * Address of a folder with `images.glb` and `arrays.glb`, the shipped face with maps of 512 x 512 in both forms, `shipped.glb`,
     * that face itself, and `transformed.glb` and `transformed-lossy.glb`, it as glTF-Transform leaves it.
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
  for (const [name, lossless] of [
    ['transformed', true],
    ['transformed-lossy', false],
  ] as const) {
    await writeTransformed(join(faces, 'human.glb'), join(folder, `${name}.glb`), lossless)
  }
  provide('packedFaces', `/@fs${folder}`)
  return () => rmSync(folder, { recursive: true })
}

/** What users do to files before they publish them: dedup, prune, resize, WebP, meshopt with quantised vertices. */
async function writeTransformed(input: string, output: string, lossless: boolean): Promise<void> {
  await MeshoptEncoder.ready
  const io = new NodeIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .registerExtensions([...ALL_EXTENSIONS, FurrowWrinkleMaps])
    .registerDependencies({ 'meshopt.decoder': MeshoptDecoder, 'meshopt.encoder': MeshoptEncoder })
  const document = await io.read(input)
  await document.transform(
    dedup(),
    prune(),
    textureCompress({ encoder: sharp, targetFormat: 'webp', resize: [512, 512], lossless }),
    meshopt({ encoder: MeshoptEncoder }),
  )
  await io.write(output, document)
}

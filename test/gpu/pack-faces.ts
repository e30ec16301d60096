import { copyFileSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Transform } from '@gltf-transform/core'
import { draco, quantize } from '@gltf-transform/functions'
import { ktx2 } from 'ktx2-encoder/gltf-transform'
import sharp from 'sharp'
import type { TestProject } from 'vitest/node'
import { packCommand } from '../../packages/cli/src/commands/pack.ts'
import { shrinking, transformFile } from '../../scripts/lib/transform.mjs'
import { hasScan, packScan } from '../real-face/pack-scan.ts'

declare module 'vitest' {
  export interface ProvidedContext {
    /**
     * URL of a folder with `images.glb` and `arrays.glb`, the shipped face with maps of 512 x 512 in both forms; `shipped.glb`,
     * that face itself; `scan.glb`, if the scanned face is available; and the files of `TRANSFORMED`.
     */
    packedFaces: string
  }
}

/** Packs the faces that tests in the browser load. */
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
  if (hasScan) await writeScan(folder)
  for (const [name, [from, ...transforms]] of Object.entries(TRANSFORMED)) {
    if (from === 'scan' && !hasScan) continue
    await transformFile(join(folder, `${from}.glb`), join(folder, `${name}.glb`), transforms)
  }
  provide('packedFaces', `/@fs${folder}`)
  return () => rmSync(folder, { recursive: true })
}

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

/** Common transforms before publication, and the files they are applied to. */
const TRANSFORMED: Record<string, [from: string, ...transforms: Transform[]]> = {
  transformed: ['shipped', ...shrinking(true)],
  'transformed-lossy': ['shipped', ...shrinking(false)],
  'scan-transformed': ['scan', ...shrinking(true)],
  draco: ['images', draco()],
  quantized: ['images', quantize()],
  // Single images, as written by tools without texture arrays.
  ktx2: ['images', basis(/color/i, true), basis(/.*/, false)],
}

async function writeScan(folder: string): Promise<void> {
  mkdirSync(join(folder, 'scan'))
  const packed = await packScan(join(folder, 'scan'), (command, ...words) =>
    command.parseAsync(words, { from: 'user' }),
  )
  copyFileSync(packed, join(folder, 'scan.glb'))
}

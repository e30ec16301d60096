import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { TestProject } from 'vitest/node'
import { packCommand } from '../../packages/cli/src/commands/pack.ts'

declare module 'vitest' {
  export interface ProvidedContext {
    /** Address of a folder with `images.glb` and `arrays.glb`: the shipped face with maps of 512 x 512 in both forms. */
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
  provide('packedFaces', `/@fs${folder}`)
  return () => rmSync(folder, { recursive: true })
}

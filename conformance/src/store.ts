import { execFile } from 'node:child_process'
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { promisify } from 'node:util'
import { draco, meshopt, quantize } from '@gltf-transform/functions'
import { MeshoptEncoder } from 'meshoptimizer'
import { transformFile } from '../../scripts/lib/transform.mjs'
import { encodeFile } from './encode-file.ts'
import type { SampleFile, Storage } from './sample.ts'

const CLI = fileURLToPath(new URL('../../packages/cli/bin/furrow.js', import.meta.url))

const TRANSFORMS = {
  quantized: () => quantize(),
  draco: () => draco(),
  meshopt: () => meshopt({ encoder: MeshoptEncoder }),
}

/** Encodes a sample file. Compresses it with the tools that users have: glTF-Transform and `furrow pack`. */
export async function storeFile(file: SampleFile): Promise<Uint8Array> {
  const bytes = encodeFile(file)
  if (!file.storage) return bytes
  const folder = await mkdtemp(join(tmpdir(), 'furrow-conformance-'))
  try {
    const [plain, stored] = [join(folder, 'face.glb'), join(folder, 'stored.glb')]
    await writeFile(plain, bytes)
    await store(plain, stored, file.storage, folder)
    return await readFile(stored)
  } finally {
    await rm(folder, { recursive: true })
  }
}

async function store(plain: string, stored: string, storage: Storage, folder: string): Promise<void> {
  if (storage !== 'ktx2') return transformFile(plain, stored, [TRANSFORMS[storage]()])
  const maps = join(folder, 'maps')
  await furrow('unpack', plain, '-o', maps)
  await furrow('pack', maps, '--face', plain, '--ktx2', '--area-size', '16', '-o', stored)
}

async function furrow(...args: string[]): Promise<void> {
  await promisify(execFile)(process.execPath, [CLI, ...args])
}

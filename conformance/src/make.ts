import { encode } from 'fast-png'
import { describe, normalPicture } from './expected.ts'
import type { Sample } from './sample.ts'
import { storeFile } from './store.ts'

/**
 * Returns the files of a sample by name: the model as .glb, the expected values as .json, and for each pose a .png of
 * the normals.
 */
export async function filesOf(sample: Sample): Promise<Map<string, Uint8Array>> {
  const { name, file, poses, isMoved } = sample
  const files = new Map<string, Uint8Array>([
    [`${name}.glb`, await storeFile(file)],
    [`${name}.json`, new TextEncoder().encode(`${JSON.stringify(describe(sample), null, 2)}\n`)],
  ])
  if (isMoved) return files
  for (const [i, pose] of poses.entries()) {
    files.set(`${name}-${i}.png`, encode({ ...normalPicture(file, pose), channels: 3 }))
  }
  return files
}

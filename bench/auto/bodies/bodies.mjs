import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { NodeIO } from '@gltf-transform/core'
import { importSource } from '../../../scripts/lib/import-source.mjs'
import { ROOT } from '../../../scripts/lib/run.mjs'
import { REGIONS } from './regions.mjs'

/** For each body, the mesh that each of its regions shows. */
export const BODIES = {
  figure: {
    elbow: 'shirt',
    knee: 'trousers',
    hip: 'trousers',
    waist: 'shirt',
    twist: 'shirt',
    shoulder: 'shirt',
    neck: 'skin',
    fist: 'hands',
  },
  dress: Object.fromEntries(
    ['elbow', 'knee', 'hip', 'waist', 'twist', 'shoulder'].map((region) => [region, 'dress']),
  ),
  robot: Object.fromEntries(Object.keys(REGIONS).map((region) => [region, 'frame'])),
}

/**
 * Returns the path of each body without wrinkles. Builds the dress and the robot.
 *
 * @param folder folder of the built bodies.
 */
export async function bodyFiles(folder) {
  mkdirSync(folder, { recursive: true })
  const { dressFile, robotFile } = await importSource('test/bodies.ts')
  const built = { dress: dressFile(), robot: robotFile() }
  const files = { figure: join(ROOT, 'faces/body.glb') }
  for (const [name, document] of Object.entries(built)) {
    files[name] = join(folder, `${name}.glb`)
    writeFileSync(files[name], await new NodeIO().writeBinary(document))
  }
  return files
}

import { existsSync, mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { NodeIO } from '@gltf-transform/core'
import type { Command } from 'commander'
import { packCommand } from '../../packages/cli/src/commands/pack.ts'
import { strokesCommand } from '../../packages/cli/src/commands/strokes.ts'

const fromHere = (path: string) => fileURLToPath(new URL(path, import.meta.url))
export const SCAN = fromHere('../../../shared/real-face/ict-face.glb')

/** The scan is third-party data that is not in the repository. */
export const hasScan = existsSync(SCAN)

const driver = (area: string, ...targets: string[]) => ({
  type: 'morph',
  area,
  targets: targets.map((name) => ({ name })),
})

const DRIVERS = [
  driver('foreheadLeft', 'browInnerUp_L', 'browOuterUp_L'),
  driver('foreheadRight', 'browInnerUp_R', 'browOuterUp_R'),
  driver('nasolabialLeft', 'mouthSmile_L'),
  driver('nasolabialRight', 'mouthSmile_R'),
]

/**
 * Draws wrinkles for the scan and packs them into it, as a user would.
 *
 * @param folder an empty folder for intermediate files.
 * @param options of `furrow pack`.
 * @returns path of the packed face.
 */
export async function packScan(
  folder: string,
  run: (command: Command, ...words: string[]) => Promise<unknown>,
  ...options: string[]
): Promise<string> {
  const inFolder = (name: string) => join(folder, name)
  // The file has wrong bounds in its accessors, which writing it again corrects.
  writeFileSync(inFolder('face.glb'), await new NodeIO().writeBinary(await new NodeIO().read(SCAN)))
  for (const path of ['layers/expression', 'areas']) mkdirSync(inFolder(`drawn/${path}`), { recursive: true })
  writeFileSync(inFolder('drawn/wrinkles.json'), JSON.stringify({ version: 1, drivers: DRIVERS }))
  const face = ['--face', inFolder('face.glb'), '--mesh', 'face']
  const maps = ['-o', inFolder('height.png'), '--normal', inFolder('drawn/layers/expression/normal.png')]
  await run(strokesCommand, fromHere('strokes.json'), ...face, ...maps, '--areas', inFolder('drawn/areas'))
  await run(packCommand, inFolder('drawn'), ...face, '-o', inFolder('packed.glb'), ...options)
  return inFolder('packed.glb')
}

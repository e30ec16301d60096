import { existsSync, mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { NodeIO } from '@gltf-transform/core'
import type { Command } from 'commander'
import { packCommand } from '../../packages/cli/src/commands/pack.ts'
import { strokesCommand } from '../../packages/cli/src/commands/strokes.ts'

const fromHere = (path: string) => fileURLToPath(new URL(path, import.meta.url))
export const SCAN = fromHere('../../../shared/real-face/ict-face.glb')

/** The scan is data of others, and not everybody has it. */
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
 * Draws the wrinkles of the scan and packs them into it, as its users would.
 *
 * @param folder an empty one, for all files in between.
 * @param options of `furrow pack`.
 * @returns path of the packed face.
 */
export async function packScan(
  folder: string,
  run: (command: Command, ...words: string[]) => Promise<unknown>,
  ...options: string[]
): Promise<string> {
  const place = (name: string) => join(folder, name)
  // The scan's own file has wrong bounds in its accessors; any tool that writes it anew computes them.
  writeFileSync(place('face.glb'), await new NodeIO().writeBinary(await new NodeIO().read(SCAN)))
  for (const made of ['layers/expression', 'areas']) mkdirSync(place(`drawn/${made}`), { recursive: true })
  writeFileSync(place('drawn/wrinkles.json'), JSON.stringify({ version: 1, drivers: DRIVERS }))
  const face = ['--face', place('face.glb'), '--mesh', 'face']
  const maps = ['-o', place('height.png'), '--normal', place('drawn/layers/expression/normal.png')]
  await run(strokesCommand, fromHere('strokes.json'), ...face, ...maps, '--areas', place('drawn/areas'))
  await run(packCommand, place('drawn'), ...face, '-o', place('packed.glb'), ...options)
  return place('packed.glb')
}

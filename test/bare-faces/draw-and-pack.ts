import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { Logger, NodeIO } from '@gltf-transform/core'
import type { CommandName } from '../commands.ts'
import type { BareFace } from './bare-faces.ts'

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
 * Draws wrinkles for a bare face and packs them into it, as users do.
 *
 * @param folder an empty folder for intermediate files.
 * @param options options of `furrow pack`.
 * @returns path of the packed face.
 */
export async function drawAndPack(
  { path, strokes }: BareFace,
  folder: string,
  run: (name: CommandName, ...words: string[]) => Promise<unknown>,
  ...options: string[]
): Promise<string> {
  const file = (name: string) => join(folder, name)
  // Writes the face again, which corrects the wrong accessor bounds of the scan.
  const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT))
  writeFileSync(file('face.glb'), await io.writeBinary(await io.read(path)))
  for (const made of ['layers/expression', 'areas']) mkdirSync(file(`drawn/${made}`), { recursive: true })
  const { areas } = JSON.parse(readFileSync(strokes, 'utf8')) as { areas: { name: string }[] }
  const drivers = DRIVERS.filter(({ area }) => areas.some(({ name }) => name === area))
  writeFileSync(file('drawn/wrinkles.json'), JSON.stringify({ version: 1, drivers }))
  const face = ['--face', file('face.glb'), '--mesh', 'face']
  const maps = ['-o', file('height.png'), '--normal', file('drawn/layers/expression/normal.png')]
  await run('strokes', strokes, ...face, ...maps, '--areas', file('drawn/areas'))
  await run('pack', file('drawn'), ...face, '-o', file('packed.glb'), ...options)
  return file('packed.glb')
}

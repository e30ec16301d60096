import { type AutoProgress, type AutoWrinkles, autoWrinkles } from '../author/auto/auto.ts'
import type { AutoOptions } from '../author/auto/options.ts'
import { chooseSkin } from '../author/auto/surface/choose-skin.ts'
import { autoWrinkleSet } from '../author/auto/wrinkle-set.ts'
import { BLOOD_AT_REST } from '../core/blood.ts'
import { FurrowError } from '../core/error.ts'
import type { ImageArray } from '../core/image-array.ts'
import { packChannels } from '../core/maps/pack-channels.ts'
import { packColours } from '../core/pack.ts'
import type { Area, Layer } from '../core/types.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import { type CharacterData, skinOf } from './character.ts'
import { keep, keyOf, recall } from './kept.ts'

/** Generated wrinkles for the skin of a character. */
export interface CharacterWrinkles {
  /** Index of the mesh that was chosen as the skin. */
  mesh: number
  /** Names of the layers. The maps of this object are in the same order. */
  layers: string[]
  normals: ImageArray
  /** Images with four channels: occlusion, blood, onset, and an unused one. */
  values: ImageArray
  /** For each layer, whether it has an onset map. */
  hasOnset: boolean[]
  /** Optical depth for green light that byte 255 of a blood map adds. */
  bloodAmplitude: number
  /** Height map of each layer, and the difference in height between black and white, in metres. */
  heights: Pick<Layer, 'height' | 'heightAmplitude'>[]
  areas: Area[]
  drivers: WrinkleDriver[]
}

/**
 * Chooses the skin among a character's meshes, as the command `furrow auto` does, and makes wrinkles for it. If the cache contains these
 * wrinkles, `made` receives the cached wrinkles.
 *
 * @param version version of the code. Cached results of other versions are not used.
 * @param made receives the wrinkles, and may transfer their buffers.
 * @returns a promise that resolves when the wrinkles are cached, or when caching has failed.
 */
export async function makeCharacterWrinkles(
  character: CharacterData,
  options: AutoOptions,
  version: string,
  progress: AutoProgress,
  made: (wrinkles: CharacterWrinkles) => void,
): Promise<void> {
  const candidates = character.map((mesh) => {
    const { isLit, frame, label } = mesh
    return { skin: skinOf(mesh), isLit, frame, label }
  })
  const key = await keyOf({ options, candidates })
  const known = await recall<CharacterWrinkles>(version, key)
  if (known) return made(known)
  const { index } = chooseSkin(candidates)!
  const { skin, frame } = candidates[index]
  const wrinkles = autoWrinkles(skin, { frame, ...options }, progress)
  if (wrinkles.emptyReason !== undefined) throw withoutAreas(wrinkles.emptyReason)
  const result = { mesh: index, ...packed(wrinkles) }
  await keep(version, key, result, () => made(result))
}

function packed(wrinkles: AutoWrinkles): Omit<CharacterWrinkles, 'mesh'> {
  const { layers, areas, drivers } = autoWrinkleSet(wrinkles)
  const names = layers.map(({ name }) => name)
  const normals = layers.map(({ normal }) => normal)
  const maps = wrinkles.layers.map(({ occlusion, onset }, i) => [occlusion, wrinkles.blood.maps[i], onset])
  return {
    layers: names,
    normals: packColours(normals),
    values: packChannels(maps, [255, BLOOD_AT_REST, 0]),
    hasOnset: wrinkles.layers.map(({ onset }) => onset !== undefined),
    bloodAmplitude: wrinkles.blood.amplitude,
    heights: layers.map(({ height, heightAmplitude }) => ({ height, heightAmplitude })),
    areas,
    drivers,
  }
}

function withoutAreas(reason: string): FurrowError {
  return new FurrowError({
    who: 'WrinkleLoaderPlugin',
    problem: `no wrinkles can be made: ${reason}`,
    remedy: 'draw wrinkles with `npx furrow strokes`, or load the file without the `auto` option',
  })
}

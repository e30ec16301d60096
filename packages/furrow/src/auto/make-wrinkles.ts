import { AUTO_STEPS, type AutoProgress, type AutoWrinkles, autoWrinkles } from '../author/auto/auto.ts'
import {
  type ChosenSurface,
  chooseSurfaces,
  emptyAside,
  kindNote,
} from '../author/auto/character/choose-surfaces.ts'
import { CharacterBudget } from '../author/auto/character/limits.ts'
import type { SurfaceKind } from '../author/auto/character/surface-kinds.ts'
import type { AutoOptions } from '../author/auto/options.ts'
import { halfSide } from '../author/auto/raster/half-side.ts'
import { limbsOf } from '../author/auto/skeleton/limbs-of.ts'
import { surfaceOptions } from '../author/auto/surface-options.ts'
import { autoWrinkleSet } from '../author/auto/wrinkle-set.ts'
import { BLOOD_AT_REST } from '../core/blood.ts'
import { FurrowError } from '../core/error.ts'
import type { ImageArray } from '../core/image-array.ts'
import { packChannels } from '../core/maps/pack-channels.ts'
import { packColours } from '../core/pack.ts'
import type { Area, Layer, WrinkleSet } from '../core/types.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import { type CharacterData, type CharacterMesh, skinOf } from './character.ts'
import { keep, keyOf, pack, recall } from './kept.ts'
import { nothingToWrinkle, withoutAreas } from './no-wrinkles.ts'
import { pngSize } from './png-size.ts'

/** Generated wrinkles for one mesh of a character. */
export interface MeshWrinkles {
  /** Index of the mesh. */
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

/** Character that gets wrinkles. */
export interface CharacterJob {
  meshes: CharacterData
  /** Kinds that the user stated, by name of a mesh or material. */
  kinds: Readonly<Record<string, SurfaceKind>>
}

export interface MadeCharacter {
  /** Notes about meshes that get no wrinkles. Each note is a complete sentence without a full stop. */
  notes: string[]
  /** Resolves when the wrinkles are cached, or when caching has failed. */
  kept: Promise<void>
}

type Candidate = ReturnType<typeof candidateOf>

/**
 * Chooses the surfaces of a character that get wrinkles, as the command `furrow auto` does, and makes wrinkles for each. If the cache contains
 * these wrinkles, `made` receives the cached wrinkles.
 *
 * @param version version of the code. Cached results of other versions are not used.
 * @param made receives the wrinkles of one mesh after another, and may transfer their buffers.
 * @throws FurrowError if no mesh gets wrinkles.
 */
export async function makeCharacterWrinkles(
  { meshes, kinds }: CharacterJob,
  options: AutoOptions,
  version: string,
  progress: AutoProgress,
  made: (wrinkles: MeshWrinkles) => void,
): Promise<MadeCharacter> {
  const candidates = meshes.map(candidateOf)
  const key = await keyOf({ options, kinds, candidates })
  const known = await recall(version, key)
  if (known) {
    const [notes, ...wrinkles] = known
    for (const each of wrinkles as MeshWrinkles[]) made(each)
    return { notes: notes as string[], kept: Promise.resolve() }
  }
  const chosen = chooseSurfaces(candidates, { kinds: new Map(Object.entries(kinds)), cloth: options.cloth })
  const [unknown] = chosen.unknown
  if (chosen.surfaces.length === 0) {
    throw nothingToWrinkle(emptyAside(chosen), unknown && askForKind(unknown.meshName))
  }
  // Regions belong to faces.
  const surfaces = options.regions ? chosen.surfaces.slice(0, 1) : chosen.surfaces
  const budget = surfaces.length > 1 ? new CharacterBudget() : undefined
  const [packed, failed]: [Blob[], { mesh: string; reason: string; error: FurrowError }[]] = [[], []]
  for (const [i, surface] of surfaces.entries()) {
    const own: AutoProgress = (done, total, step) => {
      const isLast = i === surfaces.length - 1
      if (done < total || isLast)
        progress(i * AUTO_STEPS.length + done, surfaces.length * AUTO_STEPS.length, step)
    }
    const { candidate } = surface
    const result = await makeSurface(surface, surfaceOptions(surface, options, i === 0), own, budget)
    if ('error' in result) failed.push({ ...result, mesh: candidate.meshName })
    else {
      const wrinkles = { mesh: candidates.indexOf(candidate), ...result }
      packed.push(pack(wrinkles))
      made(wrinkles)
    }
  }
  if (packed.length === 0) throw failed[0].error
  const notes = [
    ...failed.map(({ mesh, reason }) => `mesh "${mesh}" gets no wrinkles: ${reason}`),
    ...chosen.unknown.map((candidate) => kindNote(candidate, askForKind(candidate.meshName))),
  ]
  return { notes, kept: keep(version, key, [pack(notes), ...packed]) }
}

function candidateOf(mesh: CharacterMesh) {
  const skin = skinOf(mesh)
  const { meshName, materialName, materialJson, isLit, frame } = mesh
  const limbs = limbsOf(skin).map(({ limb }) => limb)
  return { skin, limbs, meshName, materialName, materialJson, isLit, frame }
}

function askForKind(mesh: string): string {
  const name = JSON.stringify(mesh)
  return `set the option kinds to { ${name}: 'skin' } or { ${name}: 'cloth' }`
}

/** Makes the wrinkles of one surface. Returns the reason, a clause for a message, if it gets none. */
async function makeSurface(
  { candidate, skin }: ChosenSurface<Candidate>,
  options: AutoOptions,
  progress: AutoProgress,
  budget: CharacterBudget | undefined,
): Promise<Omit<MeshWrinkles, 'mesh'> | { reason: string; error: FurrowError }> {
  let wrinkles: AutoWrinkles
  try {
    wrinkles = autoWrinkles(skin, { ...options, frame: candidate.frame }, progress)
  } catch (error) {
    if (error instanceof FurrowError) return { reason: error.problem, error }
    throw error
  }
  const { emptyReason } = wrinkles
  if (emptyReason !== undefined) return { reason: emptyReason, error: withoutAreas(emptyReason) }
  const set = autoWrinkleSet(wrinkles)
  const reason = budget && (await excess(set, budget))
  return reason === undefined ? packMaps(wrinkles, set) : { reason, error: withoutAreas(reason) }
}

/** Counts a surface. Returns the reason if it exceeds the limits of its character. */
async function excess({ layers, areas }: WrinkleSet, budget: CharacterBudget): Promise<string | undefined> {
  const maps = layers.flatMap(({ normal, occlusion, onset, blood, height }) => [
    { width: 4 * normal.width, data: normal.data },
    ...[occlusion, onset].flatMap((map) => (map ? halfSide(map) : [])),
    ...[blood, height].flatMap((map) => map ?? []),
  ])
  return budget.add(areas.length, await pngSize([...maps, ...areas.map(({ weights }) => weights)]))
}

function packMaps(
  wrinkles: AutoWrinkles,
  { layers, areas, drivers }: ReturnType<typeof autoWrinkleSet>,
): Omit<MeshWrinkles, 'mesh'> {
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

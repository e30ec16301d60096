import { FurrowError } from 'furrow'
import { type AutoOptions, type AutoProgress, type AutoWrinkles, autoWrinkles } from 'furrow/author'
import { CharacterBudget, surfaceOptions, WRINKLE_MAPS } from 'furrow/internal'
import {
  addNormals,
  type Cost,
  correctionsIn,
  costOf,
  type documentOf,
  embedWrinkles,
  type FoundSkin,
  faceWarnings,
  type Glb,
  inspectWrinkles,
  parseWrinkledFile,
  stripWrinkles,
  strokesIn,
  withCommandErrors,
} from 'furrow-files'
import { packAuto } from 'furrow-files/node'
import { mapBytes } from './map-bytes.ts'
import type { Steps } from './steps.ts'

const WITHOUT_NORMALS = 'the mesh has no normals; smooth normals were added, because wrinkles need them'

/** File that gets wrinkles. */
export interface WrinkledSource {
  /** Changed in place. */
  glb: Glb
  /** `glb`, decoded. */
  document: Awaited<ReturnType<typeof documentOf>>
  who: string
}

/** File, with the limits of its character. */
interface CharacterSource extends WrinkledSource {
  /** Corrections and random seeds of the wrinkles that the surfaces had, for the new ones. */
  kept: ReadonlyMap<FoundSkin, Kept>
  budget: CharacterBudget
}

interface Kept extends ReturnType<typeof correctionsIn> {
  /** Random seed. */
  seed: number | undefined
}

export interface SurfaceSettings {
  options: AutoOptions
  ktx2: boolean
  /** Whether to replace existing wrinkles. */
  replace: boolean
}

/** Surface with its wrinkles, and what they cost. */
export interface WrinkledSurface {
  found: FoundSkin
  wrinkles: AutoWrinkles
  cost: Cost
  /** Each warning is a complete sentence without a full stop. */
  warnings: string[]
}

/** Surfaces with wrinkles, and surfaces that get none, with the reason as a clause for a message. */
export interface WrinkledSurfaces {
  made: WrinkledSurface[]
  failed: { found: FoundSkin; reason: string }[]
}

/**
 * Makes wrinkles for the surfaces of a file in their order, and embeds them, until the limits of a character are reached.
 *
 * @param steps get the steps of the first surface. The other surfaces belong to the step `encoding`.
 */
export async function wrinkleSurfaces(
  file: WrinkledSource,
  surfaces: readonly FoundSkin[],
  settings: SurfaceSettings,
  steps: Steps,
): Promise<WrinkledSurfaces> {
  const [first, ...others] = surfaces
  const kept = new Map(surfaces.map((found) => [found, keptIn(file.glb, found, file.who)]))
  if (settings.replace) stripAll(file, surfaces)
  const source = { ...file, kept, budget: new CharacterBudget() }
  const [made, failed]: [WrinkledSurface[], WrinkledSurfaces['failed']] = [[], []]
  const add = (found: FoundSkin, result: WrinkledSurface | string) => {
    if (typeof result === 'string') failed.push({ found, reason: result })
    else made.push(result)
  }
  const progress: AutoProgress = (done, count, step) => {
    if (done < count) steps.at(step, done % 1)
  }
  const ofFirst = { ...settings, options: surfaceOptions(first, settings.options, true) }
  add(first, await wrinkleSurface(source, first, ofFirst, progress, () => steps.begin('encoding')))
  for (const [i, found] of others.entries()) {
    const progress: AutoProgress = (done, count) =>
      steps.at('encoding', Math.min(0.99, (i + done / count) / others.length))
    add(found, await wrinkleOther(source, found, settings, progress))
  }
  return { made, failed }
}

/**
 * Makes wrinkles for a surface and embeds them in the file.
 *
 * @param encoding called before the maps are encoded.
 * @returns the reason, a clause for a message, if the surface gets no wrinkles.
 */
async function wrinkleSurface(
  { glb, document, who, kept, budget }: CharacterSource,
  found: FoundSkin,
  { options, ktx2 }: SurfaceSettings,
  progress: AutoProgress,
  encoding: () => void = () => {},
): Promise<WrinkledSurface | string> {
  const { corrections, problem: fault, ...old } = kept.get(found)!
  const seed = options.seed ?? old.seed
  checkPlain(glb, found, who)
  const skinWarnings = fault === undefined ? [] : [fault]
  if (addNormals(glb, document, found.mesh) > 0) skinWarnings.push(WITHOUT_NORMALS)
  skinWarnings.push(...faceWarnings(glb.json, found, found.materialName, who))
  const frame = found.hasTangents ? 'orthonormal' : 'derivative'
  const own = { ...options, ...(seed !== undefined && { seed }), frame } as const
  const wrinkles = withCommandErrors(who, () => autoWrinkles(found.skin, own, progress))
  if (wrinkles.emptyReason !== undefined) return wrinkles.emptyReason
  encoding()
  const packed = await packAuto(wrinkles, ktx2, who)
  const problem = budget.add(packed.areas.length, mapBytes(packed))
  if (problem !== undefined) return problem
  embedWrinkles(glb, found.material, { ...packed, shapes: corrections }, who)
  const cost = costOf(await inspectWrinkles(parseWrinkledFile(glb, found.material, who), who), ktx2)
  return { found, wrinkles, cost, warnings: [...wrinkles.warnings, ...skinWarnings] }
}

/** Makes wrinkles for a further surface. An error costs only this surface its wrinkles. */
async function wrinkleOther(
  source: CharacterSource,
  found: FoundSkin,
  { options, ...settings }: SurfaceSettings,
  progress: AutoProgress,
): Promise<WrinkledSurface | string> {
  try {
    const own = { ...settings, options: surfaceOptions(found, options, false) }
    return await wrinkleSurface(source, found, own, progress)
  } catch (error) {
    if (error instanceof FurrowError) return error.problem
    throw error
  }
}

function keptIn(glb: Glb, found: FoundSkin, who: string): Kept {
  const corrections = correctionsIn(glb.json, found.material, 'a correction is left out')
  return { ...corrections, seed: seedIn(glb, found, who) }
}

/** Returns the random seed that is stored with the wrinkles of a material. Wrinkles that are not valid have none. */
function seedIn(glb: Glb, { material }: FoundSkin, who: string): number | undefined {
  if (!isWrinkled(glb, material)) return undefined
  try {
    return strokesIn(parseWrinkledFile(glb, material, who), who).strokes?.seed
  } catch (error) {
    if (error instanceof FurrowError) return undefined
    throw error
  }
}

/** Removes the wrinkles of all surfaces. The last ones in the file go first, because only the end of a list can be cut off. */
function stripAll({ glb, who }: WrinkledSource, surfaces: readonly FoundSkin[]): void {
  const firstTexture = (material: number) => {
    const [{ normalTexture }] = parseWrinkledFile(glb, material, who).maps.layers
    return normalTexture.index
  }
  const materials = [...new Set(surfaces.map(({ material }) => material))].filter((i) => isWrinkled(glb, i))
  const found = materials.map((material) => ({ material, at: firstTexture(material) }))
  for (const { material } of found.sort((a, b) => b.at - a.at)) stripWrinkles(glb, material, who)
}

function isWrinkled({ json }: Glb, material: number): boolean {
  return json.materials![material].extensions?.[WRINKLE_MAPS] !== undefined
}

function checkPlain(glb: Glb, { material, materialName }: FoundSkin, who: string): void {
  if (!isWrinkled(glb, material)) return
  throw new FurrowError({
    who,
    problem: 'the material already has wrinkles',
    value: materialName,
    remedy: 'pass --replace to replace them',
  })
}

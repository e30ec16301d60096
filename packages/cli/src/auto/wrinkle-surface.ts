import { FurrowError } from 'furrow'
import { type AutoOptions, type AutoProgress, type AutoWrinkles, autoWrinkles } from 'furrow/author'
import { WRINKLE_MAPS } from 'furrow/internal'
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
 * Makes wrinkles for the surfaces of a file, and embeds them.
 *
 * @param steps get the steps of the first surface. The other surfaces belong to the step `encoding`.
 */
export async function wrinkleSurfaces(
  source: WrinkledSource,
  [first, ...others]: readonly FoundSkin[],
  settings: SurfaceSettings,
  steps: Steps,
): Promise<WrinkledSurfaces> {
  const [made, failed]: [WrinkledSurface[], WrinkledSurfaces['failed']] = [[], []]
  const add = (found: FoundSkin, result: WrinkledSurface | string) => {
    if (typeof result === 'string') failed.push({ found, reason: result })
    else made.push(result)
  }
  const progress: AutoProgress = (done, count, step) => {
    if (done < count) steps.at(step, done % 1)
  }
  add(first, await wrinkleSurface(source, first, settings, progress, () => steps.begin('encoding')))
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
  { glb, document, who }: WrinkledSource,
  found: FoundSkin,
  { options, ktx2, replace }: SurfaceSettings,
  progress: AutoProgress,
  encoding: () => void = () => {},
): Promise<WrinkledSurface | string> {
  const { corrections, problem } = correctionsIn(glb.json, found.material, 'a correction is left out')
  const seed = options.seed ?? seedIn(glb, found, who)
  removeOldWrinkles(glb, found, replace, who)
  const skinWarnings = problem === undefined ? [] : [problem]
  if (addNormals(glb, document, found.mesh) > 0) skinWarnings.push(WITHOUT_NORMALS)
  skinWarnings.push(...faceWarnings(glb.json, found, found.materialName, who))
  const frame = found.hasTangents ? 'orthonormal' : 'derivative'
  const wrinkles = withCommandErrors(who, () =>
    autoWrinkles(
      found.skin,
      {
        ...options,
        ...(seed !== undefined && { seed }),
        ...(found.cloth !== undefined && { cloth: found.cloth, furrows: false }),
        frame,
      },
      progress,
    ),
  )
  if (wrinkles.emptyReason !== undefined) return wrinkles.emptyReason
  encoding()
  const packed = await packAuto(wrinkles, ktx2, who)
  embedWrinkles(glb, found.material, { ...packed, shapes: corrections }, who)
  const cost = costOf(await inspectWrinkles(parseWrinkledFile(glb, found.material, who), who), ktx2)
  return { found, wrinkles, cost, warnings: [...wrinkles.warnings, ...skinWarnings] }
}

/** Makes wrinkles for a further surface, without fine furrows. An error costs only this surface its wrinkles. */
async function wrinkleOther(
  source: WrinkledSource,
  found: FoundSkin,
  { options, ...settings }: SurfaceSettings,
  progress: AutoProgress,
): Promise<WrinkledSurface | string> {
  try {
    const own = { ...settings, options: { ...options, furrows: false } }
    return await wrinkleSurface(source, found, own, progress)
  } catch (error) {
    if (error instanceof FurrowError) return error.problem
    throw error
  }
}

/** Returns the random seed that is stored with the wrinkles of a material. Wrinkles that are not valid have none. */
function seedIn(glb: Glb, { material }: FoundSkin, who: string): number | undefined {
  if (glb.json.materials![material].extensions?.[WRINKLE_MAPS] === undefined) return undefined
  try {
    return strokesIn(parseWrinkledFile(glb, material, who), who).strokes?.seed
  } catch (error) {
    if (error instanceof FurrowError) return undefined
    throw error
  }
}

/** Removes existing wrinkles from a material if `replace` is true. Otherwise throws if the material has wrinkles. */
function removeOldWrinkles(
  glb: Glb,
  { material, materialName }: FoundSkin,
  replace: boolean,
  who: string,
): void {
  if (glb.json.materials![material].extensions?.[WRINKLE_MAPS] === undefined) return
  if (replace) {
    stripWrinkles(glb, material, who)
    return
  }
  throw new FurrowError({
    who,
    problem: 'the material already has wrinkles',
    value: materialName,
    remedy: 'pass --replace to replace them',
  })
}

import type { Document } from '@gltf-transform/core'
import { FurrowError } from 'furrow'
import type { ClothKind } from 'furrow/author'
import { didYouMean } from 'furrow/internal'
import { sourceOf } from '../gltf/document.ts'
import { clothOf } from './cloth-kind.ts'
import { allSurfaces, bestSkin, type FoundSkin, findSkin, type LimbSurface } from './find-skin.ts'
import { type JudgedKind, judgeKind, type SurfaceKind } from './surface-kind.ts'

/** Surfaces of a character that get wrinkles. */
export interface FoundSurfaces {
  /** At least one. The first one is the face, if blendshapes move a surface. */
  surfaces: FoundSkin[]
  /** Each note is a complete sentence without a full stop. */
  notes: string[]
}

export interface SurfaceChoice {
  /** Name of a mesh or its node. Only this mesh is considered. */
  mesh?: string | undefined
  /** Kinds that the user stated, by name of a mesh or material. */
  kinds?: ReadonlyMap<string, SurfaceKind>
  /** Kind of all cloth. Default: told by the names of materials and meshes. */
  cloth?: ClothKind | undefined
  /** Returns whether the given material can show wrinkles. */
  isLit?: (material: number) => boolean
}

/**
 * Finds the surfaces of a character that get wrinkles: the face, which blendshapes move, and all skin and cloth that joints fold.
 *
 * @throws FurrowError if no surface can have wrinkles, or if `kinds` has an unknown name.
 */
export function findSurfaces(
  document: Document,
  path: string,
  who: string,
  { mesh, kinds = new Map(), cloth, isLit = () => true }: SurfaceChoice,
): FoundSurfaces {
  const all = allSurfaces(document, mesh).map((surface) => judged(document, surface, kinds))
  checkNames(kinds, all, who)
  const best = bestSkin(
    all.map(({ surface }) => surface),
    isLit,
  )
  const face = best && best.fraction > 0 ? best : undefined
  const surfaces: FoundSkin[] = []
  if (face) surfaces.push(isFolding(judged(document, face, kinds)) ? face : withoutSkeleton(face))
  const others = all.filter(({ surface }) => !isSame(surface, face) && surface.limbs.length > 0)
  for (const { surface, kind, isStated } of others) {
    if (!isFoldedAs(kind, surface.limbs, isStated)) continue
    const found = { ...surface, tubes: isStated }
    surfaces.push(kind === 'skin' ? found : { ...found, cloth: cloth ?? clothOf(surface) })
  }
  // `autoWrinkles` explains why blendshapes that move nothing give no wrinkles.
  if (surfaces.length === 0 && best && best.skin.targets.length > 0) surfaces.push(withoutSkeleton(best))
  const unknown = others.filter(({ kind }) => kind === undefined)
  const unfolded = others.filter(
    ({ kind, surface, isStated }) => kind === 'cloth' && !isFoldedAs(kind, surface.limbs, isStated),
  )
  if (surfaces.length === 0) throw nothingFound(document, path, who, mesh, unknown, unfolded)
  return { surfaces, notes: [...unknown.map(noteOf), ...clothNote(unfolded)] }
}

/** Returns whether joints of any of the given limbs fold a surface. */
export function isFoldedAs(
  kind: SurfaceKind | 'unknown' | undefined,
  limbs: readonly string[],
  isStated = false,
): boolean {
  return limbs.some((limb) => foldsLimb(kind, limb, isStated))
}

/**
 * Returns whether the joints of a limb fold a surface: skin everywhere except the waist, and cloth at elbows, knees and waists. Chains fold
 * both, if the user stated the kind.
 */
export function foldsLimb(
  kind: SurfaceKind | 'unknown' | undefined,
  limb: string,
  isStated = false,
): boolean {
  if (limb === 'chain') return isStated && (kind === 'skin' || kind === 'cloth')
  return kind === 'cloth' ? /elbow|knee|waist/.test(limb) : kind === 'skin' && limb !== 'waist'
}

interface JudgedSurface extends JudgedKind {
  /** Whether the user stated the kind. */
  isStated: boolean
  surface: LimbSurface
}

function judged(
  document: Document,
  surface: LimbSurface,
  kinds: ReadonlyMap<string, SurfaceKind>,
): JudgedSurface {
  const { meshName, materialName } = surface
  const isStated = kinds.has(meshName) || kinds.has(materialName)
  return { surface, isStated, ...judgeKind(sourceOf(document), surface, kinds) }
}

/** Returns whether joints fold a surface that blendshapes move. A surface with brows, lids and a mouth is skin unless its name denies it. */
function isFolding({ surface, kind }: JudgedSurface): boolean {
  return kind === 'skin' || (kind === undefined && surface.isFace === true)
}

function withoutSkeleton(surface: FoundSkin): FoundSkin {
  return { ...surface, skin: { ...surface.skin, skeleton: undefined } }
}

function isSame(a: FoundSkin, b: FoundSkin | undefined): boolean {
  return b !== undefined && a.mesh === b.mesh && a.material === b.material
}

function noteOf({ surface: { meshName, materialName, limbs } }: JudgedSurface): string {
  return `mesh "${meshName}", material "${materialName}" (${limbs.join(', ')}) may be skin, cloth or hard, and gets no wrinkles: pass --kind "${meshName}=skin" or --kind "${meshName}=cloth"`
}

function clothNote(cloth: readonly JudgedSurface[]): string[] {
  if (cloth.length === 0) return []
  const names = cloth.map(({ surface }) => `"${surface.meshName}"`).join(', ')
  return [`cloth folds at elbows, knees and waists only, so it gets no folds: ${names}`]
}

function nothingFound(
  document: Document,
  path: string,
  who: string,
  mesh: string | undefined,
  [unknown]: readonly JudgedSurface[],
  cloth: readonly JudgedSurface[],
): FurrowError {
  // Reports files without any usable mesh, and unknown names of meshes.
  findSkin(document, path, who, mesh)
  const judged = unknown
    ? [`mesh "${unknown.surface.meshName}" may be skin, cloth or hard`]
    : clothNote(cloth)
  const aside = judged.length > 0 ? ` (${judged[0]})` : ''
  return new FurrowError({
    who,
    problem: `no blendshapes, and no skin or cloth that joints of a humanoid move, in ${path}${aside}`,
    remedy: unknown
      ? `pass --kind "${unknown.surface.meshName}=skin" or --kind "${unknown.surface.meshName}=cloth"`
      : 'export the face with its blendshapes, or the body with its skeleton',
  })
}

function checkNames(
  kinds: ReadonlyMap<string, SurfaceKind>,
  all: readonly JudgedSurface[],
  who: string,
): void {
  const names = [...new Set(all.flatMap(({ surface }) => [surface.meshName, surface.materialName]))]
  for (const name of kinds.keys()) {
    if (names.includes(name)) continue
    throw new FurrowError({
      code: 'unknown-name',
      who,
      problem: 'no mesh or material has this name',
      value: name,
      limit: names.join(', '),
      remedy: didYouMean(name, names, 'correct --kind'),
    })
  }
}

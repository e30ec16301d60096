import { type Skin, surfaceArea } from '../../skin/surface.ts'
import type { ClothKind } from '../cloth/cloth-kinds.ts'
import { chooseSkin, FACE_MOVERS, type SkinChoice } from '../surface/choose-skin.ts'
import { judgeKind, type MaterialJson, type SurfaceNames } from './judge-kind.ts'
import { clothOf } from './named-cloth.ts'
import type { SurfaceKind } from './surface-kinds.ts'

/** Surface of a character that may get wrinkles: the parts of a mesh with one material. */
export interface SurfaceCandidate extends SurfaceNames {
  skin: Skin
  /** Parts of a humanoid that joints of the skin move, see `limbsOf`. */
  limbs: readonly string[]
  /** Material in the file; undefined if the file has none. */
  materialJson: MaterialJson | undefined
  /** Whether the material can show wrinkles. */
  isLit: boolean
}

export interface SurfaceSettings {
  /** Kinds that the user stated, by name of a mesh or material. */
  kinds?: ReadonlyMap<string, SurfaceKind> | undefined
  /** Kind of all cloth. Default: told by the names of materials and meshes. */
  cloth?: ClothKind | undefined
}

/** Surface that gets wrinkles. */
export interface ChosenSurface<T> {
  candidate: T
  /** Skin of the candidate, without its skeleton if joints do not fold it. */
  skin: Skin
  /** Whether the joints of chains fold the surface, see `AutoOptions`. */
  tubes: boolean
  /** Kind of cloth; undefined if the surface is skin. */
  cloth: ClothKind | undefined
  /** Choice of the surface by its blendshapes; undefined if joints decided. */
  choice?: SkinChoice
}

export interface ChosenSurfaces<T> {
  /** The face, if blendshapes move a surface. The other surfaces follow, largest first. */
  surfaces: ChosenSurface<T>[]
  /** Surfaces of unknown kind, which would get wrinkles if the user stated it. */
  unknown: T[]
  /** Cloth that joints move, but do not fold. */
  unfolded: T[]
}

/** Chooses the surfaces of a character that get wrinkles: the face, which blendshapes move, and all skin and cloth that joints fold. */
export function chooseSurfaces<T extends SurfaceCandidate>(
  candidates: readonly T[],
  { kinds, cloth }: SurfaceSettings,
): ChosenSurfaces<T> {
  const judged = candidates.map((candidate) => ({
    candidate,
    kind: judgeKind(candidate.materialJson, candidate, kinds).kind,
    isStated: [candidate.meshName, candidate.materialName].some((name) => kinds?.has(name)),
  }))
  const choice = chooseSkin(candidates.map(forChoice))
  const surfaces: ChosenSurface<T>[] = []
  const face = choice && choice.fraction > 0 ? judged[choice.index] : undefined
  if (face) {
    const isSkin = (face.kind ?? kindOfFace(choice)) === 'skin'
    surfaces.push({ ...(isSkin ? asSkin(face.candidate) : withoutSkeleton(face.candidate)), choice })
  }
  const others = judged.filter((one) => one !== face && one.candidate.limbs.length > 0)
  const isFolded = ({ kind, candidate, isStated }: (typeof judged)[number]) =>
    isFoldedAs(kind, candidate.limbs, isStated)
  for (const one of others) {
    const { candidate, kind, isStated } = one
    if (!isFolded(one)) continue
    const found = { ...asSkin(candidate), tubes: isStated }
    surfaces.push(kind === 'skin' ? found : { ...found, cloth: cloth ?? clothOf(candidate) })
  }
  // `autoWrinkles` explains why blendshapes that move nothing give no wrinkles.
  const still = choice && candidates[choice.index]
  if (surfaces.length === 0 && still && still.skin.targets.length > 0)
    surfaces.push({ ...withoutSkeleton(still), choice })
  const candidatesOf = (list: typeof judged) => list.map(({ candidate }) => candidate)
  return {
    surfaces: largestFirst(surfaces),
    unknown: candidatesOf(others.filter(({ kind }) => kind === undefined)),
    unfolded: candidatesOf(others.filter((one) => one.kind === 'cloth' && !isFolded(one))),
  }
}

/** Returns the kind of a surface whose names and material do not tell it: skin if it has brows, lids and a mouth. */
export function kindOfFace(choice: SkinChoice | undefined): 'skin' | undefined {
  return choice && choice.fraction > 0 && choice.movers === FACE_MOVERS ? 'skin' : undefined
}

/**
 * Returns a complete sentence without a full stop: why a surface of unknown kind gets no wrinkles.
 *
 * @param remedy tells how to state the kind.
 */
export function kindNote(
  { meshName, materialName, limbs }: Pick<SurfaceCandidate, 'meshName' | 'materialName' | 'limbs'>,
  remedy: string,
): string {
  return `mesh "${meshName}", material "${materialName}" (${limbs.join(', ')}) may be skin, cloth or hard, and gets no wrinkles: ${remedy}`
}

/** Returns a complete sentence without a full stop: why cloth gets no folds. */
export function clothNote(unfolded: readonly SurfaceNames[]): string {
  const names = unfolded.map(({ meshName }) => `"${meshName}"`).join(', ')
  return `cloth folds at elbows, knees and waists only, so it gets no folds: ${names}`
}

/** Returns in parentheses why none of the surfaces that joints move gets wrinkles. Returns an empty text if there are none. */
export function emptyAside({
  unknown: [unknown],
  unfolded,
}: Pick<ChosenSurfaces<SurfaceNames>, 'unknown' | 'unfolded'>): string {
  if (unknown) return ` (mesh "${unknown.meshName}" may be skin, cloth or hard)`
  return unfolded.length > 0 ? ` (${clothNote(unfolded)})` : ''
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

function forChoice({ skin, isLit, meshName, materialName }: SurfaceCandidate) {
  return { skin, isLit, label: `${meshName} ${materialName}` }
}

function asSkin<T extends SurfaceCandidate>(candidate: T): ChosenSurface<T> {
  return { candidate, skin: candidate.skin, tubes: false, cloth: undefined }
}

function withoutSkeleton<T extends SurfaceCandidate>(candidate: T): ChosenSurface<T> {
  return { ...asSkin(candidate), skin: { ...candidate.skin, skeleton: undefined } }
}

/** Sorts all surfaces except the first one. The largest surface takes the most pixels on the screen. */
function largestFirst<T>([first, ...others]: readonly ChosenSurface<T>[]): ChosenSurface<T>[] {
  if (first === undefined) return []
  const size = ({ skin }: ChosenSurface<T>) => surfaceArea(skin.positions, skin.indices)
  const sized = others.map((surface) => ({ surface, size: size(surface) })).sort((a, b) => b.size - a.size)
  return [first, ...sized.map(({ surface }) => surface)]
}

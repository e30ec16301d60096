import type { Document } from '@gltf-transform/core'
import { FurrowError } from 'furrow'
import type { ClothKind } from 'furrow/author'
import {
  type ChosenSurfaces,
  chooseSurfaces,
  clothNote,
  didYouMean,
  emptyAside,
  kindNote,
  type SurfaceKind,
} from 'furrow/internal'
import { sourceOf } from '../gltf/document.ts'
import { allSurfaces, chosenSkin, type FoundSkin, findSkin, type LimbSurface } from './find-skin.ts'

/** Surfaces of a character that get wrinkles. */
export interface FoundSurfaces {
  /** At least one. The first one is the face, if blendshapes move a surface. The others follow, largest first. */
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
 * Finds the surfaces of a character that get wrinkles, see `chooseSurfaces`.
 *
 * @throws FurrowError if no surface can have wrinkles, or if `kinds` has an unknown name.
 */
export function findSurfaces(
  document: Document,
  path: string,
  who: string,
  { mesh, kinds = new Map(), cloth, isLit = () => true }: SurfaceChoice,
): FoundSurfaces {
  const { materials = [] } = sourceOf(document)
  const all = allSurfaces(document, mesh)
  checkNames(kinds, all, who)
  const candidates = all.map((surface) => ({
    ...surface,
    materialJson: materials[surface.material],
    isLit: isLit(surface.material),
  }))
  const chosen = chooseSurfaces(candidates, { kinds, cloth })
  if (chosen.surfaces.length === 0) throw nothingFound(document, path, who, mesh, chosen)
  const surfaces = chosen.surfaces.map(({ candidate, skin, tubes, cloth, choice }): FoundSkin => {
    const found = choice ? chosenSkin(candidates, choice) : candidate
    return { ...found, skin, tubes, ...(cloth !== undefined && { cloth }) }
  })
  const { unknown, unfolded } = chosen
  const notes = unknown.map((surface) => kindNote(surface, askForKind(surface.meshName)))
  return { surfaces, notes: unfolded.length > 0 ? [...notes, clothNote(unfolded)] : notes }
}

function askForKind(mesh: string): string {
  return `pass --kind "${mesh}=skin" or --kind "${mesh}=cloth"`
}

function nothingFound(
  document: Document,
  path: string,
  who: string,
  mesh: string | undefined,
  chosen: ChosenSurfaces<LimbSurface>,
): FurrowError {
  // Reports files without any usable mesh, and unknown names of meshes.
  findSkin(document, path, who, mesh)
  const [unknown] = chosen.unknown
  return new FurrowError({
    who,
    problem: `no blendshapes, and no skin or cloth that joints of a humanoid move, in ${path}${emptyAside(chosen)}`,
    remedy: unknown
      ? askForKind(unknown.meshName)
      : 'export the face with its blendshapes, or the body with its skeleton',
  })
}

function checkNames(kinds: ReadonlyMap<string, SurfaceKind>, all: readonly LimbSurface[], who: string): void {
  const names = [...new Set(all.flatMap(({ meshName, materialName }) => [meshName, materialName]))]
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

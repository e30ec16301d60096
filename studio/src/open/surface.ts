import type { ClothKind, Skin } from 'furrow/author'
import {
  chooseSkin,
  clothOf,
  isFoldedAs,
  judgeKind,
  kindOfFace,
  limbsOf,
  type MaterialJson,
  type SurfaceKind,
  type SurfaceNames,
} from 'furrow/internal'
import type { AutoSettings } from '../document/document.ts'

/** How a skin folds, as `furrow auto` judges it. */
export interface JudgedSurface {
  /** Undefined if neither names nor the material tell. */
  readonly kind: SurfaceKind | undefined
  /** Kind of cloth, if the surface is cloth. */
  readonly cloth: ClothKind
}

/** Judges the surface of a mesh with one material by its names and its material. */
export function judgeSurface(
  surface: SurfaceNames & { materialJson: MaterialJson | undefined },
): JudgedSurface {
  return { kind: judgeKind(surface.materialJson, surface).kind, cloth: clothOf(surface) }
}

/** Skin with what is known about its surface. */
export interface JudgedSkin {
  readonly skin: Skin
  readonly surface: JudgedSurface
  /** Parts of the body that the joints move, as nouns. */
  readonly limbs: readonly string[]
}

/** Judges a skin. If names and material do not tell its kind, its blendshapes do. */
export function judgedSkin(skin: Skin, surface: JudgedSurface, label: string): JudgedSkin {
  const limbs = limbsOf(skin).map(({ limb }) => limb)
  if (surface.kind || limbs.length === 0 || skin.targets.length === 0) return { skin, limbs, surface }
  const kind = kindOfFace(chooseSkin([{ skin, isLit: true, label }]))
  return { skin, limbs, surface: { ...surface, kind } }
}

/** Skin from which automatic wrinkles are made, with the options for its surface. */
export interface AutoSource {
  readonly skin: Skin
  readonly options: { readonly cloth?: ClothKind; readonly tubes: boolean }
}

/**
 * Returns what automatic wrinkles are made from: the joints, if they fold a surface of this kind, and the blendshapes of skin.
 *
 * @returns null if neither joints nor blendshapes wrinkle the surface.
 */
export function autoSource(
  { skin, surface, limbs }: JudgedSkin,
  { kind: stated, cloth }: Pick<AutoSettings, 'kind' | 'cloth'>,
): AutoSource | null {
  const isStated = stated !== undefined
  const kind = stated ?? surface.kind
  const isFolded = isFoldedAs(kind, limbs, isStated)
  if (isFolded && kind === 'cloth')
    return { skin, options: { cloth: cloth ?? surface.cloth, tubes: isStated } }
  if (isFolded) return { skin, options: { tubes: isStated } }
  return skin.targets.length > 0
    ? { skin: { ...skin, skeleton: undefined }, options: { tubes: false } }
    : null
}

import type { ClothKind, Skin } from 'furrow/author'
import {
  chooseSkin,
  clothOf,
  FACE_MOVERS,
  isFoldedAs,
  judgeKind,
  limbsOf,
  type MaterialJson,
  type SurfaceKind,
  type SurfaceNames,
} from 'furrow/internal'
import type { AutoSettings } from '../document/document.ts'
import { withoutSkeleton } from './rest-skeleton.ts'

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

/** Judges a skin. A surface with brows, lids and a mouth is skin unless its name denies it. */
export function judgedSkin(skin: Skin, surface: JudgedSurface, label: string): JudgedSkin {
  const limbs = limbsOf(skin).map(({ limb }) => limb)
  const isFace = surface.kind === undefined && limbs.length > 0 && hasFace(skin, label)
  return { skin, limbs, surface: isFace ? { ...surface, kind: 'skin' } : surface }
}

function hasFace(skin: Skin, label: string): boolean {
  if (skin.targets.length === 0) return false
  const { fraction, movers } = chooseSkin([{ skin, isLit: true, label }])!
  return fraction > 0 && movers === FACE_MOVERS
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
  return skin.targets.length > 0 ? { skin: withoutSkeleton(skin), options: { tubes: false } } : null
}

import type { TangentFrame } from 'furrow/author'
import type { Skin } from 'furrow/auto'
import { correctSkin, type ShapeCorrection, skinOf } from 'furrow/internal'
import { readMeshes } from 'furrow/internal/three'
import type { OpenedAvatar } from '../open/avatar.ts'

/** Skin of an avatar, for making and drawing wrinkles. */
export interface SkinSource {
  readonly skin: Skin
  /** Names of its mesh; the first is unique in the file. */
  readonly meshes: readonly [string, ...string[]]
  /** Tangent frame in which renderers read its normal maps. */
  readonly frame: TangentFrame
}

/** Returns null if the avatar's skin cannot wrinkle. A skin without blendshapes has no targets. */
export function skinSource({ skins, skin }: OpenedAvatar): SkinSource | null {
  const { meshes, expressions, problem, meshNames } = skins[skin]
  if (problem !== null) return null
  const data = readMeshes(meshes, expressions)
  return { skin: skinOf(data), frame: data.frame, meshes: meshNames }
}

/** Applies corrections of recognised blendshapes. */
export function correctedSkin(
  { skin, meshes }: Pick<SkinSource, 'skin' | 'meshes'>,
  corrections: readonly ShapeCorrection[],
): Skin {
  return correctSkin(skin, corrections, meshes)
}

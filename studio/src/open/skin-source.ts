import type { TangentFrame } from 'furrow/author'
import type { Skin } from 'furrow/auto'
import { correctSkin, type ShapeCorrection, skinOf } from 'furrow/internal'
import { readMeshes } from 'furrow/internal/three'
import type { OpenedAvatar } from '../open/avatar.ts'

/** Skin of an avatar, for making and drawing wrinkles. */
export interface SkinSource {
  readonly skin: Skin
  /** Names of the skin's mesh. The first one is unique in the file. */
  readonly meshes: readonly [string, ...string[]]
  /** Tangent frame in which renderers read the skin's normal maps. */
  readonly frame: TangentFrame
}

/** Reads the chosen skin of an avatar. Returns null if this skin cannot wrinkle. */
export function skinSource({ skins, skin }: OpenedAvatar): SkinSource | null {
  const { meshes, expressions, problem, meshNames } = skins[skin]
  if (problem !== null) return null
  const data = readMeshes(meshes, expressions)
  return { skin: skinOf(data), frame: data.frame, meshes: meshNames }
}

/** Applies the artist's corrections of recognised blendshapes to a skin. */
export function correctedSkin(
  { skin, meshes }: Pick<SkinSource, 'skin' | 'meshes'>,
  corrections: readonly ShapeCorrection[],
): Skin {
  return correctSkin(skin, corrections, meshes)
}

import type { TangentFrame } from 'furrow/author'
import type { Skin } from 'furrow/auto'
import { correctSkin, type ShapeCorrection, skinOf } from 'furrow/internal'
import { readMeshes } from 'furrow/internal/three'
import type { OpenedAvatar } from '../open/avatar.ts'

/** The skin of an avatar as wrinkles are made and drawn on it. */
export interface SkinSource {
  readonly skin: Skin
  /** Names of its mesh; the first is unique in the file. */
  readonly meshes: readonly [string, ...string[]]
  /** The frame in which renderers read its normal maps. */
  readonly frame: TangentFrame
}

/** Null where the avatar's skin cannot wrinkle; without blendshapes it has no targets. */
export function skinSource({ skins, skin }: OpenedAvatar): SkinSource | null {
  const { meshes, expressions, fault, meshNames } = skins[skin]
  if (fault !== null) return null
  const data = readMeshes(meshes, expressions)
  return { skin: skinOf(data), frame: data.frame, meshes: meshNames }
}

/** The skin with corrections of what its blendshapes are. */
export function correctedSkin(
  { skin, meshes }: Pick<SkinSource, 'skin' | 'meshes'>,
  corrections: readonly ShapeCorrection[],
): Skin {
  return correctSkin(skin, corrections, meshes)
}

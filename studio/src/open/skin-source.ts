import type { TangentFrame } from 'furrow/author'
import type { Skin } from 'furrow/auto'
import { correctSkin, type ShapeCorrection, skinOf } from 'furrow/internal'
import { readMeshes } from 'furrow/internal/three'
import type { OpenedAvatar } from '../open/avatar.ts'
import { type JudgedSkin, judgedSkin } from './surface.ts'

/** Skin of an avatar, for making and drawing wrinkles. */
export interface SkinSource extends JudgedSkin {
  /** Names of the skin's mesh. The first one is unique in the file. */
  readonly meshes: readonly [string, ...string[]]
  /** Tangent frame in which renderers read the skin's normal maps. */
  readonly frame: TangentFrame
}

/** Reads the chosen skin of an avatar. Returns null if this skin cannot wrinkle. */
export function skinSource({ skins, skin }: OpenedAvatar): SkinSource | null {
  const { meshes, expressions, problem, meshNames, rest, surface } = skins[skin]
  if (problem !== null) return null
  // The avatar may be posed now.
  const data = { ...readMeshes(meshes, expressions), ...rest }
  return { ...judgedSkin(skinOf(data), surface, data.label), frame: data.frame, meshes: meshNames }
}

/** Reads the chosen skin of an avatar with its joints and without its blendshapes. Returns null if no joints move it. */
export function jointSkin({ skins, skin }: OpenedAvatar): Skin | null {
  const { meshes, rest } = skins[skin]
  if (!rest.joints) return null
  const data = readMeshes(meshes)
  const parts = data.parts.map((part) => ({ ...part, targets: [], head: undefined }))
  return skinOf({ ...data, parts, names: [], ...rest })
}

/** Applies the artist's corrections of recognised blendshapes to a skin. */
export function correctedSkin(
  { skin, meshes }: Pick<SkinSource, 'skin' | 'meshes'>,
  corrections: readonly ShapeCorrection[],
): Skin {
  return correctSkin(skin, corrections, meshes)
}

import type { TangentFrame } from 'furrow/author'
import type { Skin } from 'furrow/auto'
import { skinOf } from 'furrow/internal'
import { readMeshes } from 'furrow/internal/three'
import type { OpenedAvatar } from '../open/avatar.ts'

/** The skin of an avatar as wrinkles are made and drawn on it. */
export interface SkinSource {
  readonly skin: Skin
  /** The frame in which renderers read its normal maps. */
  readonly frame: TangentFrame
}

/** Null where the avatar's skin cannot wrinkle; without blendshapes it has no targets. */
export function skinSource({ skins, skin }: OpenedAvatar): SkinSource | null {
  const { meshes, fault } = skins[skin]
  if (fault !== null) return null
  const data = readMeshes(meshes)
  return { skin: skinOf(data), frame: data.frame }
}

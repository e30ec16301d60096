import type { Layer } from '../../core/types.ts'
import { VALUE_KINDS } from '../../runtime/layer-maps.ts'
import type { valueTextures } from './value-textures.ts'
import { isToon, type WrinkleMaterial } from './wrinkle-material.ts'

/** What layers with other maps than normals take, and materials that light in steps. */
export interface Channels {
  valueTextures: typeof valueTextures
}

/** Whether wrinkles take these. */
export function needChannels(layers: readonly Layer<unknown>[], material: WrinkleMaterial): boolean {
  return isToon(material) || layers.some((layer) => VALUE_KINDS.some((kind) => layer[kind]))
}

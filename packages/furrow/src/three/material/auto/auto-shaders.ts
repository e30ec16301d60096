import type { Material, Texture } from 'three'
import type { Channels } from '../channels.ts'
import type { ComposeMaterial } from '../composed-map.ts'
import type { Edit, Patch } from '../patch.ts'
import type { ShaderInputs } from '../shader-inputs.ts'
import type { WrinkleMaterial } from '../wrinkle-material.ts'
import type { WrinkleTextures } from '../wrinkle-textures.ts'
import type { FirstValues } from './first-values.ts'

/** What the mode `auto` takes on a renderer. */
export interface AutoShaders {
  composeMaterial: ComposeMaterial
  /** Draws `Quads` of a map of occlusion, in red, with that of the layers mixed in. */
  occlusionMaterial(aoMap: Texture, inputs: ShaderInputs, channels: Channels): Material
  /** Makes a material read normals, visibility and blood of a composed map, in place of mixing them. */
  composedEdit(
    material: WrinkleMaterial,
    inputs: ShaderInputs,
    parts: Pick<DualParts, 'patch' | 'refuse'> & { channels: Channels | null },
  ): Edit
  /** Draws `Quads` of a dual map, see `DualMap`. */
  dualMaterial(base: Texture, textures: WrinkleTextures): Material
  /** Draws `Quads` of a map of occlusion, in red, and values of a layer behind it. */
  valuesMaterial(aoMap: Texture, values: FirstValues): Material
  /** Makes a material read its own normal and the first layer's from one texel of its normal map. */
  dualEdit(material: WrinkleMaterial, inputs: ShaderInputs, parts: DualParts): Edit
}

/** What an edit for a dual map is made of. */
export interface DualParts {
  patch: Patch
  /** A factor of the influence: 1 while a dual map is the material's normal map, else 0, since another has no normals of a layer. */
  isDual: { value: number }
  /** What the material's map of occlusion holds of the first layer then; null for nothing. */
  values: FirstValues | null
  /** Called where a shader cannot be edited so; it is then plain. */
  refuse(): void
}

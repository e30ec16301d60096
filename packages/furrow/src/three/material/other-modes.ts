import type { Material, Texture } from 'three'
import type { ComposedMap } from './composed-map.ts'
import type { packPaperArray } from './paper-array.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** What the modes `paper` and `composed` take on a renderer. */
export interface OtherModes {
  packPaperArray: typeof packPaperArray
  /** As `RendererParts.patch`, for the paper's mode. */
  patchPaper(material: WrinkleMaterial, inputs: ShaderInputs, refuse: () => void): () => void
  ComposedMap: typeof ComposedMap
  /** A material for `Quads` that draws the composed normal map: `base` with the wrinkles mixed in. */
  composeMaterial(base: Texture, inputs: ShaderInputs): Material
}

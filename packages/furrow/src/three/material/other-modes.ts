import type { ComposedMap, ComposeMaterial, composedSize } from './composed-map.ts'
import type { packPaperArray } from './paper-array.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** What the modes `paper`, `composed` and `auto` take on a renderer. */
export interface OtherModes {
  packPaperArray: typeof packPaperArray
  /** As `RendererParts.patch`, for the paper's mode. */
  patchPaper(material: WrinkleMaterial, inputs: ShaderInputs, refuse: () => void): () => void
  ComposedMap: typeof ComposedMap
  composedSize: typeof composedSize
  composeMaterial: ComposeMaterial
}

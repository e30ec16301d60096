import { ActivationTable } from './activation-table.ts'
import { packPaperArray } from './paper-array.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/**
 * Packs the texture array for the mode `paper` if it is missing or outdated. An existing texture is kept and gets new pixels, because shaders
 * reference it.
 *
 * @param smoothMap original normal map of the material, or null.
 * @throws FurrowError if there are several layers, or maps cannot be read or differ in size.
 */
export function updatePaper(
  inputs: ShaderInputs,
  material: WrinkleMaterial,
  smoothMap: WrinkleMaterial['normalMap'],
): void {
  const { paper, textures } = inputs
  if (paper?.version === textures.version) return
  const packed = packPaperArray(textures, material, smoothMap)
  if (!paper) {
    inputs.paper = { ...packed, table: new ActivationTable() }
    return
  }
  paper.texture.image = packed.texture.image
  paper.texture.needsUpdate = true
  paper.version = packed.version
}

import type { Material } from 'three'
import { ActivationTable } from './activation-table.ts'
import type { InfluenceView } from './influence-view.ts'
import type { RendererParts } from './renderer-parts.ts'

/** Creates an unlit material that shows the influence map of a face in gray, or the weights of some areas. */
export function createInfluenceMaterial(
  view: InfluenceView,
  { unlitMaterial, showInfluence }: RendererParts,
): Material {
  const { inputs, weights } = view
  const material = unlitMaterial()
  const table = weights ? new ActivationTable() : null
  if (weights && table) {
    const values = Float32Array.from(weights.areas, ({ name }) => Number(weights.names.includes(name)))
    table.update(inputs.areas, { version: 0, values })
    material.addEventListener('dispose', () => table.texture.dispose())
  }
  showInfluence(material, view, table)
  return material
}

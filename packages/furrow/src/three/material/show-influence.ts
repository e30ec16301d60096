import { ActivationTable } from './activation-table.ts'
import type { OtherModes, ShowInfluence } from './other-modes.ts'

/** `OtherModes.showInfluence` by a renderer's shaders. */
export function showInfluenceBy(show: ShowInfluence): OtherModes['showInfluence'] {
  return (material, view) => {
    const { inputs, weights } = view
    if (!weights) return show(material, view, null)
    const { areas, names } = weights
    const table = new ActivationTable()
    const values = Float32Array.from(areas, ({ name }) => Number(names.includes(name)))
    table.update(inputs.areas, { version: 0, values })
    material.addEventListener('dispose', () => table.texture.dispose())
    show(material, view, table)
  }
}

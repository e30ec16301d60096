import type { Material, Mesh } from 'three'
import { FurrowError } from '../../core/error.ts'
import type { Area } from '../../core/types.ts'
import type { QuadMaterials } from '../atlas/quad-materials.ts'
import type { Instances } from '../mesh/instances.ts'
import type { WrinkleMode } from '../options.ts'
import { ActivationTable } from './activation-table.ts'
import { ComposedMap, type ComposeMaterial, composedFormat } from './composed-map.ts'
import type { PatchEvents, ShownMode } from './patch.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import { updatePaper } from './update-paper.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** Makes a material show a mode, as `RendererParts.patch` does. */
type Show = (
  material: WrinkleMaterial,
  inputs: ShaderInputs,
  host: Pick<PatchEvents, 'refuse'> & Pick<QuadMaterials, 'hasContents'>,
) => ShownMode

/** The shaders of these modes on a renderer, and of what shows influence. */
export interface ModeShaders {
  paper: Show
  composeMaterial: ComposeMaterial
  /**
   * Whether the composed mode draws all levels of its map, only where areas move: on a software rasteriser that takes half of what
   * the GPU takes to make them, each of them whole. Where a pass is dear, the GPU makes them.
   */
  drawsLevels: boolean
  showInfluence: ShowInfluence
}

/** Shows influence as gray by a renderer's shaders: that of the influence map, or that of a table of activations. */
export type ShowInfluence = (material: Material, view: InfluenceView, table: ActivationTable | null) => void

/** What is shown as gray. */
export interface InfluenceView {
  /** Its normal map has the texture coordinates. */
  wrinkled: Pick<WrinkleMaterial, 'normalMap'>
  inputs: ShaderInputs
  instances: Instances
  /** The weights of some areas; by default, the current influence. */
  weights?: { areas: readonly Area<unknown>[]; names: readonly string[] } | undefined
}

/** The modes `paper` and `composed` on a renderer, what shows influence, and what a mode that fails says. */
export class OtherModes {
  readonly updatePaper = updatePaper
  readonly #shaders: ModeShaders

  constructor(shaders: ModeShaders) {
    this.#shaders = shaders
  }

  /** Lights twice, and mixes the colours: after `updatePaper`. */
  readonly paper: Show = (material, inputs, host) => ({
    ...this.#shaders.paper(material, inputs, host),
    update: (_, activations) => inputs.paper!.table.update(inputs.areas, activations),
  })

  /** Replaces a material's own normal map by the composed one. */
  readonly composed: Show = (material, inputs, { hasContents }) => {
    const { composeMaterial, drawsLevels } = this.#shaders
    const base = material.normalMap!
    const format = composedFormat(base, inputs.textures.normals.texture, drawsLevels)
    const composed = new ComposedMap(base, format, composeMaterial(base, inputs, format.level), hasContents)
    const { texture } = composed.target
    material.normalMap = texture
    return {
      base,
      composed: texture,
      update(renderer, { values }) {
        const { areas, textures, fade } = inputs
        composed.update(renderer, areas, values, fade.value, areas.version + textures.version)
      },
      undo() {
        if (material.normalMap === texture) material.normalMap = base
        composed.dispose()
      },
    }
  }

  /** Makes an unlit material show influence as gray. */
  showInfluence(material: Material, view: InfluenceView): void {
    const { inputs, weights } = view
    const table = weights ? new ActivationTable() : null
    if (weights && table) {
      const values = Float32Array.from(weights.areas, ({ name }) => Number(weights.names.includes(name)))
      table.update(inputs.areas, { version: 0, values })
      material.addEventListener('dispose', () => table.texture.dispose())
    }
    this.#shaders.showInfluence(material, view, table)
  }

  /** Warns of a shader that the GPU refuses. */
  tellFault({ name }: Mesh, mode: WrinkleMode, fault: string): void {
    const { message } = new FurrowError({
      code: 'unsupported',
      who: 'Wrinkles',
      what: `the shader of mesh "${name}" does not compile in the ${mode} mode, so it is shown without wrinkles`,
      value: fault,
      remedy:
        mode === 'composed'
          ? 'give it another material, such as MeshStandardMaterial'
          : 'use the composed mode, or another material',
    })
    console.warn(message)
  }
}

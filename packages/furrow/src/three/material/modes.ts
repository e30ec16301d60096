import type { WrinkleMode } from '../options.ts'
import { ComposedMap, composedFormat } from './composed-map.ts'
import type { ModeHost, ShownMode } from './patch.ts'
import type { RendererParts } from './renderer-parts.ts'

/** Patches a material to show wrinkles in a mode. Callers must call `RendererParts.renew` afterwards, and again after `undo`. */
export function showMode(mode: Exclude<WrinkleMode, 'off'>, host: ModeHost, parts: RendererParts): ShownMode {
  if (mode === 'composed') return showComposed(host, parts)
  return mode === 'paper' ? showPaper(host, parts) : parts.showDefault(host)
}

/**
 * Patches a material to compute the lighting separately for smooth and for wrinkled skin, and to mix the two colours. Call `updatePaper`
 * first.
 */
function showPaper(host: ModeHost, { showPaper: show }: RendererParts): ShownMode {
  const { inputs } = host
  return {
    ...show(host),
    update: (_, activations) => inputs.paper!.table.update(inputs.areas, activations),
  }
}

/** Replaces the normal map of a material by a composed normal map, see `ComposedMap`. */
function showComposed(
  { material, inputs }: ModeHost,
  { composeMaterial, drawsLevels, quads }: RendererParts,
): ShownMode {
  const base = material.normalMap!
  const format = composedFormat(base, inputs.textures.normals.texture, drawsLevels)
  const drawn = composeMaterial(base, inputs, format.level)
  const composed = new ComposedMap(base, format, drawn, quads.hasContents)
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

import { checkFinite, isObject, wrongArgument } from '../../core/argument.ts'
import type { Layer } from '../../core/types.ts'
import { checkBloodAmplitude, checkOnsetStrength } from '../../core/wrinkle-set.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'
import { unknownLayer } from './unknown-layer.ts'

const WHO = 'scaleLayer'

/** Strengths of the maps of a layer; see `Layer`. */
export type LayerScale = Pick<Layer, 'normalScale' | 'occlusionStrength' | 'bloodAmplitude' | 'onsetStrength'>

/**
 * Changes how strongly the maps of a layer show, from the next frame on. The change affects all `Wrinkles` that share the textures. No shader
 * is compiled and no texture uploaded, but the modes `paper` and `composed` redraw their maps.
 *
 * @param wrinkles wrinkles of the face.
 * @param name name of the layer.
 * @param scale new strengths; omitted strengths stay unchanged.
 * @throws FurrowError if the layer is unknown, a number is out of range, or the wrinkles were disposed of; nothing then changes.
 */
export function scaleLayer(wrinkles: WrinklesBase, name: string, scale: LayerScale): void {
  checkWrinkles(wrinkles, WHO)
  const mesh = meshOf(wrinkles)
  mesh.checkInUse(WHO)
  const { textures } = mesh.shaderInputs
  const index = textures.layers.findIndex((layer) => layer.name === name)
  if (index < 0) throw unknownLayer(name, textures.layers, WHO)
  if (!isObject(scale))
    throw wrongArgument(WHO, 'scale', scale, 'normalScale, occlusionStrength, bloodAmplitude, onsetStrength')
  const layer = textures.layers[index]
  const {
    normalScale = layer.normalScale ?? 1,
    occlusionStrength = layer.occlusionStrength ?? 1,
    bloodAmplitude = layer.bloodAmplitude ?? 0,
    onsetStrength = layer.onsetStrength ?? 1,
  } = scale
  checkFinite(normalScale, `normalScale of layer "${name}"`, WHO)
  checkFinite(occlusionStrength, `occlusionStrength of layer "${name}"`, WHO)
  checkBloodAmplitude(bloodAmplitude, name, WHO)
  checkOnsetStrength(onsetStrength, name, WHO)
  textures.layers[index] = { ...layer, normalScale, occlusionStrength, bloodAmplitude, onsetStrength }
  textures.normalScale.value.setComponent(index, normalScale)
  textures.occlusionStrength.value.setComponent(index, occlusionStrength)
  textures.bloodAmplitude.value.setComponent(index, bloodAmplitude)
  textures.onsetStrength.value.setComponent(index, onsetStrength)
  textures.version++
}

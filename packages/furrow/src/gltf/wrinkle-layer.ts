import {
  ExtensionProperty,
  type IProperty,
  type Nullable,
  type Texture,
  TextureChannel,
  TextureInfo,
} from '@gltf-transform/core'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import type { LayerKind } from '../core/types.ts'

interface IWrinkleLayer extends IProperty {
  kind: LayerKind
  normalTexture: Texture
  normalTextureInfo: TextureInfo
  normalTextureSlice: number
  normalScale: number
  baseColorTexture: Texture
  baseColorTextureInfo: TextureInfo
  baseColorTextureSlice: number
  roughnessTexture: Texture
  roughnessTextureInfo: TextureInfo
  roughnessTextureSlice: number
  occlusionTexture: Texture
  occlusionTextureInfo: TextureInfo
  occlusionTextureSlice: number
  occlusionStrength: number
  heightTexture: Texture
  heightTextureInfo: TextureInfo
  heightTextureSlice: number
  heightAmplitude: number
  bloodTexture: Texture
  bloodTextureInfo: TextureInfo
  bloodTextureSlice: number
  bloodAmplitude: number
  onsetTexture: Texture
  onsetTextureInfo: TextureInfo
  onsetTextureSlice: number
  onsetStrength: number
  /** JSON text of unknown fields. */
  unknownFields: string
}

/** Stored slice index if the texture is not an array. */
export const NO_SLICE = -1

/** Name of a field in a layer's JSON that refers to a texture. */
export type LayerSlot =
  | 'normalTexture'
  | 'baseColorTexture'
  | 'roughnessTexture'
  | 'occlusionTexture'
  | 'heightTexture'
  | 'bloodTexture'
  | 'onsetTexture'

/** For each slot: a bit mask of the texture channels that it uses, and whether its texture contains sRGB colours. */
export const LAYER_SLOTS: Readonly<Record<LayerSlot, { channels: number; isColor?: boolean }>> = {
  normalTexture: { channels: TextureChannel.R | TextureChannel.G | TextureChannel.B },
  baseColorTexture: { channels: TextureChannel.R | TextureChannel.G | TextureChannel.B, isColor: true },
  roughnessTexture: { channels: TextureChannel.G },
  occlusionTexture: { channels: TextureChannel.R },
  heightTexture: { channels: TextureChannel.R },
  bloodTexture: { channels: TextureChannel.B },
  onsetTexture: { channels: TextureChannel.G },
}

/** A layer with maps of fully wrinkled skin. Areas of influence control where the maps are visible. See {@link MaterialWrinkles}. */
export class WrinkleLayer extends ExtensionProperty<IWrinkleLayer> {
  static override readonly EXTENSION_NAME = WRINKLE_MAPS
  declare readonly extensionName: typeof WRINKLE_MAPS
  declare readonly propertyType: 'WrinkleLayer'
  declare readonly parentTypes: ['MaterialWrinkles', 'WrinkleArea']

  protected override init(): void {
    Object.assign(this, {
      extensionName: WRINKLE_MAPS,
      propertyType: 'WrinkleLayer',
      parentTypes: ['MaterialWrinkles', 'WrinkleArea'],
    })
  }

  protected override getDefaults(): Nullable<IWrinkleLayer> {
    const info = (slot: LayerSlot) => new TextureInfo(this.graph, `${slot}Info`)
    return Object.assign(super.getDefaults() as IProperty, {
      kind: 'replace' as const,
      normalTexture: null,
      normalTextureInfo: info('normalTexture'),
      normalTextureSlice: NO_SLICE,
      normalScale: 1,
      baseColorTexture: null,
      baseColorTextureInfo: info('baseColorTexture'),
      baseColorTextureSlice: NO_SLICE,
      roughnessTexture: null,
      roughnessTextureInfo: info('roughnessTexture'),
      roughnessTextureSlice: NO_SLICE,
      occlusionTexture: null,
      occlusionTextureInfo: info('occlusionTexture'),
      occlusionTextureSlice: NO_SLICE,
      occlusionStrength: 1,
      heightTexture: null,
      heightTextureInfo: info('heightTexture'),
      heightTextureSlice: NO_SLICE,
      heightAmplitude: 0,
      bloodTexture: null,
      bloodTextureInfo: info('bloodTexture'),
      bloodTextureSlice: NO_SLICE,
      bloodAmplitude: 0,
      onsetTexture: null,
      onsetTextureInfo: info('onsetTexture'),
      onsetTextureSlice: NO_SLICE,
      onsetStrength: 1,
      unknownFields: '{}',
    })
  }

  /** Returns how the layer's normal map combines with the material's normal map. A `detail` map is laid over it; a `replace` map replaces it. */
  getKind(): LayerKind {
    return this.get('kind')
  }

  /** Sets how the layer's normal map combines with the material's normal map. A `detail` map is laid over it; a `replace` map replaces it. */
  setKind(kind: LayerKind): this {
    return this.set('kind', kind)
  }

  /** Returns the image of a slot. A layer without a `normalTexture` cannot be written. */
  getTexture(slot: LayerSlot): Texture | null {
    return this.getRef(slot)
  }

  /** Sets the image of a slot. Null removes the image. Occlusion, blood and onset of a layer must be channels of the same image. */
  setTexture(slot: LayerSlot, texture: Texture | null): this {
    return this.setRef(slot, texture, { ...LAYER_SLOTS[slot] })
  }

  /** Returns which slice of a KTX 2 texture array the slot uses, or null if the image is not an array. */
  getSlice(slot: LayerSlot): number | null {
    const slice = this.get(`${slot}Slice`)
    return slice === NO_SLICE ? null : slice
  }

  /** Sets which slice of a KTX 2 texture array the slot uses. Pass null if the image is not an array. */
  setSlice(slot: LayerSlot, slice: number | null): this {
    return this.set(`${slot}Slice`, slice ?? NO_SLICE)
  }

  /** Returns the texture coordinate set and the sampler of a slot, or null if the slot has no image. */
  getTextureInfo(slot: LayerSlot): TextureInfo | null {
    return this.getRef(slot) ? this.getRef(`${slot}Info`) : null
  }

  /** Returns the factor for x and y of the layer's normals. */
  getNormalScale(): number {
    return this.get('normalScale')
  }

  /** Sets the factor for x and y of the layer's normals. */
  setNormalScale(scale: number): this {
    return this.set('normalScale', scale)
  }

  /** Returns the strength of the occlusion: 0 = no occlusion, 1 = occlusion as in the map. */
  getOcclusionStrength(): number {
    return this.get('occlusionStrength')
  }

  /** Sets the strength of the occlusion: 0 = no occlusion, 1 = occlusion as in the map. */
  setOcclusionStrength(strength: number): this {
    return this.set('occlusionStrength', strength)
  }

  /** Returns the difference in height between black and white in the height map, in metres. */
  getHeightAmplitude(): number {
    return this.get('heightAmplitude')
  }

  /** Sets the difference in height between black and white in the height map, in metres. */
  setHeightAmplitude(metres: number): this {
    return this.set('heightAmplitude', metres)
  }

  /** Returns the added optical depth for green light where the blood map is 255. */
  getBloodAmplitude(): number {
    return this.get('bloodAmplitude')
  }

  /** Sets the added optical depth, 0..2, for green light where the blood map is 255. */
  setBloodAmplitude(depth: number): this {
    return this.set('bloodAmplitude', depth)
  }

  /** Returns how much the onset map delays the wrinkles: 0 = no delay, 1 = as in the map. */
  getOnsetStrength(): number {
    return this.get('onsetStrength')
  }

  /** Sets how much the onset map delays the wrinkles: 0 = no delay, 1 = as in the map. */
  setOnsetStrength(strength: number): this {
    return this.set('onsetStrength', strength)
  }

  /** Returns the unknown fields of the layer's JSON. Writing keeps them unchanged. */
  getUnknownFields(): Record<string, unknown> {
    return JSON.parse(this.get('unknownFields'))
  }

  /** Replaces the unknown fields by a copy of `fields`, which must be JSON data. */
  setUnknownFields(fields: Record<string, unknown>): this {
    return this.set('unknownFields', JSON.stringify(fields))
  }
}

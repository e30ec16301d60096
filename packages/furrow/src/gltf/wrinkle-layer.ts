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
  /** JSON of unknown fields. */
  unknownFields: string
}

/** Slice of a texture that is an ordinary image. */
export const NO_SLICE = -1

/** A texture slot of a layer, as in the extension's JSON. */
export type LayerSlot =
  | 'normalTexture'
  | 'baseColorTexture'
  | 'roughnessTexture'
  | 'occlusionTexture'
  | 'heightTexture'
  | 'bloodTexture'

/** The channels that are read of each slot's image, and whether they are colours. */
export const LAYER_SLOTS: Readonly<Record<LayerSlot, { channels: number; isColor?: boolean }>> = {
  normalTexture: { channels: TextureChannel.R | TextureChannel.G | TextureChannel.B },
  baseColorTexture: { channels: TextureChannel.R | TextureChannel.G | TextureChannel.B, isColor: true },
  roughnessTexture: { channels: TextureChannel.G },
  occlusionTexture: { channels: TextureChannel.R },
  heightTexture: { channels: TextureChannel.R },
  bloodTexture: { channels: TextureChannel.B },
}

/** A layer of {@link MaterialWrinkles}: maps of the skin fully wrinkled. */
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
      unknownFields: '{}',
    })
  }

  /** How the layer's normals combine with the skin's own: `replace` or `detail`. */
  getKind(): LayerKind {
    return this.get('kind')
  }

  /** Sets how the layer's normals combine with the skin's own: `replace` or `detail`. */
  setKind(kind: LayerKind): this {
    return this.set('kind', kind)
  }

  /** The image of a slot. Writing requires a `normalTexture`. */
  getTexture(slot: LayerSlot): Texture | null {
    return this.getRef(slot)
  }

  /** Sets the image of a slot; null for none. Blood is in that of the occlusion, where there is one. */
  setTexture(slot: LayerSlot, texture: Texture | null): this {
    return this.setRef(slot, texture, { ...LAYER_SLOTS[slot] })
  }

  /** Slice of the slot's texture if that is a KTX 2 array; null if it is an ordinary image. */
  getSlice(slot: LayerSlot): number | null {
    const slice = this.get(`${slot}Slice`)
    return slice === NO_SLICE ? null : slice
  }

  /** Sets the slice of the slot's texture if that is a KTX 2 array; null for an ordinary image. */
  setSlice(slot: LayerSlot, slice: number | null): this {
    return this.set(`${slot}Slice`, slice ?? NO_SLICE)
  }

  /** Texture coordinates and sampler of a slot; null while it has no texture. */
  getTextureInfo(slot: LayerSlot): TextureInfo | null {
    return this.getRef(slot) ? this.getRef(`${slot}Info`) : null
  }

  /** The factor on x and y of the normals. */
  getNormalScale(): number {
    return this.get('normalScale')
  }

  /** Sets the factor on x and y of the normals. */
  setNormalScale(scale: number): this {
    return this.set('normalScale', scale)
  }

  /** The strength of the occlusion, 0 = none, 1 = as in the map. */
  getOcclusionStrength(): number {
    return this.get('occlusionStrength')
  }

  /** Sets the strength of the occlusion, 0 = none, 1 = as in the map. */
  setOcclusionStrength(strength: number): this {
    return this.set('occlusionStrength', strength)
  }

  /** Metres from black to white of the height map. */
  getHeightAmplitude(): number {
    return this.get('heightAmplitude')
  }

  /** Sets the metres from black to white of the height map. */
  setHeightAmplitude(metres: number): this {
    return this.set('heightAmplitude', metres)
  }

  /** Optical depth that green light gains from 128 to 255 of the blood map. */
  getBloodAmplitude(): number {
    return this.get('bloodAmplitude')
  }

  /** Sets the optical depth that green light gains from 128 to 255 of the blood map, 0 to 2. */
  setBloodAmplitude(depth: number): this {
    return this.set('bloodAmplitude', depth)
  }

  /** Fields of the JSON that are unknown to this version; they are written back unchanged. */
  getUnknownFields(): Record<string, unknown> {
    return JSON.parse(this.get('unknownFields'))
  }

  /** Replaces the unknown fields with a copy of these, which must be plain JSON. */
  setUnknownFields(fields: Record<string, unknown>): this {
    return this.set('unknownFields', JSON.stringify(fields))
  }
}

import { ExtensionProperty, type IProperty, type Nullable, PropertyType, RefSet } from '@gltf-transform/core'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import type { WrinkleArea } from './wrinkle-area.ts'
import type { WrinkleLayer } from './wrinkle-layer.ts'

interface IMaterialWrinkles extends IProperty {
  layers: RefSet<WrinkleLayer>
  areas: RefSet<WrinkleArea>
  /** One JSON text per driver, so that copies are deep and equal drivers compare as equal. */
  drivers: string[]
  /** JSON of the strokes, `null` for none. */
  strokes: string
  /** JSON of the corrections, `null` for none. */
  shapes: string
  /** JSON of unknown fields. */
  unknownFields: string
}

/** The wrinkles of one material: layers, areas, drivers, strokes and corrections. See {@link FurrowWrinkleMaps}. */
export class MaterialWrinkles extends ExtensionProperty<IMaterialWrinkles> {
  static override readonly EXTENSION_NAME = WRINKLE_MAPS
  declare readonly extensionName: typeof WRINKLE_MAPS
  declare readonly propertyType: 'MaterialWrinkles'
  declare readonly parentTypes: [PropertyType.MATERIAL]

  protected override init(): void {
    Object.assign(this, {
      extensionName: WRINKLE_MAPS,
      propertyType: 'MaterialWrinkles',
      parentTypes: [PropertyType.MATERIAL],
    })
  }

  protected override getDefaults(): Nullable<IMaterialWrinkles> {
    return Object.assign(super.getDefaults() as IProperty, {
      layers: new RefSet<WrinkleLayer>(),
      areas: new RefSet<WrinkleArea>(),
      drivers: [],
      strokes: 'null',
      shapes: 'null',
      unknownFields: '{}',
    })
  }

  /** Appends a layer. The specification allows 1 to 4. */
  addLayer(layer: WrinkleLayer): this {
    return this.addRef('layers', layer)
  }

  /** Removes a layer. Writing throws while an area is still on it. */
  removeLayer(layer: WrinkleLayer): this {
    return this.removeRef('layers', layer)
  }

  /** The layers, in the order in which they are written. */
  listLayers(): WrinkleLayer[] {
    return this.listRefs('layers')
  }

  /** Appends an area. The specification allows 1 to 256. */
  addArea(area: WrinkleArea): this {
    return this.addRef('areas', area)
  }

  /** Removes an area; drivers that name it stay, and writing throws until they are changed. */
  removeArea(area: WrinkleArea): this {
    return this.removeRef('areas', area)
  }

  /** The areas, in the order in which they are written. */
  listAreas(): WrinkleArea[] {
    return this.listRefs('areas')
  }

  /** Copies of the drivers; those of types unknown to this version are kept as they are. */
  getDrivers(): WrinkleDriver[] {
    return this.get('drivers').map((text) => JSON.parse(text))
  }

  /** Replaces all drivers with copies of these, which must be plain JSON. */
  setDrivers(drivers: readonly WrinkleDriver[]): this {
    return this.set(
      'drivers',
      drivers.map((driver) => JSON.stringify(driver)),
    )
  }

  /** A copy of the lines of the layers, for `parseStrokes` of `furrow/author`, unchecked as they stand in the file; null for none. */
  getStrokes(): unknown {
    return JSON.parse(this.get('strokes'))
  }

  /** Replaces the strokes with a copy of these, which must be plain JSON; null for none. */
  setStrokes(strokes: unknown): this {
    return this.set('strokes', JSON.stringify(strokes ?? null))
  }

  /** A copy of the corrections of recognised blendshapes, unchecked as they stand in the file; null for none. */
  getShapes(): unknown {
    return JSON.parse(this.get('shapes'))
  }

  /** Replaces the corrections with a copy of these, which must be plain JSON; null for none. */
  setShapes(shapes: unknown): this {
    return this.set('shapes', JSON.stringify(shapes ?? null))
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

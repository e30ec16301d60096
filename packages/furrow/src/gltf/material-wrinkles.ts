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

/** Wrinkles of a material: layers, areas, drivers, strokes and corrections. See {@link FurrowWrinkleMaps}. */
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

  /** Removes a layer. Writing throws while an area uses the layer. */
  removeLayer(layer: WrinkleLayer): this {
    return this.removeRef('layers', layer)
  }

  /** Returns the layers in the order of the file. */
  listLayers(): WrinkleLayer[] {
    return this.listRefs('layers')
  }

  /** Appends an area. The specification allows 1 to 256. */
  addArea(area: WrinkleArea): this {
    return this.addRef('areas', area)
  }

  /** Removes an area. Drivers that name the area remain, and writing throws until they are changed. */
  removeArea(area: WrinkleArea): this {
    return this.removeRef('areas', area)
  }

  /** Returns the areas in the order of the file. */
  listAreas(): WrinkleArea[] {
    return this.listRefs('areas')
  }

  /** Returns copies of the drivers, including those of unknown type. */
  getDrivers(): WrinkleDriver[] {
    return this.get('drivers').map((text) => JSON.parse(text))
  }

  /** Replaces all drivers by copies. Drivers must be plain JSON. */
  setDrivers(drivers: readonly WrinkleDriver[]): this {
    return this.set(
      'drivers',
      drivers.map((driver) => JSON.stringify(driver)),
    )
  }

  /** Returns an unchecked copy of the strokes, for `parseStrokes` of `furrow/author`; null if there are none. */
  getStrokes(): unknown {
    return JSON.parse(this.get('strokes'))
  }

  /** Replaces the strokes by a copy. Strokes must be plain JSON; null removes them. */
  setStrokes(strokes: unknown): this {
    return this.set('strokes', JSON.stringify(strokes ?? null))
  }

  /** Returns an unchecked copy of the corrections to recognised blendshapes; null if there are none. */
  getShapes(): unknown {
    return JSON.parse(this.get('shapes'))
  }

  /** Replaces the corrections by a copy. Corrections must be plain JSON; null removes them. */
  setShapes(shapes: unknown): this {
    return this.set('shapes', JSON.stringify(shapes ?? null))
  }

  /** Returns unknown fields of the JSON, which are written back unchanged. */
  getUnknownFields(): Record<string, unknown> {
    return JSON.parse(this.get('unknownFields'))
  }

  /** Replaces the unknown fields by a copy. Fields must be plain JSON. */
  setUnknownFields(fields: Record<string, unknown>): this {
    return this.set('unknownFields', JSON.stringify(fields))
  }
}

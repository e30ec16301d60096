import { ExtensionProperty, type IProperty, type Nullable, PropertyType, RefSet } from '@gltf-transform/core'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import type { WrinkleArea } from './wrinkle-area.ts'
import type { WrinkleLayer } from './wrinkle-layer.ts'

interface IMaterialWrinkles extends IProperty {
  layers: RefSet<WrinkleLayer>
  areas: RefSet<WrinkleArea>
  /** One JSON text per driver. Drivers are stored as texts, because glTF-Transform copies and compares properties shallowly. */
  drivers: string[]
  /** JSON text of the strokes (wrinkle lines as curves). The text is `null` if there are none. */
  strokes: string
  /** JSON text of the field `shapes`: ARKit shapes, such as `browInnerUp`, that the user assigned to blendshapes. `null` if there are none. */
  shapes: string
  /** JSON text of unknown fields. */
  unknownFields: string
}

/**
 * Wrinkles of a material: layers, areas, drivers, strokes, and ARKit shapes that the user assigned to blendshapes. See
 * {@link FurrowWrinkleMaps}.
 */
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

  /** Appends a layer. The specification allows 1 to 4 layers. */
  addLayer(layer: WrinkleLayer): this {
    return this.addRef('layers', layer)
  }

  /** Removes a layer. Also change or remove all areas that use the layer. Otherwise, writing throws. */
  removeLayer(layer: WrinkleLayer): this {
    return this.removeRef('layers', layer)
  }

  /** Returns the layers in the order of the file. */
  listLayers(): WrinkleLayer[] {
    return this.listRefs('layers')
  }

  /** Appends an area. The specification allows 1 to 256 areas. */
  addArea(area: WrinkleArea): this {
    return this.addRef('areas', area)
  }

  /** Removes an area. Also change or remove all drivers that name the area. Otherwise, writing throws. */
  removeArea(area: WrinkleArea): this {
    return this.removeRef('areas', area)
  }

  /** Returns the areas in the order of the file. */
  listAreas(): WrinkleArea[] {
    return this.listRefs('areas')
  }

  /** Returns copies of the drivers, including drivers of unknown types. */
  getDrivers(): WrinkleDriver[] {
    return this.get('drivers').map((text) => JSON.parse(text))
  }

  /** Replaces all drivers by copies of `drivers`, which must be JSON data. */
  setDrivers(drivers: readonly WrinkleDriver[]): this {
    return this.set(
      'drivers',
      drivers.map((driver) => JSON.stringify(driver)),
    )
  }

  /** Returns a copy of the strokes' JSON, or null if there are no strokes. The JSON is not checked; to check it, call `parseStrokes` of `furrow/author`. */
  getStrokes(): unknown {
    return JSON.parse(this.get('strokes'))
  }

  /** Replaces the strokes by a copy of `strokes`, which must be JSON data. Null removes the strokes. */
  setStrokes(strokes: unknown): this {
    return this.set('strokes', JSON.stringify(strokes ?? null))
  }

  /**
   * Returns a copy of the field `shapes`, or null if there is none. It names the ARKit shapes, such as `browInnerUp`, that the user assigned to
   * blendshapes. The JSON is not checked.
   */
  getShapes(): unknown {
    return JSON.parse(this.get('shapes'))
  }

  /** Replaces the field `shapes` (see `getShapes`) by a copy of `shapes`, which must be JSON data. Null removes the field. */
  setShapes(shapes: unknown): this {
    return this.set('shapes', JSON.stringify(shapes ?? null))
  }

  /** Returns the unknown fields of the extension's JSON. Writing keeps them unchanged. */
  getUnknownFields(): Record<string, unknown> {
    return JSON.parse(this.get('unknownFields'))
  }

  /** Replaces the unknown fields by a copy of `fields`, which must be JSON data. */
  setUnknownFields(fields: Record<string, unknown>): this {
    return this.set('unknownFields', JSON.stringify(fields))
  }
}

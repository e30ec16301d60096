import { ExtensionProperty, type IProperty, type Nullable, PropertyType, RefSet } from '@gltf-transform/core'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import type { WrinkleDriver } from '../drivers/registry.ts'
import type { WrinkleArea } from './wrinkle-area.ts'
import type { WrinkleLayer } from './wrinkle-layer.ts'

interface IMaterialWrinkles extends IProperty {
  layers: RefSet<WrinkleLayer>
  areas: RefSet<WrinkleArea>
  /** One JSON text per driver. glTF-Transform copies and compares properties shallowly, which is correct for texts but not for objects. */
  drivers: string[]
  /** JSON text of the strokes document; the text `null` if there is none. */
  strokes: string
  /** JSON text of the corrections to recognised blendshapes; the text `null` if there are none. */
  shapes: string
  /** JSON of unknown fields. */
  unknownFields: string
}

/** Wrinkles of a material: layers, areas, drivers, strokes, and corrections to recognised blendshapes. See {@link FurrowWrinkleMaps}. */
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

  /** Removes a layer. Areas that use the layer must be changed or removed too, because writing throws otherwise. */
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

  /** Removes an area. Drivers that name the area must be changed or removed too, because writing throws otherwise. */
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

  /** Replaces all drivers by copies of the given ones. Drivers must be JSON data. */
  setDrivers(drivers: readonly WrinkleDriver[]): this {
    return this.set(
      'drivers',
      drivers.map((driver) => JSON.stringify(driver)),
    )
  }

  /** Returns an unchecked copy of the strokes document; null if there is none. `parseStrokes` of `furrow/author` checks it. */
  getStrokes(): unknown {
    return JSON.parse(this.get('strokes'))
  }

  /** Replaces the strokes document by a copy of the given one, which must be JSON data. Null removes it. */
  setStrokes(strokes: unknown): this {
    return this.set('strokes', JSON.stringify(strokes ?? null))
  }

  /** Returns an unchecked copy of the corrections to recognised blendshapes; null if there are none. */
  getShapes(): unknown {
    return JSON.parse(this.get('shapes'))
  }

  /** Replaces the corrections to recognised blendshapes by a copy of the given ones, which must be JSON data. Null removes them. */
  setShapes(shapes: unknown): this {
    return this.set('shapes', JSON.stringify(shapes ?? null))
  }

  /** Returns the unknown fields of the extension's JSON. Writing keeps them unchanged. */
  getUnknownFields(): Record<string, unknown> {
    return JSON.parse(this.get('unknownFields'))
  }

  /** Replaces the unknown fields by a copy of the given ones, which must be JSON data. */
  setUnknownFields(fields: Record<string, unknown>): this {
    return this.set('unknownFields', JSON.stringify(fields))
  }
}

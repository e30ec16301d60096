import {
  Extension,
  type GLTF,
  PropertyType,
  type ReaderContext,
  type WriterContext,
} from '@gltf-transform/core'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import { MaterialWrinkles } from './material-wrinkles.ts'
import { readMaterialWrinkles } from './read.ts'
import { WrinkleArea } from './wrinkle-area.ts'
import { WrinkleLayer } from './wrinkle-layer.ts'
import { writeMaterialWrinkles } from './write.ts'

/**
 * The glTF extension FURROW_wrinkle_maps for glTF-Transform. It reads and writes the wrinkles of materials. Register it with an I/O class:
 *
 * ```ts
 * const io = new NodeIO().registerExtensions([...ALL_EXTENSIONS, FurrowWrinkleMaps])
 * const document = await io.read('face.glb')
 * const wrinkles = document.getRoot().listMaterials()[0].getExtension<MaterialWrinkles>('FURROW_wrinkle_maps')
 * ```
 *
 * Reading throws a FurrowError if the extension's JSON is invalid. Writing throws a FurrowError if a value is invalid, or if a layer or an
 * area has no texture.
 */
export class FurrowWrinkleMaps extends Extension {
  static override readonly EXTENSION_NAME = WRINKLE_MAPS
  override readonly extensionName = WRINKLE_MAPS
  // `preread` and `prewrite` run when glTF-Transform reaches the meshes, after textures and materials. The extensions for WebP, Basis and
  // texture transforms write later. They therefore also convert the texture references that `prewrite` creates.
  override readonly prereadTypes: PropertyType[] = [PropertyType.MESH]
  override readonly prewriteTypes: PropertyType[] = [PropertyType.MESH]

  /** Creates empty wrinkles. Add them to a material with `material.setExtension('FURROW_wrinkle_maps', wrinkles)`. */
  createMaterialWrinkles(): MaterialWrinkles {
    return new MaterialWrinkles(this.document.getGraph())
  }

  /** Creates a layer. Add it to wrinkles with {@link MaterialWrinkles.addLayer}. */
  createLayer(name = ''): WrinkleLayer {
    return new WrinkleLayer(this.document.getGraph(), name)
  }

  /** Creates an area. Add it to wrinkles with {@link MaterialWrinkles.addArea}. */
  createArea(name = ''): WrinkleArea {
    return new WrinkleArea(this.document.getGraph(), name)
  }

  override preread(context: ReaderContext): this {
    for (const [index, material] of (context.jsonDoc.json.materials ?? []).entries()) {
      if (material.extensions?.[WRINKLE_MAPS] === undefined) continue
      const wrinkles = readMaterialWrinkles(this, context, material, whoOf(material, index))
      context.materials[index].setExtension(WRINKLE_MAPS, wrinkles)
    }
    return this
  }

  override prewrite(context: WriterContext): this {
    for (const [material, index] of context.materialIndexMap) {
      const wrinkles = material.getExtension<MaterialWrinkles>(WRINKLE_MAPS)
      if (!wrinkles) continue
      const json = context.jsonDoc.json.materials![index]
      json.extensions ??= {}
      json.extensions[WRINKLE_MAPS] = writeMaterialWrinkles(context, wrinkles, whoOf(json, index))
    }
    return this
  }

  read(): this {
    return this
  }

  write(): this {
    return this
  }
}

function whoOf({ name }: GLTF.IMaterial, index: number): string {
  return `${WRINKLE_MAPS} of material ${index}${name ? ` "${name}"` : ''}`
}

import { FurrowError } from 'furrow'
import { didYouMean, parseWrinkleMaps, WRINKLE_MAPS, type WrinkleMaps } from 'furrow/internal'
import type { Glb } from '../gltf/glb.ts'

/** A glTF file, and the wrinkles of one of its materials. */
export interface WrinkledFile {
  glb: Glb
  /** Index of the material. */
  material: number
  maps: WrinkleMaps
}

/** Returns the indices of materials with wrinkles. */
export function wrinkledMaterials({ json }: Glb): number[] {
  return (json.materials ?? []).flatMap(({ extensions }, index) => {
    return extensions?.[WRINKLE_MAPS] === undefined ? [] : [index]
  })
}

/**
 * Finds the material with wrinkles, and parses its wrinkles.
 *
 * @param path path of the file, for errors.
 * @param materialName name of the material. Default: the only material with wrinkles.
 * @throws FurrowError if no material has wrinkles, if several have wrinkles and `materialName` is missing, or if the
 *   wrinkles are malformed.
 */
export function wrinkledFile(glb: Glb, path: string, who: string, materialName?: string): WrinkledFile {
  const materials = glb.json.materials ?? []
  const all = wrinkledMaterials(glb)
  if (all.length === 0) {
    const limit = `a material with ${WRINKLE_MAPS}`
    const remedy = 'generate wrinkles with furrow auto, or add painted ones with furrow pack'
    throw new FurrowError({ who, problem: `${path} has no wrinkles`, limit, remedy })
  }
  const found =
    materialName === undefined ? all : all.filter((index) => materials[index].name === materialName)
  if (found.length !== 1) {
    const names = all.map((index) => materials[index].name ?? String(index))
    throw new FurrowError({
      code: 'unknown-name',
      who,
      problem: `${found.length === 0 ? 'no such material' : 'several materials'} with wrinkles in ${path}`,
      value: materialName,
      limit: names.join(', '),
      remedy: didYouMean(materialName, names, 'name one with --material'),
    })
  }
  return parseWrinkledFile(glb, found[0], `${who}: ${path}`)
}

/**
 * Parses the wrinkles of a material.
 *
 * @param material index of the material.
 */
export function parseWrinkledFile(glb: Glb, material: number, who: string): WrinkledFile {
  const json = glb.json.materials![material].extensions![WRINKLE_MAPS]
  return { glb, material, maps: parseWrinkleMaps(json, glb.json.textures?.length ?? 0, who) }
}

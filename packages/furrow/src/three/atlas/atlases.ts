import { InfluenceAtlas } from './influence-atlas.ts'
import type { QuadMaterials } from './influence-pass.ts'

/** All atlases in use, by the renderer's kind. */
const atlases = new Map<QuadMaterials, InfluenceAtlas[]>()

/** The atlas that all faces share whose renderer, size of areas and number of layers are the same. */
export function sharedAtlas(
  materials: QuadMaterials,
  width: number,
  height: number,
  layers: number,
): InfluenceAtlas {
  const known = atlases.get(materials) ?? []
  atlases.set(materials, known)
  const found = known.find(
    (atlas) => atlas.width === width && atlas.height === height && atlas.layers === layers,
  )
  if (found) return found
  const atlas = new InfluenceAtlas(width, height, layers, materials)
  known.push(atlas)
  return atlas
}

/** Frees an atlas that holds no face any more. */
export function releaseAtlas(atlas: InfluenceAtlas): void {
  if (!atlas.isEmpty) return
  atlas.dispose()
  for (const known of atlases.values()) {
    const index = known.indexOf(atlas)
    if (index >= 0) known.splice(index, 1)
  }
}

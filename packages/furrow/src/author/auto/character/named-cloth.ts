import type { ClothKind } from '../cloth/cloth-kinds.ts'
import type { SurfaceNames } from './judge-kind.ts'

/** Words in the names of materials and meshes. Other cloth folds like a shirt. */
const WORDS: readonly (readonly [ClothKind, RegExp])[] = [
  ['leather', /leather|suede|\bfur|boot/i],
  ['denim', /denim|jean|canvas|coat|jacket|pants|trouser|wool/i],
  ['silk', /silk|satin|chiffon|veil|tights|legging|stocking/i],
]

/** Tells the kind of cloth by the name of its material, then by the name of its mesh. */
export function clothOf({ meshName, materialName }: SurfaceNames): ClothKind {
  for (const name of [materialName, meshName]) {
    const found = WORDS.find(([, words]) => words.test(name))
    if (found) return found[0]
  }
  return 'shirt'
}

/** Functions of the three.js integration for other packages of this repository, which import this module as `furrow/internal/three`. */

export { movingCopy } from '../src/inspector/moving-copy.ts'
export { PoseWatch } from '../src/inspector/pose-watch.ts'
export { strainColour, strainOf } from '../src/inspector/strain.ts'
export { StrainView } from '../src/inspector/strain-view.ts'
export { DeclaredWrinkles } from '../src/three/loader/declared-wrinkles.ts'
export { animatedRotations, readBoundSkin, surfaceInFile } from '../src/three/loader/file-surface.ts'
export { expressionsOfMesh, nameTargets } from '../src/three/loader/file-targets.ts'
export { readImages } from '../src/three/loader/load-wrinkle-set.ts'
export {
  addFlatNormalMap,
  placementOf,
  readMeshes,
  supportsAutoWrinkles,
} from '../src/three/loader/read-character.ts'
export {
  chooseFaces,
  facesOf,
  materialReader,
  separateOthers,
  wrinkledMaterials,
} from '../src/three/loader/read-wrinkle-maps.ts'
export { readsNormalMap, surfaceOf } from '../src/three/material/surface.ts'
export { copyUvTransform } from '../src/three/material/textures.ts'
export { bindInputs } from '../src/three/sources/bind-inputs.ts'
export { coordinates, trianglesOf, vectorsOf } from '../src/three/sources/geometry-arrays.ts'
export { bindTension } from '../src/three/sources/tension.ts'

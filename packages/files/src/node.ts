export { readLow, readSurface, type Tangents } from './bake/read-meshes.ts'
export { type ReadOptions, resolveInside } from './disk/external-files.ts'
export { fileProblem, ignoreMissing, statOf } from './disk/file-status.ts'
export { forgetFilesRead, recordRead, wasRead } from './disk/files-read.ts'
export { readBytes, readJson } from './disk/read-bytes.ts'
export { FACE_EXTENSIONS, filesOfFace } from './gltf/face-files.ts'
export { readDocument } from './gltf/read-document.ts'
export { readGlbFile } from './gltf/read-glb-file.ts'
export { decodeNormalMap } from './images/decode-normal-map.ts'
export {
  encodeArea,
  encodeHeight,
  encodeNormalMap,
  encodePng,
  encodePngWithoutOpaqueAlpha,
  encodeRgb,
  encodeRgbaNormalMap,
} from './images/encode.ts'
export { type HeightImage, readHeightImage } from './images/height-image.ts'
export { HEIGHT_ZERO, MAX_HEIGHT } from './images/height-steps.ts'
export { POWER_RANGE } from './imports/character-creator/region-settings.ts'
export { REGIONS } from './imports/character-creator/rules.ts'
export {
  detectSource,
  type ImportResult,
  importWrinkles,
  MAX_IMPORT_BYTES,
} from './imports/import-wrinkles.ts'
export { IMPORT_SOURCES, type ImportSource } from './imports/imported-set.ts'
export { openSourceFiles } from './imports/open-source-files.ts'
export type { SourceFiles } from './imports/source-files.ts'
export { readLayers } from './ktx2/read-layers.ts'
export { type FaceMesh, readFaceMesh } from './mesh/face-mesh.ts'
export { drawSet } from './pack/draw-set.ts'
export { type OpenSet, openSet } from './pack/open-set.ts'
export { packAuto } from './pack/pack-auto.ts'
export { readFolder, readReferenced } from './wrinkles/folder.ts'
export { readWrinkledFile } from './wrinkles/read-wrinkled-file.ts'

/**
 * The glTF extension `FURROW_wrinkle_maps` for glTF-Transform.
 *
 * @module furrow/gltf
 */

export { FurrowWrinkleMaps } from './extension.ts'
export { MaterialWrinkles } from './material-wrinkles.ts'
export { WrinkleArea } from './wrinkle-area.ts'
export { type LayerSlot, WrinkleLayer } from './wrinkle-layer.ts'

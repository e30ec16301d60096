export { FurrowWrinkleMaps } from './extension.ts'
export { MaterialWrinkles } from './material-wrinkles.ts'
export { WrinkleArea } from './wrinkle-area.ts'
export { type LayerSlot, WrinkleLayer } from './wrinkle-layer.ts'

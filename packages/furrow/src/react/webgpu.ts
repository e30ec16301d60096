/**
 * Wrinkles in React Three Fiber, for `WebGPURenderer`.
 *
 * @module furrow/react/webgpu
 */

import type { ReactNode } from 'react'
import { Wrinkles as WebGPUWrinkles } from '../three/webgpu/Wrinkles.ts'
import { type WrinklesProps, wrinklesComponent } from './wrinkles-component.ts'

export type { ExtendableLoader } from '../three/loader/extend-loader.ts'
export { extendLoader } from '../three/webgpu/extend-loader.ts'
export { useWrinkles } from './use-wrinkles.ts'
export type { WrinkleState } from './wrinkle-state.ts'
export type { WrinklesProps } from './wrinkles-component.ts'

/**
 * The state of wrinkles: of the meshes among its children, or without children of its parent and what is under it.
 *
 * What a face cannot do is left out with one warning; a face without wrinkles stays as it is.
 */
export const Wrinkles: (props: WrinklesProps) => ReactNode = /* @__PURE__ */ wrinklesComponent(WebGPUWrinkles)

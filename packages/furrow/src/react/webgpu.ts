/**
 * Wrinkles for React Three Fiber with `WebGPURenderer`.
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
 * React component that sets the state of wrinkled faces by properties. With children, it applies to all faces among the children. Without
 * children, it applies to the parent object and all objects below the parent.
 *
 * Properties that a face does not support are skipped with one warning. Meshes without wrinkles are left unchanged.
 */
export const Wrinkles: (props: WrinklesProps) => ReactNode = /* @__PURE__ */ wrinklesComponent(WebGPUWrinkles)

/**
 * Wrinkles in React Three Fiber, for `WebGPURenderer`.
 *
 * @module furrow/react/webgpu
 */

import type { ReactNode } from 'react'
import { WrinkleLoaderPlugin } from '../three/webgpu/WrinkleLoaderPlugin.ts'
import { Wrinkles as WebGPUWrinkles } from '../three/webgpu/Wrinkles.ts'
import { type ExtendableLoader, loaderExtensions } from './extend-loader.ts'
import { type WrinklesProps, wrinklesComponent } from './wrinkles-component.ts'

export type { ExtendableLoader } from './extend-loader.ts'
export { useWrinkles } from './use-wrinkles.ts'
export type { WrinkleState } from './wrinkle-state.ts'
export type { WrinklesProps } from './wrinkles-component.ts'

/**
 * Adds `WrinkleLoaderPlugin` with options to the loader of drei's `useGLTF` and `<Gltf>`, or of fiber's `useLoader`. Call it once, outside of
 * components.
 *
 * @throws FurrowError, as the file is loaded, when an option is unknown or out of range.
 */
export const extendLoaderWith = /* @__PURE__ */ loaderExtensions(WrinkleLoaderPlugin)

/** Adds `WrinkleLoaderPlugin` to a loader: `useGLTF(url, true, true, extendLoader)`, or `<Gltf src={url} extendLoader={extendLoader} />`. */
export const extendLoader: (loader: ExtendableLoader) => void = /* @__PURE__ */ extendLoaderWith()

/**
 * The state of wrinkles: of the meshes among its children, or without children of its parent and what is under it.
 *
 * What a face cannot do is left out with one warning; a face without wrinkles stays as it is.
 */
export const Wrinkles: (props: WrinklesProps) => ReactNode = /* @__PURE__ */ wrinklesComponent(WebGPUWrinkles)

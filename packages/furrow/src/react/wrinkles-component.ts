import { createElement, type ReactNode, useLayoutEffect, useRef } from 'react'
import type { Group, Mesh, Object3D } from 'three'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import type { WrinklesBase } from '../three/wrinkles-base.ts'
import { wrinklesOf } from '../three/wrinkles-of.ts'
import { useDeclaration } from './use-declaration.ts'
import type { WrinkleState } from './wrinkle-state.ts'

/** Properties of `<Wrinkles>`. */
export interface WrinklesProps extends WrinkleState {
  /** Objects that contain the faces. Without children, the parent object is used: `<mesh><Wrinkles set={set} /></mesh>`. */
  children?: ReactNode
  /** Wrinkle set for the parent mesh. Omit it if a loader has already added wrinkles. */
  set?: WrinkleSet<ArraySlice>
}

/** Class `Wrinkles` of `furrow/three` or of `furrow/webgpu`. */
export type WrinklesClass = new (mesh: Mesh, set: WrinkleSet<ArraySlice>) => WrinklesBase

/** Creates the component `<Wrinkles>` for one renderer, from the class `Wrinkles` for this renderer. */
export function wrinklesComponent(Wrinkles: WrinklesClass) {
  return ({ children, set, ...state }: WrinklesProps): ReactNode => {
    const group = useRef<Group>(null)
    const isWrapper = children !== undefined
    const rootOf = () => (isWrapper ? group.current : (group.current?.parent ?? null))
    useLayoutEffect(() => {
      const mesh = group.current?.parent as Mesh | null | undefined
      if (!set || !mesh) return
      try {
        const wrinkles = new Wrinkles(mesh, set)
        return () => wrinkles.dispose()
      } catch (error) {
        // If the wrinkle set is invalid, the mesh is drawn without wrinkles.
        console.warn((error as Error).message)
      }
    }, [set])
    useDeclaration(() => {
      const root = rootOf()
      return root && { root, faces: facesUnder(root) }
    }, state)
    return createElement('group', { ref: group }, children)
  }
}

function facesUnder(root: Object3D): WrinklesBase[] {
  const faces = new Set<WrinklesBase>()
  root.traverse((object) => {
    const wrinkles = (object as Mesh).isMesh ? wrinklesOf(object as Mesh) : undefined
    if (wrinkles && !wrinkles.isDisposed) faces.add(wrinkles)
  })
  return [...faces]
}

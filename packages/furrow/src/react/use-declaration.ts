import { useFrame, useThree } from '@react-three/fiber'
import { useLayoutEffect, useRef } from 'react'
import type { Object3D } from 'three'
import type { WrinklesBase } from '../three/wrinkles-base.ts'
import { DeclaredFaces } from './declared-faces.ts'
import type { WrinkleState } from './wrinkle-state.ts'

/** Faces, and the root of their meshes. */
export interface FaceSource {
  root: Object3D
  faces: readonly WrinklesBase[]
}

/**
 * Applies a state to faces before each frame, and restores the original state on unmount. Runs per frame, because meshes that a page creates
 * with the material of a loaded face get wrinkles from their second frame on.
 *
 * @param find called in each frame; returns null if there are no faces yet.
 */
export function useDeclaration(find: () => FaceSource | null, state: WrinkleState): void {
  const invalidate = useThree((three) => three.invalidate)
  const declared = useRef<DeclaredFaces>(null)
  useLayoutEffect(() => {
    declared.current = new DeclaredFaces()
    return () => {
      declared.current?.release()
      declared.current = null
    }
  }, [])
  // Required for canvases with `frameloop="demand"`.
  useLayoutEffect(() => invalidate())
  useFrame((_, seconds) => {
    const source = find()
    if (source && declared.current?.update(source.root, source.faces, state, seconds)) invalidate()
  })
}

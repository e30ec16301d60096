import { useFrame, useThree } from '@react-three/fiber'
import { useLayoutEffect, useRef } from 'react'
import type { Object3D } from 'three'
import type { WrinklesBase } from '../three/wrinkles-base.ts'
import { DeclaredFaces } from './declared-faces.ts'
import type { WrinkleState } from './wrinkle-state.ts'

/** Faces, and an object that contains their meshes. */
export interface FaceSource {
  root: Object3D
  faces: readonly WrinklesBase[]
}

/**
 * Applies a state to faces before each frame, and restores their original state on unmount. Faces are searched in each frame, because a mesh
 * may get wrinkles later. For example, a page may create a mesh with the material of a loaded face. This mesh has wrinkles after its first
 * frame.
 *
 * @param find returns the current faces, or null if there are none yet.
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
  // A canvas with `frameloop="demand"` draws a frame only after `invalidate`.
  useLayoutEffect(() => invalidate())
  useFrame((_, seconds) => {
    const source = find()
    if (source && declared.current?.update(source.root, source.faces, state, seconds)) invalidate()
  })
}

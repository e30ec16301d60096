import { useFrame, useThree } from '@react-three/fiber'
import { useLayoutEffect, useRef } from 'react'
import type { Object3D } from 'three'
import type { WrinklesBase } from '../three/wrinkles-base.ts'
import { DeclaredFaces } from './declared-faces.ts'
import type { WrinkleState } from './wrinkle-state.ts'

/** Where faces are. */
export interface FaceSource {
  root: Object3D
  faces: readonly WrinklesBase[]
}

/**
 * Applies a state to faces before each frame: those that a page makes with the material of a loaded one have wrinkles from their second
 * frame on. Unmounted, all of them return to what they were.
 *
 * @param find is called in each frame; null where there is nothing yet.
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
  // Also where the canvas draws on demand.
  useLayoutEffect(() => invalidate())
  useFrame((_, seconds) => {
    const source = find()
    if (source && declared.current?.update(source.root, source.faces, state, seconds)) invalidate()
  })
}

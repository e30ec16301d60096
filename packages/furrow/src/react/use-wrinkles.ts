import { useEffect, useState } from 'react'
import type { Object3D } from 'three'
import type { WrinklesBase } from '../three/wrinkles-base.ts'
import { type LoadedFile, wrinklesOf, wrinklesReady } from '../three/wrinkles-of.ts'
import { useDeclaration } from './use-declaration.ts'
import type { WrinkleState } from './wrinkle-state.ts'

const NO_STATE: WrinkleState = {}

/**
 * The wrinkles of a file that `useGLTF` or `useLoader` loaded with `extendLoader`, one per face, and their state while the component is
 * mounted. Those that the option `auto` makes come later, and render the component again.
 *
 * @param state what differs from how the file was loaded. What a face cannot do, such as the paper's mode with two layers, is left out with one
 *   warning.
 * @returns none for a file without wrinkles.
 */
export function useWrinkles(
  file: LoadedFile & { scene: Object3D },
  state: WrinkleState = NO_STATE,
): readonly WrinklesBase[] {
  const [faces, setFaces] = useState<readonly WrinklesBase[]>(() => [...wrinklesOf(file)])
  useEffect(() => {
    let isMounted = true
    setFaces([...wrinklesOf(file)])
    void wrinklesReady(file).then((ready) => {
      if (isMounted) setFaces((known) => (known.length === ready.length ? known : [...ready]))
    })
    return () => {
      isMounted = false
    }
  }, [file])
  useDeclaration(() => ({ root: file.scene, faces }), state)
  return faces
}

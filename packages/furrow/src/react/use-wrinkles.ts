import { useEffect, useState } from 'react'
import type { Object3D } from 'three'
import type { WrinklesBase } from '../three/wrinkles-base.ts'
import { type LoadedFile, wrinklesOf, wrinklesReady } from '../three/wrinkles-of.ts'
import { useDeclaration } from './use-declaration.ts'
import type { WrinkleState } from './wrinkle-state.ts'

const NO_STATE: WrinkleState = {}

/**
 * Returns the wrinkles of a file, one object per face, and sets their state while the component is mounted. The file must be loaded by
 * `useGLTF` or `useLoader` with `extendLoader`. If the loader has the option `auto`, wrinkles are generated after loading, and the component
 * is rendered again when they are ready.
 *
 * @param state properties to set. Omitted properties keep their loaded values. Properties that a face does not support, such as the mode
 *   `paper` with two layers, are skipped with one warning.
 * @returns an empty array if the file has no wrinkles.
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

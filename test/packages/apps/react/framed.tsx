import { useThree } from '@react-three/fiber'
import { frameFace } from 'furrow/three'
import { type ReactNode, useLayoutEffect, useRef } from 'react'
import type { Group, PerspectiveCamera } from 'three'

/** Shows a face from the front, as large as fits. */
export function Framed({ children }: { children: ReactNode }) {
  const group = useRef<Group>(null)
  const camera = useThree((state) => state.camera)
  useLayoutEffect(() => {
    frameFace(camera as PerspectiveCamera, group.current!)
  }, [camera])
  return <group ref={group}>{children}</group>
}

import { Canvas, extend, type ThreeToJSXElements, useLoader } from '@react-three/fiber'
import { extendLoader, Wrinkles } from 'furrow/react/webgpu'
import { frameFace } from 'furrow/webgpu'
import { Suspense, useLayoutEffect, useState } from 'react'
import { useThree } from '@react-three/fiber'
import type { PerspectiveCamera } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import * as THREE from 'three/webgpu'

declare module '@react-three/fiber' {
  interface ThreeElements extends ThreeToJSXElements<typeof THREE> {}
}
extend(THREE as never)

function Face() {
  const { scene } = useLoader(GLTFLoader, '/wrinkled.glb', extendLoader)
  const camera = useThree((state) => state.camera)
  useLayoutEffect(() => {
    frameFace(camera as PerspectiveCamera, scene)
  }, [camera, scene])
  return <primitive object={scene} />
}

export function App() {
  const [mode, setMode] = useState<'default' | 'off'>('default')
  return (
    <Canvas
      gl={async (props) => {
        const renderer = new THREE.WebGPURenderer(props as never)
        await renderer.init()
        return renderer
      }}
      camera={{ fov: 22 }}
      onClick={() => setMode('off')}
    >
      <directionalLight intensity={3} position={[-0.5, 0, 1]} />
      <Suspense>
        <Wrinkles expression="surprised" mode={mode}>
          <Face />
        </Wrinkles>
      </Suspense>
    </Canvas>
  )
}

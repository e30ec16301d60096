import { Canvas, extend, useLoader } from '@react-three/fiber'
import { extendLoader, Wrinkles } from 'furrow/react/webgpu'
import { Suspense, useState } from 'react'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import * as THREE from 'three/webgpu'
import { Framed } from '../framed.tsx'

extend(THREE as never)

function Face() {
  const { scene } = useLoader(GLTFLoader, '/wrinkled.glb', extendLoader)
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
          <Framed>
            <Face />
          </Framed>
        </Wrinkles>
      </Suspense>
    </Canvas>
  )
}

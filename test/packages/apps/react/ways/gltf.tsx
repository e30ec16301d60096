import { Gltf } from '@react-three/drei'
import { Canvas } from '@react-three/fiber'
import { extendLoader, Wrinkles } from 'furrow/react'
import { Suspense, useState } from 'react'
import { Framed } from '../framed.tsx'

export function App() {
  const [mode, setMode] = useState<'default' | 'off'>('default')
  return (
    <Canvas camera={{ fov: 22 }} onClick={() => setMode('off')}>
      <directionalLight intensity={3} position={[-0.5, 0, 1]} />
      <Suspense>
        <Framed>
          <Wrinkles expression={{ surprised: 1 }} mode={mode}>
            <Gltf src="/wrinkled.glb" extendLoader={extendLoader} />
          </Wrinkles>
        </Framed>
      </Suspense>
    </Canvas>
  )
}

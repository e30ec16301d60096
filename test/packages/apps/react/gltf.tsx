import { Bounds, Gltf } from '@react-three/drei'
import { Canvas } from '@react-three/fiber'
import { extendLoader, Wrinkles } from 'furrow/react'
import { Suspense, useState } from 'react'

export function App() {
  const [mode, setMode] = useState<'default' | 'off'>('default')
  return (
    <Canvas
      gl={{ preserveDrawingBuffer: true }}
      camera={{ fov: 22, position: [0, 0, 1] }}
      onClick={() => setMode('off')}
    >
      <directionalLight intensity={3} position={[-0.5, 0, 1]} />
      <Suspense>
        <Bounds fit clip margin={1} maxDuration={0}>
          <Wrinkles expression={{ surprised: 1 }} mode={mode}>
            <Gltf src="/wrinkled.glb" extendLoader={extendLoader} />
          </Wrinkles>
        </Bounds>
      </Suspense>
    </Canvas>
  )
}

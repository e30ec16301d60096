import { useGLTF } from '@react-three/drei'
import { Canvas } from '@react-three/fiber'
import { extendLoader, useWrinkles, type WrinkleState } from 'furrow/react'
import { Suspense, useState } from 'react'
import { Framed } from '../framed.tsx'

function Face(state: WrinkleState) {
  const gltf = useGLTF('/wrinkled.glb', true, true, extendLoader)
  useWrinkles(gltf, state)
  return <primitive object={gltf.scene} />
}

export function App() {
  const [mode, setMode] = useState<'default' | 'off'>('default')
  return (
    <Canvas camera={{ fov: 22 }} onClick={() => setMode('off')}>
      <directionalLight intensity={3} position={[-0.5, 0, 1]} />
      <Suspense>
        <Framed>
          <Face expression="surprised" mode={mode} />
        </Framed>
      </Suspense>
    </Canvas>
  )
}
